(()=>{var hx="http://www.w3.org/2000/svg";function yp(n,t,e){for(let[i,s]of Object.entries(t??{}))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):n.setAttribute(i,s===!0?"":s));for(let i of e.flat(3))i!=null&&n.append(i);return n}function Z(n,t,...e){return yp(document.createElement(n),t,e)}function Ft(n,t,...e){return yp(document.createElementNS(hx,n),t,e)}function xr(n,t,e,i){let s=t.map(([r,o,a])=>Z("button",{type:"button","aria-pressed":String(r===e),"data-value":r,"aria-label":a,title:a,onclick:l=>{for(let c of s)c.setAttribute("aria-pressed",String(c===l.currentTarget));i(r)}},o));return Z("div",{class:"choice",role:"group","aria-label":n},s)}function Al(n,t,e,i){return Z("label",{class:"select"},n,Z("select",{onchange:s=>i(s.target.value)},t.map(([s,r])=>Z("option",{value:s,selected:s===e},r))))}var ss={error:["Error","over","M5 1h6l4 4v6l-4 4h-6l-4-4v-6z"],warning:["Warning","near","M8 1.5L15.5 14.5H.5z"],note:["Note","accent","M8 1.5a6.5 6.5 0 1 0 .01 0z"]},ha=Object.keys(ss),ux={error:"M5.5 5.5l5 5m0-5l-5 5",warning:"M8 6v4.2m0 1.6v.6",note:"M8 7v4.5m0-7v.6"},vp=(n,t)=>ha.indexOf(n.level)-ha.indexOf(t.level),Mp=n=>ha.find(t=>n.some(e=>e.level===t))??null;function ua(n){let[t,e,i]=ss[n];return Ft("svg",{class:"level-mark",viewBox:"0 0 16 16",width:15,height:15,role:"img","aria-label":t},Ft("path",{d:i,fill:`var(--${e})`}),Ft("path",{d:ux[n],stroke:"var(--paper)","stroke-width":1.8,fill:"none"}))}function Rl(n){return ha.flatMap(t=>{let e=n.filter(i=>i.level===t).length;return e?[`${e} ${ss[t][0].toLowerCase()}${e>1?"s":""}`]:[]}).join(", ")}var Sp=n=>ha.flatMap(t=>{let e=n.filter(i=>i.level===t).length;return e?[Z("span",{class:`count level-${t}`},ua(t),String(e))]:[]});var bp=[null,[6,4],[1.5,3],[13,4],[3.5,2.5],[6,7],[1.5,6]],wp=["M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z","M-3.2 -3.2h6.4v6.4h-6.4z","M0 -4.2L4 3.2H-4z","M0 -4.6L4.2 0L0 4.6L-4.2 0z","M0 4.2L4 -3.2H-4z","M-4 -1.2h2.8v-2.8h2.4v2.8h2.8v2.4h-2.8v2.8h-2.4v-2.8h-2.8z","M-4 -2.4L-2.4 -4L0 -1.6L2.4 -4L4 -2.4L1.6 0L4 2.4L2.4 4L0 1.6L-2.4 4L-4 2.4L-1.6 0z"],Ks=n=>bp[n%bp.length],Tp=n=>wp[n%wp.length];var Ee=n=>getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim(),vs=n=>Ee(`line-${n%7}`);function dx(n){let t=parseInt(n.slice(1),16);return[t>>16,t>>8&255,t&255]}var fx=Array.from({length:10},(n,t)=>`amount-${t}`),px=["low-side-strong","low-side","middle","high-side","high-side-strong"];function mx(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,o)=>r+s*(n[i+1][o]-r))}var Du=512;function Qr(n){let t=(n?px:fx).map(i=>dx(Ee(i))),e=Array.from({length:Du+1},(i,s)=>mx(t,s/Du));return i=>e[Math.round(Math.min(Math.max(i,0),1)*Du)]}var Cl=new Map,Bt={units:"si",theme:"auto",operation:null,depths:null,times:null,depth:null,moment:null,pointer:null,hidden:new Set};function we(n,t){for(let e of n.split(" "))Cl.has(e)||Cl.set(e,[]),Cl.get(e).push(t)}function Ge(n){let t=new Set;for(let[e,i]of Object.entries(n))if(!Object.is(Bt[e],i)){Bt[e]=i;for(let s of Cl.get(e)??[])t.add(s)}for(let e of t)e()}var kn=n=>n.replaceAll("_"," "),to=n=>n==="soft"?"soft string":"dynamics",yr=n=>[...new Set(n.solved.map(t=>t.operation))],gx=n=>new Set(n.solved.map(t=>t.model)).size>1;function da(n,t){let e=yr(n),i=t.model==="soft",s=gx(n),r=e.length===1&&s&&i?1:e.indexOf(t.operation);return{colour:vs(r),dash:s?i?Ks(1):null:Ks(r),shape:e.length>1?Tp(r):null,place:r}}var Nu=n=>`${n.model} ${n.operation}`;function Uu(n,t){return yr(n).length===1?to(t.model):new Set(n.solved.map(i=>i.model)).size===1?kn(t.operation):`${kn(t.operation)}, ${to(t.model)}`}var Ai=(n,t)=>n.solved.find(e=>e.operation===Bt.operation&&e.model===t),Je=n=>n.runs.find(t=>t.operation===Bt.operation);var Ep="wholestring.";function Pl(n,t){try{let e=localStorage.getItem(Ep+n);return t.includes(e)?e:null}catch{return null}}function Il(n,t){try{localStorage.setItem(Ep+n,t)}catch{}}var Ap=["si","metric","field"],Rp={};function Cp(n,t){Rp=n,Bt.units=Pl("units",Ap)??t,we("units",()=>Il("units",Bt.units))}function Ll(n){return Rp[n]?.[Ap.indexOf(Bt.units)]??{symbol:"",factor:1}}var ce=n=>Ll(n).symbol,Jt=(n,t)=>n/Ll(t).factor,Hn=(n,t)=>n*Ll(t).factor;function Dl(n,t){let e=Ll(t).factor;return Array.from(n,i=>Number.isFinite(i)?i/e:null)}function zn(n,t=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.abs(n);if(e>=1e9||e<1e-4){let[o,a]=n.toExponential(t-1).split("e");return`${Pp(String(Number(o)))}·10${_x(Number(a))}`}let i=Math.floor(Math.log10(e))+1,s=Math.min(Math.max(t-i,0),6);if(i<=t)return Ms(n.toFixed(s));let r=10**(i-t);return Ms(String(Math.round(n/r)*r))}function _x(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}var Pp=n=>n.replace("-","−");function Ms(n){let[t,e]=n.split("."),[i,s]=Bt.units==="field"?[4,","]:[5," "],r=t.replace("-","").length>=i?t.replace(/\B(?=(\d{3})+$)/g,s):t;return Pp(e===void 0?r:`${r}.${e}`)}function rs(n,t=6){let e=zn(n,t);return/\.\d*0$/.test(e)?e.replace(/\.?0+$/,""):e}var Fu=n=>`${Ms(String(Math.round(Jt(n,"length"))))} ${ce("length")}`;function Te(n,t,e=4,i=zn){let s=ce(t),r=i(Jt(n,t),e);return s===""?r:`${r} ${s}`}var xx=8,Nl=n=>n.solved.flatMap(t=>t.findings.map(e=>({...e,solved:t}))).sort(vp),eo=(n,t)=>Nl(n).filter(e=>e.solved.operation===t),Lp=n=>n.replaceAll("_"," ").replace(/^./,t=>t.toUpperCase());function yx({md_m:n,to_md_m:t}){if(n===null)return null;let e=Fu(n);return t===null?`at ${e}`:`${e} to ${Fu(t)}`}var Ou=n=>typeof n=="number"?rs(n,4):Te(n.value,n.dimension,4,rs);function Ip({value:n,limit:t},e){return n===null||Bt.units===e?null:t===null?Ou(n):`${Ou(n)} against ${Ou(t)}`}function Dp(n,t){let e=Z("div",{class:"finding-list"}),i=new Set(n.solved.map(a=>a.operation)).size>1,s=new Set(n.solved.map(a=>a.model)).size>1;function r(a){let{level:l,solved:c,message:d}=a,[u]=ss[l],h=yx(a),f=i&&c.operation!==Bt.operation,g=[i&&kn(c.operation),s&&to(c.model)].filter(Boolean).join(", ");return Z("li",{class:`finding level-${l}`},Z("span",{class:"level"},ua(l),` ${u}`),Z("span",{class:"message"},g&&(f?Z("button",{type:"button",class:"link",title:"Show this operation",onclick:()=>Ge({operation:c.operation,times:null,moment:null})},g):Z("strong",{},g)),g&&": ",d,Z("span",{class:"note"},Ip(a,n.told_in)&&` ${Ip(a,n.told_in)}`,h&&" ",h&&Z("button",{type:"button",class:"link",title:"Show these depths along the hole",onclick:()=>{Ge({operation:c.operation,times:null,moment:null}),t(a)}},h))))}function o(){let a=Nl(n),l=u=>u.level==="error"||u.level==="warning"&&u.solved.operation===Bt.operation,c=a.length>xx?a.filter(u=>!l(u)):[],d=e.querySelector("details")?.open??!1;e.replaceChildren(...a.length?[Z("ul",{class:"findings"},a.filter(u=>!c.includes(u)).map(r)),c.length>0&&Z("details",{class:"prints",open:d},Z("summary",{},`${c.length} more: ${Rl(c)}`),Z("ul",{class:"findings"},c.map(r)))].filter(Boolean):[])}return we("units operation",o),{element:e,redraw:o}}function Bu(n,t,e){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e}));Z("a",{href:i,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(i),6e4)}var vx=n=>n.toLowerCase().replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-|-$/g,"")||"figure";function Mx(n){if(n==null||Number.isNaN(n))return"";if(typeof n=="number")return String(Number(n.toPrecision(9)));let t=/^[=+@\t\r]|^-(?![\d.])/.test(n)?`'${n}`:n;return/[",\n\r]/.test(t)?`"${t.replaceAll('"','""')}"`:t}var Wn=(n,t)=>[n,...t].map(e=>Array.from(e,Mx).join(",")).join(`\r
`)+`\r
`,Sx=["fill","fill-opacity","stroke","stroke-width","stroke-dasharray","stroke-linejoin","opacity","font-family","font-size","font-weight","text-anchor","paint-order"];function no(n){let t=n.map(a=>a.viewBox.baseVal),e=Math.max(...t.map(a=>a.width)),i=t.reduce((a,l)=>a+l.height,0),s=0,r=getComputedStyle(document.documentElement).getPropertyValue("--paper"),o=n.map((a,l)=>{let c=a.cloneNode(!0),d=[a,...a.querySelectorAll("*")];[c,...c.querySelectorAll("*")].forEach((f,g)=>{let x=getComputedStyle(d[g]);if(x.visibility==="hidden"||x.display==="none")return f.setAttribute("display","none");f.removeAttribute("style");for(let p of Sx){let m=x.getPropertyValue(p);m&&f.setAttribute(p,m)}});let{width:u,height:h}=t[l];for(let[f,g]of Object.entries({x:0,y:s,width:u,height:h}))c.setAttribute(f,g);return s+=h,new XMLSerializer().serializeToString(c)});return`<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="${e}" height="${i}" viewBox="0 0 ${e} ${i}">
<rect width="100%" height="100%" fill="${r}"/>
${o.join(`
`)}
</svg>
`}function Nn(n,{svg:t,csv:e,png:i}){let s=()=>vx(typeof n=="function"?n():n),r=(o,a)=>Z("button",{type:"button",class:"download",title:`Download as ${o}`,"data-download":o.toLowerCase(),onclick:a},o);return Z("span",{class:"downloads noprint"},t&&r("SVG",()=>Bu(`${s()}.svg`,t(),"image/svg+xml")),i&&r("PNG",()=>i().toBlob(o=>Bu(`${s()}.png`,o))),e&&r("CSV",()=>Bu(`${s()}.csv`,e(),"text/csv")))}var Up=n=>Number.isInteger(n)&&Math.abs(n)<1e12?Ms(String(n)):rs(n);function Ss(n,t,e=t?zn:rs){return n===null||n===""?"–":typeof n=="string"?n:n.href?n.text:typeof n=="number"?Up(n):n.values?bx(n):Te(n.value,n.dimension,t??6,e)}function bx({values:n,dimension:t}){return`${n.map(i=>rs(Jt(i,t))).join(", ")} ${ce(t)}`.trim()}function Fp(n){return n?.value===void 0?Ss(n):rs(Jt(n.value,n.dimension))}function Op(n,t,e){if(n===null||typeof n!="object")return Ss(n);let i=o=>Math.abs(o)<1e-6*t?0:o,s=i(Jt(n.value,n.dimension)),r=n.dimension==="ratio"&&Number.isInteger(s)?Up(s):zn(s,e);return n.std===void 0?r:`${r} ± ${zn(i(Jt(n.std,n.dimension)),2)}`}function Ul(n){let t=new Set(n.filter(e=>e!==null&&typeof e=="object").map(e=>e.dimension));return t.size===1?[...t][0]:null}var Bp=n=>n&&ce(n)!==""?Z("span",{class:"unit"},` ${ce(n)}`):null,kp=n=>typeof n=="string"||!!n?.href,zp=n=>Math.max(0,...n.map(t=>t?.dimension?Math.abs(Jt(t.value,t.dimension)):0));function wx(n){return n.rows.map(([t,...e])=>Z("tr",{},Z("th",{scope:"row"},t,Bp(Ul(e))),e.map(i=>Z("td",{class:"number"},Op(i,zp(e),5)))))}function Tx(n){let t=({value:s,dimension:r,std:o})=>{let a=Jt(s,r);return o===void 0&&Math.abs(a-Math.round(a))<=1e-9*Math.abs(a)},e=n.filter(s=>s?.dimension),i=zp(e);return e.every(t)?Fp:s=>Op(s,i,4)}function Np(n,t){let e=(n.rows[0]??[]).map((i,s)=>t(n.rows.map(r=>r[s])));return n.rows.map(i=>Z("tr",{},i.map((s,r)=>Z("td",{class:kp(s)?null:"number"},s?.href?Z("a",{href:s.href},s.text):e[r](s)))))}function Ex(n){return n.rows.map(([t,e])=>Z("tr",{},Z("th",{scope:"row"},t),Z("td",{},Ss(e))))}function Ax(n,t){let e=a=>a===null||typeof a!="object"?a:a.values||a.href?Ss(a):Jt(a.value,a.dimension),i=(a,l)=>l&&ce(l)?`${a}, ${ce(l)}`:a,s=a=>a.some(l=>l?.std!==void 0),r=a=>a?.std===void 0?null:Jt(a.std,a.dimension);if(t){let a=n.heads.map((d,u)=>u>0&&s(n.rows.map(h=>h[u]))),l=n.heads.flatMap((d,u)=>a[u]?[d,`${d}, deviation`]:[d]),c=n.rows.map(([d,...u])=>[i(d,Ul(u)),...u.flatMap((h,f)=>a[f+1]?[e(h),r(h)]:[e(h)])]);return[l,c]}if(!n.heads.length){let a=l=>l?.dimension?ce(l.dimension):"";return[["key","value","unit"],n.rows.map(([l,c])=>[l,e(c),a(c)])]}let o=n.heads.map((a,l)=>{let c=n.rows.map(d=>d[l]);return{head:i(a,Ul(c)),wide:s(c)}});return[o.flatMap(({head:a,wide:l})=>l?[a,`${a}, deviation`]:[a]),n.rows.map(a=>a.flatMap((l,c)=>o[c].wide?[e(l),r(l)]:[e(l)]))]}var ku=n=>Nn(n.title,{csv:()=>Wn(...Ax(n,["results","numerics"].includes(n.place)))});function fa(n){let t=Z("tbody",{}),e=Z("thead",{}),i=n.place==="cases",s=n.place!=="inputs"&&!i,r=()=>s?wx(n):i?Np(n,Tx):n.heads.length?Np(n,()=>Fp):Ex(n),o=()=>{t.replaceChildren(...r());let d=u=>s?null:Bp(Ul(n.rows.map(h=>h[u])));n.heads.length&&e.replaceChildren(Z("tr",{},n.heads.map((u,h)=>{let f=i&&n.rows.every(g=>kp(g[h]));return Z("th",{scope:"col",class:f?"words":null},u,d(h))})))};we("units",o),o();let a=ku(n),l=Z("div",{class:"scrolls"},Z("table",{class:n.heads.length?"grid":"keys"},e,t));if(i)return Z("div",{class:"sheet cases"},l);if(s)return Z("div",{class:"sheet"},Z("h3",{},n.title,a),l);let c=n.rows.length>24;return Z("details",{class:`sheet prints${n.heads.length>4?" wide":""}${c?" long":""}`,open:!c},Z("summary",{},n.title,c?` (${n.rows.length} rows)`:""),l,a)}function Fl(n){let t=Z("dl",{class:"asked"}),e=()=>t.replaceChildren(...n.asked.map(({label:i,value:s})=>Z("div",{},Z("dt",{},i),Z("dd",{},Ss(s,s?.dimension==="length"?5:4,rs)))));return we("units",e),e(),t}function Rx(n){return n>1?["over","over the limit"]:n>.8?["near","near the limit"]:["within","within the limit"]}function Cx(n,t){let e=t.length===1?"see the finding above":`see the ${t.length} findings above`;return Z("p",{class:`flag level-${n}`},ua(n),Z("strong",{},` ${ss[n][0]}`),`: ${e}`)}function Px(n,t,e){let i=e.filter(l=>n.about.some(c=>l.kind.includes(c))),s=Mp(i),r=n.value?.dimension,o=[Z("h3",{},n.label),Z("p",{class:"number"},Ss(n.value,r==="ratio"||r==="percent"?3:4))];n.worst!==null&&r&&o.push(Z("p",{class:"note"},`mean; at most ${Te(n.worst,r)}`));for(let{label:l,value:c}of n.more)o.push(Z("p",{class:"note"},`${Ss(c,4)} ${l}`));t?.value?.dimension===r&&r&&o.push(Z("p",{class:"note"},`soft string ${Ss(t.value,4)}`)),s&&o.push(Cx(s,i));let a=n.held??n.worst??n.value?.value;if(n.limit!==null&&Number.isFinite(a)){let l=a/n.limit,c=s==="error"||s==="warning",[d,u]=c&&l<=.8?["","of the limit"]:Rx(l);o.push(Z("div",{class:`limit ${d}`},Z("div",{class:"bar"},Z("div",{class:"used",style:`width:${Math.min(Math.max(l,0),1)*100}%`})),Z("p",{class:"note"},Z("strong",{},`${Math.round(l*100)} %${c&&l<=.8?"":","} ${u}`),Z("br"),`${n.limit_label} ${r==="percent"||r==="ratio"?"":Te(n.limit,r)}`)))}else o.push(Z("p",{class:"note"},n.limit_label));return Z("div",{class:`card answer${s?` has-${s}`:""}`},o)}function Vp(n){let t=Z("div",{}),e=()=>{let i=Ai(n,"dynamic"),s=Ai(n,"soft"),r=i??s,o=l=>i&&s?.answers.find(c=>c.label===l.label),a=[i,s].filter(l=>l?.message).map(l=>Z("p",{class:"warning"},`${to(l.model)}: ${l.message}`));t.replaceChildren(...a,Z("div",{class:"answers"},r.answers.map(l=>Px(l,o(l),eo(n,Bt.operation)))))};return we("units operation",e),{element:t,redraw:e}}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var lr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},cr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ym=0,md=1,vm=2;var Za=1,Mm=2,Lo=3,hs=0,oi=1,li=2,Rr=0,Do=1,gd=2,_d=3,xd=4,Sm=5;var Cr=100,bm=101,wm=102,Tm=103,Em=104,Am=200,Rm=201,Cm=202,Pm=203,yd=204,vd=205,Im=206,Lm=207,Dm=208,Nm=209,Um=210,Fm=211,Om=212,Bm=213,km=214,hc=0,uc=1,dc=2,So=3,fc=4,pc=5,mc=6,gc=7,Xc=0,zm=1,Vm=2,us=0,Md=1,Sd=2,bd=3,wd=4,Td=5,Ed=6,Ad=7;var Rd=300,Pr=301,No=302,qc=303,$c=304,_c=1e3,as=1001,xc=1002,Fn=1003,Gm=1004;var Ja=1005;var si=1006,Yc=1007;var Ns=1008;var ci=1009,Cd=1010,Pd=1011,Uo=1012,Zc=1013,Hi=1014,Wi=1015,Xi=1016,Jc=1017,Kc=1018,Ir=1020,Id=35902,Ld=35899,Dd=1021,Nd=1022,qi=1023,Ps=1026,Us=1027,Ud=1028,jc=1029,hr=1030,Qc=1031;var th=1033,Ka=33776,ja=33777,Qa=33778,tl=33779,eh=35840,nh=35841,ih=35842,sh=35843,rh=36196,oh=37492,ah=37496,lh=37488,ch=37489,el=37490,hh=37491,uh=37808,dh=37809,fh=37810,ph=37811,mh=37812,gh=37813,_h=37814,xh=37815,yh=37816,vh=37817,Mh=37818,Sh=37819,bh=37820,wh=37821,Th=36492,Eh=36494,Ah=36495,Rh=36283,Ch=36284,nl=36285,Ph=36286;var Ta=2300,yc=2301,lc=2302,ld=2303,cd=2400,hd=2401,ud=2402;var Hm=3200;var Ih=0,Wm=1,Fs="",ei="srgb",Ea="srgb-linear",Aa="linear",Ne="srgb";var cc=7680;var Xm=519,qm=512,$m=513,Ym=514,Fd=515,Zm=516,Jm=517,Od=518,Bd=519,kd=35044;var zd="300 es",Ci=2e3,bo=2001;function Ix(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Lx(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ra(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Km(){let n=Ra("canvas");return n.style.display="block",n}var Gp={},wo=null;function Ca(...n){let t="THREE."+n.shift();wo?wo("log",t,...n):console.log(t,...n)}function jm(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function ee(...n){n=jm(n);let t="THREE."+n.shift();if(wo)wo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function re(...n){n=jm(n);let t="THREE."+n.shift();if(wo)wo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Sa(...n){let t=n.join(" ");t in Gp||(Gp[t]=!0,ee(...n))}function Qm(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var tg={[hc]:hc,[dc]:mc,[fc]:fc,[So]:pc,[uc]:uc,[mc]:dc,[gc]:gc,[pc]:So},Gi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Xn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Hp=1234567,ba=Math.PI/180,To=180/Math.PI;function ur(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xn[n&255]+Xn[n>>8&255]+Xn[n>>16&255]+Xn[n>>24&255]+"-"+Xn[t&255]+Xn[t>>8&255]+"-"+Xn[t>>16&15|64]+Xn[t>>24&255]+"-"+Xn[e&63|128]+Xn[e>>8&255]+"-"+Xn[e>>16&255]+Xn[e>>24&255]+Xn[i&255]+Xn[i>>8&255]+Xn[i>>16&255]+Xn[i>>24&255]).toLowerCase()}function xe(n,t,e){return Math.max(t,Math.min(e,n))}function Vd(n,t){return(n%t+t)%t}function Dx(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Nx(n,t,e){return n!==t?(e-n)/(t-n):0}function wa(n,t,e){return(1-e)*n+e*t}function Ux(n,t,e,i){return wa(n,t,1-Math.exp(-e*i))}function Fx(n,t=1){return t-Math.abs(Vd(n,t*2)-t)}function Ox(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function Bx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function kx(n,t){return n+Math.floor(Math.random()*(t-n+1))}function zx(n,t){return n+Math.random()*(t-n)}function Vx(n){return n*(.5-Math.random())}function Gx(n){n!==void 0&&(Hp=n);let t=Hp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Hx(n){return n*ba}function Wx(n){return n*To}function Xx(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function qx(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Gd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function $x(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),d=o((t+i)/2),u=r((t-i)/2),h=o((t-i)/2),f=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*d,l*u,l*h,a*c);break;case"YZY":n.set(l*h,a*d,l*u,a*c);break;case"ZXZ":n.set(l*u,l*h,a*d,a*c);break;case"XZX":n.set(a*d,l*g,l*f,a*c);break;case"YXY":n.set(l*f,a*d,l*g,a*c);break;case"ZYZ":n.set(l*g,l*f,a*d,a*c);break;default:ee("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Lh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Hd(n,t){if(t.constructor===Float32Array)return n;let e=Lh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Wd(n,t){if(t.constructor===Float32Array)return n;let e=Lh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Xd={DEG2RAD:ba,RAD2DEG:To,generateUUID:ur,clamp:xe,euclideanModulo:Vd,mapLinear:Dx,inverseLerp:Nx,lerp:wa,damp:Ux,pingpong:Fx,smoothstep:Ox,smootherstep:Bx,randInt:kx,randFloat:zx,randFloatSpread:Vx,seededRandom:Gx,degToRad:Hx,radToDeg:Wx,isPowerOfTwo:Xx,ceilPowerOfTwo:qx,floorPowerOfTwo:Gd,setQuaternionFromProperEuler:$x,normalize:Wd,denormalize:Hd},Kt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},yi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],d=i[s+2],u=i[s+3],h=r[o+0],f=r[o+1],g=r[o+2],x=r[o+3];if(u!==x||l!==h||c!==f||d!==g){let p=l*h+c*f+d*g+u*x;p<0&&(h=-h,f=-f,g=-g,x=-x,p=-p);let m=1-a;if(p<.9995){let y=Math.acos(p),S=Math.sin(y);m=Math.sin(m*y)/S,a=Math.sin(a*y)/S,l=l*m+h*a,c=c*m+f*a,d=d*m+g*a,u=u*m+x*a}else{l=l*m+h*a,c=c*m+f*a,d=d*m+g*a,u=u*m+x*a;let y=1/Math.sqrt(l*l+c*c+d*d+u*u);l*=y,c*=y,d*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=d,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],d=i[s+3],u=r[o],h=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+d*u+l*f-c*h,t[e+1]=l*g+d*h+c*u-a*f,t[e+2]=c*g+d*f+a*h-l*u,t[e+3]=d*g-a*u-l*h-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),d=a(s/2),u=a(r/2),h=l(i/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*d*u+c*f*g,this._y=c*f*u-h*d*g,this._z=c*d*g+h*f*u,this._w=c*d*u-h*f*g;break;case"YXZ":this._x=h*d*u+c*f*g,this._y=c*f*u-h*d*g,this._z=c*d*g-h*f*u,this._w=c*d*u+h*f*g;break;case"ZXY":this._x=h*d*u-c*f*g,this._y=c*f*u+h*d*g,this._z=c*d*g+h*f*u,this._w=c*d*u-h*f*g;break;case"ZYX":this._x=h*d*u-c*f*g,this._y=c*f*u+h*d*g,this._z=c*d*g-h*f*u,this._w=c*d*u+h*f*g;break;case"YZX":this._x=h*d*u+c*f*g,this._y=c*f*u+h*d*g,this._z=c*d*g-h*f*u,this._w=c*d*u-h*f*g;break;case"XZY":this._x=h*d*u-c*f*g,this._y=c*f*u-h*d*g,this._z=c*d*g+h*f*u,this._w=c*d*u+h*f*g;break;default:ee("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],d=e[6],u=e[10],h=i+a+u;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(d-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(d-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+d)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+d)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,d=e._w;return this._x=i*d+o*a+s*c-r*l,this._y=s*d+o*l+r*a-i*c,this._z=r*d+o*c+i*l-s*a,this._w=o*d-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),d=Math.sin(c);l=Math.sin(l*c)/d,e=Math.sin(e*c)/d,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Wp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Wp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),d=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*d,this.y=i+l*d+a*c-r*u,this.z=s+l*u+r*d-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return zu.copy(this).projectOnVector(t),this.sub(zu)}reflect(t){return this.sub(zu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},zu=new K,Wp=new yi,he=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let d=this.elements;return d[0]=t,d[1]=s,d[2]=a,d[3]=e,d[4]=r,d[5]=l,d[6]=i,d[7]=o,d[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],d=i[4],u=i[7],h=i[2],f=i[5],g=i[8],x=s[0],p=s[3],m=s[6],y=s[1],S=s[4],v=s[7],E=s[2],w=s[5],_=s[8];return r[0]=o*x+a*y+l*E,r[3]=o*p+a*S+l*w,r[6]=o*m+a*v+l*_,r[1]=c*x+d*y+u*E,r[4]=c*p+d*S+u*w,r[7]=c*m+d*v+u*_,r[2]=h*x+f*y+g*E,r[5]=h*p+f*S+g*w,r[8]=h*m+f*v+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8];return e*o*d-e*a*c-i*r*d+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8],u=d*o-a*c,h=a*l-d*r,f=c*r-o*l,g=e*u+i*h+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return t[0]=u*x,t[1]=(s*c-d*i)*x,t[2]=(a*i-s*o)*x,t[3]=h*x,t[4]=(d*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Sa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Vu.makeScale(t,e)),this}rotate(t){return Sa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Vu.makeRotation(-t)),this}translate(t,e){return Sa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Vu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Vu=new he,Xp=new he().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),qp=new he().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Yx(){let n={enabled:!0,workingColorSpace:Ea,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ne&&(s.r=Cs(s.r),s.g=Cs(s.g),s.b=Cs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ne&&(s.r=Mo(s.r),s.g=Mo(s.g),s.b=Mo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Fs?Aa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ea]:{primaries:t,whitePoint:i,transfer:Aa,toXYZ:Xp,fromXYZ:qp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ei},outputColorSpaceConfig:{drawingBufferColorSpace:ei}},[ei]:{primaries:t,whitePoint:i,transfer:Ne,toXYZ:Xp,fromXYZ:qp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ei}}}),n}var Se=Yx();function Cs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Mo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var io,vc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{io===void 0&&(io=Ra("canvas")),io.width=t.width,io.height=t.height;let s=io.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=io}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ra("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Cs(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Cs(e[i]/255)*255):e[i]=Cs(e[i]);return{data:e,width:t.width,height:t.height}}else return ee("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Zx=0,Eo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Zx++}),this.uuid=ur(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Gu(s[o].image)):r.push(Gu(s[o]))}else r=Gu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Gu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?vc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(ee("Texture: Unable to serialize Texture."),{})}var Jx=0,Hu=new K,ri=class n extends Gi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=as,s=as,r=si,o=Ns,a=qi,l=ci,c=n.DEFAULT_ANISOTROPY,d=Fs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Jx++}),this.uuid=ur(),this.name="",this.source=new Eo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Kt(0,0),this.repeat=new Kt(1,1),this.center=new Kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new he,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=d,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Hu).x}get height(){return this.source.getSize(Hu).y}get depth(){return this.source.getSize(Hu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){ee(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ee(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Rd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case _c:t.x=t.x-Math.floor(t.x);break;case as:t.x=t.x<0?0:1;break;case xc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case _c:t.y=t.y-Math.floor(t.y);break;case as:t.y=t.y<0?0:1;break;case xc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=Rd;ri.DEFAULT_ANISOTROPY=1;var en=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],d=l[4],u=l[8],h=l[1],f=l[5],g=l[9],x=l[2],p=l[6],m=l[10];if(Math.abs(d-h)<.01&&Math.abs(u-x)<.01&&Math.abs(g-p)<.01){if(Math.abs(d+h)<.1&&Math.abs(u+x)<.1&&Math.abs(g+p)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,v=(f+1)/2,E=(m+1)/2,w=(d+h)/4,_=(u+x)/4,b=(g+p)/4;return S>v&&S>E?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=w/i,r=_/i):v>E?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=w/s,r=b/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=_/r,s=b/r),this.set(i,s,r,e),this}let y=Math.sqrt((p-g)*(p-g)+(u-x)*(u-x)+(h-d)*(h-d));return Math.abs(y)<.001&&(y=1),this.x=(p-g)/y,this.y=(u-x)/y,this.z=(h-d)/y,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mc=class extends Gi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new en(0,0,t,e),this.scissorTest=!1,this.viewport=new en(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:si,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Eo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends Mc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Pa=class extends ri{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Fn,this.minFilter=Fn,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Sc=class extends ri{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Fn,this.minFilter=Fn,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Xe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,d,u,h,f,g,x,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,d,u,h,f,g,x,p)}set(t,e,i,s,r,o,a,l,c,d,u,h,f,g,x,p){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=d,m[10]=u,m[14]=h,m[3]=f,m[7]=g,m[11]=x,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/so.setFromMatrixColumn(t,0).length(),r=1/so.setFromMatrixColumn(t,1).length(),o=1/so.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),d=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let h=o*d,f=o*u,g=a*d,x=a*u;e[0]=l*d,e[4]=-l*u,e[8]=c,e[1]=f+g*c,e[5]=h-x*c,e[9]=-a*l,e[2]=x-h*c,e[6]=g+f*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*d,f=l*u,g=c*d,x=c*u;e[0]=h+x*a,e[4]=g*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*d,e[9]=-a,e[2]=f*a-g,e[6]=x+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*d,f=l*u,g=c*d,x=c*u;e[0]=h-x*a,e[4]=-o*u,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*d,e[9]=x-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*d,f=o*u,g=a*d,x=a*u;e[0]=l*d,e[4]=g*c-f,e[8]=h*c+x,e[1]=l*u,e[5]=x*c+h,e[9]=f*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,f=o*c,g=a*l,x=a*c;e[0]=l*d,e[4]=x-h*u,e[8]=g*u+f,e[1]=u,e[5]=o*d,e[9]=-a*d,e[2]=-c*d,e[6]=f*u+g,e[10]=h-x*u}else if(t.order==="XZY"){let h=o*l,f=o*c,g=a*l,x=a*c;e[0]=l*d,e[4]=-u,e[8]=c*d,e[1]=h*u+x,e[5]=o*d,e[9]=f*u-g,e[2]=g*u-f,e[6]=a*d,e[10]=x*u+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Kx,t,jx)}lookAt(t,e,i){let s=this.elements;return gi.subVectors(t,e),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),js.crossVectors(i,gi),js.lengthSq()===0&&(Math.abs(i.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),js.crossVectors(i,gi)),js.normalize(),Ol.crossVectors(gi,js),s[0]=js.x,s[4]=Ol.x,s[8]=gi.x,s[1]=js.y,s[5]=Ol.y,s[9]=gi.y,s[2]=js.z,s[6]=Ol.z,s[10]=gi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],d=i[1],u=i[5],h=i[9],f=i[13],g=i[2],x=i[6],p=i[10],m=i[14],y=i[3],S=i[7],v=i[11],E=i[15],w=s[0],_=s[4],b=s[8],B=s[12],I=s[1],P=s[5],O=s[9],z=s[13],C=s[2],N=s[6],U=s[10],k=s[14],$=s[3],V=s[7],X=s[11],J=s[15];return r[0]=o*w+a*I+l*C+c*$,r[4]=o*_+a*P+l*N+c*V,r[8]=o*b+a*O+l*U+c*X,r[12]=o*B+a*z+l*k+c*J,r[1]=d*w+u*I+h*C+f*$,r[5]=d*_+u*P+h*N+f*V,r[9]=d*b+u*O+h*U+f*X,r[13]=d*B+u*z+h*k+f*J,r[2]=g*w+x*I+p*C+m*$,r[6]=g*_+x*P+p*N+m*V,r[10]=g*b+x*O+p*U+m*X,r[14]=g*B+x*z+p*k+m*J,r[3]=y*w+S*I+v*C+E*$,r[7]=y*_+S*P+v*N+E*V,r[11]=y*b+S*O+v*U+E*X,r[15]=y*B+S*z+v*k+E*J,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],d=t[2],u=t[6],h=t[10],f=t[14],g=t[3],x=t[7],p=t[11],m=t[15],y=l*f-c*h,S=a*f-c*u,v=a*h-l*u,E=o*f-c*d,w=o*h-l*d,_=o*u-a*d;return e*(x*y-p*S+m*v)-i*(g*y-p*E+m*w)+s*(g*S-x*E+m*_)-r*(g*v-x*w+p*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],d=t[10];return e*(o*d-a*c)-i*(r*d-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],d=t[8],u=t[9],h=t[10],f=t[11],g=t[12],x=t[13],p=t[14],m=t[15],y=e*a-i*o,S=e*l-s*o,v=e*c-r*o,E=i*l-s*a,w=i*c-r*a,_=s*c-r*l,b=d*x-u*g,B=d*p-h*g,I=d*m-f*g,P=u*p-h*x,O=u*m-f*x,z=h*m-f*p,C=y*z-S*O+v*P+E*I-w*B+_*b;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let N=1/C;return t[0]=(a*z-l*O+c*P)*N,t[1]=(s*O-i*z-r*P)*N,t[2]=(x*_-p*w+m*E)*N,t[3]=(h*w-u*_-f*E)*N,t[4]=(l*I-o*z-c*B)*N,t[5]=(e*z-s*I+r*B)*N,t[6]=(p*v-g*_-m*S)*N,t[7]=(d*_-h*v+f*S)*N,t[8]=(o*O-a*I+c*b)*N,t[9]=(i*I-e*O-r*b)*N,t[10]=(g*w-x*v+m*y)*N,t[11]=(u*v-d*w-f*y)*N,t[12]=(a*B-o*P-l*b)*N,t[13]=(e*P-i*B+s*b)*N,t[14]=(x*S-g*E-p*y)*N,t[15]=(d*E-u*S+h*y)*N,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,d=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,d*a+i,d*l-s*o,0,c*l-s*a,d*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,d=o+o,u=a+a,h=r*c,f=r*d,g=r*u,x=o*d,p=o*u,m=a*u,y=l*c,S=l*d,v=l*u,E=i.x,w=i.y,_=i.z;return s[0]=(1-(x+m))*E,s[1]=(f+v)*E,s[2]=(g-S)*E,s[3]=0,s[4]=(f-v)*w,s[5]=(1-(h+m))*w,s[6]=(p+y)*w,s[7]=0,s[8]=(g+S)*_,s[9]=(p-y)*_,s[10]=(1-(h+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=so.set(s[0],s[1],s[2]).length(),a=so.set(s[4],s[5],s[6]).length(),l=so.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ki.copy(this);let c=1/o,d=1/a,u=1/l;return ki.elements[0]*=c,ki.elements[1]*=c,ki.elements[2]*=c,ki.elements[4]*=d,ki.elements[5]*=d,ki.elements[6]*=d,ki.elements[8]*=u,ki.elements[9]*=u,ki.elements[10]*=u,e.setFromRotationMatrix(ki),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Ci,l=!1){let c=this.elements,d=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Ci)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===bo)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ci,l=!1){let c=this.elements,d=2/(e-t),u=2/(i-s),h=-(e+t)/(e-t),f=-(i+s)/(i-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Ci)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===bo)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=d,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},so=new K,ki=new Xe,Kx=new K(0,0,0),jx=new K(1,1,1),js=new K,Ol=new K,gi=new K,$p=new Xe,Yp=new yi,Is=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],d=s[9],u=s[2],h=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-d,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-d,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-d,f),this._y=0);break;default:ee("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return $p.makeRotationFromQuaternion(t),this.setFromRotationMatrix($p,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Yp.setFromEuler(this),this.setFromQuaternion(Yp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Is.DEFAULT_ORDER="XYZ";var Ia=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Qx=0,Zp=new K,ro=new yi,bs=new Xe,Bl=new K,pa=new K,ty=new K,ey=new yi,Jp=new K(1,0,0),Kp=new K(0,1,0),jp=new K(0,0,1),Qp={type:"added"},ny={type:"removed"},oo={type:"childadded",child:null},Wu={type:"childremoved",child:null},Vn=class n extends Gi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Qx++}),this.uuid=ur(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new K,e=new Is,i=new yi,s=new K(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xe},normalMatrix:{value:new he}}),this.matrix=new Xe,this.matrixWorld=new Xe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ia,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ro.setFromAxisAngle(t,e),this.quaternion.multiply(ro),this}rotateOnWorldAxis(t,e){return ro.setFromAxisAngle(t,e),this.quaternion.premultiply(ro),this}rotateX(t){return this.rotateOnAxis(Jp,t)}rotateY(t){return this.rotateOnAxis(Kp,t)}rotateZ(t){return this.rotateOnAxis(jp,t)}translateOnAxis(t,e){return Zp.copy(t).applyQuaternion(this.quaternion),this.position.add(Zp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Jp,t)}translateY(t){return this.translateOnAxis(Kp,t)}translateZ(t){return this.translateOnAxis(jp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(bs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Bl.copy(t):Bl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),pa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bs.lookAt(pa,Bl,this.up):bs.lookAt(Bl,pa,this.up),this.quaternion.setFromRotationMatrix(bs),s&&(bs.extractRotation(s.matrixWorld),ro.setFromRotationMatrix(bs),this.quaternion.premultiply(ro.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(re("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Qp),oo.child=t,this.dispatchEvent(oo),oo.child=null):re("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(ny),Wu.child=t,this.dispatchEvent(Wu),Wu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),bs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),bs.multiply(t.parent.matrixWorld)),t.applyMatrix4(bs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Qp),oo.child=t,this.dispatchEvent(oo),oo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pa,t,ty),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(pa,ey,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,d=l.length;c<d;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),d=o(t.images),u=o(t.shapes),h=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),d.length>0&&(i.images=d),u.length>0&&(i.shapes=u),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let d=a[c];delete d.metadata,l.push(d)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new K(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wr=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},iy={type:"move"},Ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new wr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new wr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new wr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let p=e.getJointPose(x,i),m=this._getHandJoint(c,x);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let d=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],h=d.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&h>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(iy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new wr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},eg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qs={h:0,s:0,l:0},kl={h:0,s:0,l:0};function Xu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var fe=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=i,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Se.workingColorSpace){if(t=Vd(t,1),e=xe(e,0,1),i=xe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Xu(o,r,t+1/3),this.g=Xu(o,r,t),this.b=Xu(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=ei){function i(r){r!==void 0&&parseFloat(r)<1&&ee("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:ee("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);ee("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ei){let i=eg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):ee("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Cs(t.r),this.g=Cs(t.g),this.b=Cs(t.b),this}copyLinearToSRGB(t){return this.r=Mo(t.r),this.g=Mo(t.g),this.b=Mo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ei){return Se.workingToColorSpace(qn.copy(this),t),Math.round(xe(qn.r*255,0,255))*65536+Math.round(xe(qn.g*255,0,255))*256+Math.round(xe(qn.b*255,0,255))}getHexString(t=ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace(qn.copy(this),e);let i=qn.r,s=qn.g,r=qn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,d=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=d<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=d,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace(qn.copy(this),e),t.r=qn.r,t.g=qn.g,t.b=qn.b,t}getStyle(t=ei){Se.workingToColorSpace(qn.copy(this),t);let e=qn.r,i=qn.g,s=qn.b;return t!==ei?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Qs),this.setHSL(Qs.h+t,Qs.s+e,Qs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Qs),t.getHSL(kl);let i=wa(Qs.h,kl.h,e),s=wa(Qs.s,kl.s,e),r=wa(Qs.l,kl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qn=new fe;fe.NAMES=eg;var La=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Is,this.environmentIntensity=1,this.environmentRotation=new Is,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},zi=new K,ws=new K,qu=new K,Ts=new K,ao=new K,lo=new K,tm=new K,$u=new K,Yu=new K,Zu=new K,Ju=new en,Ku=new en,ju=new en,Rs=class n{constructor(t=new K,e=new K,i=new K){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),zi.subVectors(t,e),s.cross(zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){zi.subVectors(s,e),ws.subVectors(i,e),qu.subVectors(t,e);let o=zi.dot(zi),a=zi.dot(ws),l=zi.dot(qu),c=ws.dot(ws),d=ws.dot(qu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let h=1/u,f=(c*l-a*d)*h,g=(o*d-a*l)*h;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(o,Ts.y),l.addScaledVector(a,Ts.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Ju.setScalar(0),Ku.setScalar(0),ju.setScalar(0),Ju.fromBufferAttribute(t,e),Ku.fromBufferAttribute(t,i),ju.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Ju,r.x),o.addScaledVector(Ku,r.y),o.addScaledVector(ju,r.z),o}static isFrontFacing(t,e,i,s){return zi.subVectors(i,e),ws.subVectors(t,e),zi.cross(ws).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return zi.subVectors(this.c,this.b),ws.subVectors(this.a,this.b),zi.cross(ws).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;ao.subVectors(s,i),lo.subVectors(r,i),$u.subVectors(t,i);let l=ao.dot($u),c=lo.dot($u);if(l<=0&&c<=0)return e.copy(i);Yu.subVectors(t,s);let d=ao.dot(Yu),u=lo.dot(Yu);if(d>=0&&u<=d)return e.copy(s);let h=l*u-d*c;if(h<=0&&l>=0&&d<=0&&l-d>0)return o=l/(l-d),e.copy(i).addScaledVector(ao,o);Zu.subVectors(t,r);let f=ao.dot(Zu),g=lo.dot(Zu);if(g>=0&&f<=g)return e.copy(r);let x=f*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(lo,a);let p=d*g-f*u;if(p<=0&&u-d>=0&&f-g>=0)return tm.subVectors(r,s),a=(u-d)/(u-d+(f-g)),e.copy(s).addScaledVector(tm,a);let m=1/(p+x+h);return o=x*m,a=h*m,e.copy(i).addScaledVector(ao,o).addScaledVector(lo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Pi=class{constructor(t=new K(1/0,1/0,1/0),e=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Vi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Vi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Vi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Vi):Vi.fromBufferAttribute(r,o),Vi.applyMatrix4(t.matrixWorld),this.expandByPoint(Vi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),zl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),zl.copy(i.boundingBox)),zl.applyMatrix4(t.matrixWorld),this.union(zl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Vi),Vi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ma),Vl.subVectors(this.max,ma),co.subVectors(t.a,ma),ho.subVectors(t.b,ma),uo.subVectors(t.c,ma),tr.subVectors(ho,co),er.subVectors(uo,ho),vr.subVectors(co,uo);let e=[0,-tr.z,tr.y,0,-er.z,er.y,0,-vr.z,vr.y,tr.z,0,-tr.x,er.z,0,-er.x,vr.z,0,-vr.x,-tr.y,tr.x,0,-er.y,er.x,0,-vr.y,vr.x,0];return!Qu(e,co,ho,uo,Vl)||(e=[1,0,0,0,1,0,0,0,1],!Qu(e,co,ho,uo,Vl))?!1:(Gl.crossVectors(tr,er),e=[Gl.x,Gl.y,Gl.z],Qu(e,co,ho,uo,Vl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Vi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Vi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Es[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Es[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Es[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Es[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Es[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Es[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Es[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Es[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Es),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Es=[new K,new K,new K,new K,new K,new K,new K,new K],Vi=new K,zl=new Pi,co=new K,ho=new K,uo=new K,tr=new K,er=new K,vr=new K,ma=new K,Vl=new K,Gl=new K,Mr=new K;function Qu(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Mr.fromArray(n,r);let a=s.x*Math.abs(Mr.x)+s.y*Math.abs(Mr.y)+s.z*Math.abs(Mr.z),l=t.dot(Mr),c=e.dot(Mr),d=i.dot(Mr);if(Math.max(-Math.max(l,c,d),Math.min(l,c,d))>a)return!1}return!0}var vn=new K,Hl=new Kt,sy=0,ii=class extends Gi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:sy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=kd,this.updateRanges=[],this.gpuType=Wi,this.version=0,this._normalizationScale=t!==void 0?Lh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Hl.fromBufferAttribute(this,e),Hl.applyMatrix3(t),this.setXY(e,Hl.x,Hl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)vn.fromBufferAttribute(this,e),vn.applyMatrix3(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)vn.fromBufferAttribute(this,e),vn.applyMatrix4(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)vn.fromBufferAttribute(this,e),vn.applyNormalMatrix(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)vn.fromBufferAttribute(this,e),vn.transformDirection(t),this.setXYZ(e,vn.x,vn.y,vn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Hd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Wd(t,this.array)}};var Da=class extends ii{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Na=class extends ii{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var fn=class extends ii{constructor(t,e,i){super(new Float32Array(t),e,i)}},ry=new Pi,ga=new K,td=new K,Tr=class{constructor(t=new K,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):ry.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ga.subVectors(t,this.center);let e=ga.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ga,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(td.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ga.copy(t.center).add(td)),this.expandByPoint(ga.copy(t.center).sub(td))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},oy=0,Ri=new Xe,ed=new Vn,fo=new K,_i=new Pi,_a=new Pi,Un=new K,On=class n extends Gi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:oy++}),this.uuid=ur(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Ix(t)?Na:Da)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new he().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ri.makeRotationFromQuaternion(t),this.applyMatrix4(Ri),this}rotateX(t){return Ri.makeRotationX(t),this.applyMatrix4(Ri),this}rotateY(t){return Ri.makeRotationY(t),this.applyMatrix4(Ri),this}rotateZ(t){return Ri.makeRotationZ(t),this.applyMatrix4(Ri),this}translate(t,e,i){return Ri.makeTranslation(t,e,i),this.applyMatrix4(Ri),this}scale(t,e,i){return Ri.makeScale(t,e,i),this.applyMatrix4(Ri),this}lookAt(t){return ed.lookAt(t),ed.updateMatrix(),this.applyMatrix4(ed.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(fo).negate(),this.translate(fo.x,fo.y,fo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new fn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&ee("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&re('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){re("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(t){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];_a.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(_i.min,_a.min),_i.expandByPoint(Un),Un.addVectors(_i.max,_a.max),_i.expandByPoint(Un)):(_i.expandByPoint(_a.min),_i.expandByPoint(_a.max))}_i.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Un.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Un));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,d=a.count;c<d;c++)Un.fromBufferAttribute(a,c),l&&(fo.fromBufferAttribute(t,c),Un.add(fo)),s=Math.max(s,i.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&re('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){re("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ii(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new K,l[B]=new K;let d=new K,u=new K,h=new K,f=new Kt,g=new Kt,x=new Kt,p=new K,m=new K;function y(B,I,P){c[B]=c[I]=c[P]=1,d.fromBufferAttribute(i,B),u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,P),f.fromBufferAttribute(r,B),g.fromBufferAttribute(r,I),x.fromBufferAttribute(r,P),u.sub(d),h.sub(d),g.sub(f),x.sub(f);let O=1/(g.x*x.y-x.x*g.y);isFinite(O)&&(p.copy(u).multiplyScalar(x.y).addScaledVector(h,-g.y).multiplyScalar(O),m.copy(h).multiplyScalar(g.x).addScaledVector(u,-x.x).multiplyScalar(O),a[B].add(p),a[I].add(p),a[P].add(p),l[B].add(m),l[I].add(m),l[P].add(m))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let B=0,I=S.length;B<I;++B){let P=S[B],O=P.start,z=P.count;for(let C=O,N=O+z;C<N;C+=3)y(t.getX(C+0),t.getX(C+1),t.getX(C+2))}let v=new K,E=new K,w=new K,_=new K;function b(B){w.fromBufferAttribute(s,B),_.copy(w);let I=a[B];v.copy(I),v.sub(w.multiplyScalar(w.dot(I))).normalize(),E.crossVectors(_,I);let O=E.dot(l[B])<0?-1:1;o.setXYZW(B,v.x,v.y,v.z,O)}for(let B=0,I=i.count;B<I;++B)c[B]&&b(B);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ii(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,d=new K,u=new K;if(t)for(let h=0,f=t.count;h<f;h+=3){let g=t.getX(h+0),x=t.getX(h+1),p=t.getX(h+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,p),d.subVectors(o,r),u.subVectors(s,r),d.cross(u),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,p),a.add(d),l.add(d),c.add(d),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(p,c.x,c.y,c.z)}else for(let h=0,f=e.count;h<f;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),d.subVectors(o,r),u.subVectors(s,r),d.cross(u),i.setXYZ(h+0,d.x,d.y,d.z),i.setXYZ(h+1,d.x,d.y,d.z),i.setXYZ(h+2,d.x,d.y,d.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Un.fromBufferAttribute(t,e),Un.normalize(),t.setXYZ(e,Un.x,Un.y,Un.z)}toNonIndexed(){function t(a,l){let c=a.array,d=a.itemSize,u=a.normalized,h=new c.constructor(l.length*d),f=0,g=0;for(let x=0,p=l.length;x<p;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*d;for(let m=0;m<d;m++)h[g++]=c[f++]}return new ii(h,d,u)}if(this.index===null)return ee("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let d=0,u=c.length;d<u;d++){let h=c[d],f=t(h,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],d=[];for(let u=0,h=c.length;u<h;u++){let f=c[u];d.push(f.toJSON(t.data))}d.length>0&&(s[l]=d,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let d=s[c];this.setAttribute(c,d.clone(e))}let r=t.morphAttributes;for(let c in r){let d=[],u=r[c];for(let h=0,f=u.length;h<f;h++)d.push(u[h].clone(e));this.morphAttributes[c]=d}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,d=o.length;c<d;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},bc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=kd,this.updateRanges=[],this.version=0,this.uuid=ur()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=em(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=em(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function em(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=ur()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ti=new K,Ua=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Lh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.applyMatrix4(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.applyNormalMatrix(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.transformDirection(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Ca("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new ii(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Ca("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Hd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Wd(t,this.data.array)}},nd=new K,ay=new K,ly=new he,xi=class{constructor(t=new K(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=nd.subVectors(i,e).cross(ay.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(nd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||ly.getNormalMatrix(t),s=this.coplanarPoint(nd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},cy=0,ls=class extends Gi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:cy++}),this.uuid=ur(),this.name="",this.type="Material",this.blending=Do,this.side=hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=yd,this.blendDst=vd,this.blendEquation=Cr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new fe(0,0,0),this.blendAlpha=0,this.depthFunc=So,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cc,this.stencilZFail=cc,this.stencilZPass=cc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){ee(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){ee(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new fe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new xi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Kt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Ro=class extends ls{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new fe(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},po,xa=new K,mo=new K,go=new K,_o=new Kt,ya=new Kt,ng=new Xe,Wl=new K,va=new K,Xl=new K,nm=new Kt,id=new Kt,im=new Kt,Fa=class extends Vn{constructor(t=new Ro){if(super(),this.isSprite=!0,this.type="Sprite",po===void 0){po=new On;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new bc(e,5);po.setIndex([0,1,2,0,2,3]),po.setAttribute("position",new Ua(i,3,0,!1)),po.setAttribute("uv",new Ua(i,2,3,!1))}this.geometry=po,this.material=t,this.center=new Kt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&re('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),mo.setFromMatrixScale(this.matrixWorld),ng.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),go.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&mo.multiplyScalar(-go.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;ql(Wl.set(-.5,-.5,0),go,o,mo,s,r),ql(va.set(.5,-.5,0),go,o,mo,s,r),ql(Xl.set(.5,.5,0),go,o,mo,s,r),nm.set(0,0),id.set(1,0),im.set(1,1);let a=t.ray.intersectTriangle(Wl,va,Xl,!1,xa);if(a===null&&(ql(va.set(-.5,.5,0),go,o,mo,s,r),id.set(0,1),a=t.ray.intersectTriangle(Wl,Xl,va,!1,xa),a===null))return;let l=t.ray.origin.distanceTo(xa);l<t.near||l>t.far||e.push({distance:l,point:xa.clone(),uv:Rs.getInterpolation(xa,Wl,va,Xl,nm,id,im,new Kt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function ql(n,t,e,i,s,r){_o.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(ya.x=r*_o.x-s*_o.y,ya.y=s*_o.x+r*_o.y):ya.copy(_o),n.copy(t),n.x+=ya.x,n.y+=ya.y,n.applyMatrix4(ng)}var As=new K,sd=new K,$l=new K,Yl=new K,Er=class{constructor(t=new K,e=new K(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,As)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=As.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(As.copy(this.origin).addScaledVector(this.direction,e),As.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){sd.copy(t).add(e).multiplyScalar(.5),$l.copy(e).sub(t).normalize(),Yl.copy(this.origin).sub(sd);let r=t.distanceTo(e)*.5,o=-this.direction.dot($l),a=Yl.dot(this.direction),l=-Yl.dot($l),c=Yl.lengthSq(),d=Math.abs(1-o*o),u,h,f,g;if(d>0)if(u=o*l-a,h=o*a-l,g=r*d,u>=0)if(h>=-g)if(h<=g){let x=1/d;u*=x,h*=x,f=u*(u+o*h+2*a)+h*(o*u+h+2*l)+c}else h=r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;else h=-r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;else h<=-g?(u=Math.max(0,-(-o*r+a)),h=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+h*(h+2*l)+c):h<=g?(u=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(u=Math.max(0,-(o*r+a)),h=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+h*(h+2*l)+c);else h=o>0?-r:r,u=Math.max(0,-(o*h+a)),f=-u*u+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(sd).addScaledVector($l,h),f}intersectSphere(t,e){if(t.radius<0)return null;As.subVectors(t.center,this.origin);let i=As.dot(this.direction),s=As.dot(As)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,d=1/this.direction.y,u=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),d>=0?(r=(t.min.y-h.y)*d,o=(t.max.y-h.y)*d):(r=(t.max.y-h.y)*d,o=(t.min.y-h.y)*d),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-h.z)*u,l=(t.max.z-h.z)*u):(a=(t.max.z-h.z)*u,l=(t.min.z-h.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,As)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,d=a.z,u=t.x-o.x,h=t.y-o.y,f=t.z-o.z,g=e.x-o.x,x=e.y-o.y,p=e.z-o.z,m=i.x-o.x,y=i.y-o.y,S=i.z-o.z,v=Math.abs(l),E=Math.abs(c),w=Math.abs(d),_,b,B,I,P,O,z,C,N,U,k,$;if(v>=E&&v>=w?(B=l,O=u,N=g,$=m,l>=0?(_=c,b=d,I=h,P=f,z=x,C=p,U=y,k=S):(_=d,b=c,I=f,P=h,z=p,C=x,U=S,k=y)):E>=w?(B=c,O=h,N=x,$=y,c>=0?(_=d,b=l,I=f,P=u,z=p,C=g,U=S,k=m):(_=l,b=d,I=u,P=f,z=g,C=p,U=m,k=S)):(B=d,O=f,N=p,$=S,d>=0?(_=l,b=c,I=u,P=h,z=g,C=x,U=m,k=y):(_=c,b=l,I=h,P=u,z=x,C=g,U=y,k=m)),B===0)return null;let V=_/B,X=b/B,J=1/B,nt=I-V*O,Q=P-X*O,W=z-V*N,st=C-X*N,ht=U-V*$,ct=k-X*$,gt=ht*st-ct*W,xt=nt*ct-Q*ht,Ut=W*Q-st*nt;if(s){if(gt<0||xt<0||Ut<0)return null}else if((gt<0||xt<0||Ut<0)&&(gt>0||xt>0||Ut>0))return null;let Lt=gt+xt+Ut;if(Lt===0)return null;let Qt=J*(gt*O+xt*N+Ut*$);return(Lt>0?Qt<0:Qt>0)?null:this.at(Qt/Lt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},wc=class extends ls{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=Xc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},sm=new Xe,Sr=new Er,Zl=new Tr,rm=new K,Jl=new K,Kl=new K,jl=new K,rd=new K,Ql=new K,om=new K,tc=new K,$n=class extends Vn{constructor(t=new On,e=new wc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ql.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let d=a[l],u=r[l];d!==0&&(rd.fromBufferAttribute(u,t),o?Ql.addScaledVector(rd,d):Ql.addScaledVector(rd.sub(e),d))}e.add(Ql)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Zl.copy(i.boundingSphere),Zl.applyMatrix4(r),Sr.copy(t.ray).recast(t.near),!(Zl.containsPoint(Sr.origin)===!1&&(Sr.intersectSphere(Zl,rm)===null||Sr.origin.distanceToSquared(rm)>(t.far-t.near)**2))&&(sm.copy(r).invert(),Sr.copy(t.ray).applyMatrix4(sm),!(i.boundingBox!==null&&Sr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Sr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,d=r.attributes.uv1,u=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=h.length;g<x;g++){let p=h[g],m=o[p.materialIndex],y=Math.max(p.start,f.start),S=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let v=y,E=S;v<E;v+=3){let w=a.getX(v),_=a.getX(v+1),b=a.getX(v+2);s=ec(this,m,t,i,c,d,u,w,_,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let p=g,m=x;p<m;p+=3){let y=a.getX(p),S=a.getX(p+1),v=a.getX(p+2);s=ec(this,o,t,i,c,d,u,y,S,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=h.length;g<x;g++){let p=h[g],m=o[p.materialIndex],y=Math.max(p.start,f.start),S=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let v=y,E=S;v<E;v+=3){let w=v,_=v+1,b=v+2;s=ec(this,m,t,i,c,d,u,w,_,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let p=g,m=x;p<m;p+=3){let y=p,S=p+1,v=p+2;s=ec(this,o,t,i,c,d,u,y,S,v),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function hy(n,t,e,i,s,r,o,a){let l;if(t.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===hs,a),l===null)return null;tc.copy(a),tc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(tc);return c<e.near||c>e.far?null:{distance:c,point:tc.clone(),object:n}}function ec(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Jl),n.getVertexPosition(l,Kl),n.getVertexPosition(c,jl);let d=hy(n,t,e,i,Jl,Kl,jl,om);if(d){let u=new K;Rs.getBarycoord(om,Jl,Kl,jl,u),s&&(d.uv=Rs.getInterpolatedAttribute(s,a,l,c,u,new Kt)),r&&(d.uv1=Rs.getInterpolatedAttribute(r,a,l,c,u,new Kt)),o&&(d.normal=Rs.getInterpolatedAttribute(o,a,l,c,u,new K),d.normal.dot(i.direction)>0&&d.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new K,materialIndex:0};Rs.getNormal(Jl,Kl,jl,h.normal),d.face=h,d.barycoord=u}return d}var Tc=class extends ri{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Fn,d=Fn,u,h){super(null,o,a,l,c,d,s,r,u,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var br=new Tr,uy=new Kt(.5,.5),nc=new K,ir=class{constructor(t=new xi,e=new xi,i=new xi,s=new xi,r=new xi,o=new xi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ci,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],d=r[4],u=r[5],h=r[6],f=r[7],g=r[8],x=r[9],p=r[10],m=r[11],y=r[12],S=r[13],v=r[14],E=r[15];if(s[0].setComponents(c-o,f-d,m-g,E-y).normalize(),s[1].setComponents(c+o,f+d,m+g,E+y).normalize(),s[2].setComponents(c+a,f+u,m+x,E+S).normalize(),s[3].setComponents(c-a,f-u,m-x,E-S).normalize(),i)s[4].setComponents(l,h,p,v).normalize(),s[5].setComponents(c-l,f-h,m-p,E-v).normalize();else if(s[4].setComponents(c-l,f-h,m-p,E-v).normalize(),e===Ci)s[5].setComponents(c+l,f+h,m+p,E+v).normalize();else if(e===bo)s[5].setComponents(l,h,p,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),br.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),br.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(br)}intersectsSprite(t){br.center.set(0,0,0);let e=uy.distanceTo(t.center);return br.radius=.7071067811865476+e,br.applyMatrix4(t.matrixWorld),this.intersectsSphere(br)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(nc.x=s.normal.x>0?t.max.x:t.min.x,nc.y=s.normal.y>0?t.max.y:t.min.y,nc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(nc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},am=new Xe,Ec=class n{constructor(){this.coordinateSystem=Ci,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];am.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new ir),i[s].setFromProjectionMatrix(am,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new ir),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var sr=class extends ls{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new fe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ac=new K,Rc=new K,lm=new Xe,Ma=new Er,ic=new Tr,od=new K,cm=new K,Cc=class extends Vn{constructor(t=new On,e=new sr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ac.fromBufferAttribute(e,s-1),Rc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ac.distanceTo(Rc);t.setAttribute("lineDistance",new fn(i,1))}else ee("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ic.copy(i.boundingSphere),ic.applyMatrix4(s),ic.radius+=r,t.ray.intersectsSphere(ic)===!1)return;lm.copy(s).invert(),Ma.copy(t.ray).applyMatrix4(lm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,d=i.index,h=i.attributes.position;if(d!==null){let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let x=f,p=g-1;x<p;x+=c){let m=d.getX(x),y=d.getX(x+1),S=sc(this,t,Ma,l,m,y,x);S&&e.push(S)}if(this.isLineLoop){let x=d.getX(g-1),p=d.getX(f),m=sc(this,t,Ma,l,x,p,g-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let x=f,p=g-1;x<p;x+=c){let m=sc(this,t,Ma,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=sc(this,t,Ma,l,g-1,f,g-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function sc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ac.fromBufferAttribute(a,s),Rc.fromBufferAttribute(a,r),e.distanceSqToSegment(Ac,Rc,od,cm)>i)return;od.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(od);if(!(c<t.near||c>t.far))return{distance:c,point:cm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var hm=new K,um=new K,Ar=class extends Cc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)hm.fromBufferAttribute(e,s),um.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+hm.distanceTo(um);t.setAttribute("lineDistance",new fn(i,1))}else ee("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Oa=class extends ri{constructor(t=[],e=Pr,i,s,r,o,a,l,c,d){super(t,e,i,s,r,o,a,l,c,d),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Ba=class extends ri{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ls=class extends ri{constructor(t,e,i=Hi,s,r,o,a=Fn,l=Fn,c,d=Ps,u=1){if(d!==Ps&&d!==Us)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:u};super(h,s,r,o,a,l,d,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Eo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ka=class extends Ls{constructor(t,e=Hi,i=Pr,s,r,o=Fn,a=Fn,l,c=Ps){let d={width:t,height:t,depth:1},u=[d,d,d,d,d,d];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},za=class extends ri{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Co=class n extends On{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],d=[],u=[],h=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new fn(c,3)),this.setAttribute("normal",new fn(d,3)),this.setAttribute("uv",new fn(u,2));function g(x,p,m,y,S,v,E,w,_,b,B){let I=v/_,P=E/b,O=v/2,z=E/2,C=w/2,N=_+1,U=b+1,k=0,$=0,V=new K;for(let X=0;X<U;X++){let J=X*P-z;for(let nt=0;nt<N;nt++){let Q=nt*I-O;V[x]=Q*y,V[p]=J*S,V[m]=C,c.push(V.x,V.y,V.z),V[x]=0,V[p]=0,V[m]=w>0?1:-1,d.push(V.x,V.y,V.z),u.push(nt/_),u.push(1-X/b),k+=1}}for(let X=0;X<b;X++)for(let J=0;J<_;J++){let nt=h+J+N*X,Q=h+J+N*(X+1),W=h+(J+1)+N*(X+1),st=h+(J+1)+N*X;l.push(nt,Q,st),l.push(Q,W,st),$+=6}a.addGroup(f,$,B),f+=$,h+=k}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Va=class n extends On{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,d=l+1,u=t/a,h=e/l,f=[],g=[],x=[],p=[];for(let m=0;m<d;m++){let y=m*h-o;for(let S=0;S<c;S++){let v=S*u-r;g.push(v,-y,0),x.push(0,0,1),p.push(S/a),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<a;y++){let S=y+c*m,v=y+c*(m+1),E=y+1+c*(m+1),w=y+1+c*m;f.push(S,v,w),f.push(v,E,w)}this.setIndex(f),this.setAttribute("position",new fn(g,3)),this.setAttribute("normal",new fn(x,3)),this.setAttribute("uv",new fn(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function Lr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(dm(s))s.isRenderTargetTexture?(ee("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(dm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Yn(n){let t={};for(let e=0;e<n.length;e++){let i=Lr(n[e]);for(let s in i)t[s]=i[s]}return t}function dm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function dy(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function qd(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var ig={clone:Lr,merge:Yn},fy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,py=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,cs=class extends ls{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=fy,this.fragmentShader=py,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Lr(t.uniforms),this.uniformsGroups=dy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new fe().setHex(s.value);break;case"v2":this.uniforms[i].value=new Kt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new K().fromArray(s.value);break;case"v4":this.uniforms[i].value=new en().fromArray(s.value);break;case"m3":this.uniforms[i].value=new he().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Xe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Pc=class extends cs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ds=class extends ls{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ih,this.normalScale=new Kt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=Xc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Ic=class extends ls{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Hm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Lc=class extends ls{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function xo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function rc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var rr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dc=class extends rr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:cd,endingEnd:cd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case hd:r=t,a=2*e-i;break;case ud:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case hd:o=t,l=2*i-e;break;case ud:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,d=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*d,this._offsetNext=o*d}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=this._offsetPrev,u=this._offsetNext,h=this._weightPrev,f=this._weightNext,g=(i-e)/(s-e),x=g*g,p=x*g,m=-h*p+2*h*x-h*g,y=(1+h)*p+(-1.5-2*h)*x+(-.5+h)*g+1,S=(-1-f)*p+(1.5+f)*x+.5*g,v=f*p-f*x;for(let E=0;E!==a;++E)r[E]=m*o[d+E]+y*o[c+E]+S*o[l+E]+v*o[u+E];return r}},Nc=class extends rr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=(i-e)/(s-e),u=1-d;for(let h=0;h!==a;++h)r[h]=o[c+h]*u+o[l+h]*d;return r}},Uc=class extends rr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Fc=class extends rr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,d=this.inTangents,u=this.outTangents;if(!d||!u){let g=(i-e)/(s-e),x=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*x+o[l+p]*g;return r}let h=a*2,f=t-1;for(let g=0;g!==a;++g){let x=o[c+g],p=o[l+g],m=f*h+g*2,y=u[m],S=u[m+1],v=t*h+g*2,E=d[v],w=d[v+1],_=gy(i,e,y,E,s);r[g]=sg(_,x,S,w,p)}return r}};function sg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function my(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function gy(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=sg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=my(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Mi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=xo(e,this.TimeBufferType),this.values=xo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:xo(t.times,Array),values:xo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),rc(t.settings)&&(i.settings={inTangents:xo(t.settings.inTangents,Array),outTangents:xo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Uc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Nc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Fc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ta:e=this.InterpolantFactoryMethodDiscrete;break;case yc:e=this.InterpolantFactoryMethodLinear;break;case lc:e=this.InterpolantFactoryMethodSmooth;break;case ld:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return ee("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ta;case this.InterpolantFactoryMethodLinear:return yc;case this.InterpolantFactoryMethodSmooth:return lc;case this.InterpolantFactoryMethodBezier:return ld}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;rc(this.settings)&&(fm(this.settings.inTangents,t),fm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;rc(this.settings)&&(pm(this.settings.inTangents,t),pm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(re("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(re("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){re("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){re("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Lx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){re("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===lc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],d=t[a+1];if(c!==d&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,h=u-i,f=u+i;for(let g=0;g!==i;++g){let x=e[u+g];if(x!==e[h+g]||x!==e[f+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,h=o*i;for(let f=0;f!==i;++f)e[h+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,rc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function fm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function pm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Mi.prototype.ValueTypeName="";Mi.prototype.TimeBufferType=Float32Array;Mi.prototype.ValueBufferType=Float32Array;Mi.prototype.DefaultInterpolation=yc;var or=class extends Mi{constructor(t,e,i){super(t,e,i)}};or.prototype.ValueTypeName="bool";or.prototype.ValueBufferType=Array;or.prototype.DefaultInterpolation=Ta;or.prototype.InterpolantFactoryMethodLinear=void 0;or.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};Oc.prototype.ValueTypeName="color";var Bc=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};Bc.prototype.ValueTypeName="number";var kc=class extends rr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let d=c+a;c!==d;c+=4)yi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ga=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new kc(this.times,this.values,this.getValueSize(),t)}};Ga.prototype.ValueTypeName="quaternion";Ga.prototype.InterpolantFactoryMethodSmooth=void 0;var ar=class extends Mi{constructor(t,e,i){super(t,e,i)}};ar.prototype.ValueTypeName="string";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Ta;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var zc=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};zc.prototype.ValueTypeName="vector";var Vc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(d){a++,r===!1&&s.onStart!==void 0&&s.onStart(d,o,a),r=!0},this.itemEnd=function(d){o++,s.onProgress!==void 0&&s.onProgress(d,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(d){s.onError!==void 0&&s.onError(d)},this.resolveURL=function(d){return d=d.normalize("NFC"),l?l(d):d},this.setURLModifier=function(d){return l=d,this},this.addHandler=function(d,u){return c.push(d,u),this},this.removeHandler=function(d){let u=c.indexOf(d);return u!==-1&&c.splice(u,2),this},this.getHandler=function(d){for(let u=0,h=c.length;u<h;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(d))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},rg=new Vc,Gc=class{constructor(t){this.manager=t!==void 0?t:rg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Gc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ha=class extends Vn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new fe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var ad=new Xe,mm=new K,gm=new K,Hc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Kt(512,512),this.mapType=ci,this.map=null,this.mapPass=null,this.matrix=new Xe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ir,this._frameExtents=new Kt(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;mm.setFromMatrixPosition(t.matrixWorld),e.position.copy(mm),gm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(gm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){ad.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(ad,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===bo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(ad)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},oc=new K,ac=new yi,os=new K,Wa=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xe,this.projectionMatrix=new Xe,this.projectionMatrixInverse=new Xe,this.coordinateSystem=Ci,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(oc,ac,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,os.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(oc,ac,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,os.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},nr=new K,_m=new Kt,xm=new Kt,ni=class extends Wa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=To*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ba*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return To*2*Math.atan(Math.tan(ba*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){nr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(nr.x,nr.y).multiplyScalar(-t/nr.z),nr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(nr.x,nr.y).multiplyScalar(-t/nr.z)}getViewSize(t,e){return this.getViewBounds(t,_m,xm),e.subVectors(xm,_m)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ba*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Xa=class extends Wa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,d=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=d*this.view.offsetY,l=a-d*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},dd=class extends Hc{constructor(){super(new Xa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},qa=class extends Ha{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new dd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},$a=class extends Ha{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var yo=-90,vo=1,Po=class extends Vn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ni(yo,vo,t,e);s.layers=this.layers,this.add(s);let r=new ni(yo,vo,t,e);r.layers=this.layers,this.add(r);let o=new ni(yo,vo,t,e);o.layers=this.layers,this.add(o);let a=new ni(yo,vo,t,e);a.layers=this.layers,this.add(a);let l=new ni(yo,vo,t,e);l.layers=this.layers,this.add(l);let c=new ni(yo,vo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ci)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===bo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,d]=this.children,u=t.getRenderTarget(),h=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,d),t.setRenderTarget(u,h,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Wc=class extends ni{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var $d="\\[\\]\\.:\\/",_y=new RegExp("["+$d+"]","g"),Yd="[^"+$d+"]",xy="[^"+$d.replace("\\.","")+"]",yy=/((?:WC+[\/:])*)/.source.replace("WC",Yd),vy=/(WCOD+)?/.source.replace("WCOD",xy),My=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Yd),Sy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Yd),by=new RegExp("^"+yy+vy+My+Sy+"$"),wy=["material","materials","bones","map"],fd=class{constructor(t,e,i){let s=i||Ke.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ke=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(_y,"")}static parseTrackName(t){let e=by.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);wy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){ee("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){re("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){re("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let d=0;d<t.length;d++)if(t[d].name===c){c=d;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){re("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){re("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){re("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){re("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;re("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){re("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ke.Composite=fd;Ke.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ke.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ke.prototype.GetterByBindingType=[Ke.prototype._getValue_direct,Ke.prototype._getValue_array,Ke.prototype._getValue_arrayElement,Ke.prototype._getValue_toArray];Ke.prototype.SetterByBindingTypeAndVersioning=[[Ke.prototype._setValue_direct,Ke.prototype._setValue_direct_setNeedsUpdate,Ke.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_array,Ke.prototype._setValue_array_setNeedsUpdate,Ke.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_arrayElement,Ke.prototype._setValue_arrayElement_setNeedsUpdate,Ke.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_fromArray,Ke.prototype._setValue_fromArray_setNeedsUpdate,Ke.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var HE=new Float32Array(1);var Io=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=xe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(xe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var pd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ya=class extends Gi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Zd(n,t,e,i){let s=Ty(i);switch(e){case Dd:return n*t;case Ud:return n*t/s.components*s.byteLength;case jc:return n*t/s.components*s.byteLength;case hr:return n*t*2/s.components*s.byteLength;case Qc:return n*t*2/s.components*s.byteLength;case Nd:return n*t*3/s.components*s.byteLength;case qi:return n*t*4/s.components*s.byteLength;case th:return n*t*4/s.components*s.byteLength;case Ka:case ja:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Qa:case tl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case nh:case sh:return Math.max(n,16)*Math.max(t,8)/4;case eh:case ih:return Math.max(n,8)*Math.max(t,8)/2;case rh:case oh:case lh:case ch:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ah:case el:case hh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case uh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case dh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case fh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case ph:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case mh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case gh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case _h:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case xh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case yh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case vh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Mh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Sh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case bh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case wh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Th:case Eh:case Ah:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Rh:case Ch:return Math.ceil(n/4)*Math.ceil(t/4)*8;case nl:case Ph:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Ty(n){switch(n){case ci:case Cd:return{byteLength:1,components:1};case Uo:case Pd:case Xi:return{byteLength:2,components:1};case Jc:case Kc:return{byteLength:2,components:4};case Hi:case Zc:case Wi:return{byteLength:4,components:1};case Id:case Ld:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ee("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Ag(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Ay(n){let t=new WeakMap;function e(a,l){let c=a.array,d=a.usage,u=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,d),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let d=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,d);else{u.sort((f,g)=>f.start-g.start);let h=0;for(let f=1;f<u.length;f++){let g=u[h],x=u[f];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++h,u[h]=x)}u.length=h+1;for(let f=0,g=u.length;f<g;f++){let x=u[f];n.bufferSubData(c,x.start*d.BYTES_PER_ELEMENT,d,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let d=t.get(a);(!d||d.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ry=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Cy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Py=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Iy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ly=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Dy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ny=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Uy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Fy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Oy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,By=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ky=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,zy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Vy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Gy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Hy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Wy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Xy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,qy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,$y=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Yy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Zy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Jy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Ky=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,jy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Qy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,tv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ev=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,nv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,iv="gl_FragColor = linearToOutputTexel( gl_FragColor );",sv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,rv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,ov=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,av=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,lv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,cv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,hv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,uv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,dv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,fv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,pv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,mv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,gv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,_v=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,xv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,yv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,vv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Mv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Sv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,bv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,wv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Tv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Ev=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Av=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Rv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Cv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Pv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Iv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Lv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Dv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Nv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Uv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Fv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Ov=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Bv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,kv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,zv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Vv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Gv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Hv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Wv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Xv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,qv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,$v=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Yv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Zv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Jv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Kv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,jv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Qv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,tM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,eM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,nM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,iM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,sM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,rM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,oM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,aM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,lM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,cM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,hM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,uM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,dM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,fM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,pM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,mM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,gM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,_M=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,xM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,yM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,vM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,MM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,SM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,bM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,wM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,TM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,EM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,AM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,RM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,CM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,PM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,IM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,DM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,NM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,UM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,FM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,OM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,BM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,zM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,VM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,GM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,HM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,WM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,XM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,qM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$M=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,YM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,ZM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,JM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,jM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,eS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,nS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,iS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,sS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,oS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,me={alphahash_fragment:Ry,alphahash_pars_fragment:Cy,alphamap_fragment:Py,alphamap_pars_fragment:Iy,alphatest_fragment:Ly,alphatest_pars_fragment:Dy,aomap_fragment:Ny,aomap_pars_fragment:Uy,batching_pars_vertex:Fy,batching_vertex:Oy,begin_vertex:By,beginnormal_vertex:ky,bsdfs:zy,iridescence_fragment:Vy,bumpmap_pars_fragment:Gy,clipping_planes_fragment:Hy,clipping_planes_pars_fragment:Wy,clipping_planes_pars_vertex:Xy,clipping_planes_vertex:qy,color_fragment:$y,color_pars_fragment:Yy,color_pars_vertex:Zy,color_vertex:Jy,common:Ky,defaultnormal_vertex:jy,displacementmap_pars_vertex:Qy,displacementmap_vertex:tv,emissivemap_fragment:ev,emissivemap_pars_fragment:nv,colorspace_fragment:iv,colorspace_pars_fragment:sv,envmap_fragment:rv,envmap_common_pars_fragment:ov,envmap_pars_fragment:av,envmap_pars_vertex:lv,envmap_physical_pars_fragment:yv,envmap_vertex:cv,fog_vertex:hv,fog_pars_vertex:uv,fog_fragment:dv,fog_pars_fragment:fv,gradientmap_pars_fragment:pv,lightmap_pars_fragment:mv,lights_lambert_fragment:gv,lights_lambert_pars_fragment:_v,lights_pars_begin:xv,lights_toon_fragment:vv,lights_toon_pars_fragment:Mv,lights_phong_fragment:Sv,lights_phong_pars_fragment:bv,lights_physical_fragment:wv,lights_physical_pars_fragment:Tv,lights_fragment_begin:Ev,lights_fragment_maps:Av,lights_fragment_end:Rv,lightprobes_pars_fragment:Cv,logdepthbuf_fragment:Pv,logdepthbuf_pars_fragment:Iv,logdepthbuf_pars_vertex:Lv,logdepthbuf_vertex:Dv,map_fragment:Nv,map_pars_fragment:Uv,map_particle_fragment:Fv,map_particle_pars_fragment:Ov,metalnessmap_fragment:Bv,metalnessmap_pars_fragment:kv,morphinstance_vertex:zv,morphcolor_vertex:Vv,morphnormal_vertex:Gv,morphtarget_pars_vertex:Hv,morphtarget_vertex:Wv,normal_fragment_begin:Xv,normal_fragment_maps:qv,normal_pars_fragment:$v,normal_pars_vertex:Yv,normal_vertex:Zv,normalmap_pars_fragment:Jv,clearcoat_normal_fragment_begin:Kv,clearcoat_normal_fragment_maps:jv,clearcoat_pars_fragment:Qv,iridescence_pars_fragment:tM,opaque_fragment:eM,packing:nM,premultiplied_alpha_fragment:iM,project_vertex:sM,dithering_fragment:rM,dithering_pars_fragment:oM,roughnessmap_fragment:aM,roughnessmap_pars_fragment:lM,shadowmap_pars_fragment:cM,shadowmap_pars_vertex:hM,shadowmap_vertex:uM,shadowmask_pars_fragment:dM,skinbase_vertex:fM,skinning_pars_vertex:pM,skinning_vertex:mM,skinnormal_vertex:gM,specularmap_fragment:_M,specularmap_pars_fragment:xM,tonemapping_fragment:yM,tonemapping_pars_fragment:vM,transmission_fragment:MM,transmission_pars_fragment:SM,uv_pars_fragment:bM,uv_pars_vertex:wM,uv_vertex:TM,worldpos_vertex:EM,background_vert:AM,background_frag:RM,backgroundCube_vert:CM,backgroundCube_frag:PM,cube_vert:IM,cube_frag:LM,depth_vert:DM,depth_frag:NM,distance_vert:UM,distance_frag:FM,equirect_vert:OM,equirect_frag:BM,linedashed_vert:kM,linedashed_frag:zM,meshbasic_vert:VM,meshbasic_frag:GM,meshlambert_vert:HM,meshlambert_frag:WM,meshmatcap_vert:XM,meshmatcap_frag:qM,meshnormal_vert:$M,meshnormal_frag:YM,meshphong_vert:ZM,meshphong_frag:JM,meshphysical_vert:KM,meshphysical_frag:jM,meshtoon_vert:QM,meshtoon_frag:tS,points_vert:eS,points_frag:nS,shadow_vert:iS,shadow_frag:sS,sprite_vert:rS,sprite_frag:oS},Nt={common:{diffuse:{value:new fe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new he}},envmap:{envMap:{value:null},envMapRotation:{value:new he},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new he}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new he}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new he},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new he},normalScale:{value:new Kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new he},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new he}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new he}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new he}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new fe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new fe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0},uvTransform:{value:new he}},sprite:{diffuse:{value:new fe(16777215)},opacity:{value:1},center:{value:new Kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}}},fs={basic:{uniforms:Yn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:Yn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:Yn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)},specular:{value:new fe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:Yn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:Yn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:Yn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:Yn([Nt.points,Nt.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:Yn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:Yn([Nt.common,Nt.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:Yn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:Yn([Nt.sprite,Nt.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new he},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new he}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:Yn([Nt.common,Nt.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:Yn([Nt.lights,Nt.fog,{color:{value:new fe(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};fs.physical={uniforms:Yn([fs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new he},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new he},clearcoatNormalScale:{value:new Kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new he},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new he},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new he},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new he},sheen:{value:0},sheenColor:{value:new fe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new he},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new he},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new he},transmissionSamplerSize:{value:new Kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new he},attenuationDistance:{value:0},attenuationColor:{value:new fe(0)},specularColor:{value:new fe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new he},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new he},anisotropyVector:{value:new Kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new he}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var Dh={r:0,b:0,g:0},aS=new Xe,Rg=new he;Rg.set(-1,0,0,0,1,0,0,0,1);function lS(n,t,e,i,s,r){let o=new fe(0),a=s===!0?0:1,l,c,d=null,u=0,h=null;function f(y){let S=y.isScene===!0?y.background:null;if(S&&S.isTexture){let v=y.backgroundBlurriness>0;S=t.get(S,v)}return S}function g(y){let S=!1,v=f(y);v===null?p(o,a):v&&v.isColor&&(p(v,1),S=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,S){let v=f(S);v&&v.isCubeTexture?(c===void 0&&(c=new $n(new Co(1,1,1),new cs({name:"BackgroundCubeMaterial",uniforms:Lr(fs.backgroundCube.uniforms),vertexShader:fs.backgroundCube.vertexShader,fragmentShader:fs.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,w,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(aS.makeRotationFromEuler(S.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Rg),c.material.toneMapped=Se.getTransfer(v.colorSpace)!==Ne,(d!==v||u!==v.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,d=v,u=v.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new $n(new Va(2,2),new cs({name:"BackgroundMaterial",uniforms:Lr(fs.background.uniforms),vertexShader:fs.background.vertexShader,fragmentShader:fs.background.fragmentShader,side:hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=Se.getTransfer(v.colorSpace)!==Ne,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(d!==v||u!==v.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,d=v,u=v.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function p(y,S){y.getRGB(Dh,qd(n)),e.buffers.color.setClear(Dh.r,Dh.g,Dh.b,S,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,S=1){o.set(y),a=S,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,p(o,a)},render:g,addToRenderList:x,dispose:m}}function cS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(P,O,z,C,N){let U=!1,k=u(P,C,z,O);r!==k&&(r=k,c(r.object)),U=f(P,C,z,N),U&&g(P,C,z,N),N!==null&&t.update(N,n.ELEMENT_ARRAY_BUFFER),(U||o)&&(o=!1,v(P,O,z,C),N!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(N).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function d(P){return n.deleteVertexArray(P)}function u(P,O,z,C){let N=C.wireframe===!0,U=i[O.id];U===void 0&&(U={},i[O.id]=U);let k=P.isInstancedMesh===!0?P.id:0,$=U[k];$===void 0&&($={},U[k]=$);let V=$[z.id];V===void 0&&(V={},$[z.id]=V);let X=V[N];return X===void 0&&(X=h(l()),V[N]=X),X}function h(P){let O=[],z=[],C=[];for(let N=0;N<e;N++)O[N]=0,z[N]=0,C[N]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:z,attributeDivisors:C,object:P,attributes:{},index:null}}function f(P,O,z,C){let N=r.attributes,U=O.attributes,k=0,$=z.getAttributes();for(let V in $)if($[V].location>=0){let J=N[V],nt=U[V];if(nt===void 0&&(V==="instanceMatrix"&&P.instanceMatrix&&(nt=P.instanceMatrix),V==="instanceColor"&&P.instanceColor&&(nt=P.instanceColor)),J===void 0||J.attribute!==nt||nt&&J.data!==nt.data)return!0;k++}return r.attributesNum!==k||r.index!==C}function g(P,O,z,C){let N={},U=O.attributes,k=0,$=z.getAttributes();for(let V in $)if($[V].location>=0){let J=U[V];J===void 0&&(V==="instanceMatrix"&&P.instanceMatrix&&(J=P.instanceMatrix),V==="instanceColor"&&P.instanceColor&&(J=P.instanceColor));let nt={};nt.attribute=J,J&&J.data&&(nt.data=J.data),N[V]=nt,k++}r.attributes=N,r.attributesNum=k,r.index=C}function x(){let P=r.newAttributes;for(let O=0,z=P.length;O<z;O++)P[O]=0}function p(P){m(P,0)}function m(P,O){let z=r.newAttributes,C=r.enabledAttributes,N=r.attributeDivisors;z[P]=1,C[P]===0&&(n.enableVertexAttribArray(P),C[P]=1),N[P]!==O&&(n.vertexAttribDivisor(P,O),N[P]=O)}function y(){let P=r.newAttributes,O=r.enabledAttributes;for(let z=0,C=O.length;z<C;z++)O[z]!==P[z]&&(n.disableVertexAttribArray(z),O[z]=0)}function S(P,O,z,C,N,U,k){k===!0?n.vertexAttribIPointer(P,O,z,N,U):n.vertexAttribPointer(P,O,z,C,N,U)}function v(P,O,z,C){x();let N=C.attributes,U=z.getAttributes(),k=O.defaultAttributeValues;for(let $ in U){let V=U[$];if(V.location>=0){let X=N[$];if(X===void 0&&($==="instanceMatrix"&&P.instanceMatrix&&(X=P.instanceMatrix),$==="instanceColor"&&P.instanceColor&&(X=P.instanceColor)),X!==void 0){let J=X.normalized,nt=X.itemSize,Q=t.get(X);if(Q===void 0)continue;let W=Q.buffer,st=Q.type,ht=Q.bytesPerElement,ct=st===n.INT||st===n.UNSIGNED_INT||X.gpuType===Zc;if(X.isInterleavedBufferAttribute){let gt=X.data,xt=gt.isInterleavedBuffer===!0?gt.stride:gt.itemSize,Ut=X.offset;if(gt.isInstancedInterleavedBuffer||gt.isInstancedBufferAttribute){for(let Lt=0;Lt<V.locationSize;Lt++)m(V.location+Lt,gt.meshPerAttribute);P.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=gt.meshPerAttribute*gt.count)}else for(let Lt=0;Lt<V.locationSize;Lt++)p(V.location+Lt);n.bindBuffer(n.ARRAY_BUFFER,W);for(let Lt=0;Lt<V.locationSize;Lt++)S(V.location+Lt,nt/V.locationSize,st,J,xt*ht,(Ut+nt/V.locationSize*Lt)*ht,ct)}else{if(X.isInstancedBufferAttribute){for(let gt=0;gt<V.locationSize;gt++)m(V.location+gt,X.meshPerAttribute);P.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=X.meshPerAttribute*X.count)}else for(let gt=0;gt<V.locationSize;gt++)p(V.location+gt);n.bindBuffer(n.ARRAY_BUFFER,W);for(let gt=0;gt<V.locationSize;gt++)S(V.location+gt,nt/V.locationSize,st,J,nt*ht,nt/V.locationSize*gt*ht,ct)}}else if(k!==void 0){let J=k[$];if(J!==void 0)switch(J.length){case 2:n.vertexAttrib2fv(V.location,J);break;case 3:n.vertexAttrib3fv(V.location,J);break;case 4:n.vertexAttrib4fv(V.location,J);break;default:n.vertexAttrib1fv(V.location,J)}}}}y()}function E(){B();for(let P in i){let O=i[P];for(let z in O){let C=O[z];for(let N in C){let U=C[N];for(let k in U)d(U[k].object),delete U[k];delete C[N]}}delete i[P]}}function w(P){if(i[P.id]===void 0)return;let O=i[P.id];for(let z in O){let C=O[z];for(let N in C){let U=C[N];for(let k in U)d(U[k].object),delete U[k];delete C[N]}}delete i[P.id]}function _(P){for(let O in i){let z=i[O];for(let C in z){let N=z[C];if(N[P.id]===void 0)continue;let U=N[P.id];for(let k in U)d(U[k].object),delete U[k];delete N[P.id]}}}function b(P){for(let O in i){let z=i[O],C=P.isInstancedMesh===!0?P.id:0,N=z[C];if(N!==void 0){for(let U in N){let k=N[U];for(let $ in k)d(k[$].object),delete k[$];delete N[U]}delete z[C],Object.keys(z).length===0&&delete i[O]}}}function B(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:I,dispose:E,releaseStatesOfGeometry:w,releaseStatesOfObject:b,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:p,disableUnusedAttributes:y}}function hS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,d){d!==0&&(n.drawArraysInstanced(i,l,c,d),e.update(c,i,d))}function a(l,c,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,d);let h=0;for(let f=0;f<d;f++)h+=c[f];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function uS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==qi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let b=_===Xi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ci&&_!==Wi&&!b&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",d=l(c);d!==c&&(ee("WebGLRenderer:",c,"not supported, using",d,"instead."),c=d);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&ee("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&ee("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:y,maxVaryings:S,maxFragmentUniforms:v,maxSamples:E,samples:w}}function dS(n){let t=this,e=null,i=0,s=!1,r=!1,o=new xi,a=new he,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,h){let f=u.length!==0||h||i!==0||s;return s=h,i=u.length,f},this.beginShadows=function(){r=!0,d(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,h){e=d(u,h,0)},this.setState=function(u,h,f){let g=u.clippingPlanes,x=u.clipIntersection,p=u.clipShadows,m=n.get(u);if(!s||g===null||g.length===0||r&&!p)r?d(null):c();else{let y=r?0:i,S=y*4,v=m.clippingState||null;l.value=v,v=d(g,h,S,f);for(let E=0;E!==S;++E)v[E]=e[E];m.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function d(u,h,f,g){let x=u!==null?u.length:0,p=null;if(x!==0){if(p=l.value,g!==!0||p===null){let m=f+x*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(p===null||p.length<m)&&(p=new Float32Array(m));for(let S=0,v=f;S!==x;++S,v+=4)o.copy(u[S]).applyMatrix4(y,a),o.normal.toArray(p,v),p[v+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,p}}var rl=class extends vi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Oa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Co(5,5,5),r=new cs({name:"CubemapFromEquirect",uniforms:Lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:Rr});r.uniforms.tEquirect.value=e;let o=new $n(s,r),a=e.minFilter;return e.minFilter===Ns&&(e.minFilter=si),new Po(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},og=256,fS=3,pS=20,Cg=256,Pg=16,mS=3,gS=new K,_S=new fe,Uh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Po(1,10,null),this._boxMesh=new $n(new Co(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=gS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),d=this._getSourceTarget(!0);e>0&&(d.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(_S));let p=new Po(i,s,d);return p.position.copy(a),p.update(l,t),l.autoClear=u,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=g,t.background=x,e>0&&(d.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=cg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=lg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(og,Gd(t))}_fromTexture(t,e){t.mapping===Pr||t.mapping===No?this._setSize(t.image.length===0?og:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=ag(t,!1,!1),i=Math.log2(t)-fS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ag(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Pr||t.mapping===No?(this._cubemapMaterial===null&&(this._cubemapMaterial=cg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=lg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=xS(),this._integrationMaterial=yS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Pg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-mS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Cg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=vS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function ag(n,t,e){return new rl(n,{minFilter:Ns,generateMipmaps:t,type:Xi,colorSpace:Ea,depthBuffer:e})}function ol(n,t,e){return new cs({name:n,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:oi,blending:Rr,depthTest:!1,depthWrite:!1})}function xS(){return ol("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Cg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function yS(){return ol("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Pg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function vS(){return ol("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${pS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function lg(){return ol("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function cg(){return ol("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function MS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===qc||f===$c)if(t.has(h)){let g=t.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let x=new rl(g.height);return x.fromEquirectangularTexture(n,h),t.set(h,x),h.addEventListener("dispose",c),a(x.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,g=f===qc||f===$c,x=f===Pr||f===No;if(g||x){let p=e.get(h),m=p!==void 0?p.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Uh(n)),p=g?i.fromEquirectangular(h,p):i.fromCubemap(h,p),p.texture.pmremVersion=h.pmremVersion,e.set(h,p),p.texture;if(p!==void 0)return p.texture;{let y=h.image;return g&&y&&y.height>0||x&&y&&l(y)?(i===null&&(i=new Uh(n)),p=g?i.fromEquirectangular(h):i.fromCubemap(h),p.texture.pmremVersion=h.pmremVersion,e.set(h,p),h.addEventListener("dispose",d),p.texture):null}}}return h}function a(h,f){return f===qc?h.mapping=Pr:f===$c&&(h.mapping=No),h}function l(h){let f=0,g=6;for(let x=0;x<g;x++)h[x]!==void 0&&f++;return f===g}function c(h){let f=h.target;f.removeEventListener("dispose",c);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function d(h){let f=h.target;f.removeEventListener("dispose",d);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function SS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Sa("WebGLRenderer: "+i+" extension not supported."),s}}}function bS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let p in g.attributes)t.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(t.remove(x),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function d(g){let x=g.attributes;for(let p in x)t.update(x[p],n.ARRAY_BUFFER)}function u(g){let x=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let y=x!==null?x.array.length:p.array.length/3-1,S=p.count>=65535?Na:Da,v=new S(Math.ceil(y/3)*6,1),E=v.array;if(x!==null){let _=x.array;m=x.version;for(let b=0,B=0;b<y;b+=3){let I=_[b+0],P=_[b+1],O=_[b+2];E[B++]=I,E[B++]=P,E[B++]=P,E[B++]=O,E[B++]=O,E[B++]=I}}else{m=p.version;for(let _=0,b=0;_<y;_+=3){let B=_+0,I=_+1,P=_+2;E[b++]=B,E[b++]=I,E[b++]=I,E[b++]=P,E[b++]=P,E[b++]=B}}v.version=m;let w=r.get(g);w&&t.remove(w),r.set(g,v)}function h(g){let x=r.get(g);if(x){let p=g.index;p!==null&&x.version<p.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:d,getWireframeAttribute:h,dispose:f}}function wS(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,h){n.drawElements(i,h,r,u*o),e.update(h,i,1)}function c(u,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,u*o,f),e.update(h,i,f))}function d(u,h,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,u,0,f);let x=0;for(let p=0;p<f;p++)x+=h[p];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=d}function TS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:re("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function ES(n,t,e){let i=new WeakMap,s=new en;function r(o,a,l){let c=o.morphTargetInfluences,d=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=d!==void 0?d.length:0,h=i.get(a);if(h===void 0||h.count!==u){let B=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",B)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],S=0;f===!0&&(S=1),g===!0&&(S=2),x===!0&&(S=3);let v=a.attributes.position.count*S,E=1;v>t.maxTextureSize&&(E=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let w=new Float32Array(v*E*4*u),_=new Pa(w,v,E,u);_.type=Wi,_.needsUpdate=!0;let b=S*4;for(let I=0;I<u;I++){let P=p[I],O=m[I],z=y[I],C=v*E*4*I;for(let N=0;N<P.count;N++){let U=N*b;f===!0&&(s.fromBufferAttribute(P,N),w[C+U+0]=s.x,w[C+U+1]=s.y,w[C+U+2]=s.z,w[C+U+3]=0),g===!0&&(s.fromBufferAttribute(O,N),w[C+U+4]=s.x,w[C+U+5]=s.y,w[C+U+6]=s.z,w[C+U+7]=0),x===!0&&(s.fromBufferAttribute(z,N),w[C+U+8]=s.x,w[C+U+9]=s.y,w[C+U+10]=s.z,w[C+U+11]=z.itemSize===4?s.w:1)}}h={count:u,texture:_,size:new Kt(v,E)},i.set(a,h),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function AS(n,t,e,i,s){let r=new WeakMap;function o(c){let d=s.render.frame,u=c.geometry,h=t.get(c,u);if(r.get(h)!==d&&(t.update(h),r.set(h,d)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==d&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,d))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==d&&(f.update(),r.set(f,d))}return h}function a(){r=new WeakMap}function l(c){let d=c.target;d.removeEventListener("dispose",l),i.releaseStatesOfObject(d),e.remove(d.instanceMatrix),d.instanceColor!==null&&e.remove(d.instanceColor)}return{update:o,dispose:a}}var RS={[Md]:"LINEAR_TONE_MAPPING",[Sd]:"REINHARD_TONE_MAPPING",[bd]:"CINEON_TONE_MAPPING",[wd]:"ACES_FILMIC_TONE_MAPPING",[Ed]:"AGX_TONE_MAPPING",[Ad]:"NEUTRAL_TONE_MAPPING",[Td]:"CUSTOM_TONE_MAPPING"};function CS(n,t,e,i,s,r){let o=new vi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,d=new On;d.setAttribute("position",new fn([-1,3,0,-1,-1,0,3,-1,0],3)),d.setAttribute("uv",new fn([0,2,0,0,2,0],2));let u=new Pc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new $n(d,u),f=new Xa(-1,1,1,-1,0,1),g=null,x=null,p=!1,m,y=null,S=[],v=!1;this.setSize=function(E,w){o.setSize(E,w),a!==null&&a.setSize(E,w),l!==null&&l.setSize(E,w);for(let _=0;_<S.length;_++){let b=S[_];b.setSize&&b.setSize(E,w)}},this.setEffects=function(E){S=E,v=S.length>0&&S[0].isRenderPass===!0;let w=o.width,_=o.height;S.length>0&&a===null&&(a=new vi(w,_,{type:Xi,depthBuffer:!1,stencilBuffer:!1}),l=new vi(w,_,{type:Xi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&S.some(B=>B.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new Ls(w,_),r===!0&&(c.format=Us,c.type=Ir)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let B=0;B<S.length;B++){let I=S[B];I.setSize&&I.setSize(w,_),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(E,w){if(p||E.toneMapping===us&&S.length===0)return!1;if(y=w,w!==null){let _=w.width,b=w.height;(o.width!==_||o.height!==b)&&this.setSize(_,b)}return v===!1&&E.setRenderTarget(o),m=E.toneMapping,E.toneMapping=us,!0},this.hasRenderPass=function(){return v},this.end=function(E,w){E.toneMapping=m,p=!0;let _=o,b=a;for(let B=0;B<S.length;B++){let I=S[B];I.enabled!==!1&&(I.render(E,b,_,w),I.needsSwap!==!1&&(_=b,b=b===a?l:a))}if(g!==E.outputColorSpace||x!==E.toneMapping){g=E.outputColorSpace,x=E.toneMapping,u.defines={},Se.getTransfer(g)===Ne&&(u.defines.SRGB_TRANSFER="");let B=RS[x];B&&(u.defines[B]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,E.setRenderTarget(y),E.render(h,f),y=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),d.dispose(),u.dispose()}}var Ig=new ri,Lg=new Ls(1,1),Dg=new ka(1),Ng=new Pa,Ug=new Sc,Fg=new Oa,hg=[],ug=[],dg=new Float32Array(16),fg=new Float32Array(9),pg=new Float32Array(4);function Oo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=hg[s];if(r===void 0&&(r=new Float32Array(s),hg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function wn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Tn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Oh(n,t){let e=ug[t];e===void 0&&(e=new Int32Array(t),ug[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function PS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function IS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;n.uniform2fv(this.addr,t),Tn(e,t)}}function LS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(wn(e,t))return;n.uniform3fv(this.addr,t),Tn(e,t)}}function DS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;n.uniform4fv(this.addr,t),Tn(e,t)}}function NS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(wn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,i))return;pg.set(i),n.uniformMatrix2fv(this.addr,!1,pg),Tn(e,i)}}function US(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(wn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,i))return;fg.set(i),n.uniformMatrix3fv(this.addr,!1,fg),Tn(e,i)}}function FS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(wn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Tn(e,t)}else{if(wn(e,i))return;dg.set(i),n.uniformMatrix4fv(this.addr,!1,dg),Tn(e,i)}}function OS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function BS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;n.uniform2iv(this.addr,t),Tn(e,t)}}function kS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wn(e,t))return;n.uniform3iv(this.addr,t),Tn(e,t)}}function zS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;n.uniform4iv(this.addr,t),Tn(e,t)}}function VS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function GS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wn(e,t))return;n.uniform2uiv(this.addr,t),Tn(e,t)}}function HS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wn(e,t))return;n.uniform3uiv(this.addr,t),Tn(e,t)}}function WS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wn(e,t))return;n.uniform4uiv(this.addr,t),Tn(e,t)}}function Bh(n){return n.version===0&&(n.compareFunction=Bd,n.needsUpdate=!0),n}function XS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Bh(Lg):r=Ig,e.setTexture2D(t||r,s)}function qS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Ug,s)}function $S(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Bh(Dg):r=Fg,e.setTextureCube(t||r,s)}function YS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Ng,s)}function ZS(n){switch(n){case 5126:return PS;case 35664:return IS;case 35665:return LS;case 35666:return DS;case 35674:return NS;case 35675:return US;case 35676:return FS;case 5124:case 35670:return OS;case 35667:case 35671:return BS;case 35668:case 35672:return kS;case 35669:case 35673:return zS;case 5125:return VS;case 36294:return GS;case 36295:return HS;case 36296:return WS;case 35678:case 36198:case 36298:case 36306:case 35682:return XS;case 35679:case 36299:case 36307:return qS;case 35680:case 36300:case 36308:case 36293:return $S;case 36289:case 36303:case 36311:case 36292:return YS}}function JS(n,t){n.uniform1fv(this.addr,t)}function KS(n,t){let e=Oo(t,this.size,2);n.uniform2fv(this.addr,e)}function jS(n,t){let e=Oo(t,this.size,3);n.uniform3fv(this.addr,e)}function QS(n,t){let e=Oo(t,this.size,4);n.uniform4fv(this.addr,e)}function tb(n,t){let e=Oo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function eb(n,t){let e=Oo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function nb(n,t){let e=Oo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function ib(n,t){n.uniform1iv(this.addr,t)}function sb(n,t){n.uniform2iv(this.addr,t)}function rb(n,t){n.uniform3iv(this.addr,t)}function ob(n,t){n.uniform4iv(this.addr,t)}function ab(n,t){n.uniform1uiv(this.addr,t)}function lb(n,t){n.uniform2uiv(this.addr,t)}function cb(n,t){n.uniform3uiv(this.addr,t)}function hb(n,t){n.uniform4uiv(this.addr,t)}function ub(n,t,e){let i=this.cache,s=t.length,r=Oh(e,s);wn(i,r)||(n.uniform1iv(this.addr,r),Tn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Bh(Lg):o=Ig;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function db(n,t,e){let i=this.cache,s=t.length,r=Oh(e,s);wn(i,r)||(n.uniform1iv(this.addr,r),Tn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ug,r[o])}function fb(n,t,e){let i=this.cache,s=t.length,r=Oh(e,s);wn(i,r)||(n.uniform1iv(this.addr,r),Tn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Bh(Dg):o=Fg;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function pb(n,t,e){let i=this.cache,s=t.length,r=Oh(e,s);wn(i,r)||(n.uniform1iv(this.addr,r),Tn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Ng,r[o])}function mb(n){switch(n){case 5126:return JS;case 35664:return KS;case 35665:return jS;case 35666:return QS;case 35674:return tb;case 35675:return eb;case 35676:return nb;case 5124:case 35670:return ib;case 35667:case 35671:return sb;case 35668:case 35672:return rb;case 35669:case 35673:return ob;case 5125:return ab;case 36294:return lb;case 36295:return cb;case 36296:return hb;case 35678:case 36198:case 36298:case 36306:case 35682:return ub;case 35679:case 36299:case 36307:return db;case 35680:case 36300:case 36308:case 36293:return fb;case 36289:case 36303:case 36311:case 36292:return pb}}var jd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=ZS(e.type)}},Qd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=mb(e.type)}},tf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Jd=/(\w+)(\])?(\[|\.)?/g;function mg(n,t){n.seq.push(t),n.map[t.id]=t}function gb(n,t,e){let i=n.name,s=i.length;for(Jd.lastIndex=0;;){let r=Jd.exec(i),o=Jd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){mg(e,c===void 0?new jd(a,n,t):new Qd(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new tf(a),mg(e,u)),e=u}}}var Fo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);gb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function gg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var _b=37297,xb=0;function yb(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var _g=new he;function vb(n){Se._getMatrix(_g,Se.workingColorSpace,n);let t=`mat3( ${_g.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(n)){case Aa:return[t,"LinearTransferOETF"];case Ne:return[t,"sRGBTransferOETF"];default:return ee("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function xg(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+yb(n.getShaderSource(t),a)}else return r}function Mb(n,t){let e=vb(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Sb={[Md]:"Linear",[Sd]:"Reinhard",[bd]:"Cineon",[wd]:"ACESFilmic",[Ed]:"AgX",[Ad]:"Neutral",[Td]:"Custom"};function bb(n,t){let e=Sb[t];return e===void 0?(ee("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Nh=new K;function wb(){Se.getLuminanceCoefficients(Nh);let n=Nh.x.toFixed(4),t=Nh.y.toFixed(4),e=Nh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Tb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(sl).join(`
`)}function Eb(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Ab(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function sl(n){return n!==""}function yg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function vg(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Rb=/^[ \t]*#include +<([\w\d./]+)>/gm;function ef(n){return n.replace(Rb,Cb)}function Cb(n,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return ef(e)}var Pb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Mg(n){return n.replace(Pb,Ib)}function Ib(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Sg(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Lb={[Za]:"SHADOWMAP_TYPE_PCF",[Lo]:"SHADOWMAP_TYPE_VSM"};function Db(n){return Lb[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Nb={[No]:"ENVMAP_MODE_REFRACTION"};function Ub(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Nb[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Fb={[Xc]:"ENVMAP_BLENDING_MULTIPLY",[zm]:"ENVMAP_BLENDING_MIX",[Vm]:"ENVMAP_BLENDING_ADD"};function Ob(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Fb[n.combine]||"ENVMAP_BLENDING_NONE"}function Bb(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Db(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",d=Ub(e),u=Ob(e),h=Tb(e),f=Eb(r),g=s.createProgram(),x,p,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(sl).join(`
`),x.length>0&&(x+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(sl).join(`
`),p.length>0&&(p+=`
`)):(x=[Sg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+d:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(sl).join(`
`),p=[Sg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+d:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==us?"#define TONE_MAPPING":"",e.toneMapping!==us?me.tonemapping_pars_fragment:"",e.toneMapping!==us?bb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,Mb("linearToOutputTexel",e.outputColorSpace),wb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(sl).join(`
`)),o=ef(o),o=yg(o,e),o=vg(o,e),a=ef(a),a=yg(a,e),a=vg(a,e),o=Mg(o),a=Mg(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,p=["#define varying in",e.glslVersion===zd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===zd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let y=m+x+o,S=m+p+a,v=gg(s,s.VERTEX_SHADER,y),E=gg(s,s.FRAGMENT_SHADER,S);s.attachShader(g,v),s.attachShader(g,E),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function w(I){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(g)||"",O=s.getShaderInfoLog(v)||"",z=s.getShaderInfoLog(E)||"",C=P.trim(),N=O.trim(),U=z.trim(),k=!0,$=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(k=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,v,E);else{let V=xg(s,v,"vertex"),X=xg(s,E,"fragment");re("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+C+`
`+V+`
`+X)}else C!==""?ee("WebGLProgram: Program Info Log:",C):(N===""||U==="")&&($=!1);$&&(I.diagnostics={runnable:k,programLog:C,vertexShader:{log:N,prefix:x},fragmentShader:{log:U,prefix:p}})}s.deleteShader(v),s.deleteShader(E),_=new Fo(s,g),b=Ab(s,g)}let _;this.getUniforms=function(){return _===void 0&&w(this),_};let b;this.getAttributes=function(){return b===void 0&&w(this),b};let B=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,_b)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=xb++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=E,this}var kb=0,nf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new sf(t),e.set(t,i)),i}},sf=class{constructor(t){this.id=kb++,this.code=t,this.usedTimes=0}};function zb(n){return n===hr||n===el||n===nl}function Vb(n,t,e,i,s,r){let o=new Ia,a=new nf,l=new Set,c=[],d=new Map,u=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,b,B,I,P,O){let z=I.fog,C=P.geometry,N=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?I.environment:null,U=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,k=t.get(_.envMap||N,U),$=h[_.type],V=i.precision;_.precision!==null&&(V=i.getMaxPrecision(_.precision),V!==_.precision&&ee("WebGLProgram.getParameters:",_.precision,"not supported, using",V,"instead."));let X=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,J=X!==void 0?X.length:0,nt=0;C.morphAttributes.position!==void 0&&(nt=1),C.morphAttributes.normal!==void 0&&(nt=2),C.morphAttributes.color!==void 0&&(nt=3);let Q,W,st,ht;if($){let Pt=fs[$];Q=Pt.vertexShader,W=Pt.fragmentShader}else{Q=_.vertexShader,W=_.fragmentShader;let Pt=a.getVertexShaderStage(_),de=a.getFragmentShaderStage(_);a.update(_,Pt,de),st=Pt.id,ht=de.id}let ct=n.getRenderTarget(),gt=n.state.buffers.depth.getReversed(),xt=P.isInstancedMesh===!0,Ut=P.isBatchedMesh===!0,Lt=!!_.map,Qt=!!_.matcap,te=!!k,qt=te&&k.isPMREMTexture===!0,ke=!!_.aoMap,oe=!!_.lightMap,Ce=!!_.bumpMap&&_.wireframe===!1,Pe=!!_.normalMap,mn=!!_.displacementMap,ve=!!_.emissiveMap,hn=!!_.metalnessMap,Qe=!!_.roughnessMap,sn=_.anisotropy>0,G=_.clearcoat>0,Ct=_.diffuseRoughness>0,Zt=_.dispersion>0,ae=_.retroreflectivity>0,Tt=_.iridescence>0,Ve=_.sheen>0,Xt=_.transmission>0,jt=sn&&!!_.anisotropyMap,L=G&&!!_.clearcoatMap,T=G&&!!_.clearcoatNormalMap,j=G&&!!_.clearcoatRoughnessMap,mt=Ct&&!!_.diffuseRoughnessMap,dt=Tt&&!!_.iridescenceMap,Mt=Tt&&!!_.iridescenceThicknessMap,St=Ve&&!!_.sheenColorMap,ot=Ve&&!!_.sheenRoughnessMap,lt=!!_.specularMap,yt=!!_.specularColorMap,H=!!_.specularIntensityMap,ut=Xt&&!!_.transmissionMap,at=Xt&&!!_.thicknessMap,Et=!!_.gradientMap,vt=!!_.alphaMap,wt=_.alphaTest>0,$t=!!_.alphaHash,ie=!!_.extensions,pt=us;_.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(pt=n.toneMapping);let Gt=qt?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,se={shaderID:$,shaderType:_.type,shaderName:_.name,vertexShader:Q,fragmentShader:W,defines:_.defines,customVertexShaderID:st,customFragmentShaderID:ht,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:V,batching:Ut,batchingColor:Ut&&P._colorsTexture!==null,instancing:xt,instancingColor:xt&&P.instanceColor!==null,instancingMorph:xt&&P.morphTexture!==null,outputColorSpace:ct===null?n.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Lt,matcap:Qt,envMap:te,envMapMode:te&&k.mapping,envMapPMREM:qt,envMapMaxLod:qt?Gt.length-1:null,envMapSize:qt?Gt[0].width:null,aoMap:ke,lightMap:oe,bumpMap:Ce,normalMap:Pe,displacementMap:mn,emissiveMap:ve,normalMapObjectSpace:Pe&&_.normalMapType===Wm,normalMapTangentSpace:Pe&&_.normalMapType===Ih,packedNormalMap:Pe&&_.normalMapType===Ih&&zb(_.normalMap.format),metalnessMap:hn,roughnessMap:Qe,anisotropy:sn,anisotropyMap:jt,clearcoat:G,clearcoatMap:L,clearcoatNormalMap:T,clearcoatRoughnessMap:j,diffuseRoughness:Ct,diffuseRoughnessMap:mt,dispersion:Zt,retroreflection:ae,iridescence:Tt,iridescenceMap:dt,iridescenceThicknessMap:Mt,sheen:Ve,sheenColorMap:St,sheenRoughnessMap:ot,specularMap:lt,specularColorMap:yt,specularIntensityMap:H,transmission:Xt,transmissionMap:ut,thicknessMap:at,gradientMap:Et,opaque:_.transparent===!1&&_.blending===Do&&_.alphaToCoverage===!1,alphaMap:vt,alphaTest:wt,alphaHash:$t,combine:_.combine,mapUv:Lt&&f(_.map.channel),aoMapUv:ke&&f(_.aoMap.channel),lightMapUv:oe&&f(_.lightMap.channel),bumpMapUv:Ce&&f(_.bumpMap.channel),normalMapUv:Pe&&f(_.normalMap.channel),displacementMapUv:mn&&f(_.displacementMap.channel),emissiveMapUv:ve&&f(_.emissiveMap.channel),metalnessMapUv:hn&&f(_.metalnessMap.channel),roughnessMapUv:Qe&&f(_.roughnessMap.channel),anisotropyMapUv:jt&&f(_.anisotropyMap.channel),clearcoatMapUv:L&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:mt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:dt&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:Mt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:St&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:ot&&f(_.sheenRoughnessMap.channel),specularMapUv:lt&&f(_.specularMap.channel),specularColorMapUv:yt&&f(_.specularColorMap.channel),specularIntensityMapUv:H&&f(_.specularIntensityMap.channel),transmissionMapUv:ut&&f(_.transmissionMap.channel),thicknessMapUv:at&&f(_.thicknessMap.channel),alphaMapUv:vt&&f(_.alphaMap.channel),vertexTangents:!!C.attributes.tangent&&(Pe||sn),vertexNormals:!!C.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!C.attributes.uv&&(Lt||vt),fog:!!z,useFog:_.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||C.attributes.normal===void 0&&Pe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:gt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:C.attributes.position!==void 0,morphTargets:C.morphAttributes.position!==void 0,morphNormals:C.morphAttributes.normal!==void 0,morphColors:C.morphAttributes.color!==void 0,morphTargetsCount:J,morphTextureStride:nt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:O.filter(Pt=>Pt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:pt,decodeVideoTexture:Lt&&_.map.isVideoTexture===!0&&Se.getTransfer(_.map.colorSpace)===Ne,decodeVideoTextureEmissive:ve&&_.emissiveMap.isVideoTexture===!0&&Se.getTransfer(_.emissiveMap.colorSpace)===Ne,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===li,flipSided:_.side===oi,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ie&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ie&&_.extensions.multiDraw===!0||Ut)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return se.vertexUv1s=l.has(1),se.vertexUv2s=l.has(2),se.vertexUv3s=l.has(3),l.clear(),se}function x(_){let b=[];if(_.shaderID?b.push(_.shaderID):(b.push(_.customVertexShaderID),b.push(_.customFragmentShaderID)),_.defines!==void 0)for(let B in _.defines)b.push(B),b.push(_.defines[B]);return _.isRawShaderMaterial===!1&&(p(b,_),m(b,_),b.push(n.outputColorSpace)),b.push(_.customProgramCacheKey),b.join()}function p(_,b){_.push(b.precision),_.push(b.outputColorSpace),_.push(b.envMapMode),_.push(b.envMapPMREM),_.push(b.envMapMaxLod),_.push(b.envMapSize),_.push(b.mapUv),_.push(b.alphaMapUv),_.push(b.lightMapUv),_.push(b.aoMapUv),_.push(b.bumpMapUv),_.push(b.normalMapUv),_.push(b.displacementMapUv),_.push(b.emissiveMapUv),_.push(b.metalnessMapUv),_.push(b.roughnessMapUv),_.push(b.anisotropyMapUv),_.push(b.clearcoatMapUv),_.push(b.clearcoatNormalMapUv),_.push(b.clearcoatRoughnessMapUv),_.push(b.diffuseRoughnessMapUv),_.push(b.iridescenceMapUv),_.push(b.iridescenceThicknessMapUv),_.push(b.sheenColorMapUv),_.push(b.sheenRoughnessMapUv),_.push(b.specularMapUv),_.push(b.specularColorMapUv),_.push(b.specularIntensityMapUv),_.push(b.transmissionMapUv),_.push(b.thicknessMapUv),_.push(b.combine),_.push(b.fogExp2),_.push(b.sizeAttenuation),_.push(b.morphTargetsCount),_.push(b.numSunLights),_.push(b.numDirLights),_.push(b.numPointLights),_.push(b.numSpotLights),_.push(b.numSpotLightMaps),_.push(b.numHemiLights),_.push(b.numRectAreaLights),_.push(b.numSunLightShadows),_.push(b.numDirLightShadows),_.push(b.numPointLightShadows),_.push(b.numSpotLightShadows),_.push(b.numSpotLightShadowsWithMaps),_.push(b.numLightProbes),_.push(b.numLightProbeGrids),_.push(b.shadowMapType),_.push(b.toneMapping),_.push(b.numClippingPlanes),_.push(b.numClipIntersection),_.push(b.depthPacking)}function m(_,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let b=h[_.type],B;if(b){let I=fs[b];B=ig.clone(I.uniforms)}else B=_.uniforms;return B}function S(_,b){let B=d.get(b);return B!==void 0?++B.usedTimes:(B=new Bb(n,b,_,s),c.push(B),d.set(b,B)),B}function v(_){if(--_.usedTimes===0){let b=c.indexOf(_);c[b]=c[c.length-1],c.pop(),d.delete(_.cacheKey),_.destroy()}}function E(_){a.remove(_)}function w(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:y,acquireProgram:S,releaseProgram:v,releaseShaderCache:E,programs:c,dispose:w}}function Gb(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Hb(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function bg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function wg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,g,x,p,m){let y=n[t];return y===void 0?(y={id:h.id,object:h,geometry:f,material:g,materialVariant:o(h),groupOrder:x,renderOrder:h.renderOrder,z:p,group:m},n[t]=y):(y.id=h.id,y.object=h,y.geometry=f,y.material=g,y.materialVariant=o(h),y.groupOrder=x,y.renderOrder=h.renderOrder,y.z=p,y.group=m),t++,y}function l(h,f,g,x,p,m,y){y.reversedDepth===!0&&(p=-p);let S=a(h,f,g,x,p,m);g.transmission>0?i.push(S):g.transparent===!0?s.push(S):e.push(S)}function c(h,f,g,x,p,m){let y=a(h,f,g,x,p,m);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):e.unshift(y)}function d(h,f){e.length>1&&e.sort(h||Hb),i.length>1&&i.sort(f||bg),s.length>1&&s.sort(f||bg)}function u(){for(let h=t,f=n.length;h<f;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:d}}function Wb(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new wg,n.set(i,[o])):s>=r.length?(o=new wg,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function Xb(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new K,color:new fe};break;case"SpotLight":e={position:new K,direction:new K,color:new fe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new K,color:new fe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new K,skyColor:new fe,groundColor:new fe};break;case"RectAreaLight":e={color:new fe,position:new K,halfWidth:new K,halfHeight:new K};break}return n[t.id]=e,e}}}function qb(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var $b=0;function Yb(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Zb(n){let t=new Xb,e=qb(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let s=new K,r=new Xe,o=new Xe;function a(c){let d=0,u=0,h=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let f=0,g=0,x=0,p=0,m=0,y=0,S=0,v=0,E=0,w=0,_=0,b=0,B=0,I=0;c.sort(Yb);for(let O=0,z=c.length;O<z;O++){let C=c[O],N=C.color,U=C.intensity,k=C.distance,$=null;if(C.shadow&&C.shadow.map&&(C.shadow.map.texture.format===hr?$=C.shadow.map.texture:$=C.shadow.map.depthTexture||C.shadow.map.texture),C.isAmbientLight)d+=N.r*U,u+=N.g*U,h+=N.b*U;else if(C.isLightProbe){for(let V=0;V<9;V++)i.probe[V].addScaledVector(C.sh.coefficients[V],U);I++}else if(C.isSunLight){let V=t.get(C);if(V.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let X=C.shadow,J=e.get(C);J.shadowIntensity=X.intensity,J.shadowBias=X.bias,J.shadowNormalBias=X.normalBias,J.shadowRadius=X.radius,J.shadowMapSize.copy(X.mapSize).multiply(X.getFrameExtents()),i.sunShadow[g]=J,i.sunShadowMap[g]=$;let nt=X.getViewportCount();for(let Q=0;Q<nt;Q++)i.sunShadowMatrix[x+Q]=X.getMatrix(Q),i.sunShadowCascade[x+Q]=X._cascadeData[Q];x+=nt,g++}i.sun[f]=V,f++}else if(C.isDirectionalLight){let V=t.get(C);if(V.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let X=C.shadow,J=e.get(C);J.shadowIntensity=X.intensity,J.shadowBias=X.bias,J.shadowNormalBias=X.normalBias,J.shadowRadius=X.radius,J.shadowMapSize=X.mapSize,i.directionalShadow[p]=J,i.directionalShadowMap[p]=$,i.directionalShadowMatrix[p]=C.shadow.matrix,E++}i.directional[p]=V,p++}else if(C.isSpotLight){let V=t.get(C);V.position.setFromMatrixPosition(C.matrixWorld),V.color.copy(N).multiplyScalar(U),V.distance=k,V.coneCos=Math.cos(C.angle),V.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),V.decay=C.decay,i.spot[y]=V;let X=C.shadow;if(C.map&&(i.spotLightMap[b]=C.map,b++,X.updateMatrices(C),C.castShadow&&B++),i.spotLightMatrix[y]=X.matrix,C.castShadow){let J=e.get(C);J.shadowIntensity=X.intensity,J.shadowBias=X.bias,J.shadowNormalBias=X.normalBias,J.shadowRadius=X.radius,J.shadowMapSize=X.mapSize,i.spotShadow[y]=J,i.spotShadowMap[y]=$,_++}y++}else if(C.isRectAreaLight){let V=t.get(C);V.color.copy(N).multiplyScalar(U),V.halfWidth.set(C.width*.5,0,0),V.halfHeight.set(0,C.height*.5,0),i.rectArea[S]=V,S++}else if(C.isPointLight){let V=t.get(C);if(V.color.copy(C.color).multiplyScalar(C.intensity),V.distance=C.distance,V.decay=C.decay,C.castShadow){let X=C.shadow,J=e.get(C);J.shadowIntensity=X.intensity,J.shadowBias=X.bias,J.shadowNormalBias=X.normalBias,J.shadowRadius=X.radius,J.shadowMapSize=X.mapSize,J.shadowCameraNear=X.camera.near,J.shadowCameraFar=X.camera.far,i.pointShadow[m]=J,i.pointShadowMap[m]=$,i.pointShadowMatrix[m]=C.shadow.matrix,w++}i.point[m]=V,m++}else if(C.isHemisphereLight){let V=t.get(C);V.skyColor.copy(C.color).multiplyScalar(U),V.groundColor.copy(C.groundColor).multiplyScalar(U),i.hemi[v]=V,v++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Nt.LTC_FLOAT_1,i.rectAreaLTC2=Nt.LTC_FLOAT_2):(i.rectAreaLTC1=Nt.LTC_HALF_1,i.rectAreaLTC2=Nt.LTC_HALF_2)),i.ambient[0]=d,i.ambient[1]=u,i.ambient[2]=h;let P=i.hash;(P.sunLength!==f||P.directionalLength!==p||P.pointLength!==m||P.spotLength!==y||P.rectAreaLength!==S||P.hemiLength!==v||P.numSunShadows!==g||P.numDirectionalShadows!==E||P.numPointShadows!==w||P.numSpotShadows!==_||P.numSpotMaps!==b||P.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=p,i.spot.length=y,i.rectArea.length=S,i.point.length=m,i.hemi.length=v,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+b-B,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=I,P.sunLength=f,P.directionalLength=p,P.pointLength=m,P.spotLength=y,P.rectAreaLength=S,P.hemiLength=v,P.numSunShadows=g,P.numDirectionalShadows=E,P.numPointShadows=w,P.numSpotShadows=_,P.numSpotMaps=b,P.numLightProbes=I,i.version=$b++)}function l(c,d){let u=0,h=0,f=0,g=0,x=0,p=0,m=d.matrixWorldInverse;for(let y=0,S=c.length;y<S;y++){let v=c[y];if(v.isSunLight){let E=i.sun[u];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(m),u++}else if(v.isDirectionalLight){let E=i.directional[h];E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),h++}else if(v.isSpotLight){let E=i.spot[g];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),E.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(m),g++}else if(v.isRectAreaLight){let E=i.rectArea[x];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),o.identity(),r.copy(v.matrixWorld),r.premultiply(m),o.extractRotation(r),E.halfWidth.set(v.width*.5,0,0),E.halfHeight.set(0,v.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let E=i.point[f];E.position.setFromMatrixPosition(v.matrixWorld),E.position.applyMatrix4(m),f++}else if(v.isHemisphereLight){let E=i.hemi[p];E.direction.setFromMatrixPosition(v.matrixWorld),E.direction.transformDirection(m),p++}}}return{setup:a,setupView:l,state:i}}function Tg(n){let t=new Zb(n),e=[],i=[],s=[];function r(u){d.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,h)=>u.priority-h.priority||u.id-h.id)}function c(u){t.setupView(e,u)}let d={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:d,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function Jb(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Tg(n),t.set(s,[a])):r>=o.length?(a=new Tg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var Kb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,jb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Qb=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],tw=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],Eg=new Xe,il=new K,Kd=new K;function ew(n,t,e){let i=new ir,s=new Kt,r=new Kt,o=new en,a=new Ic,l=new Lc,c={},d=e.maxTextureSize,u={[hs]:oi,[oi]:hs,[li]:li},h=new cs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Kt},radius:{value:4}},vertexShader:Kb,fragmentShader:jb}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let g=new On;g.setAttribute("position",new ii(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new $n(g,h),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Za;let m=this.type;this.render=function(w,_,b){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===Mm&&(ee("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Za);let B=n.getRenderTarget(),I=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),O=n.state;O.setBlending(Rr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=m!==this.type;z&&_.traverse(function(C){C.material&&(Array.isArray(C.material)?C.material.forEach(N=>N.needsUpdate=!0):C.material.needsUpdate=!0)});for(let C=0,N=w.length;C<N;C++){let U=w[C],k=U.shadow;if(k===void 0){ee("WebGLShadowMap:",U,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let $=k.getFrameExtents();s.multiply($),r.copy(k.mapSize),(s.x>d||s.y>d)&&(s.x>d&&(r.x=Math.floor(d/$.x),s.x=r.x*$.x,k.mapSize.x=r.x),s.y>d&&(r.y=Math.floor(d/$.y),s.y=r.y*$.y,k.mapSize.y=r.y));let V=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=V,k.map===null||z===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===Lo){if(U.isPointLight){ee("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new vi(s.x,s.y,{format:hr,type:Xi,minFilter:si,magFilter:si,generateMipmaps:!1}),k.map.texture.name=U.name+".shadowMap",k.map.depthTexture=new Ls(s.x,s.y,Wi),k.map.depthTexture.name=U.name+".shadowMapDepth",k.map.depthTexture.format=Ps,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Fn,k.map.depthTexture.magFilter=Fn}else U.isPointLight?(k.map=new rl(s.x),k.map.depthTexture=new ka(s.x,Hi)):(k.map=new vi(s.x,s.y),k.map.depthTexture=new Ls(s.x,s.y,Hi)),k.map.depthTexture.name=U.name+".shadowMap",k.map.depthTexture.format=Ps,this.type===Za?(k.map.depthTexture.compareFunction=V?Od:Fd,k.map.depthTexture.minFilter=si,k.map.depthTexture.magFilter=si):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Fn,k.map.depthTexture.magFilter=Fn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let X=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();U.isPointLight!==!0&&k.updateMatrices(U,b);let J=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:b.layers;for(let nt=0;nt<X;nt++){let Q=k.getCamera(nt);if(U.isPointLight){let W=k.camera,st=k.matrix,ht=U.distance||W.far;ht!==W.far&&(W.far=ht,W.updateProjectionMatrix()),il.setFromMatrixPosition(U.matrixWorld),W.position.copy(il),Kd.copy(W.position),Kd.add(Qb[nt]),W.up.copy(tw[nt]),W.lookAt(Kd),W.updateMatrixWorld(),st.makeTranslation(-il.x,-il.y,-il.z),Eg.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),k._frustum.setFromProjectionMatrix(Eg,W.coordinateSystem,W.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,nt),n.clear();else{nt===0&&(n.setRenderTarget(k.map),n.clear());let W=k.getViewport(nt);o.set(r.x*W.x,r.y*W.y,r.x*W.z,r.y*W.w),O.viewport(o)}i=k.getFrustum(nt),v(_,b,Q,U,J,this.type)}k.isPointLightShadow!==!0&&this.type===Lo&&y(k,b),k.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(B,I,P)};function y(w,_){let b=t.update(x);h.defines.VSM_SAMPLES!==w.blurSamples&&(h.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new vi(s.x,s.y,{format:hr,type:Xi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),h.uniforms.shadow_pass.value=w.map.depthTexture,h.uniforms.resolution.value.set(w.map.width,w.map.height),h.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(_,null,b,h,x,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(_,null,b,f,x,null)}function S(w,_,b,B){let I=null,P=b.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(P!==void 0)I=P;else if(I=b.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=I.uuid,z=_.uuid,C=c[O];C===void 0&&(C={},c[O]=C);let N=C[z];N===void 0&&(N=I.clone(),C[z]=N,_.addEventListener("dispose",E)),I=N}if(I.visible=_.visible,I.wireframe=_.wireframe,B===Lo?I.side=_.shadowSide!==null?_.shadowSide:_.side:I.side=_.shadowSide!==null?_.shadowSide:u[_.side],I.alphaMap=_.alphaMap,I.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,I.map=_.map,I.clipShadows=_.clipShadows,I.clippingPlanes=_.clippingPlanes,I.clipIntersection=_.clipIntersection,I.displacementMap=_.displacementMap,I.displacementScale=_.displacementScale,I.displacementBias=_.displacementBias,I.wireframeLinewidth=_.wireframeLinewidth,I.linewidth=_.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let O=n.properties.get(I);O.light=b}return I}function v(w,_,b,B,I,P){if(w.visible===!1)return;if(w.layers.test(I)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&P===Lo)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,w.matrixWorld);let C=t.update(w),N=w.material;if(Array.isArray(N)){let U=C.groups;for(let k=0,$=U.length;k<$;k++){let V=U[k],X=N[V.materialIndex];if(X&&X.visible){let J=S(w,X,B,P);w.onBeforeShadow(n,w,_,b,C,J,V),n.renderBufferDirect(b,null,C,J,w,V),w.onAfterShadow(n,w,_,b,C,J,V)}}}else if(N.visible){let U=S(w,N,B,P);w.onBeforeShadow(n,w,_,b,C,U,null),n.renderBufferDirect(b,null,C,U,w,null),w.onAfterShadow(n,w,_,b,C,U,null)}}let z=w.children;for(let C=0,N=z.length;C<N;C++)v(z[C],_,b,B,I,P)}function E(w){w.target.removeEventListener("dispose",E);for(let b in c){let B=c[b],I=w.target.uuid;I in B&&(B[I].dispose(),delete B[I])}}}function nw(n,t){function e(){let H=!1,ut=new en,at=null,Et=new en(0,0,0,0);return{setMask:function(vt){at!==vt&&!H&&(n.colorMask(vt,vt,vt,vt),at=vt)},setLocked:function(vt){H=vt},setClear:function(vt,wt,$t,ie,pt){pt===!0&&(vt*=ie,wt*=ie,$t*=ie),ut.set(vt,wt,$t,ie),Et.equals(ut)===!1&&(n.clearColor(vt,wt,$t,ie),Et.copy(ut))},reset:function(){H=!1,at=null,Et.set(-1,0,0,0)}}}function i(){let H=!1,ut=!1,at=null,Et=null,vt=null;return{setReversed:function(wt){if(ut!==wt){let $t=t.get("EXT_clip_control");wt?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),ut=wt;let ie=vt;vt=null,this.setClear(ie)}},getReversed:function(){return ut},setTest:function(wt){wt?gt(n.DEPTH_TEST):xt(n.DEPTH_TEST)},setMask:function(wt){at!==wt&&!H&&(n.depthMask(wt),at=wt)},setFunc:function(wt){if(ut&&(wt=tg[wt]),Et!==wt){switch(wt){case hc:n.depthFunc(n.NEVER);break;case uc:n.depthFunc(n.ALWAYS);break;case dc:n.depthFunc(n.LESS);break;case So:n.depthFunc(n.LEQUAL);break;case fc:n.depthFunc(n.EQUAL);break;case pc:n.depthFunc(n.GEQUAL);break;case mc:n.depthFunc(n.GREATER);break;case gc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=wt}},setLocked:function(wt){H=wt},setClear:function(wt){vt!==wt&&(vt=wt,ut&&(wt=1-wt),n.clearDepth(wt))},reset:function(){H=!1,at=null,Et=null,vt=null,ut=!1}}}function s(){let H=!1,ut=null,at=null,Et=null,vt=null,wt=null,$t=null,ie=null,pt=null;return{setTest:function(Gt){H||(Gt?gt(n.STENCIL_TEST):xt(n.STENCIL_TEST))},setMask:function(Gt){ut!==Gt&&!H&&(n.stencilMask(Gt),ut=Gt)},setFunc:function(Gt,se,Pt){(at!==Gt||Et!==se||vt!==Pt)&&(n.stencilFunc(Gt,se,Pt),at=Gt,Et=se,vt=Pt)},setOp:function(Gt,se,Pt){(wt!==Gt||$t!==se||ie!==Pt)&&(n.stencilOp(Gt,se,Pt),wt=Gt,$t=se,ie=Pt)},setLocked:function(Gt){H=Gt},setClear:function(Gt){pt!==Gt&&(n.clearStencil(Gt),pt=Gt)},reset:function(){H=!1,ut=null,at=null,Et=null,vt=null,wt=null,$t=null,ie=null,pt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,d={},u={},h={},f=new WeakMap,g=[],x=null,p=!1,m=null,y=null,S=null,v=null,E=null,w=null,_=null,b=new fe(0,0,0),B=0,I=!1,P=null,O=null,z=null,C=null,N=null,U=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,$=0,V=n.getParameter(n.VERSION);V.indexOf("WebGL")!==-1?($=parseFloat(/^WebGL (\d)/.exec(V)[1]),k=$>=1):V.indexOf("OpenGL ES")!==-1&&($=parseFloat(/^OpenGL ES (\d)/.exec(V)[1]),k=$>=2);let X=null,J={},nt=n.getParameter(n.SCISSOR_BOX),Q=n.getParameter(n.VIEWPORT),W=new en().fromArray(nt),st=new en().fromArray(Q);function ht(H,ut,at,Et){let vt=new Uint8Array(4),wt=n.createTexture();n.bindTexture(H,wt),n.texParameteri(H,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(H,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $t=0;$t<at;$t++)H===n.TEXTURE_3D||H===n.TEXTURE_2D_ARRAY?n.texImage3D(ut,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,vt):n.texImage2D(ut+$t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,vt);return wt}let ct={};ct[n.TEXTURE_2D]=ht(n.TEXTURE_2D,n.TEXTURE_2D,1),ct[n.TEXTURE_CUBE_MAP]=ht(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ct[n.TEXTURE_2D_ARRAY]=ht(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ct[n.TEXTURE_3D]=ht(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),gt(n.DEPTH_TEST),o.setFunc(So),Ce(!1),Pe(md),gt(n.CULL_FACE),ke(Rr);function gt(H){d[H]!==!0&&(n.enable(H),d[H]=!0)}function xt(H){d[H]!==!1&&(n.disable(H),d[H]=!1)}function Ut(H,ut){return h[H]!==ut?(n.bindFramebuffer(H,ut),h[H]=ut,H===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ut),H===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ut),!0):!1}function Lt(H,ut){let at=g,Et=!1;if(H){at=f.get(ut),at===void 0&&(at=[],f.set(ut,at));let vt=H.textures;if(at.length!==vt.length||at[0]!==n.COLOR_ATTACHMENT0){for(let wt=0,$t=vt.length;wt<$t;wt++)at[wt]=n.COLOR_ATTACHMENT0+wt;at.length=vt.length,Et=!0}}else at[0]!==n.BACK&&(at[0]=n.BACK,Et=!0);Et&&n.drawBuffers(at)}function Qt(H){return x!==H?(n.useProgram(H),x=H,!0):!1}let te={[Cr]:n.FUNC_ADD,[bm]:n.FUNC_SUBTRACT,[wm]:n.FUNC_REVERSE_SUBTRACT};te[Tm]=n.MIN,te[Em]=n.MAX;let qt={[Am]:n.ZERO,[Rm]:n.ONE,[Cm]:n.SRC_COLOR,[yd]:n.SRC_ALPHA,[Um]:n.SRC_ALPHA_SATURATE,[Dm]:n.DST_COLOR,[Im]:n.DST_ALPHA,[Pm]:n.ONE_MINUS_SRC_COLOR,[vd]:n.ONE_MINUS_SRC_ALPHA,[Nm]:n.ONE_MINUS_DST_COLOR,[Lm]:n.ONE_MINUS_DST_ALPHA,[Fm]:n.CONSTANT_COLOR,[Om]:n.ONE_MINUS_CONSTANT_COLOR,[Bm]:n.CONSTANT_ALPHA,[km]:n.ONE_MINUS_CONSTANT_ALPHA};function ke(H,ut,at,Et,vt,wt,$t,ie,pt,Gt){if(H===Rr){p===!0&&(xt(n.BLEND),p=!1);return}if(p===!1&&(gt(n.BLEND),p=!0),H!==Sm){if(H!==m||Gt!==I){if((y!==Cr||E!==Cr)&&(n.blendEquation(n.FUNC_ADD),y=Cr,E=Cr),Gt)switch(H){case Do:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case gd:n.blendFunc(n.ONE,n.ONE);break;case _d:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case xd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:re("WebGLState: Invalid blending: ",H);break}else switch(H){case Do:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case gd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case _d:re("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case xd:re("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:re("WebGLState: Invalid blending: ",H);break}S=null,v=null,w=null,_=null,b.set(0,0,0),B=0,m=H,I=Gt}return}vt=vt||ut,wt=wt||at,$t=$t||Et,(ut!==y||vt!==E)&&(n.blendEquationSeparate(te[ut],te[vt]),y=ut,E=vt),(at!==S||Et!==v||wt!==w||$t!==_)&&(n.blendFuncSeparate(qt[at],qt[Et],qt[wt],qt[$t]),S=at,v=Et,w=wt,_=$t),(ie.equals(b)===!1||pt!==B)&&(n.blendColor(ie.r,ie.g,ie.b,pt),b.copy(ie),B=pt),m=H,I=!1}function oe(H,ut){H.side===li?xt(n.CULL_FACE):gt(n.CULL_FACE);let at=H.side===oi;ut&&(at=!at),Ce(at),H.blending===Do&&H.transparent===!1?ke(Rr):ke(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),o.setFunc(H.depthFunc),o.setTest(H.depthTest),o.setMask(H.depthWrite),r.setMask(H.colorWrite);let Et=H.stencilWrite;a.setTest(Et),Et&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),ve(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?gt(n.SAMPLE_ALPHA_TO_COVERAGE):xt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ce(H){P!==H&&(H?n.frontFace(n.CW):n.frontFace(n.CCW),P=H)}function Pe(H){H!==ym?(gt(n.CULL_FACE),H!==O&&(H===md?n.cullFace(n.BACK):H===vm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):xt(n.CULL_FACE),O=H}function mn(H){H!==z&&(k&&n.lineWidth(H),z=H)}function ve(H,ut,at){H?(gt(n.POLYGON_OFFSET_FILL),(C!==ut||N!==at)&&(C=ut,N=at,o.getReversed()&&(ut=-ut,at=-at),n.polygonOffset(ut,at))):xt(n.POLYGON_OFFSET_FILL)}function hn(H){H?gt(n.SCISSOR_TEST):xt(n.SCISSOR_TEST)}function Qe(H){H===void 0&&(H=n.TEXTURE0+U-1),X!==H&&(n.activeTexture(H),X=H)}function sn(H,ut,at){at===void 0&&(X===null?at=n.TEXTURE0+U-1:at=X);let Et=J[at];Et===void 0&&(Et={type:void 0,texture:void 0},J[at]=Et),(Et.type!==H||Et.texture!==ut)&&(X!==at&&(n.activeTexture(at),X=at),n.bindTexture(H,ut||ct[H]),Et.type=H,Et.texture=ut)}function G(){let H=J[X];H!==void 0&&H.type!==void 0&&(n.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function Ct(){try{n.compressedTexImage2D(...arguments)}catch(H){re("WebGLState:",H)}}function Zt(){try{n.compressedTexImage3D(...arguments)}catch(H){re("WebGLState:",H)}}function ae(){try{n.texSubImage2D(...arguments)}catch(H){re("WebGLState:",H)}}function Tt(){try{n.texSubImage3D(...arguments)}catch(H){re("WebGLState:",H)}}function Ve(){try{n.compressedTexSubImage2D(...arguments)}catch(H){re("WebGLState:",H)}}function Xt(){try{n.compressedTexSubImage3D(...arguments)}catch(H){re("WebGLState:",H)}}function jt(){try{n.texStorage2D(...arguments)}catch(H){re("WebGLState:",H)}}function L(){try{n.texStorage3D(...arguments)}catch(H){re("WebGLState:",H)}}function T(){try{n.texImage2D(...arguments)}catch(H){re("WebGLState:",H)}}function j(){try{n.texImage3D(...arguments)}catch(H){re("WebGLState:",H)}}function mt(H){return u[H]!==void 0?u[H]:n.getParameter(H)}function dt(H,ut){u[H]!==ut&&(n.pixelStorei(H,ut),u[H]=ut)}function Mt(H){W.equals(H)===!1&&(n.scissor(H.x,H.y,H.z,H.w),W.copy(H))}function St(H){st.equals(H)===!1&&(n.viewport(H.x,H.y,H.z,H.w),st.copy(H))}function ot(H,ut){let at=c.get(ut);at===void 0&&(at=new WeakMap,c.set(ut,at));let Et=at.get(H);Et===void 0&&(Et=n.getUniformBlockIndex(ut,H.name),n.uniformBlockBinding(ut,Et,Et),at.set(H,Et))}function lt(H,ut,at){let vt=c.get(ut).get(H);l[vt]!==at&&(n.bindBufferBase(n.UNIFORM_BUFFER,vt,at),l[vt]=at)}function yt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),d={},u={},X=null,J={},h={},l={},f=new WeakMap,g=[],x=null,p=!1,m=null,y=null,S=null,v=null,E=null,w=null,_=null,b=new fe(0,0,0),B=0,I=!1,P=null,O=null,z=null,C=null,N=null,W.set(0,0,n.canvas.width,n.canvas.height),st.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:gt,disable:xt,bindFramebuffer:Ut,drawBuffers:Lt,useProgram:Qt,setBlending:ke,setMaterial:oe,setFlipSided:Ce,setCullFace:Pe,setLineWidth:mn,setPolygonOffset:ve,setScissorTest:hn,activeTexture:Qe,bindTexture:sn,unbindTexture:G,compressedTexImage2D:Ct,compressedTexImage3D:Zt,texImage2D:T,texImage3D:j,pixelStorei:dt,getParameter:mt,updateUBOMapping:ot,uniformBlockBinding:lt,texStorage2D:jt,texStorage3D:L,texSubImage2D:ae,texSubImage3D:Tt,compressedTexSubImage2D:Ve,compressedTexSubImage3D:Xt,scissor:Mt,viewport:St,reset:yt}}function iw(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Kt,d=new WeakMap,u=new Set,h,f=new WeakMap,g=new Set,x=new FinalizationRegistry(L=>g.delete(L)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(L,T){return p?new OffscreenCanvas(L,T):Ra("canvas")}function y(L,T,j){let mt=1,dt=jt(L);if((dt.width>j||dt.height>j)&&(mt=j/Math.max(dt.width,dt.height)),mt<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let Mt=Math.floor(mt*dt.width),St=Math.floor(mt*dt.height);h===void 0&&(h=m(Mt,St));let ot=T?m(Mt,St):h;return ot.width=Mt,ot.height=St,ot.getContext("2d").drawImage(L,0,0,Mt,St),ee("WebGLRenderer: Texture has been resized from ("+dt.width+"x"+dt.height+") to ("+Mt+"x"+St+")."),ot}else return"data"in L&&ee("WebGLRenderer: Image in DataTexture is too big ("+dt.width+"x"+dt.height+")."),L;return L}function S(L){return L.generateMipmaps}function v(L){n.generateMipmap(L)}function E(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(L,T,j,mt,dt,Mt=!1){if(L!==null){if(n[L]!==void 0)return n[L];ee("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let St;mt&&(St=t.get("EXT_texture_norm16"),St||ee("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ot=T;if(T===n.RED&&(j===n.FLOAT&&(ot=n.R32F),j===n.HALF_FLOAT&&(ot=n.R16F),j===n.UNSIGNED_BYTE&&(ot=n.R8),j===n.UNSIGNED_SHORT&&St&&(ot=St.R16_EXT),j===n.SHORT&&St&&(ot=St.R16_SNORM_EXT)),T===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(ot=n.R8UI),j===n.UNSIGNED_SHORT&&(ot=n.R16UI),j===n.UNSIGNED_INT&&(ot=n.R32UI),j===n.BYTE&&(ot=n.R8I),j===n.SHORT&&(ot=n.R16I),j===n.INT&&(ot=n.R32I)),T===n.RG&&(j===n.FLOAT&&(ot=n.RG32F),j===n.HALF_FLOAT&&(ot=n.RG16F),j===n.UNSIGNED_BYTE&&(ot=n.RG8),j===n.UNSIGNED_SHORT&&St&&(ot=St.RG16_EXT),j===n.SHORT&&St&&(ot=St.RG16_SNORM_EXT)),T===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(ot=n.RG8UI),j===n.UNSIGNED_SHORT&&(ot=n.RG16UI),j===n.UNSIGNED_INT&&(ot=n.RG32UI),j===n.BYTE&&(ot=n.RG8I),j===n.SHORT&&(ot=n.RG16I),j===n.INT&&(ot=n.RG32I)),T===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(ot=n.RGB8UI),j===n.UNSIGNED_SHORT&&(ot=n.RGB16UI),j===n.UNSIGNED_INT&&(ot=n.RGB32UI),j===n.BYTE&&(ot=n.RGB8I),j===n.SHORT&&(ot=n.RGB16I),j===n.INT&&(ot=n.RGB32I)),T===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(ot=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(ot=n.RGBA16UI),j===n.UNSIGNED_INT&&(ot=n.RGBA32UI),j===n.BYTE&&(ot=n.RGBA8I),j===n.SHORT&&(ot=n.RGBA16I),j===n.INT&&(ot=n.RGBA32I)),T===n.RGB&&(j===n.UNSIGNED_SHORT&&St&&(ot=St.RGB16_EXT),j===n.SHORT&&St&&(ot=St.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(ot=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(ot=n.R11F_G11F_B10F)),T===n.RGBA){let lt=Mt?Aa:Se.getTransfer(dt);j===n.FLOAT&&(ot=n.RGBA32F),j===n.HALF_FLOAT&&(ot=n.RGBA16F),j===n.UNSIGNED_BYTE&&(ot=lt===Ne?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&St&&(ot=St.RGBA16_EXT),j===n.SHORT&&St&&(ot=St.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(ot=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(ot=n.RGB5_A1)}return(ot===n.R16F||ot===n.R32F||ot===n.RG16F||ot===n.RG32F||ot===n.RGBA16F||ot===n.RGBA32F)&&t.get("EXT_color_buffer_float"),ot}function _(L,T){let j;return L?T===null||T===Hi||T===Ir?j=n.DEPTH24_STENCIL8:T===Wi?j=n.DEPTH32F_STENCIL8:T===Uo&&(j=n.DEPTH24_STENCIL8,ee("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Hi||T===Ir?j=n.DEPTH_COMPONENT24:T===Wi?j=n.DEPTH_COMPONENT32F:T===Uo&&(j=n.DEPTH_COMPONENT16),j}function b(L,T){return S(L)===!0||L.isFramebufferTexture&&L.minFilter!==Fn&&L.minFilter!==si?Math.log2(Math.max(T.width,T.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?T.mipmaps.length:1}function B(L){let T=new WeakRef(L);i.get(L).__ref=T,g.add(T),x.register(L,T,T)}function I(L){let T=i.get(L).__ref;T!==void 0&&(g.delete(T),x.unregister(T))}function P(L){z(L.target)}function O(L){C(L.target)}function z(L){L.removeEventListener("dispose",P),I(L),U(L),L.isVideoTexture&&d.delete(L),L.isHTMLTexture&&u.delete(L)}function C(L){L.removeEventListener("dispose",O),I(L),$(L)}function N(){for(let L of g){let T=L.deref();T!==void 0&&(T.isRenderTarget===!0?C(T):z(T))}g.clear(),u.clear()}function U(L){let T=i.get(L);if(T.__webglInit===void 0)return;let j=L.source,mt=f.get(j);if(mt){let dt=mt[T.__cacheKey];dt.usedTimes--,dt.usedTimes===0&&k(L),Object.keys(mt).length===0&&f.delete(j)}i.remove(L)}function k(L){let T=i.get(L);n.deleteTexture(T.__webglTexture);let j=L.source,mt=f.get(j);delete mt[T.__cacheKey],o.memory.textures--}function $(L){let T=i.get(L);T.__depthDisposeCallback&&T.__depthDisposeCallback();let j=L.depthTexture;if(j&&j.renderTarget===L&&z(j),L.isWebGLCubeRenderTarget)for(let dt=0;dt<6;dt++){if(Array.isArray(T.__webglFramebuffer[dt]))for(let Mt=0;Mt<T.__webglFramebuffer[dt].length;Mt++)n.deleteFramebuffer(T.__webglFramebuffer[dt][Mt]);else n.deleteFramebuffer(T.__webglFramebuffer[dt]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[dt])}else{if(Array.isArray(T.__webglFramebuffer))for(let dt=0;dt<T.__webglFramebuffer.length;dt++)n.deleteFramebuffer(T.__webglFramebuffer[dt]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let dt=0;dt<T.__webglColorRenderbuffer.length;dt++)T.__webglColorRenderbuffer[dt]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[dt]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let mt=L.textures;for(let dt=0,Mt=mt.length;dt<Mt;dt++){let St=i.get(mt[dt]);St.__webglTexture&&(n.deleteTexture(St.__webglTexture),o.memory.textures--),i.remove(mt[dt])}i.remove(L)}let V=0;function X(){V=0}function J(){return V}function nt(L){V=L}function Q(){let L=V;return L>=s.maxTextures&&ee("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),V+=1,L}function W(L){let T=[];return T.push(L.wrapS),T.push(L.wrapT),T.push(L.wrapR||0),T.push(L.magFilter),T.push(L.minFilter),T.push(L.anisotropy),T.push(L.internalFormat),T.push(L.format),T.push(L.type),T.push(L.generateMipmaps),T.push(L.mipmapsAutoUpdate),T.push(L.premultiplyAlpha),T.push(L.flipY),T.push(L.unpackAlignment),T.push(L.colorSpace),T.join()}function st(L,T){let j=i.get(L);if(L.isVideoTexture&&Ve(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&j.__version!==L.version){let mt=L.image;if(mt===null)ee("WebGLRenderer: Texture marked for update but no image data found.");else if(mt.complete===!1)ee("WebGLRenderer: Texture marked for update but image is incomplete");else{oe(j,L,T);return}}else L.isExternalTexture&&(j.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+T)}function ht(L,T){let j=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&j.__version!==L.version){oe(j,L,T);return}else L.isExternalTexture&&(j.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+T)}function ct(L,T){let j=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&j.__version!==L.version){oe(j,L,T);return}e.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+T)}function gt(L,T){let j=i.get(L);if(L.version>0&&j.__version!==L.version){Ce(j,L,T);return}e.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+T)}let xt={[_c]:n.REPEAT,[as]:n.CLAMP_TO_EDGE,[xc]:n.MIRRORED_REPEAT},Ut={[Fn]:n.NEAREST,[Gm]:n.NEAREST_MIPMAP_NEAREST,[Ja]:n.NEAREST_MIPMAP_LINEAR,[si]:n.LINEAR,[Yc]:n.LINEAR_MIPMAP_NEAREST,[Ns]:n.LINEAR_MIPMAP_LINEAR},Lt={[qm]:n.NEVER,[Bd]:n.ALWAYS,[$m]:n.LESS,[Fd]:n.LEQUAL,[Ym]:n.EQUAL,[Od]:n.GEQUAL,[Zm]:n.GREATER,[Jm]:n.NOTEQUAL};function Qt(L,T){if(T.type===Wi&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===si||T.magFilter===Yc||T.magFilter===Ja||T.magFilter===Ns||T.minFilter===si||T.minFilter===Yc||T.minFilter===Ja||T.minFilter===Ns)&&ee("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,xt[T.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,xt[T.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,xt[T.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,Ut[T.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,Ut[T.minFilter]),T.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Lt[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===Fn||T.minFilter!==Ja&&T.minFilter!==Ns||T.type===Wi&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let j=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function te(L,T){let j=!1;L.__webglInit===void 0&&(L.__webglInit=!0,T.addEventListener("dispose",P),B(T));let mt=T.source,dt=f.get(mt);dt===void 0&&(dt={},f.set(mt,dt));let Mt=W(T);if(Mt!==L.__cacheKey){dt[Mt]===void 0&&(dt[Mt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),dt[Mt].usedTimes++;let St=dt[L.__cacheKey];St!==void 0&&(dt[L.__cacheKey].usedTimes--,St.usedTimes===0&&k(T)),L.__cacheKey=Mt,L.__webglTexture=dt[Mt].texture}return j}function qt(L,T,j){return Math.floor(Math.floor(L/j)/T)}function ke(L,T,j,mt){let Mt=L.updateRanges;if(Mt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,j,mt,T.data);else{Mt.sort((H,ut)=>H.start-ut.start);let St=0;for(let H=1;H<Mt.length;H++){let ut=Mt[St],at=Mt[H],Et=ut.start+ut.count,vt=qt(at.start,T.width,4),wt=qt(ut.start,T.width,4);at.start<=Et+1&&vt===wt&&qt(at.start+at.count-1,T.width,4)===vt?ut.count=Math.max(ut.count,at.start+at.count-ut.start):(++St,Mt[St]=at)}Mt.length=St+1;let ot=e.getParameter(n.UNPACK_ROW_LENGTH),lt=e.getParameter(n.UNPACK_SKIP_PIXELS),yt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let H=0,ut=Mt.length;H<ut;H++){let at=Mt[H],Et=Math.floor(at.start/4),vt=Math.ceil(at.count/4),wt=Et%T.width,$t=Math.floor(Et/T.width),ie=vt,pt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,wt),e.pixelStorei(n.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(n.TEXTURE_2D,0,wt,$t,ie,pt,j,mt,T.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,ot),e.pixelStorei(n.UNPACK_SKIP_PIXELS,lt),e.pixelStorei(n.UNPACK_SKIP_ROWS,yt)}}function oe(L,T,j){let mt=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(mt=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(mt=n.TEXTURE_3D);let dt=te(L,T),Mt=T.source;e.bindTexture(mt,L.__webglTexture,n.TEXTURE0+j);let St=i.get(Mt);if(Mt.version!==St.__version||dt===!0){if(e.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let pt=Se.getPrimaries(Se.workingColorSpace),Gt=T.colorSpace===Fs?null:Se.getPrimaries(T.colorSpace),se=T.colorSpace===Fs||pt===Gt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se)}e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let lt=y(T.image,!1,s.maxTextureSize);lt=Xt(T,lt);let yt=r.convert(T.format,T.colorSpace),H=r.convert(T.type),ut=w(T.internalFormat,yt,H,T.normalized,T.colorSpace,T.isVideoTexture);Qt(mt,T);let at,Et=T.mipmaps,vt=T.isVideoTexture!==!0,wt=St.__version===void 0||dt===!0,$t=Mt.dataReady,ie=b(T,lt);if(T.isDepthTexture)ut=_(T.format===Us,T.type),wt&&(vt?e.texStorage2D(n.TEXTURE_2D,1,ut,lt.width,lt.height):e.texImage2D(n.TEXTURE_2D,0,ut,lt.width,lt.height,0,yt,H,null));else if(T.isDataTexture)if(Et.length>0){vt&&wt&&e.texStorage2D(n.TEXTURE_2D,ie,ut,Et[0].width,Et[0].height);for(let pt=0,Gt=Et.length;pt<Gt;pt++)at=Et[pt],vt?$t&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,at.width,at.height,yt,H,at.data):e.texImage2D(n.TEXTURE_2D,pt,ut,at.width,at.height,0,yt,H,at.data);T.generateMipmaps=!1}else vt?(wt&&e.texStorage2D(n.TEXTURE_2D,ie,ut,lt.width,lt.height),$t&&ke(T,lt,yt,H)):e.texImage2D(n.TEXTURE_2D,0,ut,lt.width,lt.height,0,yt,H,lt.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){vt&&wt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ie,ut,Et[0].width,Et[0].height,lt.depth);for(let pt=0,Gt=Et.length;pt<Gt;pt++)if(at=Et[pt],T.format!==qi)if(yt!==null)if(vt){if($t)if(T.layerUpdates.size>0){let se=Zd(at.width,at.height,T.format,T.type);for(let Pt of T.layerUpdates){let de=at.data.subarray(Pt*se/at.data.BYTES_PER_ELEMENT,(Pt+1)*se/at.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,Pt,at.width,at.height,1,yt,de)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,at.width,at.height,lt.depth,yt,at.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,pt,ut,at.width,at.height,lt.depth,0,at.data,0,0);else ee("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else vt?$t&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,pt,0,0,0,at.width,at.height,lt.depth,yt,H,at.data):e.texImage3D(n.TEXTURE_2D_ARRAY,pt,ut,at.width,at.height,lt.depth,0,yt,H,at.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{vt&&wt&&e.texStorage2D(n.TEXTURE_2D,ie,ut,Et[0].width,Et[0].height);for(let pt=0,Gt=Et.length;pt<Gt;pt++)at=Et[pt],T.format!==qi?yt!==null?vt?$t&&e.compressedTexSubImage2D(n.TEXTURE_2D,pt,0,0,at.width,at.height,yt,at.data):e.compressedTexImage2D(n.TEXTURE_2D,pt,ut,at.width,at.height,0,at.data):ee("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):vt?$t&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,at.width,at.height,yt,H,at.data):e.texImage2D(n.TEXTURE_2D,pt,ut,at.width,at.height,0,yt,H,at.data)}else if(T.isDataArrayTexture)if(vt){if(wt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ie,ut,lt.width,lt.height,lt.depth),$t)if(T.layerUpdates.size>0){let pt=Zd(lt.width,lt.height,T.format,T.type);for(let Gt of T.layerUpdates){let se=lt.data.subarray(Gt*pt/lt.data.BYTES_PER_ELEMENT,(Gt+1)*pt/lt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Gt,lt.width,lt.height,1,yt,H,se)}T.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,lt.width,lt.height,lt.depth,yt,H,lt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ut,lt.width,lt.height,lt.depth,0,yt,H,lt.data);else if(T.isData3DTexture)vt?(wt&&e.texStorage3D(n.TEXTURE_3D,ie,ut,lt.width,lt.height,lt.depth),$t&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,lt.width,lt.height,lt.depth,yt,H,lt.data)):e.texImage3D(n.TEXTURE_3D,0,ut,lt.width,lt.height,lt.depth,0,yt,H,lt.data);else if(T.isFramebufferTexture){if(wt)if(vt)e.texStorage2D(n.TEXTURE_2D,ie,ut,lt.width,lt.height);else{let pt=lt.width,Gt=lt.height;for(let se=0;se<ie;se++)e.texImage2D(n.TEXTURE_2D,se,ut,pt,Gt,0,yt,H,null),pt>>=1,Gt>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let pt=n.canvas;if(pt.hasAttribute("layoutsubtree")||pt.setAttribute("layoutsubtree","true"),lt.parentNode!==pt){pt.appendChild(lt),u.add(T),pt.onpaint=Gt=>{let se=Gt.changedElements;for(let Pt of u)se.includes(Pt.image)&&(Pt.needsUpdate=!0)},pt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,lt);else{let se=n.RGBA,Pt=n.RGBA,de=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,se,Pt,de,lt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(vt&&wt){let pt=jt(Et[0]);e.texStorage2D(n.TEXTURE_2D,ie,ut,pt.width,pt.height)}for(let pt=0,Gt=Et.length;pt<Gt;pt++)at=Et[pt],vt?$t&&e.texSubImage2D(n.TEXTURE_2D,pt,0,0,yt,H,at):e.texImage2D(n.TEXTURE_2D,pt,ut,yt,H,at);T.generateMipmaps=!1}else if(vt){if(wt){let pt=jt(lt);e.texStorage2D(n.TEXTURE_2D,ie,ut,pt.width,pt.height)}$t&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,yt,H,lt)}else e.texImage2D(n.TEXTURE_2D,0,ut,yt,H,lt);S(T)&&T.mipmapsAutoUpdate===!0&&v(mt),St.__version=Mt.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Ce(L,T,j){if(T.image.length!==6)return;let mt=te(L,T),dt=T.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+j);let Mt=i.get(dt);if(dt.version!==Mt.__version||mt===!0){e.activeTexture(n.TEXTURE0+j);let St=Se.getPrimaries(Se.workingColorSpace),ot=T.colorSpace===Fs?null:Se.getPrimaries(T.colorSpace),lt=T.colorSpace===Fs||St===ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,lt);let yt=T.isCompressedTexture||T.image[0].isCompressedTexture,H=T.image[0]&&T.image[0].isDataTexture,ut=[];for(let Pt=0;Pt<6;Pt++)!yt&&!H?ut[Pt]=y(T.image[Pt],!0,s.maxCubemapSize):ut[Pt]=H?T.image[Pt].image:T.image[Pt],ut[Pt]=Xt(T,ut[Pt]);let at=ut[0],Et=r.convert(T.format,T.colorSpace),vt=r.convert(T.type),wt=w(T.internalFormat,Et,vt,T.normalized,T.colorSpace),$t=T.isVideoTexture!==!0,ie=Mt.__version===void 0||mt===!0,pt=dt.dataReady,Gt=b(T,at);Qt(n.TEXTURE_CUBE_MAP,T);let se;if(T.isDepthTexture){if(wt=_(T.format===Us,T.type),ie)if($t)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,wt,at.width,at.height);else for(let Pt=0;Pt<6;Pt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,wt,at.width,at.height,0,Et,vt,null)}else if(yt){$t&&ie&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,wt,at.width,at.height);for(let Pt=0;Pt<6;Pt++){se=ut[Pt].mipmaps;for(let de=0;de<se.length;de++){let qe=se[de];T.format!==qi?Et!==null?$t?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de,0,0,qe.width,qe.height,Et,qe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de,wt,qe.width,qe.height,0,qe.data):ee("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de,0,0,qe.width,qe.height,Et,vt,qe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de,wt,qe.width,qe.height,0,Et,vt,qe.data)}}}else{if(se=T.mipmaps,$t&&ie){se.length>0&&Gt++;let Pt=jt(ut[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Gt,wt,Pt.width,Pt.height)}for(let Pt=0;Pt<6;Pt++)if(H){$t?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,0,0,ut[Pt].width,ut[Pt].height,Et,vt,ut[Pt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,wt,ut[Pt].width,ut[Pt].height,0,Et,vt,ut[Pt].data);for(let de=0;de<se.length;de++){let Zn=se[de].image[Pt].image;$t?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de+1,0,0,Zn.width,Zn.height,Et,vt,Zn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de+1,wt,Zn.width,Zn.height,0,Et,vt,Zn.data)}}else{$t?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,0,0,Et,vt,ut[Pt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,0,wt,Et,vt,ut[Pt]);for(let de=0;de<se.length;de++){let qe=se[de];$t?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de+1,0,0,Et,vt,qe.image[Pt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pt,de+1,wt,Et,vt,qe.image[Pt])}}}S(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),Mt.__version=dt.version,T.onUpdate&&T.onUpdate(T)}L.__version=T.version}function Pe(L,T,j,mt,dt,Mt){let St=r.convert(j.format,j.colorSpace),ot=r.convert(j.type),lt=w(j.internalFormat,St,ot,j.normalized,j.colorSpace),yt=i.get(T),H=i.get(j);if(H.__renderTarget=T,!yt.__hasExternalTextures){let ut=Math.max(1,T.width>>Mt),at=Math.max(1,T.height>>Mt);dt===n.TEXTURE_3D||dt===n.TEXTURE_2D_ARRAY?e.texImage3D(dt,Mt,lt,ut,at,T.depth,0,St,ot,null):e.texImage2D(dt,Mt,lt,ut,at,0,St,ot,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),Tt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,dt,H.__webglTexture,0,ae(T)):(dt===n.TEXTURE_2D||dt>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&dt<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,mt,dt,H.__webglTexture,Mt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function mn(L,T,j){if(n.bindRenderbuffer(n.RENDERBUFFER,L),T.depthBuffer){let mt=T.depthTexture,dt=mt&&mt.isDepthTexture?mt.type:null,Mt=_(T.stencilBuffer,dt),St=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Tt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ae(T),Mt,T.width,T.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,ae(T),Mt,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,Mt,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,L)}else{let mt=T.textures;for(let dt=0;dt<mt.length;dt++){let Mt=mt[dt],St=r.convert(Mt.format,Mt.colorSpace),ot=r.convert(Mt.type),lt=w(Mt.internalFormat,St,ot,Mt.normalized,Mt.colorSpace);Tt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ae(T),lt,T.width,T.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,ae(T),lt,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,lt,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ve(L,T,j){let mt=T.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let dt=i.get(T.depthTexture);dt.__renderTarget=T;let Mt=mt?T.depthTexture.image[0]:T.depthTexture.image;(!dt.__webglTexture||Mt.width!==T.width||Mt.height!==T.height)&&(Mt.width=T.width,Mt.height=T.height,T.depthTexture.needsUpdate=!0),mt?gt(T.depthTexture,0):st(T.depthTexture,0);let St=dt.__webglTexture,ot=ae(T),lt=mt?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,yt=T.depthTexture.format===Us?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===Ps)Tt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,yt,lt,St,0,ot):n.framebufferTexture2D(n.FRAMEBUFFER,yt,lt,St,0);else if(T.depthTexture.format===Us)Tt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,yt,lt,St,0,ot):n.framebufferTexture2D(n.FRAMEBUFFER,yt,lt,St,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function hn(L){let T=i.get(L),j=L.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==L.depthTexture){let mt=L.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),mt){let dt=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,mt.removeEventListener("dispose",dt)};mt.addEventListener("dispose",dt),T.__depthDisposeCallback=dt}T.__boundDepthTexture=mt}if(L.depthTexture&&!T.__autoAllocateDepthBuffer)if(j)for(let mt=0;mt<6;mt++)ve(T.__webglFramebuffer[mt],L,mt);else L.texture.mipmaps.length>0?ve(T.__webglFramebuffer[0],L,0):ve(T.__webglFramebuffer,L,0);else if(j){T.__webglDepthbuffer=[];for(let mt=0;mt<6;mt++)if(e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[mt]),T.__webglDepthbuffer[mt]===void 0)T.__webglDepthbuffer[mt]=n.createRenderbuffer(),mn(T.__webglDepthbuffer[mt],L,!1);else{let dt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=T.__webglDepthbuffer[mt];n.bindRenderbuffer(n.RENDERBUFFER,Mt),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,Mt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),mn(T.__webglDepthbuffer,L,!1);else{let dt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,Mt),n.framebufferRenderbuffer(n.FRAMEBUFFER,dt,n.RENDERBUFFER,Mt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Qe(L,T,j){let mt=i.get(L);T!==void 0&&Pe(mt.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&hn(L)}function sn(L){let T=L.texture,j=i.get(L),mt=i.get(T);L.addEventListener("dispose",O),B(L);let dt=L.textures,Mt=L.isWebGLCubeRenderTarget===!0,St=dt.length>1;if(St||(mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture()),mt.__version=T.version,o.memory.textures++),Mt){j.__webglFramebuffer=[];for(let ot=0;ot<6;ot++)if(T.mipmaps.length>0){j.__webglFramebuffer[ot]=[];for(let lt=0;lt<T.mipmaps.length;lt++)j.__webglFramebuffer[ot][lt]=n.createFramebuffer()}else j.__webglFramebuffer[ot]=n.createFramebuffer()}else{if(T.mipmaps.length>0){j.__webglFramebuffer=[];for(let ot=0;ot<T.mipmaps.length;ot++)j.__webglFramebuffer[ot]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(St)for(let ot=0,lt=dt.length;ot<lt;ot++){let yt=i.get(dt[ot]);yt.__webglTexture===void 0&&(yt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&Tt(L)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let ot=0;ot<dt.length;ot++){let lt=dt[ot];j.__webglColorRenderbuffer[ot]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[ot]);let yt=r.convert(lt.format,lt.colorSpace),H=r.convert(lt.type),ut=w(lt.internalFormat,yt,H,lt.normalized,lt.colorSpace,L.isXRRenderTarget===!0),at=ae(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,at,ut,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ot,n.RENDERBUFFER,j.__webglColorRenderbuffer[ot])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),mn(j.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(Mt){e.bindTexture(n.TEXTURE_CUBE_MAP,mt.__webglTexture),Qt(n.TEXTURE_CUBE_MAP,T);for(let ot=0;ot<6;ot++)if(T.mipmaps.length>0)for(let lt=0;lt<T.mipmaps.length;lt++)Pe(j.__webglFramebuffer[ot][lt],L,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ot,lt);else Pe(j.__webglFramebuffer[ot],L,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ot,0);S(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}else if(St){for(let ot=0,lt=dt.length;ot<lt;ot++){let yt=dt[ot],H=i.get(yt),ut=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ut=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,H.__webglTexture),Qt(ut,yt),Pe(j.__webglFramebuffer,L,yt,n.COLOR_ATTACHMENT0+ot,ut,0),S(yt)&&v(ut)}e.unbindTexture()}else{let ot=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ot=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,mt.__webglTexture),Qt(ot,T),T.mipmaps.length>0)for(let lt=0;lt<T.mipmaps.length;lt++)Pe(j.__webglFramebuffer[lt],L,T,n.COLOR_ATTACHMENT0,ot,lt);else Pe(j.__webglFramebuffer,L,T,n.COLOR_ATTACHMENT0,ot,0);S(T)?v(ot):T.mipmaps.length>0&&n.texParameteri(ot,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&hn(L)}function G(L){let T=L.textures;for(let j=0,mt=T.length;j<mt;j++){let dt=T[j];if(S(dt)&&dt.mipmapsAutoUpdate===!0){let Mt=E(L),St=i.get(dt).__webglTexture;e.bindTexture(Mt,St),v(Mt),e.unbindTexture()}}}let Ct=[];function Zt(L){if(L.samples>0){if(Tt(L)===!1){let T=L.textures,j=L.width,mt=L.height,dt=n.COLOR_BUFFER_BIT,Mt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(L),ot=T.length>1;if(ot)for(let yt=0;yt<T.length;yt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+yt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+yt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let yt=0;yt<T.length;yt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(dt|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(dt|=n.STENCIL_BUFFER_BIT)),ot){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[yt]);let H=i.get(T[yt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,H,0)}n.blitFramebuffer(0,0,j,mt,0,0,j,mt,dt,n.NEAREST),l===!0&&(Ct.length=0,Ct.push(n.COLOR_ATTACHMENT0+yt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Ct.push(Mt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ot)for(let yt=0;yt<T.length;yt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+yt,n.RENDERBUFFER,St.__webglColorRenderbuffer[yt]);let H=i.get(T[yt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+yt,n.TEXTURE_2D,H,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let T=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function ae(L){return Math.min(s.maxSamples,L.samples)}function Tt(L){let T=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Ve(L){let T=o.render.frame;d.get(L)!==T&&(d.set(L,T),L.update())}function Xt(L,T){let j=L.colorSpace,mt=L.format,dt=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||j!==Ea&&j!==Fs&&(Se.getTransfer(j)===Ne?(mt!==qi||dt!==ci)&&ee("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):re("WebGLTextures: Unsupported texture color space:",j)),T}function jt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=Q,this.resetTextureUnits=X,this.getTextureUnits=J,this.setTextureUnits=nt,this.setTexture2D=st,this.setTexture2DArray=ht,this.setTexture3D=ct,this.setTextureCube=gt,this.rebindTextures=Qe,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=Zt,this.setupDepthRenderbuffer=hn,this.setupFrameBufferTexture=Pe,this.useMultisampledRTT=Tt,this.dispose=N}function sw(n,t){function e(i,s=Fs){let r,o=Se.getTransfer(s);if(i===ci)return n.UNSIGNED_BYTE;if(i===Jc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Kc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Id)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ld)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Cd)return n.BYTE;if(i===Pd)return n.SHORT;if(i===Uo)return n.UNSIGNED_SHORT;if(i===Zc)return n.INT;if(i===Hi)return n.UNSIGNED_INT;if(i===Wi)return n.FLOAT;if(i===Xi)return n.HALF_FLOAT;if(i===Dd)return n.ALPHA;if(i===Nd)return n.RGB;if(i===qi)return n.RGBA;if(i===Ps)return n.DEPTH_COMPONENT;if(i===Us)return n.DEPTH_STENCIL;if(i===Ud)return n.RED;if(i===jc)return n.RED_INTEGER;if(i===hr)return n.RG;if(i===Qc)return n.RG_INTEGER;if(i===th)return n.RGBA_INTEGER;if(i===Ka||i===ja||i===Qa||i===tl)if(o===Ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ka)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ka)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ja)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Qa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===tl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===eh||i===nh||i===ih||i===sh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===eh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===nh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ih)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===sh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===rh||i===oh||i===ah||i===lh||i===ch||i===el||i===hh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===rh||i===oh)return o===Ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ah)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===lh)return r.COMPRESSED_R11_EAC;if(i===ch)return r.COMPRESSED_SIGNED_R11_EAC;if(i===el)return r.COMPRESSED_RG11_EAC;if(i===hh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===uh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh||i===yh||i===vh||i===Mh||i===Sh||i===bh||i===wh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===uh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===dh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===fh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ph)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===mh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===gh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===_h)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===xh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===yh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===vh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Mh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Sh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===bh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===wh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Th||i===Eh||i===Ah)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Th)return o===Ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Eh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ah)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Rh||i===Ch||i===nl||i===Ph)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Rh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===nl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ph)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ir?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var rw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,ow=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,rf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new za(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new cs({vertexShader:rw,fragmentShader:ow,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new $n(new Va(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},of=class extends Gi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,d=null,u=null,h=null,f=null,g=null,x=typeof XRWebGLBinding<"u",p=new rf,m={},y=e.getContextAttributes(),S=null,v=null,E=[],w=[],_=new Kt,b=null,B=null,I=new ni;I.viewport=new en;let P=new ni;P.viewport=new en;let O=[I,P],z=new Wc,C=null,N=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(W){let st=E[W];return st===void 0&&(st=new Ao,E[W]=st),st.getTargetRaySpace()},this.getControllerGrip=function(W){let st=E[W];return st===void 0&&(st=new Ao,E[W]=st),st.getGripSpace()},this.getHand=function(W){let st=E[W];return st===void 0&&(st=new Ao,E[W]=st),st.getHandSpace()};function U(W){let st=w.indexOf(W.inputSource);if(st===-1)return;let ht=E[st];ht!==void 0&&(ht.update(W.inputSource,W.frame,c||o),ht.dispatchEvent({type:W.type,data:W.inputSource}))}function k(){s.removeEventListener("select",U),s.removeEventListener("selectstart",U),s.removeEventListener("selectend",U),s.removeEventListener("squeeze",U),s.removeEventListener("squeezestart",U),s.removeEventListener("squeezeend",U),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",$);for(let W=0;W<E.length;W++){let st=w[W];st!==null&&(w[W]=null,E[W].disconnect(st))}C=null,N=null,p.reset();for(let W in m)delete m[W];if(t.setRenderTarget(S),f=null,h=null,u=null,s=null,v=null,Q.stop(),i.isPresenting=!1,t.setPixelRatio(b),t.setSize(_.width,_.height,!1),B!==null){let W=B.camera;W.fov=B.fov,W.zoom=B.zoom,W.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(W){r=W,i.isPresenting===!0&&ee("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(W){a=W,i.isPresenting===!0&&ee("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(W){c=W},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(W){if(s=W,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",U),s.addEventListener("selectstart",U),s.addEventListener("selectend",U),s.addEventListener("squeeze",U),s.addEventListener("squeezestart",U),s.addEventListener("squeezeend",U),s.addEventListener("end",k),s.addEventListener("inputsourceschange",$),y.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ht=null,ct=null,gt=null;y.depth&&(gt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,ht=y.stencil?Us:Ps,ct=y.stencil?Ir:Hi);let xt={colorFormat:e.RGBA8,depthFormat:gt,scaleFactor:r};u=this.getBinding(),h=u.createProjectionLayer(xt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),v=new vi(h.textureWidth,h.textureHeight,{format:qi,type:ci,depthTexture:new Ls(h.textureWidth,h.textureHeight,ct,void 0,void 0,void 0,void 0,void 0,void 0,ht),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ht={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,ht),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new vi(f.framebufferWidth,f.framebufferHeight,{format:qi,type:ci,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Q.setContext(s),Q.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function $(W){for(let st=0;st<W.removed.length;st++){let ht=W.removed[st],ct=w.indexOf(ht);ct>=0&&(w[ct]=null,E[ct].disconnect(ht))}for(let st=0;st<W.added.length;st++){let ht=W.added[st],ct=w.indexOf(ht);if(ct===-1){for(let xt=0;xt<E.length;xt++)if(xt>=w.length){w.push(ht),ct=xt;break}else if(w[xt]===null){w[xt]=ht,ct=xt;break}if(ct===-1)break}let gt=E[ct];gt&&gt.connect(ht)}}function V(W,st){st===null?W.matrixWorld.copy(W.matrix):W.matrixWorld.multiplyMatrices(st.matrixWorld,W.matrix),W.matrixWorldInverse.copy(W.matrixWorld).invert()}this.updateCamera=function(W){if(s===null)return;let st=W.near,ht=W.far;p.texture!==null&&(p.depthNear>0&&(st=p.depthNear),p.depthFar>0&&(ht=p.depthFar)),z.near=P.near=I.near=st,z.far=P.far=I.far=ht,(C!==z.near||N!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),C=z.near,N=z.far),z.layers.mask=W.layers.mask|6,I.layers.mask=z.layers.mask&-5,P.layers.mask=z.layers.mask&-3;let ct=W.parent,gt=z.cameras;V(z,ct);for(let xt=0;xt<gt.length;xt++)V(gt[xt],ct);z.projectionMatrix.copy(I.projectionMatrix),z.projectionMatrixInverse.copy(I.projectionMatrixInverse),B===null&&W.isPerspectiveCamera&&(B={camera:W,fov:W.fov,zoom:W.zoom}),X(W,z,ct)};function X(W,st,ht){ht===null?W.matrix.copy(st.matrixWorld):(W.matrix.copy(ht.matrixWorld),W.matrix.invert(),W.matrix.multiply(st.matrixWorld)),W.matrix.decompose(W.position,W.quaternion,W.scale),W.updateMatrixWorld(!0),W.projectionMatrix.copy(st.projectionMatrix),W.projectionMatrixInverse.copy(st.projectionMatrixInverse),W.isPerspectiveCamera&&(W.fov=To*2*Math.atan(1/W.projectionMatrix.elements[5]),W.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(W){l=W,h!==null&&(h.fixedFoveation=W),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=W)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(z)},this.getCameraTexture=function(W){return m[W]};let J=null;function nt(W,st){if(d=st.getViewerPose(c||o),g=st,d!==null){let ht=d.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let ct=!1;ht.length!==z.cameras.length&&(z.cameras.length=0,ct=!0);for(let Lt=0;Lt<ht.length;Lt++){let Qt=ht[Lt],te=null;if(f!==null)te=f.getViewport(Qt);else{let ke=u.getViewSubImage(h,Qt);te=ke.viewport,Lt===0&&(t.setRenderTargetTextures(v,ke.colorTexture,ke.depthStencilTexture),t.setRenderTarget(v))}let qt=O[Lt];qt===void 0&&(qt=new ni,qt.layers.enable(Lt),qt.viewport=new en,O[Lt]=qt),qt.matrix.fromArray(Qt.transform.matrix),qt.matrix.decompose(qt.position,qt.quaternion,qt.scale),qt.projectionMatrix.fromArray(Qt.projectionMatrix),qt.projectionMatrixInverse.copy(qt.projectionMatrix).invert(),qt.viewport.set(te.x,te.y,te.width,te.height),Lt===0&&(z.matrix.copy(qt.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),ct===!0&&z.cameras.push(qt)}let gt=s.enabledFeatures;if(gt&&gt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Lt=u.getDepthInformation(ht[0]);Lt&&Lt.isValid&&Lt.texture&&p.init(Lt,s.renderState)}if(gt&&gt.includes("camera-access")&&x){t.state.unbindTexture(),u=i.getBinding();for(let Lt=0;Lt<ht.length;Lt++){let Qt=ht[Lt].camera;if(Qt){let te=m[Qt];te||(te=new za,m[Qt]=te);let qt=u.getCameraImage(Qt);te.sourceTexture=qt}}}}for(let ht=0;ht<E.length;ht++){let ct=w[ht],gt=E[ht];ct!==null&&gt!==void 0&&gt.update(ct,st,c||o)}J&&J(W,st),st.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:st}),g=null}let Q=new Ag;Q.setAnimationLoop(nt),this.setAnimationLoop=function(W){J=W},this.dispose=function(){}}},aw=new Xe,Og=new he;Og.set(-1,0,0,0,1,0,0,0,1);function lw(n,t){function e(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,qd(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,y,S,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),d(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),h(p,m),m.isMeshPhysicalMaterial&&f(p,m,v)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),x(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(o(p,m),m.isLineDashedMaterial&&a(p,m)):m.isPointsMaterial?l(p,m,y,S):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,e(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===oi&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,e(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===oi&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,e(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,e(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let y=t.get(m),S=y.envMap,v=y.envMapRotation;S&&(p.envMap.value=S,p.envMapRotation.value.setFromMatrix4(aw.makeRotationFromEuler(v)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Og),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,p.aoMapTransform))}function o(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform))}function a(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,y,S){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*y,p.scale.value=S*.5,m.map&&(p.map.value=m.map,e(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,e(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,e(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function d(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function h(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,y){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===oi&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=y.texture,p.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function x(p,m){let y=t.get(m).light;p.referencePosition.value.setFromMatrixPosition(y.matrixWorld),p.nearDistance.value=y.shadow.camera.near,p.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function cw(n,t,e,i){let s={},r={};function o(y,S){let v=S.program;i.uniformBlockBinding(y,v,s[y.id])}function a(y,S){let v=s[y.id];v===void 0&&(g(y),v=l(y),s[y.id]=v,y.addEventListener("dispose",p));let E=S.program;i.updateUBOMapping(y,E);let w=t.render.frame;r[y.id]!==w&&(c(y),r[y.id]=w)}function l(y){let S=n.createBuffer(),v=y.__size,E=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,v,E),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function c(y){let S=s[y.id],v=y.uniforms,E=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let w=0,_=v.length;w<_;w++){let b=v[w];if(Array.isArray(b))for(let B=0,I=b.length;B<I;B++)d(b[B],w,B,E);else d(b,w,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(y,S,v,E){if(h(y,S,v,E)===!0){let w=y.__offset,_=y.value;if(Array.isArray(_)){let b=0;for(let B=0;B<_.length;B++){let I=_[B],P=x(I,!0);u(I,y.__data,b),b+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,y.__data)}}function u(y,S,v){typeof y=="number"||typeof y=="boolean"?S[v]=y:y.isMatrix3?(S[v]=y.elements[0],S[v+1]=y.elements[1],S[v+2]=y.elements[2],S[v+3]=0,S[v+4]=y.elements[3],S[v+5]=y.elements[4],S[v+6]=y.elements[5],S[v+7]=0,S[v+8]=y.elements[6],S[v+9]=y.elements[7],S[v+10]=y.elements[8],S[v+11]=0):ArrayBuffer.isView(y)?S.set(y.subarray(0,S.length-v),v):y.toArray(S,v)}function h(y,S,v,E){let w=y.value,_=S+"_"+v;if(Array.isArray(w)){E[_]===void 0&&(E[_]=[]);let b=E[_],B=!1;for(let I=0;I<w.length;I++)f(w[I],b,I)===!0&&(B=!0);return B}return f(w,E,_)}function f(y,S,v){if(S[v]===void 0)return typeof y=="number"||typeof y=="boolean"?S[v]=y:ArrayBuffer.isView(y)?S[v]=y.slice():S[v]=y.clone(),!0;{let E=S[v];if(typeof y=="number"||typeof y=="boolean"){if(E!==y)return S[v]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(E.equals(y)===!1)return E.copy(y),!0}}return!1}function g(y){let S=y.uniforms,v=0,E=16;for(let _=0,b=S.length;_<b;_++){let B=Array.isArray(S[_])?S[_]:[S[_]];for(let I=0,P=B.length;I<P;I++){let O=B[I],z=Array.isArray(O.value)?O.value:[O.value],C=Array.isArray(S[_])||Array.isArray(O.value),N=v;for(let k=0,$=z.length;k<$;k++){let V=z[k],X=x(V,C),J=v%E,nt=J%X.boundary,Q=J+nt;v+=nt,Q!==0&&E-Q<X.storage&&(v+=E-Q),k===0&&(N=v),v+=X.storage}let U=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new U((v-N)/Float32Array.BYTES_PER_ELEMENT),O.__offset=N}}let w=v%E;return w>0&&(v+=E-w),y.__size=v,y.__cache={},this}function x(y,S){let v={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(v.boundary=4,v.storage=4):y.isVector2?(v.boundary=8,v.storage=8):y.isVector3||y.isColor?(v.boundary=16,v.storage=12):y.isVector4?(v.boundary=16,v.storage=16):y.isMatrix3?(v.boundary=16,v.storage=48):y.isMatrix4?(v.boundary=16,v.storage=64):y.isTexture?ee("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(v.boundary=16,v.storage=y.byteLength):ee("WebGLRenderer: Unsupported uniform value type.",y),S===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function p(y){let S=y.target;S.removeEventListener("dispose",p),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function m(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var hw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ds=null;function uw(){return ds===null&&(ds=new Tc(hw,16,16,hr,Xi),ds.name="DFG_LUT",ds.minFilter=si,ds.magFilter=si,ds.wrapS=as,ds.wrapT=as,ds.generateMipmaps=!1,ds.needsUpdate=!0),ds}var Fh=class{constructor(t={}){let{canvas:e=Km(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:d="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:h=!1,outputBufferType:f=ci}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let x=f,p=new Set([th,Qc,jc]),m=new Set([ci,Hi,Uo,Ir,Jc,Kc]),y=new Uint32Array(4),S=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},E=null,w=null,_=[],b=[],B=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=us,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,P=!1,O=null,z=null,C=null,N=null;this._outputColorSpace=ei;let U=0,k=0,$=null,V=-1,X=null,J=new en,nt=new en,Q=null,W=new fe(0),st=0,ht=e.width,ct=e.height,gt=1,xt=null,Ut=null,Lt=new en(0,0,ht,ct),Qt=new en(0,0,ht,ct),te=!1,qt=new ir,ke=new Ec,oe=!1,Ce=!1,Pe=new Xe,mn=new K,ve=new en,hn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qe=!1;function sn(){return $===null?gt:1}let G=i;function Ct(R,q){return e.getContext(R,q)}let Zt,ae,Tt,Ve,Xt,jt,L,T,j,mt,dt,Mt,St,ot,lt,yt,H,ut,at,Et,vt,wt,$t;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:d,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Gt,!1),e.addEventListener("webglcontextrestored",se,!1),e.addEventListener("webglcontextcreationerror",Pt,!1),G===null){let q="webgl2";if(G=Ct(q,R),G===null)throw Ct(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ie()}catch(R){throw e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",se,!1),e.removeEventListener("webglcontextcreationerror",Pt,!1),re("WebGLRenderer: "+R.message),R}function ie(){Zt=new SS(G),Zt.init(),vt=new sw(G,Zt),ae=new uS(G,Zt,t,vt),Tt=new nw(G,Zt),ae.reversedDepthBuffer&&h&&Tt.buffers.depth.setReversed(!0),z=G.createFramebuffer(),C=G.createFramebuffer(),N=G.createFramebuffer(),Ve=new TS(G),Xt=new Gb,jt=new iw(G,Zt,Tt,Xt,ae,vt,Ve),L=new MS(I),T=new Ay(G),wt=new cS(G,T),j=new bS(G,T,Ve,wt),mt=new AS(G,j,T,wt,Ve),ut=new ES(G,ae,jt),lt=new dS(Xt),dt=new Vb(I,L,Zt,ae,wt,lt),Mt=new lw(I,Xt),St=new Wb,ot=new Jb(Zt),H=new lS(I,L,Tt,mt,g,l),yt=new ew(I,mt,ae),$t=new cw(G,Ve,ae,Tt),at=new hS(G,Zt,Ve),Et=new wS(G,Zt,Ve),Ve.programs=dt.programs,I.capabilities=ae,I.extensions=Zt,I.properties=Xt,I.renderLists=St,I.shadowMap=yt,I.state=Tt,I.info=Ve}x!==ci&&(B=new CS(x,e.width,e.height,a,s,r));let pt=new of(I,G);this.xr=pt,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let R=Zt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Zt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return gt},this.setPixelRatio=function(R){R!==void 0&&(gt=R,this.setSize(ht,ct,!1))},this.getSize=function(R){return R.set(ht,ct)},this.setSize=function(R,q,rt=!0){if(pt.isPresenting){ee("WebGLRenderer: Can't change size while VR device is presenting.");return}ht=R,ct=q,e.width=Math.floor(R*gt),e.height=Math.floor(q*gt),rt===!0&&(e.style.width=R+"px",e.style.height=q+"px"),B!==null&&B.setSize(e.width,e.height),this.setViewport(0,0,R,q)},this.getDrawingBufferSize=function(R){return R.set(ht*gt,ct*gt).floor()},this.setDrawingBufferSize=function(R,q,rt){ht=R,ct=q,gt=rt,e.width=Math.floor(R*rt),e.height=Math.floor(q*rt),this.setViewport(0,0,R,q)},this.setEffects=function(R){if(x===ci){re("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let q=0;q<R.length;q++)if(R[q].isOutputPass===!0){ee("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(J)},this.getViewport=function(R){return R.copy(Lt)},this.setViewport=function(R,q,rt,tt){R.isVector4?Lt.set(R.x,R.y,R.z,R.w):Lt.set(R,q,rt,tt),Tt.viewport(J.copy(Lt).multiplyScalar(sn()).round())},this.getScissor=function(R){return R.copy(Qt)},this.setScissor=function(R,q,rt,tt){R.isVector4?Qt.set(R.x,R.y,R.z,R.w):Qt.set(R,q,rt,tt),Tt.scissor(nt.copy(Qt).multiplyScalar(sn()).round())},this.getScissorTest=function(){return te},this.setScissorTest=function(R){Tt.setScissorTest(te=R)},this.setOpaqueSort=function(R){xt=R},this.setTransparentSort=function(R){Ut=R},this.getClearColor=function(R){return R.copy(H.getClearColor())},this.setClearColor=function(){H.setClearColor(...arguments)},this.getClearAlpha=function(){return H.getClearAlpha()},this.setClearAlpha=function(){H.setClearAlpha(...arguments)},this.clear=function(R=!0,q=!0,rt=!0){let tt=0;if(R){let et=!1;if($!==null){let At=$.texture.format;et=p.has(At)}if(et){let At=$.texture.type,It=m.has(At),Rt=H.getClearColor(),Dt=H.getClearAlpha(),Wt=Rt.r,le=Rt.g,ge=Rt.b;It?(y[0]=Wt,y[1]=le,y[2]=ge,y[3]=Dt,G.clearBufferuiv(G.COLOR,0,y)):(S[0]=Wt,S[1]=le,S[2]=ge,S[3]=Dt,G.clearBufferiv(G.COLOR,0,S))}else tt|=G.COLOR_BUFFER_BIT}q&&(tt|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),rt&&(tt|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),tt!==0&&G.clear(tt)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Gt,!1),e.removeEventListener("webglcontextrestored",se,!1),e.removeEventListener("webglcontextcreationerror",Pt,!1),H.dispose(),St.dispose(),ot.dispose(),jt.dispose(),Xt.dispose(),L.dispose(),mt.dispose(),j.dispose(),wt.dispose(),$t.dispose(),dt.dispose(),pt.dispose(),pt.removeEventListener("sessionstart",bl),pt.removeEventListener("sessionend",Ki),ms.stop()};function Gt(R){R.preventDefault(),Ca("WebGLRenderer: Context Lost."),P=!0}function se(){Ca("WebGLRenderer: Context Restored."),P=!1;let R=Ve.autoReset,q=yt.enabled,rt=yt.autoUpdate,tt=yt.needsUpdate,et=yt.type;ie(),Ve.autoReset=R,yt.enabled=q,yt.autoUpdate=rt,yt.needsUpdate=tt,yt.type=et}function Pt(R){re("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function de(R){let q=R.target;q.removeEventListener("dispose",de),qe(q)}function qe(R){Zn(R),Xt.remove(R)}function Zn(R){let q=Xt.get(R).programs;q!==void 0&&(q.forEach(function(rt){dt.releaseProgram(rt)}),R.isShaderMaterial&&dt.releaseShaderCache(R))}this.renderBufferDirect=function(R,q,rt,tt,et,At){q===null&&(q=hn);let It=et.isMesh&&et.matrixWorld.determinantAffine()<0,Rt=ra(R,q,rt,tt,et);Tt.setMaterial(tt,It);let Dt=rt.index,Wt=1;if(tt.wireframe===!0){if(Dt=j.getWireframeAttribute(rt),Dt===void 0)return;Wt=2}let le=rt.drawRange,ge=rt.attributes.position,Ht=le.start*Wt,_e=(le.start+le.count)*Wt;At!==null&&(Ht=Math.max(Ht,At.start*Wt),_e=Math.min(_e,(At.start+At.count)*Wt)),Dt!==null?(Ht=Math.max(Ht,0),_e=Math.min(_e,Dt.count)):ge!=null&&(Ht=Math.max(Ht,0),_e=Math.min(_e,ge.count));let nn=_e-Ht;if(nn<0||nn===1/0)return;wt.setup(et,tt,Rt,rt,Dt);let Fe,Oe=at;if(Dt!==null&&(Fe=T.get(Dt),Oe=Et,Oe.setIndex(Fe)),et.isMesh)tt.wireframe===!0?(Tt.setLineWidth(tt.wireframeLinewidth*sn()),Oe.setMode(G.LINES)):Oe.setMode(G.TRIANGLES);else if(et.isLine){let bn=tt.linewidth;bn===void 0&&(bn=1),Tt.setLineWidth(bn*sn()),et.isLineSegments?Oe.setMode(G.LINES):et.isLineLoop?Oe.setMode(G.LINE_LOOP):Oe.setMode(G.LINE_STRIP)}else et.isPoints?Oe.setMode(G.POINTS):et.isSprite&&Oe.setMode(G.TRIANGLES);if(et.isBatchedMesh)if(Zt.get("WEBGL_multi_draw"))Oe.renderMultiDraw(et._multiDrawStarts,et._multiDrawCounts,et._multiDrawCount);else{let bn=et._multiDrawStarts,zt=et._multiDrawCounts,gn=et._multiDrawCount,Me=Dt?T.get(Dt).bytesPerElement:1,_s=Xt.get(tt).currentProgram.getUniforms();for(let _n=0;_n<gn;_n++)_s.setValue(G,"_gl_DrawID",_n),Oe.render(bn[_n]/Me,zt[_n])}else if(et.isInstancedMesh)Oe.renderInstances(Ht,nn,et.count);else if(rt.isInstancedBufferGeometry){let bn=rt._maxInstanceCount!==void 0?rt._maxInstanceCount:1/0,zt=Math.min(rt.instanceCount,bn);Oe.renderInstances(Ht,nn,zt)}else Oe.render(Ht,nn)};function na(R,q,rt,tt){O!==null&&R.isNodeMaterial&&O.setObject(tt,R),oe===!0&&lt.setState(R,rt,!1),R.transparent===!0&&R.side===li&&R.forceSinglePass===!1?(R.side=oi,R.needsUpdate=!0,ji(R,q,tt),R.side=hs,R.needsUpdate=!0,ji(R,q,tt),R.side=li):ji(R,q,tt)}this.compile=function(R,q,rt=null){rt===null&&(rt=R),O!==null&&O.renderStart(R,q,rt),w=ot.get(rt),w.init(q),b.push(w),rt.traverseVisible(function(et){et.isLight&&et.layers.test(q.layers)&&(w.pushLight(et),et.castShadow&&w.pushShadow(et))}),R!==rt&&R.traverseVisible(function(et){et.isLight&&et.layers.test(q.layers)&&(w.pushLight(et),et.castShadow&&w.pushShadow(et))}),w.setupLights(),O!==null&&O.updateLights(w.state.lightsArray),Ce=this.localClippingEnabled,oe=lt.init(this.clippingPlanes,Ce),oe===!0&&lt.setGlobalState(this.clippingPlanes,q),O!==null&&yt.render(w.state.shadowsArray,rt,q);let tt=new Set;return R.traverse(function(et){if(!(et.isMesh||et.isPoints||et.isLine||et.isSprite))return;let At=et.material;if(At)if(Array.isArray(At))for(let It=0;It<At.length;It++){let Rt=At[It];na(Rt,rt,q,et),tt.add(Rt)}else na(At,rt,q,et),tt.add(At)}),w=b.pop(),O!==null&&O.renderEnd(),tt},this.compileAsync=function(R,q,rt=null){let tt=this.compile(R,q,rt);return new Promise(et=>{function At(){if(tt.forEach(function(It){let Dt=Xt.get(It).currentProgram;(Dt===void 0||Dt.isReady())&&tt.delete(It)}),tt.size===0){et(R);return}setTimeout(At,10)}Zt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let Gr=null;function bu(R){Gr&&Gr(R)}function bl(){ms.stop()}function Ki(){ms.start()}let ms=new Ag;ms.setAnimationLoop(bu),typeof self<"u"&&ms.setContext(self),this.setAnimationLoop=function(R){Gr=R,pt.setAnimationLoop(R),R===null?ms.stop():ms.start()},pt.addEventListener("sessionstart",bl),pt.addEventListener("sessionend",Ki),this.render=function(R,q){if(q!==void 0&&q.isCamera!==!0){re("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(R,q);let rt=pt.enabled===!0&&pt.isPresenting===!0,tt=B!==null&&($===null||rt)&&B.begin(I,$);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),pt.enabled===!0&&pt.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(pt.cameraAutoUpdate===!0&&pt.updateCamera(q),q=pt.getCamera()),R.isScene===!0&&R.onBeforeRender(I,R,q,$),w=ot.get(R,b.length),w.init(q),w.state.textureUnits=jt.getTextureUnits(),b.push(w),Pe.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?ke.setFromArrayCamera(q):qt.setFromProjectionMatrix(Pe,Ci,q.reversedDepth),Ce=this.localClippingEnabled,oe=lt.init(this.clippingPlanes,Ce),E=St.get(R,_.length),E.init(),_.push(E),this.info.render.frame++,pt.enabled===!0&&pt.isPresenting===!0){let It=I.xr.getDepthSensingMesh();It!==null&&gs(It,q,-1/0,I.sortObjects)}gs(R,q,0,I.sortObjects),E.finish(),O!==null&&O.updateLights(w.state.lightsArray),I.sortObjects===!0&&E.sort(xt,Ut),Qe=pt.enabled===!1||pt.isPresenting===!1||pt.hasDepthSensing()===!1,Qe&&H.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),oe===!0&&lt.beginShadows();let et=w.state.shadowsArray;if(yt.render(et,R,q),oe===!0&&lt.endShadows(),(tt&&B.hasRenderPass())===!1){let It=E.opaque,Rt=E.transmissive;if(w.setupLights(),q.isArrayCamera){let Dt=q.cameras;if(Rt.length>0)for(let Wt=0,le=Dt.length;Wt<le;Wt++){let ge=Dt[Wt];Fi(It,Rt,R,ge)}Qe&&H.render(R);for(let Wt=0,le=Dt.length;Wt<le;Wt++){let ge=Dt[Wt];ia(E,R,ge,ge.viewport)}}else Rt.length>0&&Fi(It,Rt,R,q),Qe&&H.render(R),ia(E,R,q)}$!==null&&k===0&&(jt.updateMultisampleRenderTarget($),jt.updateRenderTargetMipmap($)),tt&&B.end(I),R.isScene===!0&&R.onAfterRender(I,R,q),wt.resetDefaultState(),V=-1,X=null,b.pop(),b.length>0?(w=b[b.length-1],jt.setTextureUnits(w.state.textureUnits),oe===!0&&lt.setGlobalState(I.clippingPlanes,w.state.camera)):w=null,_.pop(),_.length>0?E=_[_.length-1]:E=null,O!==null&&O.renderEnd()};function gs(R,q,rt,tt){if(R.visible===!1)return;if(R.layers.test(q.layers)){if(R.isGroup)rt=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(q);else if(R.isLight)w.pushLight(R),R.castShadow&&w.pushShadow(R);else if(R.isSprite){let It=q.isArrayCamera?ke:qt;if(!R.frustumCulled||R.intersectsFrustum(It)){tt&&ve.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Pe);let Rt=mt.update(R),Dt=R.material;Dt.visible&&E.push(R,Rt,Dt,rt,ve.z,null,q)}}else if(R.isMesh||R.isLine||R.isPoints){let It=q.isArrayCamera?ke:qt;if(!R.frustumCulled||R.intersectsFrustum(It)){let Rt=mt.update(R),Dt=R.material;if(tt&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ve.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),ve.copy(Rt.boundingSphere.center)),ve.applyMatrix4(R.matrixWorld).applyMatrix4(Pe)),Array.isArray(Dt)){let Wt=Rt.groups;for(let le=0,ge=Wt.length;le<ge;le++){let Ht=Wt[le],_e=Dt[Ht.materialIndex];_e&&_e.visible&&E.push(R,Rt,_e,rt,ve.z,Ht,q)}}else Dt.visible&&E.push(R,Rt,Dt,rt,ve.z,null,q)}}}let At=R.children;for(let It=0,Rt=At.length;It<Rt;It++)gs(At[It],q,rt,tt)}function ia(R,q,rt,tt){let{opaque:et,transmissive:At,transparent:It}=R;w.setupLightsView(rt),oe===!0&&lt.setGlobalState(I.clippingPlanes,rt),tt&&Tt.viewport(J.copy(tt)),et.length>0&&rn(et,q,rt),At.length>0&&rn(At,q,rt),It.length>0&&rn(It,q,rt),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function Fi(R,q,rt,tt){if((rt.isScene===!0?rt.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[tt.id]===void 0){let Ht=Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[tt.id]=new vi(1,1,{generateMipmaps:!0,type:Ht?Xi:ci,minFilter:Ns,samples:Math.max(4,ae.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let At=w.state.transmissionRenderTarget[tt.id],It=tt.viewport||J;At.setSize(It.z*I.transmissionResolutionScale,It.w*I.transmissionResolutionScale);let Rt=I.getRenderTarget(),Dt=I.getActiveCubeFace(),Wt=I.getActiveMipmapLevel();I.setRenderTarget(At),I.getClearColor(W),st=I.getClearAlpha(),st<1&&I.setClearColor(16777215,.5),I.clear(),Qe&&H.render(rt);let le=I.toneMapping;I.toneMapping=us;let ge=tt.viewport;if(tt.viewport!==void 0&&(tt.viewport=void 0),w.setupLightsView(tt),oe===!0&&lt.setGlobalState(I.clippingPlanes,tt),rn(R,rt,tt),jt.updateMultisampleRenderTarget(At),jt.updateRenderTargetMipmap(At),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let Ht=!1;for(let _e=0,nn=q.length;_e<nn;_e++){let Fe=q[_e],{object:Oe,geometry:bn,material:zt,group:gn}=Fe;if(zt.side===li&&Oe.layers.test(tt.layers)){let Me=zt.side;zt.side=oi,zt.needsUpdate=!0,un(Oe,rt,tt,bn,zt,gn),zt.side=Me,zt.needsUpdate=!0,Ht=!0}}Ht===!0&&(jt.updateMultisampleRenderTarget(At),jt.updateRenderTargetMipmap(At))}I.setRenderTarget(Rt,Dt,Wt),I.setClearColor(W,st),ge!==void 0&&(tt.viewport=ge),I.toneMapping=le}function rn(R,q,rt){let tt=q.isScene===!0?q.overrideMaterial:null;for(let et=0,At=R.length;et<At;et++){let It=R[et],{object:Rt,geometry:Dt,group:Wt}=It,le=It.material;le.allowOverride===!0&&tt!==null&&(le=tt),Rt.layers.test(rt.layers)&&un(Rt,q,rt,Dt,le,Wt)}}function un(R,q,rt,tt,et,At){O!==null&&et.isNodeMaterial&&O.setObject(R,et),R.onBeforeRender(I,q,rt,tt,et,At),R.modelViewMatrix.multiplyMatrices(rt.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),et.onBeforeRender(I,q,rt,tt,R,At),et.transparent===!0&&et.side===li&&et.forceSinglePass===!1?(et.side=oi,et.needsUpdate=!0,I.renderBufferDirect(rt,q,tt,et,R,At),et.side=hs,et.needsUpdate=!0,I.renderBufferDirect(rt,q,tt,et,R,At),et.side=li):I.renderBufferDirect(rt,q,tt,et,R,At),R.onAfterRender(I,q,rt,tt,et,At)}function dn(R){let q=0;for(let rt of R)rt.texture!==null&&q++;return q}function ji(R,q,rt){q.isScene!==!0&&(q=hn);let tt=Xt.get(R),et=w.state.lights,At=w.state.shadowsArray,It=et.state.version,Rt=dt.getParameters(R,et.state,At,q,rt,w.state.lightProbeGridArray),Dt=dt.getProgramCacheKey(Rt),Wt=tt.programs;tt.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?q.environment:null,tt.fog=q.fog;let le=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;tt.envMap=L.get(R.envMap||tt.environment,le),tt.envMapRotation=tt.environment!==null&&R.envMap===null?q.environmentRotation:R.envMapRotation,Wt===void 0&&(R.addEventListener("dispose",de),Wt=new Map,tt.programs=Wt,tt.programVariants=new Map);let ge=Wt.get(Dt);if(ge!==void 0){if(tt.currentProgram===ge&&tt.lightsStateVersion===It)return sa(R,Rt),ge}else Rt.uniforms=dt.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,rt,Rt),R.onBeforeCompile(Rt,I),ge=dt.acquireProgram(Rt,Dt),Wt.set(Dt,ge),tt.uniforms=Rt.uniforms;let Ht=tt.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ht.clippingPlanes=lt.uniform),sa(R,Rt),tt.needsLights=qs(R),tt.lightsStateVersion=It,tt.needsLights&&(Ht.ambientLightColor.value=et.state.ambient,Ht.lightProbe.value=et.state.probe,Ht.sunLights.value=et.state.sun,Ht.sunLightShadows.value=et.state.sunShadow,Ht.directionalLights.value=et.state.directional,Ht.directionalLightShadows.value=et.state.directionalShadow,Ht.spotLights.value=et.state.spot,Ht.spotLightShadows.value=et.state.spotShadow,Ht.rectAreaLights.value=et.state.rectArea,Ht.ltc_1.value=et.state.rectAreaLTC1,Ht.ltc_2.value=et.state.rectAreaLTC2,Ht.pointLights.value=et.state.point,Ht.pointLightShadows.value=et.state.pointShadow,Ht.hemisphereLights.value=et.state.hemi,Ht.sunShadowMatrix.value=et.state.sunShadowMatrix,Ht.sunShadowCascade.value=et.state.sunShadowCascade,Ht.directionalShadowMatrix.value=et.state.directionalShadowMatrix,Ht.spotLightMatrix.value=et.state.spotLightMatrix,Ht.spotLightMap.value=et.state.spotLightMap,Ht.pointShadowMatrix.value=et.state.pointShadowMatrix),tt.numLightProbeGrids=dn(w.state.lightProbeGridArray),tt.currentProgram=ge,tt.uniformsList=null,ge}function di(R,q,rt,tt,et){let At=Xt.get(R),It=At.currentProgram.id+","+tt+","+et,Rt=At.programVariants.get(It);return Rt===void 0?(Rt=ji(R,q,rt),At.programVariants.set(It,Rt)):(At.currentProgram=Rt,At.uniformsList=null,At.outputColorSpace=tt,At.toneMapping=et),Rt}function Xs(R){if(R.uniformsList===null){let q=R.currentProgram.getUniforms();R.uniformsList=Fo.seqWithValue(q.seq,R.uniforms)}return R.uniformsList}function sa(R,q){let rt=Xt.get(R);rt.outputColorSpace=q.outputColorSpace,rt.batching=q.batching,rt.batchingColor=q.batchingColor,rt.instancing=q.instancing,rt.instancingColor=q.instancingColor,rt.instancingMorph=q.instancingMorph,rt.skinning=q.skinning,rt.morphTargets=q.morphTargets,rt.morphNormals=q.morphNormals,rt.morphColors=q.morphColors,rt.morphTargetsCount=q.morphTargetsCount,rt.numClippingPlanes=q.numClippingPlanes,rt.numIntersection=q.numClipIntersection,rt.vertexAlphas=q.vertexAlphas,rt.vertexTangents=q.vertexTangents,rt.toneMapping=q.toneMapping}function ra(R,q,rt,tt,et){q.isScene!==!0&&(q=hn),jt.resetTextureUnits();let At=q.fog,It=tt.isMeshStandardMaterial||tt.isMeshLambertMaterial||tt.isMeshPhongMaterial?q.environment:null,Rt=$===null?I.outputColorSpace:$.isXRRenderTarget===!0?$.texture.colorSpace:Se.workingColorSpace,Dt=tt.isMeshStandardMaterial||tt.isMeshLambertMaterial&&!tt.envMap||tt.isMeshPhongMaterial&&!tt.envMap,Wt=L.get(tt.envMap||It,Dt),le=tt.vertexColors===!0&&!!rt.attributes.color&&rt.attributes.color.itemSize===4,ge=!!rt.attributes.tangent&&(!!tt.normalMap||tt.anisotropy>0),Ht=!!rt.morphAttributes.position,_e=!!rt.morphAttributes.normal,nn=!!rt.morphAttributes.color,Fe=us;tt.toneMapped&&($===null||$.isXRRenderTarget===!0)&&(Fe=I.toneMapping);let Oe=rt.morphAttributes.position||rt.morphAttributes.normal||rt.morphAttributes.color,bn=Oe!==void 0?Oe.length:0,zt=Xt.get(tt),gn=w.state.lights;if(oe===!0&&(Ce===!0||R!==X)){let Be=R===X&&tt.id===V;lt.setState(tt,R,Be)}let Me=!1,_s=!1;tt.version===zt.__version?zt.needsLights&&zt.lightsStateVersion!==gn.state.version||et.isBatchedMesh&&zt.batching===!1||!et.isBatchedMesh&&zt.batching===!0||et.isBatchedMesh&&zt.batchingColor===!0&&et._colorsTexture===null||et.isBatchedMesh&&zt.batchingColor===!1&&et._colorsTexture!==null||et.isInstancedMesh&&zt.instancing===!1||!et.isInstancedMesh&&zt.instancing===!0||et.isSkinnedMesh&&zt.skinning===!1||!et.isSkinnedMesh&&zt.skinning===!0||et.isInstancedMesh&&zt.instancingColor===!0&&et.instanceColor===null||et.isInstancedMesh&&zt.instancingColor===!1&&et.instanceColor!==null||et.isInstancedMesh&&zt.instancingMorph===!0&&et.morphTexture===null||et.isInstancedMesh&&zt.instancingMorph===!1&&et.morphTexture!==null||zt.envMap!==Wt||tt.fog===!0&&zt.fog!==At||zt.numClippingPlanes!==void 0&&(zt.numClippingPlanes!==lt.numPlanes||zt.numIntersection!==lt.numIntersection)||zt.vertexAlphas!==le||zt.vertexTangents!==ge||zt.morphTargets!==Ht||zt.morphNormals!==_e||zt.morphColors!==nn||zt.morphTargetsCount!==bn||zt.numLightProbeGrids!==dn(w.state.lightProbeGridArray)?Me=!0:(zt.outputColorSpace!==Rt||zt.toneMapping!==Fe)&&(_s=!0):(Me=!0,zt.__version=tt.version);let _n=zt.currentProgram;(Me===!0||_s===!0)&&(_n=_s===!0?di(tt,q,et,Rt,Fe):ji(tt,q,et),O&&tt.isNodeMaterial&&O.onUpdateProgram(tt,_n,zt));let Xr=!1,Qi=!1,xs=!1,pe=_n.getUniforms(),on=zt.uniforms;if(Tt.useProgram(_n.program)&&(Xr=!0,Qi=!0,xs=!0),tt.id!==V&&(V=tt.id,Qi=!0),Xr||X!==R){Tt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),pe.setValue(G,"projectionMatrix",R.projectionMatrix),pe.setValue(G,"viewMatrix",R.matrixWorldInverse);let xn=pe.map.cameraPosition;xn!==void 0&&xn.setValue(G,mn.setFromMatrixPosition(R.matrixWorld)),ae.logarithmicDepthBuffer&&pe.setValue(G,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(tt.isMeshPhongMaterial||tt.isMeshToonMaterial||tt.isMeshLambertMaterial||tt.isMeshBasicMaterial||tt.isMeshStandardMaterial||tt.isShaderMaterial)&&pe.setValue(G,"isOrthographic",R.isOrthographicCamera===!0),X!==R&&(X=R,Qi=!0,xs=!0)}if(zt.needsLights&&(gn.state.sunShadowMap.length>0&&pe.setValue(G,"sunShadowMap",gn.state.sunShadowMap,jt),gn.state.directionalShadowMap.length>0&&pe.setValue(G,"directionalShadowMap",gn.state.directionalShadowMap,jt),gn.state.spotShadowMap.length>0&&pe.setValue(G,"spotShadowMap",gn.state.spotShadowMap,jt),gn.state.pointShadowMap.length>0&&pe.setValue(G,"pointShadowMap",gn.state.pointShadowMap,jt)),et.isSkinnedMesh){pe.setOptional(G,et,"bindMatrix"),pe.setOptional(G,et,"bindMatrixInverse");let Be=et.skeleton;Be&&(Be.boneTexture===null&&Be.computeBoneTexture(),pe.setValue(G,"boneTexture",Be.boneTexture,jt))}et.isBatchedMesh&&(pe.setOptional(G,et,"batchingTexture"),pe.setValue(G,"batchingTexture",et._matricesTexture,jt),pe.setOptional(G,et,"batchingIdTexture"),pe.setValue(G,"batchingIdTexture",et._indirectTexture,jt),pe.setOptional(G,et,"batchingColorTexture"),et._colorsTexture!==null&&pe.setValue(G,"batchingColorTexture",et._colorsTexture,jt));let Jn=rt.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&ut.update(et,rt,_n),(Qi||zt.receiveShadow!==et.receiveShadow)&&(zt.receiveShadow=et.receiveShadow,pe.setValue(G,"receiveShadow",et.receiveShadow)),(tt.isMeshStandardMaterial||tt.isMeshLambertMaterial||tt.isMeshPhongMaterial)&&tt.envMap===null&&q.environment!==null&&(on.envMapIntensity.value=q.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=uw()),Qi){if(pe.setValue(G,"toneMappingExposure",I.toneMappingExposure),zt.needsLights&&Hr(on,xs),At&&tt.fog===!0&&Mt.refreshFogUniforms(on,At),Mt.refreshMaterialUniforms(on,tt,gt,ct,w.state.transmissionRenderTarget[R.id]),zt.needsLights&&zt.numLightProbeGrids>0){let Be=v,xn=0;for(let Gn of w.state.lightProbeGridArray)Gn.texture!==null&&(Be.textures[xn]=Gn.texture,Be.min[xn]=Gn.boundingBox.min,Be.max[xn]=Gn.boundingBox.max,Be.resolution[xn]=Gn.resolution,xn++);for(let Gn in Be)Be[Gn].length=xn;on.probesSH.value=Be.textures,on.probesMin.value=Be.min,on.probesMax.value=Be.max,on.probesResolution.value=Be.resolution}Fo.upload(G,Xs(zt),on,jt)}if(tt.isShaderMaterial&&tt.uniformsNeedUpdate===!0&&(Fo.upload(G,Xs(zt),on,jt),tt.uniformsNeedUpdate=!1),tt.isSpriteMaterial&&pe.setValue(G,"center",et.center),pe.setValue(G,"modelViewMatrix",et.modelViewMatrix),pe.setValue(G,"normalMatrix",et.normalMatrix),pe.setValue(G,"modelMatrix",et.matrixWorld),tt.uniformsGroups!==void 0){let Be=tt.uniformsGroups;for(let xn=0,Gn=Be.length;xn<Gn;xn++){let wl=Be[xn];$t.update(wl,_n),$t.bind(wl,_n)}}return _n}function Hr(R,q){R.ambientLightColor.needsUpdate=q,R.lightProbe.needsUpdate=q,R.sunLights.needsUpdate=q,R.sunLightShadows.needsUpdate=q,R.directionalLights.needsUpdate=q,R.directionalLightShadows.needsUpdate=q,R.pointLights.needsUpdate=q,R.pointLightShadows.needsUpdate=q,R.spotLights.needsUpdate=q,R.spotLightShadows.needsUpdate=q,R.rectAreaLights.needsUpdate=q,R.hemisphereLights.needsUpdate=q}function qs(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return U},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return $},this.setRenderTargetTextures=function(R,q,rt){let tt=Xt.get(R);tt.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,tt.__autoAllocateDepthBuffer===!1&&(tt.__useRenderToTexture=!1),Xt.get(R.texture).__webglTexture=q,Xt.get(R.depthTexture).__webglTexture=tt.__autoAllocateDepthBuffer?void 0:rt,tt.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,q){let rt=Xt.get(R);rt.__webglFramebuffer=q,rt.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(R,q=0,rt=0){$=R,U=q,k=rt;let tt=null,et=!1,At=!1;if(R){let Rt=Xt.get(R);if(Rt.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(G.FRAMEBUFFER,Rt.__webglFramebuffer),J.copy(R.viewport),nt.copy(R.scissor),Q=R.scissorTest,Tt.viewport(J),Tt.scissor(nt),Tt.setScissorTest(Q),V=-1;return}else if(Rt.__webglFramebuffer===void 0)jt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)jt.rebindTextures(R,Xt.get(R.texture).__webglTexture,Xt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let le=R.depthTexture;if(Rt.__boundDepthTexture!==le){if(le!==null&&Xt.has(le)&&(R.width!==le.image.width||R.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");jt.setupDepthRenderbuffer(R)}}let Dt=R.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(At=!0);let Wt=Xt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Wt[q])?tt=Wt[q][rt]:tt=Wt[q],et=!0):R.samples>0&&jt.useMultisampledRTT(R)===!1?tt=Xt.get(R).__webglMultisampledFramebuffer:Array.isArray(Wt)?tt=Wt[rt]:tt=Wt,J.copy(R.viewport),nt.copy(R.scissor),Q=R.scissorTest}else J.copy(Lt).multiplyScalar(gt).floor(),nt.copy(Qt).multiplyScalar(gt).floor(),Q=te;if(rt!==0&&(tt=z),Tt.bindFramebuffer(G.FRAMEBUFFER,tt)&&Tt.drawBuffers(R,tt),Tt.viewport(J),Tt.scissor(nt),Tt.setScissorTest(Q),et){let Rt=Xt.get(R.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+q,Rt.__webglTexture,rt)}else if(At){let Rt=q;for(let Dt=0;Dt<R.textures.length;Dt++){let Wt=Xt.get(R.textures[Dt]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+Dt,Wt.__webglTexture,rt,Rt)}}else if(R!==null&&rt!==0){let Rt=Xt.get(R.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,Rt.__webglTexture,rt)}V=-1};function Wr(R){let q=Xt.get(R);return(q.__readFormat!==R.format||q.__readType!==R.type)&&(q.__readFormat=R.format,q.__readType=R.type,q.__formatReadable=ae.textureFormatReadable(R.format),q.__typeReadable=ae.textureTypeReadable(R.type)),q}this.readRenderTargetPixels=function(R,q,rt,tt,et,At,It,Rt=0){if(!(R&&R.isWebGLRenderTarget)){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Xt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Dt=Dt[It],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){Tt.bindFramebuffer(G.FRAMEBUFFER,Dt);try{let Wt=R.textures[Rt],le=Wt.format,ge=Wt.type;R.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Rt);let Ht=Wr(Wt);if(Ht.__formatReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ht.__typeReadable===!1){re("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=R.width-tt&&rt>=0&&rt<=R.height-et&&G.readPixels(q,rt,tt,et,vt.convert(le),vt.convert(ge),At)}finally{let Wt=$!==null?Xt.get($).__webglFramebuffer:null;Tt.bindFramebuffer(G.FRAMEBUFFER,Wt)}}},this.readRenderTargetPixelsAsync=async function(R,q,rt,tt,et,At,It,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Xt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Dt=Dt[It],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(q>=0&&q<=R.width-tt&&rt>=0&&rt<=R.height-et){Tt.bindFramebuffer(G.FRAMEBUFFER,Dt);let Wt=R.textures[Rt],le=Wt.format,ge=Wt.type;R.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Rt);let Ht=Wr(Wt);if(Ht.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ht.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,_e),G.bufferData(G.PIXEL_PACK_BUFFER,At.byteLength,G.STREAM_READ),G.readPixels(q,rt,tt,et,vt.convert(le),vt.convert(ge),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let nn=$!==null?Xt.get($).__webglFramebuffer:null;Tt.bindFramebuffer(G.FRAMEBUFFER,nn);let Fe=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await Qm(G,Fe,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,_e),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,At),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(_e),G.deleteSync(Fe),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,q=null,rt=0){let tt=Math.pow(2,-rt),et=Math.floor(R.image.width*tt),At=Math.floor(R.image.height*tt),It=q!==null?q.x:0,Rt=q!==null?q.y:0;jt.setTexture2D(R,0),G.copyTexSubImage2D(G.TEXTURE_2D,rt,0,0,It,Rt,et,At),Tt.unbindTexture()},this.copyTextureToTexture=function(R,q,rt=null,tt=null,et=0,At=0){let It,Rt,Dt,Wt,le,ge,Ht,_e,nn,Fe=R.isCompressedTexture?R.mipmaps[At]:R.image;if(rt!==null)It=rt.max.x-rt.min.x,Rt=rt.max.y-rt.min.y,Dt=rt.isBox3?rt.max.z-rt.min.z:1,Wt=rt.min.x,le=rt.min.y,ge=rt.isBox3?rt.min.z:0;else{let pe=Math.pow(2,-et);It=Math.floor(Fe.width*pe),Rt=Math.floor(Fe.height*pe),R.isDataArrayTexture?Dt=Fe.depth:R.isData3DTexture?Dt=Math.floor(Fe.depth*pe):Dt=1,Wt=0,le=0,ge=0}tt!==null?(Ht=tt.x,_e=tt.y,nn=tt.z):(Ht=0,_e=0,nn=0);let Oe=vt.convert(q.format),bn=vt.convert(q.type),zt;q.isData3DTexture?(jt.setTexture3D(q,0),zt=G.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(jt.setTexture2DArray(q,0),zt=G.TEXTURE_2D_ARRAY):(jt.setTexture2D(q,0),zt=G.TEXTURE_2D),Tt.activeTexture(G.TEXTURE0),Tt.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,q.flipY),Tt.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Tt.pixelStorei(G.UNPACK_ALIGNMENT,q.unpackAlignment);let gn=Tt.getParameter(G.UNPACK_ROW_LENGTH),Me=Tt.getParameter(G.UNPACK_IMAGE_HEIGHT),_s=Tt.getParameter(G.UNPACK_SKIP_PIXELS),_n=Tt.getParameter(G.UNPACK_SKIP_ROWS),Xr=Tt.getParameter(G.UNPACK_SKIP_IMAGES);Tt.pixelStorei(G.UNPACK_ROW_LENGTH,Fe.width),Tt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Fe.height),Tt.pixelStorei(G.UNPACK_SKIP_PIXELS,Wt),Tt.pixelStorei(G.UNPACK_SKIP_ROWS,le),Tt.pixelStorei(G.UNPACK_SKIP_IMAGES,ge);let Qi=R.isDataArrayTexture||R.isData3DTexture,xs=q.isDataArrayTexture||q.isData3DTexture;if(R.isDepthTexture){let pe=Xt.get(R),on=Xt.get(q),Jn=Xt.get(pe.__renderTarget),Be=Xt.get(on.__renderTarget);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,Jn.__webglFramebuffer),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,Be.__webglFramebuffer);for(let xn=0;xn<Dt;xn++)Qi&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Xt.get(R).__webglTexture,et,ge+xn),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Xt.get(q).__webglTexture,At,nn+xn)),G.blitFramebuffer(Wt,le,Wt+It,le+Rt,Ht,_e,Ht+It,_e+Rt,G.DEPTH_BUFFER_BIT,G.NEAREST);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(et!==0||R.isRenderTargetTexture||Xt.has(R)){let pe=Xt.get(R),on=Xt.get(q);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,C),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,N);for(let Jn=0;Jn<Dt;Jn++)Qi?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,pe.__webglTexture,et,ge+Jn):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,pe.__webglTexture,et),xs?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,on.__webglTexture,At,nn+Jn):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,on.__webglTexture,At),et!==0?G.blitFramebuffer(Wt,le,Wt+It,le+Rt,Ht,_e,Ht+It,_e+Rt,G.COLOR_BUFFER_BIT,G.NEAREST):xs?G.copyTexSubImage3D(zt,At,Ht,_e,nn+Jn,Wt,le,It,Rt):G.copyTexSubImage2D(zt,At,Ht,_e,Wt,le,It,Rt);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else xs?R.isDataTexture||R.isData3DTexture?G.texSubImage3D(zt,At,Ht,_e,nn,It,Rt,Dt,Oe,bn,Fe.data):q.isCompressedArrayTexture?G.compressedTexSubImage3D(zt,At,Ht,_e,nn,It,Rt,Dt,Oe,Fe.data):G.texSubImage3D(zt,At,Ht,_e,nn,It,Rt,Dt,Oe,bn,Fe):R.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,At,Ht,_e,It,Rt,Oe,bn,Fe.data):R.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,At,Ht,_e,Fe.width,Fe.height,Oe,Fe.data):G.texSubImage2D(G.TEXTURE_2D,At,Ht,_e,It,Rt,Oe,bn,Fe);Tt.pixelStorei(G.UNPACK_ROW_LENGTH,gn),Tt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Me),Tt.pixelStorei(G.UNPACK_SKIP_PIXELS,_s),Tt.pixelStorei(G.UNPACK_SKIP_ROWS,_n),Tt.pixelStorei(G.UNPACK_SKIP_IMAGES,Xr),At===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&G.generateMipmap(zt),Tt.unbindTexture()},this.initRenderTarget=function(R){Xt.get(R).__webglFramebuffer===void 0&&jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?jt.setTextureCube(R,0):R.isData3DTexture?jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?jt.setTexture2DArray(R,0):jt.setTexture2D(R,0),Tt.unbindTexture()},this.resetState=function(){U=0,k=0,$=null,Tt.reset(),wt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ci}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var al=()=>{let n=Qr(!1);return t=>n(1-t)};function $i({radius_m:n}){let[t,e]=[n[0],n.at(-1)],i=n.length>1?(e-t)/(n.length-1)/2:t;return[Math.max(t-i,0),e+i]}var Bo=({depth_m:n})=>n.reduce((t,e)=>e>t?e:t,0);function af(n,t,e){let[i,s]=$i(n),r=n.radius_m.length,o=n.angle_rad.length,a=Math.floor((Math.hypot(t,e)-i)/(s-i)*r);if(a<0||a>=r)return NaN;let l=Math.atan2(e,t)/(2*Math.PI),c=Math.min(Math.floor((l-Math.floor(l))*o),o-1);return n.depth_m[a*o+c]}function En(n,t,e){let i=t-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],step:1};let s=i/Math.max(e,1),r=10**Math.floor(Math.log10(s)),o=[1,2,2.5,5,10].map(l=>l*r).find(l=>l>=s*.999),a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=t+o*1e-9;l++)a.push(l*o);return{values:a,step:o}}var lf=(n,t)=>n<8?"start":n>t-8?"end":"middle",dw={start:0,middle:.5,end:1};function Bg(n,t,e){for(let r=Math.floor(e/24);r>1;r--){let o=En(n,t,r),a=o.values.map(l=>{let c=(l-n)/(t-n)*e,d=6.2*Mn(l,o.step).length,u=c-dw[lf(c,e)]*d;return[u,u+d]});if(a.every(([l],c)=>c===0||a[c-1][1]+5<=l))return o}return En(n,t,1)}function Mn(n,t){let e=Math.abs(n)<t*1e-6?0:n,i=0;for(;i<8&&Math.abs(t*10**i-Math.round(t*10**i))>1e-6;)i++;return Ms(e.toFixed(i))}function kg(n,t,e,i,s){if(!(n<=t)||n===0&&t===0)return[0,i];(e||n>0&&n<.35*t)&&(n=Math.min(n,0)),(e||t<0&&t>.35*n)&&(t=Math.max(t,0));let r=s-(t-n);if(r>0)return n>=0&&n<r/2?[0,Math.max(t,s)]:t<=0&&-t<r/2?[Math.min(n,-s),0]:[n-r/2,t+r/2];let a=.05*(t-n||Math.abs(t)*.2||1);return[n===0?0:n-a,t===0?0:t+a]}function kh(n,t,e,i){let s=Array.from({length:21},(l,c)=>`rgb(${i(c/20).join(" ")}) ${c*5}%`),r=e.map(l=>Jt(l,t)),{values:o,step:a}=En(r[0],r[1],4);return[Z("span",{},n),Z("div",{class:"ramp",style:`background:linear-gradient(to right, ${s.join(",")})`}),Z("div",{class:"ramp-ticks"},o.map(l=>Z("span",{style:`left:${(l-r[0])/(r[1]-r[0])*100}%`},Mn(l,a))))]}var fw={top:"hanging",middle:"central",bottom:"text-after-edge"},ko=class{fillStyle="#000";strokeStyle="#000";textAlign="left";textBaseline="alphabetic";font="";#i=[];#n="";#t=[];#s=[];constructor(t,e){this.picture=Ft("svg",{viewBox:`0 0 ${t} ${e}`,xmlns:"http://www.w3.org/2000/svg","font-family":"system-ui, sans-serif","font-size":11})}#e(t,e,...i){let s=this.#t.join(" ")||null;this.picture.append(Ft(t,{...e,transform:s},...i))}save(){this.#s.push([...this.#t])}restore(){this.#t=this.#s.pop()??[]}translate(t,e){this.#t.push(`translate(${t} ${e})`)}rotate(t){this.#t.push(`rotate(${t*180/Math.PI})`)}setLineDash(t){this.#i=t}beginPath(){this.#n=""}moveTo(t,e){this.#n+=`M${t} ${e}`}lineTo(t,e){this.#n+=`L${t} ${e}`}stroke(){this.#e("path",{d:this.#n,fill:"none",stroke:this.strokeStyle,"stroke-dasharray":this.#i.join(" ")||null})}fillRect(t,e,i,s){this.#e("rect",{x:t,y:e,width:i,height:s,fill:this.fillStyle})}strokeRect(t,e,i,s){this.#e("rect",{x:t,y:e,width:i,height:s,fill:"none",stroke:this.strokeStyle})}fillText(t,e,i){let s={center:"middle",right:"end"}[this.textAlign]??"start";this.#e("text",{x:e,y:i,fill:this.fillStyle,"text-anchor":s,"dominant-baseline":fw[this.textBaseline]??"auto"},t)}image(t,e,i,s,r){this.#e("image",{x:e,y:i,width:s,height:r,href:t,preserveAspectRatio:"none"})}file(){let{width:t,height:e}=this.picture.viewBox.baseVal;return this.picture.setAttribute("width",t),this.picture.setAttribute("height",e),`<?xml version="1.0" encoding="UTF-8"?>
${new XMLSerializer().serializeToString(this.picture)}
`}};var zg=matchMedia("(prefers-color-scheme: dark)"),cf=!1,pn=()=>cf,pw=()=>!cf&&(Bt.theme==="dark"||Bt.theme==="auto"&&zg.matches);function Vg(n){Bt.theme=Pl("theme",["auto","light","dark"])??Bt.theme;let t=()=>{document.documentElement.dataset.theme=pw()?"dark":"light"},e=()=>{t(),n()};zg.addEventListener("change",e);let i=s=>()=>{cf=s;for(let r of document.querySelectorAll("details.prints"))s?(r.dataset.was=r.open?"open":"",r.open=!0):r.open=r.dataset.was==="open";e()};return addEventListener("beforeprint",i(!0)),addEventListener("afterprint",i(!1)),t(),s=>{Ge({theme:s}),Il("theme",s),e()}}var hi=44,hf=34,Ii=18,ll=8,zh=400,mw=270;function Gg(n,t){let e=Z("canvas",{class:"plan",role:"img","aria-label":"The bottom of the hole from above"}),i=Z("p",{class:"readout-line"}," "),s=Nn("Bottom of the hole",{svg:()=>l(),csv:()=>Wn(...c())}),r=Z("div",{class:"plan-holder"},e,i,s),o=zh;function a(){let h=n();if(!h)return;o=pn()?mw:Math.min(Math.max((r.clientWidth||zh)-hi-ll,150),zh);let f=Math.max(devicePixelRatio,2),[g,x]=[hi+o+ll,Ii+o+hf];[e.width,e.height]=[g*f,x*f],e.style.width=`${g}px`,e.style.height=`${x}px`;let p=e.getContext("2d");p.scale(f,f),p.font="11px system-ui, sans-serif";let m=1.04*$i(h)[1];d(p,h,m,Math.round(o*f)),u(p,m)}function l(){let h=n(),f=new ko(hi+o+ll,Ii+o+hf);f.fillStyle=Ee("paper"),f.fillRect(0,0,hi+o+ll,Ii+o+hf);let g=Z("canvas",{width:2*o,height:2*o}),x=g.getContext("2d");x.scale(2,2),x.translate(-hi,-Ii);let p=1.04*$i(h)[1];return d(x,h,p,2*o),f.image(g.toDataURL(),hi,Ii,o,o),u(f,p),f.file()}function c(){let{radius_m:h,angle_rad:f,depth_m:g}=n(),x=Array.from(h).flatMap((m,y)=>Array.from(f,(S,v)=>[Jt(m,"diameter"),Jt(S,"angle"),Jt(g[y*f.length+v],"diameter")])),p=ce("diameter");return[[`radius, ${p}`,`angle, ${ce("angle")}`,`depth, ${p}`],x]}function d(h,f,g,x){let p=al(),m=Bo(f)||1,y=new ImageData(x,x),S=E=>(2*((E+.5)/x)-1)*g;for(let E=0;E<x;E++)for(let w=0;w<x;w++){let _=af(f,-S(E),S(w));Number.isFinite(_)&&y.data.set([...p(_/m),255],4*(E*x+w))}let v=new OffscreenCanvas(x,x);v.getContext("2d").putImageData(y,0,0),h.drawImage(v,hi,Ii,o,o)}function u(h,f){let g=Jt(f,"diameter"),{values:x,step:p}=En(-g,g,6),m=S=>.5+Hn(S,"diameter")/(2*f);h.fillStyle=Ee("muted"),h.textAlign="center",h.textBaseline="top";for(let S of x)h.fillText(Mn(S,p),hi+m(S)*o,Ii+o+5);let y=t?"to the right":"across";h.fillText(`${y}, ${ce("diameter")}`,hi+o/2,Ii+o+19),h.textAlign="right",h.textBaseline="middle";for(let S of x)h.fillText(Mn(S,p),hi-6,Ii+(1-m(S))*o);t&&(h.textAlign="center",h.textBaseline="bottom",h.fillText("high side ▴",hi+o/2,Ii-4)),h.strokeStyle=Ee("frame"),h.strokeRect(hi,Ii,o,o)}return e.addEventListener("pointermove",h=>{let f=n();if(!f)return;let g=e.getBoundingClientRect(),x=1.04*$i(f)[1],p=E=>(2*(E/o)-1)*x,m=p(h.clientX-g.left-hi),y=-p(h.clientY-g.top-Ii),S=af(f,y,m),v=(Math.atan2(m,y)+2*Math.PI)%(2*Math.PI);i.textContent=Number.isFinite(S)?`radius ${Te(Math.hypot(y,m),"diameter",3)}, ${Te(v,"angle",3)}: ${Te(S,"diameter",3)} deep`:" "}),e.addEventListener("pointerleave",()=>i.textContent=" "),new ResizeObserver(()=>{let h=Math.min(Math.max(r.clientWidth-hi-ll,150),zh);!pn()&&r.clientWidth&&h!==o&&a()}).observe(r),{element:r,draw:a}}var Vh=17;function Dr(n,t,e,i="text",s=.5){let r=Z("canvas",{}),o=r.getContext("2d"),a="600 44px system-ui, sans-serif";o.font=a,r.width=Math.ceil(o.measureText(n).width)+8,r.height=56,o.font=a,o.textBaseline="middle",o.fillStyle=Ee(i),o.fillText(n,4,30);let l=new Ba(r);l.colorSpace=ei;let c=new Fa(new Ro({map:l,depthTest:!1,transparent:!0}));return c.position.set(...t),c.center.set(s,.5),c.userData.pixels=[e*r.width/r.height,e],c.renderOrder=3,c}function uf(n,[t,e]){let i=new K(1/0,1/0,1/0),s=i.clone().negate();for(let o=0;o<=100;o++){let a=new K(...n.at(t+(e-t)*o/100,{}).place);i.min(a),s.max(a)}let r=.22*s.clone().sub(i).length();for(let o of["x","y","z"]){let l=Math.max(r-(s[o]-i[o]),0)/2+(o==="y"?0:.03*r);i[o]-=l,s[o]+=l}return{low:i,high:s}}function df({low:n,high:t},[e,,i]){let[s,r]=e>=0?[n.x,t.x]:[t.x,n.x],[o,a]=i>=0?[n.z,t.z]:[t.z,n.z];return[[s,o],[r,o],[s,a]]}function gw(n,[t,e],i,s,r){let a=1/0;for(let l=0;l<=100;l++){let[c,d,u]=n.at(t+(e-t)*l/100,{}).place;Math.abs(d-i)<=(e-t)/100&&(a=Math.min(a,Math.abs(s([c,u])-s(r))))}return a}function Hg(n,t,e,i){let s=uf(n,t),{low:r,high:o}=s,[a,...l]=df(s,i),c=([_,b])=>_*i[2]-b*i[0],[d,u]=l.sort((_,b)=>c(_)-c(b)),h=o.clone().sub(r).length(),f=ce("length"),g=En(Jt(t[0],"length"),Jt(t[1],"length"),8),x=g.values.map(_=>{let{place:b,high:B}=n.at(Hn(_,"length"),{}),I=e+.012*h;return Dr(`${Mn(_,g.step)} ${f}`,b.map((P,O)=>P+I*B[O]),Vh,"text",0)}),p=[],m=(_,b)=>p.push(..._,...b),y=En(Jt(-o.y,"length"),Jt(-r.y,"length"),5),S=_=>Math.min(...y.values.map(b=>gw(n,t,-Hn(b,"length"),c,_))),v=S(u)>S(d)+.1*h?u:d,E=y.values.map(_=>{let b=-Hn(_,"length"),B=([I,P])=>[I,b,P];return m(B(a),B(u)),m(B(a),B(d)),Dr(`TVD ${Mn(_,y.step)} ${f}`,B(v),Vh,"muted",v===d?1.06:-.06)});for(let[_,b]of[a,u,d])m([_,r.y,b],[_,o.y,b]);let w=new On;return w.setAttribute("position",new fn(p,3)),[new Ar(w,new sr({color:Ee("frame"),transparent:!0,opacity:.35})),Dr("N",[(r.x+o.x)/2,o.y,r.z-.04*h],Vh+2),Dr("E",[o.x+.04*h,o.y,(r.z+o.z)/2],Vh+2),...E,...x]}var Wg={type:"change"},pf={type:"start"},qg={type:"end"},Gh=new Er,Xg=new xi,_w=Math.cos(70*Xd.DEG2RAD),An=new K,ui=2*Math.PI,Le={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},ff=1e-6,Hh=class extends Ya{constructor(t,e=null){super(t,e),this.state=Le.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:lr.ROTATE,MIDDLE:lr.DOLLY,RIGHT:lr.PAN},this.touches={ONE:cr.ROTATE,TWO:cr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new yi,this._lastTargetPosition=new K,this._quat=new yi().setFromUnitVectors(t.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Io,this._sphericalDelta=new Io,this._scale=1,this._panOffset=new K,this._rotateStart=new Kt,this._rotateEnd=new Kt,this._rotateDelta=new Kt,this._panStart=new Kt,this._panEnd=new Kt,this._panDelta=new Kt,this._dollyStart=new Kt,this._dollyEnd=new Kt,this._dollyDelta=new Kt,this._dollyDirection=new K,this._mouse=new Kt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=yw.bind(this),this._onPointerDown=xw.bind(this),this._onPointerUp=vw.bind(this),this._onContextMenu=Aw.bind(this),this._onMouseWheel=bw.bind(this),this._onKeyDown=ww.bind(this),this._onTouchStart=Tw.bind(this),this._onTouchMove=Ew.bind(this),this._onMouseDown=Mw.bind(this),this._onMouseMove=Sw.bind(this),this._interceptControlDown=Rw.bind(this),this._interceptControlUp=Cw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Le.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Wg),this.update(),this.state=Le.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;An.copy(e).sub(this.target),An.applyQuaternion(this._quat),this._spherical.setFromVector3(An),this.autoRotate&&this.state===Le.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ui:i>Math.PI&&(i-=ui),s<-Math.PI?s+=ui:s>Math.PI&&(s-=ui),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(An.setFromSpherical(this._spherical),An.applyQuaternion(this._quatInverse),e.copy(this.target).add(An),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=An.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=An.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Gh.origin.copy(this.object.position),Gh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Gh.direction))<_w?this.object.lookAt(this.target):(Xg.setFromNormalAndCoplanarPoint(this.object.up,this.target),Gh.intersectPlane(Xg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>ff||8*(1-this._lastQuaternion.dot(this.object.quaternion))>ff||this._lastTargetPosition.distanceToSquared(this.target)>ff?(this.dispatchEvent(Wg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ui/60*this.autoRotateSpeed*t:ui/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){An.setFromMatrixColumn(e,0),An.multiplyScalar(-t),this._panOffset.add(An)}_panUp(t,e){this.screenSpacePanning===!0?An.setFromMatrixColumn(e,1):(An.setFromMatrixColumn(e,0),An.crossVectors(this.object.up,An)),An.multiplyScalar(t),this._panOffset.add(An)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;An.copy(s).sub(this.target);let r=An.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Kt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function xw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function yw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function vw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(qg),this.state=Le.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Mw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case lr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Le.DOLLY;break;case lr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Le.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Le.ROTATE}break;case lr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Le.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Le.PAN}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(pf)}function Sw(n){switch(this.state){case Le.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Le.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Le.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function bw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Le.NONE||(n.preventDefault(),this.dispatchEvent(pf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(qg))}function ww(n){this.enabled!==!1&&this._handleKeyDown(n)}function Tw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case cr.ROTATE:if(this.enableRotate===!1){this.state=Le.NONE;break}this._handleTouchStartRotate(n),this.state=Le.TOUCH_ROTATE;break;case cr.PAN:if(this.enablePan===!1){this.state=Le.NONE;break}this._handleTouchStartPan(n),this.state=Le.TOUCH_PAN;break;default:this.state=Le.NONE}break;case 2:switch(this.touches.TWO){case cr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Le.TOUCH_DOLLY_PAN;break;case cr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Le.TOUCH_DOLLY_ROTATE;break;default:this.state=Le.NONE}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(pf)}function Ew(n){switch(this._trackPointer(n),this.state){case Le.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Le.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Le.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Le.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Le.NONE}}function Aw(n){this.enabled!==!1&&n.preventDefault()}function Rw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Cw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Wh=()=>Z("p",{class:"warning"},"This view needs WebGL, which this browser does not give."),Pw=n=>new Pi().setFromArray(n.flat()).getCenter(new K),Xh="drag to turn, right-drag to move, Ctrl + wheel to go nearer";function qh(n,t,e=0){let i=Z("canvas",{class:"space",style:`height:${t}px`,role:"img","aria-label":n}),s;try{s=new Fh({canvas:i,antialias:!0,alpha:!0,preserveDrawingBuffer:!0})}catch{return null}let r=new La,o=new ni(38,1,1,1e5),a=new Hh(o,i);a.enableDamping=!1,a.enableZoom=!1;let l=new qa(16777215,2.2);r.add(new $a(16777215,1.6),l);let c=Z("canvas",{class:"space-paper"}),d=Z("div",{class:"space-holder"},i,c),u=[];i.addEventListener("wheel",S=>{if(!S.ctrlKey&&!S.metaKey)return;S.preventDefault();let v=o.position.clone().sub(a.target).multiplyScalar(Math.exp(S.deltaY*.002));o.position.copy(a.target).add(v),g()},{passive:!1}),a.addEventListener("change",g);function h(S){return u.push(S),r.add(S),S}function f(S=u){for(let v of S)r.remove(v),v.geometry?.dispose(),v.material.map?.dispose(),v.material.dispose();u=u.filter(v=>!S.includes(v))}function g(){let S=e*o.position.distanceTo(a.target);l.position.copy(o.position).add(new K(-S,S,0).applyQuaternion(o.quaternion)),l.target.position.copy(a.target),l.target.updateMatrixWorld(),d.dataset.labels=JSON.stringify(p()),s.render(r,o),pn()&&([c.width,c.height]=[i.width,i.height],c.getContext("2d").drawImage(i,0,0))}function x(S,v,E=Pw(S),w=[.07*(i.clientWidth||1200),.04*t]){let _=i.clientWidth||1200,b=new K(...v).normalize(),B=S.map(C=>new K(...C)),I=Math.tan(o.fov*Math.PI/360),P=[1-2*w[0]/_,1-2*w[1]/t].map(C=>Math.max(C,.3)),O=E.clone(),z=2*Math.max(...B.map(C=>C.distanceTo(E)),.001);for(let C=0;C<12;C++){o.position.copy(O).addScaledVector(b,z),o.near=z/1e3,o.far=z*1e3,o.updateProjectionMatrix(),o.lookAt(O),o.updateMatrixWorld();let N=new Pi().setFromPoints(B.map(X=>X.clone().project(o))),[U,k]=[(N.min.x+N.max.x)/2,(N.min.y+N.max.y)/2],$=new K().setFromMatrixColumn(o.matrixWorld,0),V=new K().setFromMatrixColumn(o.matrixWorld,1);O.addScaledVector($,U*z*I*(_/t)).addScaledVector(V,k*z*I),z*=Math.max((N.max.x-N.min.x)/2/P[0],(N.max.y-N.min.y)/2/P[1])||1}a.target.copy(O),o.position.copy(O).addScaledVector(b,z),o.near=z/200,o.far=z*20,o.updateProjectionMatrix(),a.update(),g()}function p(){o.updateMatrixWorld();let[S,v]=[i.clientWidth||1200,Math.tan(o.fov*Math.PI/360)],E=[];for(let w of u.filter(_=>_.userData.pixels)){let[_,b]=w.userData.pixels,B=-w.position.clone().applyMatrix4(o.matrixWorldInverse).z,I=2*v*B/t;w.scale.set(_*I,b*I,1);let P=w.position.clone().project(o),O=(P.x+1)/2*S-w.center.x*_,z=(1-P.y)/2*t-b/2,C={left:O,top:z,right:O+_,bottom:z+b},N=U=>C.left<U.right+4&&U.left<C.right+4&&C.top<U.bottom&&U.top<C.bottom;w.visible=B>0&&C.left>=0&&C.right<=S&&!E.some(N),w.visible&&E.push(C)}return E}function m(){let S=d.clientWidth||1200;s.setPixelRatio(Math.min(devicePixelRatio*(devicePixelRatio<1.5?1.5:1),2.5)),s.setSize(S,t,!1),o.aspect=S/t,o.updateProjectionMatrix()}let y=0;return new ResizeObserver(()=>{d.clientWidth!==y&&(y=d.clientWidth,m(),g())}).observe(d),{holder:d,canvas:i,spans:S=>{let v=new Pi().setFromPoints(S.map(E=>new K(...E).project(o)));return[(v.max.x-v.min.x)/2,(v.max.y-v.min.y)/2]},add:h,has:S=>u.includes(S),remove:f,render:g,lookAt:x,size:m,from:()=>o.position.clone().sub(a.target)}}var Iw=460,$g=[-.35,.95,.9];function Yh(n,t){let e=qh("The bottom of the hole in space",Iw,.9),i=Gg(n,t),s=Z("div",{class:"colour-key"}),r=1,o=null,a=Z("output",{}),l=Z("input",{type:"range",min:0,max:1.3,step:.01,"aria-label":"Exaggeration of depth",oninput:()=>{r=10**Number(l.value),u()}}),c=[["At an angle",$g],["From above",[0,1,.001]],["From the side",[0,.12,1]]].map(([p,m])=>Z("button",{type:"button",onclick:()=>h(m)},p)),d=Z("div",{class:"tools noprint"},Z("label",{},"Depth × ",l,a),c,Z("span",{class:"hint"},Xh));function u(){let p=n();if(!p)return;let[,m]=$i(p),y=Bo(p),S=ce("diameter");s.replaceChildren(...kh(`Depth below the rim, ${S}`,"diameter",[0,y],al())),e&&(e.remove(),e.add(Dw(p,y,r)),e.add(Nw(p,r)),Uw(m,t?Zg(p)*r:null).forEach(e.add),a.textContent=` ${zn(r,2)}`,e.render())}function h(p){let m=n();if(!m||!e)return;let[,y]=$i(m),S=Bo(m)*r,v=m.depth_m.reduce((b,B)=>B<b?B:b,0)*r,w=Array.from({length:24},(b,B)=>B*Math.PI/12).flatMap(b=>[v,S].map(B=>$h(y,b,B))),_=[-1,1].map(b=>[.7*b*y,0,1.25*y]);t&&_.push([0,.2*y-v,-y]),e.lookAt([...w,..._],p,new K(0,-(v+S)/2,.22*y))}function f(){let p=n();if(o=p,!p)return;let m=.3*$i(p)[1]/(Bo(p)||1);r=[10,5,2].find(y=>y<=m)??1,l.value=Math.log10(r),u(),h($g)}function g(){i.draw(),e&&e.size(),n()===o?u():f()}we("units",()=>{i.draw(),u()}),we("operation",()=>{i.draw(),f()});let x=e?[d,Z("div",{class:"bottom"},e.holder,i.element)]:[Wh(),i.element];return{element:Z("div",{},x,s),redraw:g}}var $h=(n,t,e)=>[n*Math.sin(t),-e,-n*Math.cos(t)];function Lw(n){let[t,e]=$i(n),i=n.angle_rad.length,s=n.radius_m.length-1,r=d=>n.depth_m.subarray(d*i,(d+1)*i),o=Array.from(n.radius_m,(d,u)=>[d,r(u)]),a=r(0),l=a.filter(Number.isFinite),c=l.reduce((d,u)=>d+u,0)/l.length;return o.unshift(t>0?[t,a]:[0,a.map(()=>c)]),o.push([e,r(s)]),o}function Dw(n,t,e){let i=Lw(n),s=n.angle_rad.length,r=al(),o=new fe,[a,l,c]=[[],[],[]];for(let[h,f]of i)f.forEach((g,x)=>{let p=Number.isFinite(g)?g:0;a.push(...$h(h,n.angle_rad[x],p*e));let[m,y,S]=r(p/(t||1)).map(v=>v/255);o.setRGB(m,y,S,"srgb"),l.push(o.r,o.g,o.b)});let d=(h,f)=>Number.isFinite(i[h][1][f]);for(let h=0;h+1<i.length;h++)for(let f=0;f<s;f++){let g=(f+1)%s;if(![d(h,f),d(h,g),d(h+1,f),d(h+1,g)].every(Boolean))continue;let[x,p]=[h*s+f,h*s+g];c.push(x,p,x+s,p,p+s,x+s)}let u=new On;return u.setAttribute("position",new fn(a,3)),u.setAttribute("color",new fn(l,3)),u.setIndex(c),u.computeVertexNormals(),new $n(u,new Ds({vertexColors:!0,side:li}))}var Yg=n=>n.depth_m.subarray((n.radius_m.length-1)*n.angle_rad.length),Zg=n=>Math.min(0,...Yg(n).filter(Number.isFinite));function Nw(n,t){let[,e]=$i(n),i=n.angle_rad.length,s=Yg(n),r=Zg(n)*t-.02*e,[o,a]=[[],[]];s.forEach((c,d)=>{let u=n.angle_rad[d];o.push(...$h(e,u,r)),o.push(...$h(e,u,(Number.isFinite(c)?c:0)*t));let[h,f]=[2*d,2*((d+1)%i)];a.push(h,h+1,f,f,h+1,f+1)});let l=new On;return l.setAttribute("position",new fn(o,3)),l.setIndex(a),l.computeVertexNormals(),new $n(l,new Ds({color:Ee("rock"),side:hs}))}function Uw(n,t){let{values:e,step:i}=En(0,Jt(1.4*n,"diameter"),3),s=Hn(e.at(-1),"diameter"),r=1.12*n,[o,a]=[-s/2,s/2],l=.025*n,c=[o,0,r,a,0,r];for(let f of[o,a])c.push(f,0,r-l,f,0,r+l);let d=new On;d.setAttribute("position",new fn(c,3));let u=.075*n,h=`${Mn(e.at(-1),i)} ${ce("diameter")}`;return[new Ar(d,new sr({color:Ee("text")})),Dr(h,[0,0,r+1.1*u],18),...t===null?[]:[Dr("high side",[0,1.2*u-t,-n],18)]]}function Zh(n){let t=n.map(s=>[s,Z("a",{href:`#${s.id}`},s.querySelector("h2").firstChild.textContent)]),e=Z("nav",{class:"contents noprint","aria-label":"Contents"},t.map(([,s])=>s)),i=()=>t.forEach(([s,r])=>r.toggleAttribute("hidden",s.hidden));return i(),{element:e,redraw:i}}var dr=Z("div",{class:"tip noprint",role:"status",hidden:!0});function Jh(n,t,e){dr.isConnected||document.body.append(dr),dr.replaceChildren(Z("strong",{},t),...e.map(({colour:a,text:l,class:c})=>Z("div",{class:c},a&&Z("span",{class:"swatch",style:`background:${a}`}),l))),dr.hidden=!1;let{width:i,height:s}=dr.getBoundingClientRect(),r=n.clientX+16+i>innerWidth?n.clientX-16-i:n.clientX+16,o=Math.min(n.clientY+12,innerHeight-s-4);dr.style.left=`${Math.max(r,4)}px`,dr.style.top=`${Math.max(o,4)}px`}var cl=()=>dr.hidden=!0;function Jg(n,t,e=null){let i=Z("div",{class:"figure-holder"}),s=new Set;function r(c){let d=u=>u.dataset.keys.split(" ").filter(Boolean);for(let u of c.querySelectorAll(".series"))u.toggleAttribute("hidden",d(u).some(h=>s.has(h)));for(let u of c.querySelectorAll(".legend-key")){let h=s.has(u.dataset.keys);u.setAttribute("aria-pressed",String(!h)),u.classList.toggle("off",h)}}function o(c){for(let d of c.querySelectorAll(".legend-key")){if(![...c.querySelectorAll(".series")].some(g=>g.dataset.keys.split(" ").includes(d.dataset.keys)))continue;let h=()=>{s.delete(d.dataset.keys)||s.add(d.dataset.keys),r(c)},f={tabindex:0,role:"button","aria-label":`Show or hide ${d.textContent.trim()}`};for(let[g,x]of Object.entries(f))d.setAttribute(g,x);d.addEventListener("click",h),d.addEventListener("keydown",g=>{g.key!=="Enter"&&g.key!==" "||(g.preventDefault(),h())})}if(e)for(let d of c.querySelectorAll(".spot"))a(d);r(c)}function a(c){let d=()=>e(Number(c.dataset.row)),{title:u,href:h,level:f}=d();if(f&&c.classList.add(`level-${f}`),c.setAttribute("aria-label",u),h){c.setAttribute("role","link"),c.setAttribute("tabindex",0),c.classList.add("leads");let x=()=>location.assign(h);c.addEventListener("click",x),c.addEventListener("keydown",p=>p.key==="Enter"&&x())}let g=x=>{let{title:p,rows:m}=d(),y=c.getBoundingClientRect();Jh({clientX:x.clientX??y.right,clientY:x.clientY??y.bottom},p,m)};for(let x of["pointerenter","pointermove","focus"])c.addEventListener(x,g);for(let x of["pointerleave","blur"])c.addEventListener(x,cl)}function l(){let d=document.getElementById(`${n}-${Bt.units}`)?.content.cloneNode(!0);i.replaceChildren(...d?.firstElementChild?[d]:[t]);let u=i.querySelector("svg");u&&o(u)}return we("units",l),l(),{element:i,file:()=>no([...i.querySelectorAll("svg")]),there:()=>i.querySelector("svg")!==null}}var Kh=()=>Z("details",{},Z("summary",{},"Plots by uPlot, 3D by three.js: their licences (MIT)"),Z("pre",{},document.getElementById("licences").content.textContent));function jh(n,t,e){let i=Vg(e);return Z("header",{},Z("div",{class:"title-line"},Z("h1",{},n),Z("div",{class:"controls noprint"},xr("Units",[["si","SI"],["metric","Metric"],["field","US field"]],Bt.units,s=>Ge({units:s})),xr("Colours",[["auto","Auto"],["light","Light"],["dark","Dark"]],Bt.theme,i),Z("button",{type:"button",onclick:()=>print()},"Print"))),t)}var Qh=(n,t,...e)=>Z("section",{id:n},Z("h2",{},t),e);function Kg(n,t,e){let{element:i,file:s,there:r}=Jg(e,"No point was finished.");return Qh(n,[t,Nn(t,{svg:r()?s:null})],i)}function jg(n){let{bottoms:t}=n,e=t.length-1,i=t.length?Yh(()=>t[e].bottom,!1):null,s=Z("div",{class:"tools noprint"}),r=Z("p",{class:"note"}),o=({weight_N:h,rotary_rad_per_s:f})=>`${Te(h,"force",3)} at ${Te(f,"rotary speed",3)}`,a=()=>{let h=t.map((f,g)=>[String(g),o(f)]);s.replaceChildren(Al("Point: ",h,String(e),f=>{e=Number(f),l(),i.redraw()})),l()},l=()=>r.textContent=`After ${o(t[e])}.`,[c,...d]=n.sheets,u=document.getElementById("page");u.append(jh(n.title,Fl(n),()=>i?.redraw()),...n.message?[Z("p",{class:"warning"},n.message)]:[],Kg("drill-off","Drill-off","drill-off"),Kg("energy","Specific energy","specific-energy")),i&&(a(),we("units",a),u.append(Qh("bottom","Bottom of the hole",s,i.element,r))),u.append(Qh("points",["Points",ku(c)],fa(c)),...d.length?[Qh("inputs","Inputs, defaults included",d.map(fa))]:[],Z("footer",{},Z("p",{},`Made by ${n.program}. The tables beside this file hold every digit.`),Kh())),u.querySelector("header").after(Zh([...u.querySelectorAll("section:has(h2)")]).element),i?.redraw()}function Qg(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function Fw(n){if(n.f32!==void 0)return new Float32Array(Qg(n.f32));let[t,e,i]=n.i16,s=new Int16Array(Qg(t)),r=new Float32Array(s.length);for(let o=0;o<s.length;o++)r[o]=s[o]===-32768?NaN:e+i*s[o];return r}function mf(n){return Array.isArray(n)?n.map(mf):n===null||typeof n!="object"?n:typeof n.f32=="string"||Array.isArray(n.i16)?Fw(n):Object.fromEntries(Object.entries(n).map(([t,e])=>[t,mf(e)]))}function t0(){return mf(JSON.parse(document.getElementById("report").textContent))}var Ow="uplot",Bw="u-hz",kw="u-vt",zw="u-title",Vw="u-wrap",Gw="u-under",Hw="u-over",Ww="u-axis",Fr="u-off",Xw="u-select",qw="u-cursor-x",$w="u-cursor-y",Yw="u-cursor-pt",Zw="u-legend",Jw="u-live",Kw="u-inline",jw="u-series",Qw="u-marker",e0="u-label",t1="u-value",ul="width",dl="height";var n0="bottom",zo="left",gf="right",Df="#000",i0=Df+"0",_f="mousemove",s0="mousedown",xf="mouseup",r0="mouseenter",o0="mouseleave",a0="dblclick",e1="resize",n1="scroll",l0="change",su="dppxchange",Nf="--",$o=typeof window<"u",bf=$o?document:null,Go=$o?window:null,i1=$o?navigator:null,De,tu;function wf(){let n=devicePixelRatio;De!=n&&(De=n,tu&&Ef(l0,tu,wf),tu=matchMedia(`(min-resolution: ${De-.001}dppx) and (max-resolution: ${De+.001}dppx)`),Or(l0,tu,wf),Go.dispatchEvent(new CustomEvent(su)))}function Si(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Tf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function je(n,t,e){n.style[t]=e+"px"}function Yi(n,t,e,i){let s=bf.createElement(n);return t!=null&&Si(s,t),e?.insertBefore(s,i),s}function Li(n,t){return Yi("div",n,t)}var c0=new WeakMap;function ps(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=c0.get(n);r!=o&&(n.style.transform=r,c0.set(n,r),t<0||e<0||t>i||e>s?Si(n,Fr):Tf(n,Fr))}var h0=new WeakMap;function u0(n,t,e){let i=t+e,s=h0.get(n);i!=s&&(h0.set(n,i),n.style.background=t,n.style.borderColor=e)}var d0=new WeakMap;function f0(n,t,e,i){let s=t+""+e,r=d0.get(n);s!=r&&(d0.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Uf={passive:!0},s1={...Uf,capture:!0};function Or(n,t,e,i){t.addEventListener(n,e,i?s1:Uf)}function Ef(n,t,e,i){t.removeEventListener(n,e,Uf)}$o&&wf();function Zi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:bi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function V0(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var G0=n=>n!=null,H0=n=>n!=null&&n>0,au=V0(G0),r1=V0(H0);function o1(n,t,e,i=0,s=!1){let r=s?r1:au,o=s?H0:G0;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let d=n[c];o(d)&&(d<a?a=d:d>l&&(l=d))}return[a??He,l??-He]}function lu(n,t,e,i){let s=g0(n),r=g0(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Os:W0,a=s==1?bi:Di,l=r==1?Di:bi,c=a(o(Cn(n))),d=l(o(Cn(t))),u=Ho(e,c),h=Ho(e,d);return e==10&&(c<0&&(u=We(u,-c)),d<0&&(h=We(h,-d))),i||e==2?(n=u*s,t=h*r):(n=Y0(n,u),t=cu(t,h)),[n,t]}function Ff(n,t,e,i){let s=lu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Of=.1,p0={mode:3,pad:Of},pl={pad:0,soft:null,mode:0},a1={min:pl,max:pl};function ru(n,t,e,i){return hu(e)?m0(n,t,e):(pl.pad=e,pl.soft=i?0:null,pl.mode=i?3:0,m0(n,t,a1))}function Re(n,t){return n??t}function l1(n,t,e){for(t=Re(t,0),e=Re(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function m0(n,t,e){let i=e.min,s=e.max,r=Re(i.pad,0),o=Re(s.pad,0),a=Re(i.hard,-He),l=Re(s.hard,He),c=Re(i.soft,He),d=Re(s.soft,-He),u=Re(i.mode,0),h=Re(s.mode,0),f=t-n,g=Os(f),x=ai(Cn(n),Cn(t)),p=Os(x),m=Cn(p-g);(f<1e-24||m>10)&&(f=0,(n==0||t==0)&&(f=1e-24,u==2&&c!=He&&(r=0),h==2&&d!=-He&&(o=0)));let y=f||x||1e3,S=Os(y),v=Ho(10,bi(S)),E=y*(f==0?n==0?.1:1:r),w=We(Y0(n-E,v/10),24),_=n>=c&&(u==1||u==3&&w<=c||u==2&&w>=c)?c:He,b=ai(a,w<_&&n>=_?_:Ji(_,w)),B=y*(f==0?t==0?.1:1:o),I=We(cu(t+B,v/10),24),P=t<=d&&(h==1||h==3&&I>=d||h==2&&I<=d)?d:-He,O=Ji(l,I>P&&t<=P?P:ai(P,I));return b==O&&b==0&&(O=100),[b,O]}var c1=new Intl.NumberFormat($o?i1.language:"en-US"),Bf=n=>c1.format(n),wi=Math,iu=wi.PI,Cn=wi.abs,bi=wi.floor,Rn=wi.round,Di=wi.ceil,Ji=wi.min,ai=wi.max,Ho=wi.pow,g0=wi.sign,Os=wi.log10,W0=wi.log2,h1=(n,t=1)=>wi.sinh(n)*t,yf=(n,t=1)=>wi.asinh(n/t),He=1/0;function _0(n){return(Os((n^n>>31)-(n>>31))|0)+1}function Af(n,t,e){return Ji(ai(n,t),e)}function X0(n){return typeof n=="function"}function be(n){return X0(n)?n:()=>n}var u1=()=>{},q0=n=>n,$0=(n,t)=>t,d1=n=>null,x0=n=>!0,y0=(n,t)=>n==t,f1=/\.\d*?(?=9{6,}|0{6,})/gm,Br=n=>{if(J0(n)||pr.has(n))return n;let t=`${n}`,e=t.match(f1);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Br(s)}e${r}`}return We(n,i)};function Nr(n,t){return Br(We(Br(n/t))*t)}function cu(n,t){return Br(Di(Br(n/t))*t)}function Y0(n,t){return Br(bi(Br(n/t))*t)}function We(n,t=0){if(J0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Rn(i)/e}var pr=new Map;function Z0(n){return((""+n).split(".")[1]||"").length}function gl(n,t,e,i){let s=[],r=i.map(Z0);for(let o=t;o<e;o++){let a=Cn(o),l=We(Ho(n,o),a);for(let c=0;c<i.length;c++){let d=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?d:We(d,u);s.push(h),pr.set(h,u)}}return s}var ml={},kf=[],Wo=[null,null],fr=Array.isArray,J0=Number.isInteger,p1=n=>n===void 0;function v0(n){return typeof n=="string"}function hu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function m1(n){return n!=null&&typeof n=="object"}var g1=Object.getPrototypeOf(Uint8Array),K0="__proto__";function Xo(n,t=hu){let e;if(fr(n)){let i=n.find(s=>s!=null);if(fr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Xo(n[s],t)}else e=n.slice()}else if(n instanceof g1)e=n.slice();else if(t(n)){e={};for(let i in n)i!=K0&&(e[i]=Xo(n[i],t))}else e=n;return e}function Sn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=K0&&(hu(n[s])?Sn(n[s],Xo(i[s])):n[s]=Xo(i[s]))}return n}var _1=0,x1=1,y1=2;function v1(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function M1(n,t){if(w1(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return T1(o[0])||(o=b1(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let d=0;d<c;d++)e.add(l[d])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let d=a[c],u=Array(s).fill(void 0),h=t?t[o][c]:x1,f=[];for(let g=0;g<d.length;g++){let x=d[g],p=r.get(l[g]);x===null?h!=_1&&(u[p]=x,h==y1&&f.push(p)):u[p]=x}v1(u,f,s),i.push(u)}}return i}var S1=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function b1(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function w1(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function T1(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ai(1,bi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var j0=["January","February","March","April","May","June","July","August","September","October","November","December"],Q0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function t_(n){return n.slice(0,3)}var E1=Q0.map(t_),A1=j0.map(t_),R1={MMMM:j0,MMM:A1,WWWW:Q0,WWW:E1};function hl(n){return(n<10?"0":"")+n}function C1(n){return(n<10?"00":n<100?"0":"")+n}var P1={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>hl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>hl(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>hl(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>hl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>hl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>C1(n.getMilliseconds())};function zf(n,t){t=t||R1;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?P1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var I1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function L1(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==I1?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var e_=n=>n%1==0,ou=[1,2,2.5,5],D1=gl(10,-32,0,ou),n_=gl(10,0,32,ou),N1=n_.filter(e_),Ur=D1.concat(n_),Vf=`
`,i_="{YYYY}",M0=Vf+i_,s_="{M}/{D}",fl=Vf+s_,eu=fl+"/{YY}",r_="{aa}",U1="{h}:{mm}",Vo=U1+r_,S0=Vf+Vo,b0=":{ss}",Ue=null;function o_(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?gl(10,0,3,ou).filter(e_):gl(10,-3,0,ou)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,i_,Ue,Ue,Ue,Ue,Ue,Ue,1],[s*28,"{MMM}",M0,Ue,Ue,Ue,Ue,Ue,1],[s,s_,M0,Ue,Ue,Ue,Ue,Ue,1],[i,"{h}"+r_,eu,Ue,fl,Ue,Ue,Ue,1],[e,Vo,eu,Ue,fl,Ue,Ue,Ue,1],[t,b0,eu+" "+Vo,Ue,fl+" "+Vo,Ue,S0,Ue,1],[n,b0+".{fff}",eu+" "+Vo,Ue,fl+" "+Vo,Ue,S0,Ue,1]];function d(u){return(h,f,g,x,p,m)=>{let y=[],S=p>=o,v=p>=r&&p<o,E=u(g),w=We(E*n,3),_=vf(E.getFullYear(),S?0:E.getMonth(),v||S?1:E.getDate()),b=We(_*n,3);if(v||S){let B=v?p/r:0,I=S?p/o:0,P=w==b?w:We(vf(_.getFullYear()+I,_.getMonth()+B,1)*n,3),O=new Date(Rn(P/n)),z=O.getFullYear(),C=O.getMonth();for(let N=0;P<=x;N++){let U=vf(z+I*N,C+B*N,1),k=U-u(We(U*n,3));P=We((+U+k)*n,3),P<=x&&y.push(P)}}else{let B=p>=s?s:p,I=bi(g)-bi(w),P=b+I+cu(w-b,B);y.push(P);let O=u(P),z=O.getHours()+O.getMinutes()/e+O.getSeconds()/i,C=p/i,N=h.axes[f]._space,U=m/N;for(;P=We(P+p,n==1?0:3),!(P>x);)if(C>1){let k=bi(We(z+C,6))%24,X=u(P).getHours()-k;X>1&&(X=-1),P-=X*i,z=(z+C)%24;let J=y[y.length-1];We((P-J)/p,3)*U>=.7&&y.push(P)}else y.push(P)}return y}}return[l,c,d]}var[F1,O1,B1]=o_(1),[k1,z1,V1]=o_(.001);gl(2,-53,53,[1]);function w0(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function T0(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,d,u,h,f;return i.map(g=>{let x=n(g),p=x.getFullYear(),m=x.getMonth(),y=x.getDate(),S=x.getHours(),v=x.getMinutes(),E=x.getSeconds(),w=p!=l&&a[2]||m!=c&&a[3]||y!=d&&a[4]||S!=u&&a[5]||v!=h&&a[6]||E!=f&&a[7]||a[1];return l=p,c=m,d=y,u=S,h=v,f=E,w(x)})}}function G1(n,t){let e=zf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function vf(n,t,e){return new Date(n,t,e)}function E0(n,t){return t(n)}var H1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function A0(n,t){return(e,i,s,r)=>r==null?Nf:t(n(i))}function W1(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function X1(n,t){return n.series[t].fill(n,t)}var q1={show:!0,live:!0,isolate:!1,mount:u1,markers:{show:!0,width:2,stroke:W1,fill:X1,dash:"solid"},idx:null,idxs:null,values:[]};function $1(n,t){let e=n.cursor.points,i=Li(),s=e.size(n,t);je(i,ul,s),je(i,dl,s);let r=s/-2;je(i,"marginLeft",r),je(i,"marginTop",r);let o=e.width(n,t,s);return o&&je(i,"borderWidth",o),i}function Y1(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Z1(n,t){let e=n.series[t].points;return e._stroke||e._fill}function J1(n,t){return n.series[t].points.size}var Mf=[0,0];function K1(n,t,e){return Mf[0]=t,Mf[1]=e,Mf}function nu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Sf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var j1={show:!0,x:!0,y:!0,lock:!1,move:K1,points:{one:!1,show:$1,size:J1,width:0,stroke:Z1,fill:Y1},bind:{mousedown:nu,mouseup:nu,click:nu,dblclick:nu,mousemove:Sf,mouseleave:Sf,mouseenter:Sf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},a_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Gf=Sn({},a_,{filter:$0}),l_=Sn({},Gf,{size:10}),c_=Sn({},a_,{show:!1}),Hf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',h_="bold "+Hf,u_=1.5,R0={show:!0,scale:"x",stroke:Df,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:h_,side:2,grid:Gf,ticks:l_,border:c_,font:Hf,lineGap:u_,rotate:0},Q1="Value",tT="Time",C0={show:!0,scale:"x",auto:!1,sorted:1,min:He,max:-He,idxs:[]};function eT(n,t,e,i,s){return t.map(r=>r==null?"":Bf(r))}function nT(n,t,e,i,s,r,o){let a=[],l=pr.get(s)||0;e=o?e:We(cu(e,s),l);for(let c=e;c<=i;c=We(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Rf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Os:W0,d=bi(c(e));s=Ho(l,d),l==10&&(s=Ur[Zi(s,Ur)]);let u=e,h=s*l;l==10&&(h=Ur[Zi(h,Ur)]);do a.push(u),u=u+s,l==10&&!pr.has(u)&&(u=We(u,pr.get(s))),u>=h&&(s=u,h=s*l,l==10&&(h=Ur[Zi(h,Ur)]));while(u<=i);return a}function iT(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Rf(n,t,ai(l,e),i,s):[l],d=i>=0&&e<=0?[0]:[];return(e<-l?Rf(n,t,ai(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(d,c)}var d_=/./,sT=/[12357]/,rT=/[125]/,P0=/1/,Cf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function oT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,d=l(10,o),u=l(9,o)-d>=c?d_:l(7,o)-d>=c?sT:l(5,o)-d>=c?rT:P0;if(u==P0){let h=Cn(l(1,o)-d);if(h<c)return Cf(t.slice().reverse(),a.distr,u,Di(c/h)).reverse()}return Cf(t,a.distr,u,1)}function aT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Cn(l(1,o)-l(2,o));return c<a?Cf(t.slice().reverse(),3,d_,Di(a/c)).reverse():t}function lT(n,t,e,i){return i==null?Nf:t==null?"":Bf(t)}var I0={show:!0,scale:"y",stroke:Df,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:h_,side:3,grid:Gf,ticks:l_,border:c_,font:Hf,lineGap:u_,rotate:0};function cT(n,t){let e=3+(n||1)*2;return We(e*t,3)}function hT(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Cn(o-r),l=n.series[t],c=a/(l.points.space*De);return i[1]-i[0]<=c}var L0={scale:null,auto:!0,sorted:0,min:He,max:-He},f_=(n,t,e,i,s)=>s,D0={show:!0,auto:!0,sorted:0,gaps:f_,alpha:1,facets:[Sn({},L0,{scale:"x"}),Sn({},L0,{scale:"y"})]},N0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:f_,alpha:1,points:{show:hT,filter:null},values:null,min:He,max:-He,idxs:[],path:null,clip:null};function uT(n,t,e,i,s){return e/10}var p_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},dT=Sn({},p_,{time:!1,ori:1}),U0={};function m_(n,t){let e=U0[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let d=0;d<e.plots.length;d++)e.plots[d]!=s&&e.plots[d].pub(i,s,r,o,a,l,c)}},n!=null&&(U0[n]=e)),e}var qo=1,Pf=2;function kr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],d=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,g=a.width,x=a.height,p=n.valToPosH,m=n.valToPosV;return d.ori==0?e(s,l,c,d,u,p,m,h,f,g,x,du,Yo,pu,__,y_):e(s,l,c,d,u,m,p,f,h,x,g,fu,Zo,qf,x_,v_)}function Wf(n,t){let e=0,i=0,s=Re(n.bands,kf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function fT(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Bs(n,t,e,i,s,r){return kr(n,t,(o,a,l,c,d,u,h,f,g,x,p)=>{let m=o.pxRound,y=c.dir*(c.ori==0?1:-1),S=c.ori==0?Yo:Zo,v,E;y==1?(v=e,E=i):(v=i,E=e);let w=m(u(a[v],c,x,f)),_=m(h(l[v],d,p,g)),b=m(u(a[E],c,x,f)),B=m(h(r==1?d.max:d.min,d,p,g)),I=new Path2D(s);return S(I,b,B),S(I,w,B),S(I,w,_),I})}function uu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?pu:qf,l=e;for(let u=0;u<n.length;u++){let h=n[u];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=e+s-l,d=10;c>0&&a(o,l,i-d/2,c,i+r+d)}return o}function pT(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Xf(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let u=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let f=r(n[u]),g=h==u?f:r(n[h]),x=u-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let m=h+s;g=o>=0&&m>=0&&m<l?r(n[m]):g,g>=f&&a.push([f,g])}return a}function F0(n){return n==0?q0:n==1?Rn:t=>Nr(t,n)}function g_(n){let t=n==0?du:fu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,d=0)=>{c==0&&d==0?i(s,r,o,a,l):(c=Ji(c,a/2,l/2),d=Ji(d,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,d),e(s,r,o+l,r,o,d),e(s,r,o,r+a,o,c),s.closePath())}}var du=(n,t,e)=>{n.moveTo(t,e)},fu=(n,t,e)=>{n.moveTo(e,t)},Yo=(n,t,e)=>{n.lineTo(t,e)},Zo=(n,t,e)=>{n.lineTo(e,t)},pu=g_(0),qf=g_(1),__=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},x_=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},y_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},v_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function M_(n){return(t,e,i,s,r)=>kr(t,e,(o,a,l,c,d,u,h,f,g,x,p)=>{let{pxRound:m,points:y}=o,S,v;c.ori==0?(S=du,v=__):(S=fu,v=x_);let E=We(y.width*De,3),w=(y.size-y.width)/2*De,_=We(w*2,3),b=new Path2D,B=new Path2D,{left:I,top:P,width:O,height:z}=t.bbox;pu(B,I-_,P-_,O+_*2,z+_*2);let C=N=>{if(l[N]!=null){let U=m(u(a[N],c,x,f)),k=m(h(l[N],d,p,g));S(b,U+w,k),v(b,U,k,w,0,iu*2)}};if(r)r.forEach(C);else for(let N=i;N<=s;N++)C(N);return{stroke:E>0?b:null,fill:b,clip:B,flags:qo|Pf}})}function S_(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var mT=S_(Yo),gT=S_(Zo);function b_(n){let t=Re(n?.alignGaps,0);return(e,i,s,r)=>kr(e,i,(o,a,l,c,d,u,h,f,g,x,p)=>{[s,r]=au(l,s,r);let m=o.pxRound,y=z=>m(u(z,c,x,f)),S=z=>m(h(z,d,p,g)),v,E;c.ori==0?(v=Yo,E=mT):(v=Zo,E=gT);let w=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:qo},b=_.stroke,B=!1;if(r-s>=x*4){let z=Q=>e.posToVal(Q,c.key,!0),C=null,N=null,U,k,$,V=y(a[w==1?s:r]),X=y(a[s]),J=y(a[r]),nt=z(w==1?X+1:J-1);for(let Q=w==1?s:r;Q>=s&&Q<=r;Q+=w){let W=a[Q],ht=(w==1?W<nt:W>nt)?V:y(W),ct=l[Q];ht==V?ct!=null?(k=ct,C==null?(v(b,ht,S(k)),U=C=N=k):k<C?C=k:k>N&&(N=k)):ct===null&&(B=!0):(C!=null&&E(b,V,S(C),S(N),S(U),S(k)),ct!=null?(k=ct,v(b,ht,S(k)),C=N=U=k):(C=N=null,ct===null&&(B=!0)),V=ht,nt=z(V+w))}C!=null&&C!=N&&$!=V&&E(b,V,S(C),S(N),S(U),S(k))}else for(let z=w==1?s:r;z>=s&&z<=r;z+=w){let C=l[z];C===null?B=!0:C!=null&&v(b,y(a[z]),S(C))}let[P,O]=Wf(e,i);if(o.fill!=null||P!=0){let z=_.fill=new Path2D(b),C=o.fillTo(e,i,o.min,o.max,P),N=S(C),U=y(a[s]),k=y(a[r]);w==-1&&([k,U]=[U,k]),v(z,k,N),v(z,U,N)}if(!o.spanGaps){let z=[];B&&z.push(...Xf(a,l,s,r,w,y,t)),_.gaps=z=o.gaps(e,i,s,r,z),_.clip=uu(z,c.ori,f,g,x,p)}return O!=0&&(_.band=O==2?[Bs(e,i,s,r,b,-1),Bs(e,i,s,r,b,1)]:Bs(e,i,s,r,b,O)),_})}function _T(n){let t=Re(n.align,1),e=Re(n.ascDesc,!1),i=Re(n.alignGaps,0),s=Re(n.extend,!1);return(r,o,a,l)=>kr(r,o,(c,d,u,h,f,g,x,p,m,y,S)=>{[a,l]=au(u,a,l);let v=c.pxRound,{left:E,width:w}=r.bbox,_=X=>v(g(X,h,y,p)),b=X=>v(x(X,f,S,m)),B=h.ori==0?Yo:Zo,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:qo},P=I.stroke,O=h.dir*(h.ori==0?1:-1),z=b(u[O==1?a:l]),C=_(d[O==1?a:l]),N=C,U=C;s&&t==-1&&(U=E,B(P,U,z)),B(P,C,z);for(let X=O==1?a:l;X>=a&&X<=l;X+=O){let J=u[X];if(J==null)continue;let nt=_(d[X]),Q=b(J);t==1?B(P,nt,z):B(P,N,Q),B(P,nt,Q),z=Q,N=nt}let k=N;s&&t==1&&(k=E+w,B(P,k,z));let[$,V]=Wf(r,o);if(c.fill!=null||$!=0){let X=I.fill=new Path2D(P),J=c.fillTo(r,o,c.min,c.max,$),nt=b(J);B(X,k,nt),B(X,U,nt)}if(!c.spanGaps){let X=[];X.push(...Xf(d,u,a,l,O,_,i));let J=c.width*De/2,nt=e||t==1?J:-J,Q=e||t==-1?-J:J;X.forEach(W=>{W[0]+=nt,W[1]+=Q}),I.gaps=X=c.gaps(r,o,a,l,X),I.clip=uu(X,h.ori,p,m,y,S)}return V!=0&&(I.band=V==2?[Bs(r,o,a,l,P,-1),Bs(r,o,a,l,P,1)]:Bs(r,o,a,l,P,V)),I})}function O0(n,t,e,i,s,r,o=He){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let d=Cn(n[l]-n[a]);d<c&&(c=d,o=Cn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function xT(n){n=n||ml;let t=Re(n.size,[.6,He,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Re(t[1],He),l=Re(t[2],1),c=Re(n.disp,ml),d=Re(n.each,f=>{}),{fill:u,stroke:h}=c;return(f,g,x,p)=>kr(f,g,(m,y,S,v,E,w,_,b,B,I,P)=>{let O=m.pxRound,z=e,C=i*De,N=a*De,U=l*De,k,$;v.ori==0?[k,$]=r(f,g):[$,k]=r(f,g);let V=v.dir*(v.ori==0?1:-1),X=v.ori==0?pu:qf,J=v.ori==0?d:(Ct,Zt,ae,Tt,Ve,Xt,jt)=>{d(Ct,Zt,ae,Ve,Tt,jt,Xt)},nt=Re(f.bands,kf).find(Ct=>Ct.series[0]==g),Q=nt!=null?nt.dir:0,W=m.fillTo(f,g,m.min,m.max,Q),st=O(_(W,E,P,B)),ht,ct,gt,xt=I,Ut=O(m.width*De),Lt=!1,Qt=null,te=null,qt=null,ke=null;u!=null&&(Ut==0||h!=null)&&(Lt=!0,Qt=u.values(f,g,x,p),te=new Map,new Set(Qt).forEach(Ct=>{Ct!=null&&te.set(Ct,new Path2D)}),Ut>0&&(qt=h.values(f,g,x,p),ke=new Map,new Set(qt).forEach(Ct=>{Ct!=null&&ke.set(Ct,new Path2D)})));let{x0:oe,size:Ce}=c;if(oe!=null&&Ce!=null){z=1,y=oe.values(f,g,x,p),oe.unit==2&&(y=y.map(ae=>f.posToVal(b+ae*I,v.key,!0)));let Ct=Ce.values(f,g,x,p);Ce.unit==2?ct=Ct[0]*I:ct=w(Ct[0],v,I,b)-w(0,v,I,b),xt=O0(y,S,w,v,I,b,xt),gt=xt-ct+C}else xt=O0(y,S,w,v,I,b,xt),gt=xt*o+C,ct=xt-gt;gt<1&&(gt=0),Ut>=ct/2&&(Ut=0),gt<5&&(O=q0);let Pe=gt>0,mn=xt-gt-(Pe?Ut:0);ct=O(Af(mn,U,N)),ht=(z==0?ct/2:z==V?0:ct)-z*V*((z==0?C/2:0)+(Pe?Ut/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},hn=Lt?null:new Path2D,Qe=null;if(nt!=null)Qe=f.data[nt.series[1]];else{let{y0:Ct,y1:Zt}=c;Ct!=null&&Zt!=null&&(S=Zt.values(f,g,x,p),Qe=Ct.values(f,g,x,p))}let sn=k*ct,G=$*ct;for(let Ct=V==1?x:p;Ct>=x&&Ct<=p;Ct+=V){let Zt=S[Ct];if(Zt==null)continue;if(Qe!=null){let j=Qe[Ct]??0;if(Zt-j==0)continue;st=_(j,E,P,B)}let ae=v.distr!=2||c!=null?y[Ct]:Ct,Tt=w(ae,v,I,b),Ve=_(Re(Zt,W),E,P,B),Xt=O(Tt-ht),jt=O(ai(Ve,st)),L=O(Ji(Ve,st)),T=jt-L;if(Zt!=null){let j=Zt<0?G:sn,mt=Zt<0?sn:G;Lt?(Ut>0&&qt[Ct]!=null&&X(ke.get(qt[Ct]),Xt,L+bi(Ut/2),ct,ai(0,T-Ut),j,mt),Qt[Ct]!=null&&X(te.get(Qt[Ct]),Xt,L+bi(Ut/2),ct,ai(0,T-Ut),j,mt)):X(hn,Xt,L+bi(Ut/2),ct,ai(0,T-Ut),j,mt),J(f,g,Ct,Xt-Ut/2,L,ct+Ut,T)}}return Ut>0?ve.stroke=Lt?ke:hn:Lt||(ve._fill=m.width==0?m._fill:m._stroke??m._fill,ve.width=0),ve.fill=Lt?te:hn,ve})}function yT(n,t){let e=Re(t?.alignGaps,0);return(i,s,r,o)=>kr(i,s,(a,l,c,d,u,h,f,g,x,p,m)=>{[r,o]=au(c,r,o);let y=a.pxRound,S=k=>y(h(k,d,p,g)),v=k=>y(f(k,u,m,x)),E,w,_;d.ori==0?(E=du,_=Yo,w=y_):(E=fu,_=Zo,w=v_);let b=d.dir*(d.ori==0?1:-1),B=S(l[b==1?r:o]),I=B,P=[],O=[];for(let k=b==1?r:o;k>=r&&k<=o;k+=b)if(c[k]!=null){let V=l[k],X=S(V);P.push(I=X),O.push(v(c[k]))}let z={stroke:n(P,O,E,_,w,y),fill:null,clip:null,band:null,gaps:null,flags:qo},C=z.stroke,[N,U]=Wf(i,s);if(a.fill!=null||N!=0){let k=z.fill=new Path2D(C),$=a.fillTo(i,s,a.min,a.max,N),V=v($);_(k,I,V),_(k,B,V)}if(!a.spanGaps){let k=[];k.push(...Xf(l,c,r,o,b,S,e)),z.gaps=k=a.gaps(i,s,r,o,k),z.clip=uu(k,d.ori,g,x,p,m)}return U!=0&&(z.band=U==2?[Bs(i,s,r,o,C,-1),Bs(i,s,r,o,C,1)]:Bs(i,s,r,o,C,U)),z})}function vT(n){return yT(MT,n)}function MT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),d=Array(o-1),u=Array(o-1);for(let h=0;h<o-1;h++)d[h]=t[h+1]-t[h],u[h]=n[h+1]-n[h],c[h]=d[h]/u[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(u[h-1]+u[h])/((2*u[h]+u[h-1])/c[h-1]+(u[h]+2*u[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+u[h]/3,t[h]+l[h]*u[h]/3,n[h+1]-u[h]/3,t[h+1]-l[h+1]*u[h]/3,n[h+1],t[h+1])}return a}var If=new Set;function B0(){for(let n of If)n.syncRect(!0)}$o&&(Or(e1,Go,B0),Or(n1,Go,B0,!0),Or(su,Go,()=>{cn.pxRatio=De}));var ST=b_(),bT=M_();function k0(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Lf(r,o,t,e))}function wT(n,t){return n.map((e,i)=>i==0?{}:Sn({},t,e))}function Lf(n,t,e,i){return Sn({},t==0?e:i,n)}function w_(n,t,e){return t==null?Wo:[t,e]}var TT=w_;function ET(n,t,e){return t==null?Wo:ru(t,e,Of,!0)}function T_(n,t,e,i){return t==null?Wo:lu(t,e,n.scales[i].log,!1)}var AT=T_;function E_(n,t,e,i){return t==null?Wo:Ff(t,e,n.scales[i].log,!1)}var RT=E_;function CT(n,t,e,i,s){let r=ai(_0(n),_0(t)),o=t-n,a=Zi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?pr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function z0(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Rn((e=+s)*De))+"px"),[n,t,e]}function PT(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=We(t[2]*De,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function cn(n,t,e){let i={mode:Re(n.mode,1)},s=i.mode;function r(M,A,D,F){let Y=A.valToPct(M);return F+D*(A.dir==-1?1-Y:Y)}function o(M,A,D,F){let Y=A.valToPct(M);return F+D*(A.dir==-1?Y:1-Y)}function a(M,A,D,F){return A.ori==0?r(M,A,D,F):o(M,A,D,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Li(Ow);if(n.id!=null&&(c.id=n.id),Si(c,n.class),n.title){let M=Li(zw,c);M.textContent=n.title}let d=Yi("canvas"),u=i.ctx=d.getContext("2d"),h=Li(Vw,c);Or("click",h,M=>{M.target===g&&($e!=Yr||tn!=Zr)&&Bn.click(i,M)},!0);let f=i.under=Li(Gw,h);h.appendChild(d);let g=i.over=Li(Hw,h);n=Xo(n);let x=+Re(n.pxAlign,1),p=F0(x);(n.plugins||[]).forEach(M=>{M.opts&&(n=M.opts(i,n)||n)});let m=n.ms||.001,y=i.series=s==1?k0(n.series||[],C0,N0,!1):wT(n.series||[null],D0),S=i.axes=k0(n.axes||[],R0,I0,!0),v=i.scales={},E=i.bands=n.bands||[];E.forEach(M=>{M.fill=be(M.fill||null),M.dir=Re(M.dir,-1)});let w=s==2?y[1].facets[0].scale:y[0].scale,_={axes:xs,series:_e},b=(n.drawOrder||["axes","series"]).map(M=>_[M]);function B(M){let A=M.distr==3?D=>Os(D>0?D:M.clamp(i,D,M.min,M.max,M.key)):M.distr==4?D=>yf(D,M.asinh):M.distr==100?D=>M.fwd(D):D=>D;return D=>{let F=A(D),{_min:Y,_max:it}=M,ft=it-Y;return(F-Y)/ft}}function I(M){let A=v[M];if(A==null){let D=(n.scales||ml)[M]||ml;if(D.from!=null){I(D.from);let F=Sn({},v[D.from],D,{key:M});F.valToPct=B(F),v[M]=F}else{A=v[M]=Sn({},M==w?p_:dT,D),A.key=M;let F=A.time,Y=A.range,it=fr(Y);if((M!=w||s==2&&!F)&&(it&&(Y[0]==null||Y[1]==null)&&(Y={min:Y[0]==null?p0:{mode:1,hard:Y[0],soft:Y[0]},max:Y[1]==null?p0:{mode:1,hard:Y[1],soft:Y[1]}},it=!1),!it&&hu(Y))){let ft=Y;Y=(_t,bt,Ot)=>bt==null?Wo:ru(bt,Ot,ft)}A.range=be(Y||(F?TT:M==w?A.distr==3?AT:A.distr==4?RT:w_:A.distr==3?T_:A.distr==4?E_:ET)),A.auto=be(it?!1:A.auto),A.clamp=be(A.clamp||uT),A._min=A._max=null,A.valToPct=B(A)}}}I("x"),I("y"),s==1&&y.forEach(M=>{I(M.scale)}),S.forEach(M=>{I(M.scale)});for(let M in n.scales)I(M);let P=v[w],O=P.distr,z,C;P.ori==0?(Si(c,Bw),z=r,C=o):(Si(c,kw),z=o,C=r);let N={};for(let M in v){let A=v[M];(A.min!=null||A.max!=null)&&(N[M]={min:A.min,max:A.max},A.min=A.max=null)}let U=n.tzDate||(M=>new Date(Rn(M/m))),k=n.fmtDate||zf,$=m==1?B1(U):V1(U),V=T0(U,w0(m==1?O1:z1,k)),X=A0(U,E0(H1,k)),J=[],nt=i.legend=Sn({},q1,n.legend),Q=i.cursor=Sn({},j1,{drag:{y:s==2}},n.cursor),W=nt.show,st=Q.show,ht=nt.markers;nt.idxs=J,ht.width=be(ht.width),ht.dash=be(ht.dash),ht.stroke=be(ht.stroke),ht.fill=be(ht.fill);let ct,gt,xt,Ut=[],Lt=[],Qt,te=!1,qt={};if(nt.live){let M=y[1]?y[1].values:null;te=M!=null,Qt=te?M(i,1,0):{_:0};for(let A in Qt)qt[A]=Nf}if(W)if(ct=Yi("table",Zw,c),xt=Yi("tbody",null,ct),nt.mount(i,ct),te){gt=Yi("thead",null,ct,xt);let M=Yi("tr",null,gt);Yi("th",null,M);for(var ke in Qt)Yi("th",e0,M).textContent=ke}else Si(ct,Kw),nt.live&&Si(ct,Jw);let oe={show:!0},Ce={show:!1};function Pe(M,A){if(A==0&&(te||!nt.live||s==2))return Wo;let D=[],F=Yi("tr",jw,xt,xt.childNodes[A]);Si(F,M.class),M.show||Si(F,Fr);let Y=Yi("th",null,F);if(ht.show){let _t=Li(Qw,Y);if(A>0){let bt=ht.width(i,A);bt&&(_t.style.border=bt+"px "+ht.dash(i,A)+" "+ht.stroke(i,A)),_t.style.background=ht.fill(i,A)}}let it=Li(e0,Y);M.label instanceof HTMLElement?it.appendChild(M.label):it.textContent=M.label,A>0&&(ht.show||(it.style.color=M.width>0?ht.stroke(i,A):ht.fill(i,A)),ve("click",Y,_t=>{if(Q._lock)return;ie(_t);let bt=y.indexOf(M);if((_t.ctrlKey||_t.metaKey)!=nt.isolate){let Ot=y.some((kt,Vt)=>Vt>0&&Vt!=bt&&kt.show);y.forEach((kt,Vt)=>{Vt>0&&ts(Vt,Ot?Vt==bt?oe:Ce:oe,!0,yn.setSeries)})}else ts(bt,{show:!M.show},!0,yn.setSeries)},!1),se&&ve(r0,Y,_t=>{Q._lock||(ie(_t),ts(y.indexOf(M),Kr,!0,yn.setSeries))},!1));for(var ft in Qt){let _t=Yi("td",t1,F);_t.textContent="--",D.push(_t)}return[F,D]}let mn=new Map;function ve(M,A,D,F=!0){let Y=mn.get(A)||{},it=Q.bind[M](i,A,D,F);it&&(Or(M,A,Y[M]=it),mn.set(A,Y))}function hn(M,A,D){let F=mn.get(A)||{};for(let Y in F)(M==null||Y==M)&&(Ef(Y,A,F[Y]),delete F[Y]);M==null&&mn.delete(A)}let Qe=0,sn=0,G=0,Ct=0,Zt=0,ae=0,Tt=Zt,Ve=ae,Xt=G,jt=Ct,L=0,T=0,j=0,mt=0;i.bbox={};let dt=!1,Mt=!1,St=!1,ot=!1,lt=!1,yt=!1;function H(M,A,D){(D||M!=i.width||A!=i.height)&&ut(M,A),pe(!1),St=!0,Mt=!0,Gn()}function ut(M,A){i.width=Qe=G=M,i.height=sn=Ct=A,Zt=ae=0,wt(),$t();let D=i.bbox;L=D.left=Nr(Zt*De,.5),T=D.top=Nr(ae*De,.5),j=D.width=Nr(G*De,.5),mt=D.height=Nr(Ct*De,.5)}let at=3;function Et(){let M=!1,A=0;for(;!M;){A++;let D=Xr(A),F=Qi(A);M=A==at||D&&F,M||(ut(i.width,i.height),Mt=!0)}}function vt({width:M,height:A}){H(M,A)}i.setSize=vt;function wt(){let M=!1,A=!1,D=!1,F=!1;S.forEach((Y,it)=>{if(Y.show&&Y._show){let{side:ft,_size:_t}=Y,bt=ft%2,Ot=Y.label!=null?Y.labelSize:0,kt=_t+Ot;kt>0&&(bt?(G-=kt,ft==3?(Zt+=kt,F=!0):D=!0):(Ct-=kt,ft==0?(ae+=kt,M=!0):A=!0))}}),Ki[0]=M,Ki[1]=D,Ki[2]=A,Ki[3]=F,G-=Fi[1]+Fi[3],Zt+=Fi[3],Ct-=Fi[2]+Fi[0],ae+=Fi[0]}function $t(){let M=Zt+G,A=ae+Ct,D=Zt,F=ae;function Y(it,ft){switch(it){case 1:return M+=ft,M-ft;case 2:return A+=ft,A-ft;case 3:return D-=ft,D+ft;case 0:return F-=ft,F+ft}}S.forEach((it,ft)=>{if(it.show&&it._show){let _t=it.side;it._pos=Y(_t,it._size),it.label!=null&&(it._lpos=Y(_t,it.labelSize))}})}if(Q.dataIdx==null){let M=Q.hover,A=M.skip=new Set(M.skip??[]);A.add(void 0);let D=M.prox=be(M.prox),F=M.bias??=0;Q.dataIdx=(Y,it,ft,_t)=>{if(it==0)return ft;let bt=ft,Ot=D(Y,it,ft,_t)??He,kt=Ot>=0&&Ot<He,Vt=P.ori==0?G:Ct,ue=Q.left,Ie=t[0],Ae=t[it];if(A.has(Ae[ft])){bt=null;let ye=null,ne=null,Yt;if(F==0||F==-1)for(Yt=ft;ye==null&&Yt-- >0;)A.has(Ae[Yt])||(ye=Yt);if(F==0||F==1)for(Yt=ft;ne==null&&Yt++<Ae.length;)A.has(Ae[Yt])||(ne=Yt);if(ye!=null||ne!=null)if(kt){let Ze=ye==null?-1/0:z(Ie[ye],P,Vt,0),an=ne==null?1/0:z(Ie[ne],P,Vt,0),Dn=ue-Ze,ze=an-ue;Dn<=ze?Dn<=Ot&&(bt=ye):ze<=Ot&&(bt=ne)}else bt=ne==null?ye:ye==null?ne:ft-ye<=ne-ft?ye:ne}else kt&&Cn(ue-z(Ie[ft],P,Vt,0))>Ot&&(bt=null);return bt}}let ie=M=>{Q.event=M};Q.idxs=J,Q._lock=!1;let pt=Q.points;pt.show=be(pt.show),pt.size=be(pt.size),pt.stroke=be(pt.stroke),pt.width=be(pt.width),pt.fill=be(pt.fill);let Gt=i.focus=Sn({},n.focus||{alpha:.3},Q.focus),se=Gt.prox>=0,Pt=se&&pt.one,de=[],qe=[],Zn=[];function na(M,A){let D=pt.show(i,A);if(D instanceof HTMLElement)return Si(D,Yw),Si(D,M.class),ps(D,-10,-10,G,Ct),g.insertBefore(D,de[A]),D}function Gr(M,A){if(s==1||A>0){let D=s==1&&v[M.scale].time,F=M.value;M.value=D?v0(F)?A0(U,E0(F,k)):F||X:F||lT,M.label=M.label||(D?tT:Q1)}if(Pt||A>0){M.width=M.width==null?1:M.width,M.paths=M.paths||ST||d1,M.fillTo=be(M.fillTo||fT),M.pxAlign=+Re(M.pxAlign,x),M.pxRound=F0(M.pxAlign),M.stroke=be(M.stroke||null),M.fill=be(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let D=cT(ai(1,M.width),1),F=M.points=Sn({},{size:D,width:ai(1,D*.2),stroke:M.stroke,space:D*2,paths:bT,_stroke:null,_fill:null},M.points);F.show=be(F.show),F.filter=be(F.filter),F.fill=be(F.fill),F.stroke=be(F.stroke),F.paths=be(F.paths),F.pxAlign=M.pxAlign}if(W){let D=Pe(M,A);Ut.splice(A,0,D[0]),Lt.splice(A,0,D[1]),nt.values.push(null)}if(st){J.splice(A,0,null);let D=null;Pt?A==0&&(D=na(M,A)):A>0&&(D=na(M,A)),de.splice(A,0,D),qe.splice(A,0,0),Zn.splice(A,0,0)}Ln("addSeries",A)}function bu(M,A){A=A??y.length,M=s==1?Lf(M,A,C0,N0):Lf(M,A,{},D0),y.splice(A,0,M),Gr(y[A],A)}i.addSeries=bu;function bl(M){if(y.splice(M,1),W){nt.values.splice(M,1),Lt.splice(M,1);let A=Ut.splice(M,1)[0];hn(null,A.firstChild),A.remove()}st&&(J.splice(M,1),de.splice(M,1)[0].remove(),qe.splice(M,1),Zn.splice(M,1)),Ln("delSeries",M)}i.delSeries=bl;let Ki=[!1,!1,!1,!1];function ms(M,A){if(M._show=M.show,M.show){let D=M.side%2,F=v[M.scale];F==null&&(M.scale=D?y[1].scale:w,F=v[M.scale]);let Y=F.time;M.size=be(M.size),M.space=be(M.space),M.rotate=be(M.rotate),fr(M.incrs)&&M.incrs.forEach(ft=>{!pr.has(ft)&&pr.set(ft,Z0(ft))}),M.incrs=be(M.incrs||(F.distr==2?N1:Y?m==1?F1:k1:Ur)),M.splits=be(M.splits||(Y&&F.distr==1?$:F.distr==3?Rf:F.distr==4?iT:nT)),M.stroke=be(M.stroke),M.grid.stroke=be(M.grid.stroke),M.ticks.stroke=be(M.ticks.stroke),M.border.stroke=be(M.border.stroke);let it=M.values;M.values=fr(it)&&!fr(it[0])?be(it):Y?fr(it)?T0(U,w0(it,k)):v0(it)?G1(U,it):it||V:it||eT,M.filter=be(M.filter||(F.distr>=3&&F.log==10?oT:F.distr==3&&F.log==2?aT:$0)),M.font=z0(M.font),M.labelFont=z0(M.labelFont),M._size=M.size(i,null,A,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(Ki[A]=!0,M._el=Li(Ww,h))}}function gs(M,A,D,F){let[Y,it,ft,_t]=D,bt=A%2,Ot=0;return bt==0&&(_t||it)&&(Ot=A==0&&!Y||A==2&&!ft?Rn(R0.size/3):0),bt==1&&(Y||ft)&&(Ot=A==1&&!it||A==3&&!_t?Rn(I0.size/2):0),Ot}let ia=i.padding=(n.padding||[gs,gs,gs,gs]).map(M=>be(Re(M,gs))),Fi=i._padding=ia.map((M,A)=>M(i,A,Ki,0)),rn,un=null,dn=null,ji=s==1?y[0].idxs:null,di=null,Xs=!1;function sa(M,A){if(t=M??[],i.data=i._data=t,s==2){rn=0;for(let D=1;D<y.length;D++)rn+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),di=t[0],rn=di.length;let D=t;if(O==2){D=t.slice();let F=D[0]=Array(rn);for(let Y=0;Y<rn;Y++)F[Y]=Y}i._data=t=D}if(pe(!0),Ln("setData"),O==2&&(St=!0),A!==!1){let D=P;D.auto(i,Xs)?ra():Ys(w,D.min,D.max),ot=ot||Q.left>=0,yt=!0,Gn()}}i.setData=sa;function ra(){Xs=!0;let M,A;s==1&&(rn>0?(un=ji[0]=0,dn=ji[1]=rn-1,M=t[0][un],A=t[0][dn],O==2?(M=un,A=dn):M==A&&(O==3?[M,A]=lu(M,M,P.log,!1):O==4?[M,A]=Ff(M,M,P.log,!1):P.time?A=M+Rn(86400/m):[M,A]=ru(M,A,Of,!0))):(un=ji[0]=M=null,dn=ji[1]=A=null)),Ys(w,M,A)}let Hr,qs,Wr,R,q,rt,tt,et,At,It;function Rt(M,A,D,F,Y,it){M??=i0,D??=kf,F??="butt",Y??=i0,it??="round",M!=Hr&&(u.strokeStyle=Hr=M),Y!=qs&&(u.fillStyle=qs=Y),A!=Wr&&(u.lineWidth=Wr=A),it!=q&&(u.lineJoin=q=it),F!=rt&&(u.lineCap=rt=F),D!=R&&u.setLineDash(R=D)}function Dt(M,A,D,F){A!=qs&&(u.fillStyle=qs=A),M!=tt&&(u.font=tt=M),D!=et&&(u.textAlign=et=D),F!=At&&(u.textBaseline=At=F)}function Wt(M,A,D,F,Y=0){if(F.length>0&&M.auto(i,Xs)&&(A==null||A.min==null)){let it=Re(un,0),ft=Re(dn,F.length-1),_t=D.min==null?o1(F,it,ft,Y,M.distr==3):[D.min,D.max];M.min=Ji(M.min,D.min=_t[0]),M.max=ai(M.max,D.max=_t[1])}}let le={min:null,max:null};function ge(){for(let F in v){let Y=v[F];N[F]==null&&(Y.min==null||N[w]!=null&&Y.auto(i,Xs))&&(N[F]=le)}for(let F in v){let Y=v[F];N[F]==null&&Y.from!=null&&N[Y.from]!=null&&(N[F]=le)}N[w]!=null&&pe(!0);let M={};for(let F in N){let Y=N[F];if(Y!=null){let it=M[F]=Xo(v[F],m1);if(Y.min!=null)Sn(it,Y);else if(F!=w||s==2)if(rn==0&&it.from==null){let ft=it.range(i,null,null,F);it.min=ft[0],it.max=ft[1]}else it.min=He,it.max=-He}}if(rn>0){y.forEach((F,Y)=>{if(s==1){let it=F.scale,ft=N[it];if(ft==null)return;let _t=M[it];if(Y==0){let bt=_t.range(i,_t.min,_t.max,it);_t.min=bt[0],_t.max=bt[1],un=Zi(_t.min,t[0]),dn=Zi(_t.max,t[0]),dn-un>1&&(t[0][un]<_t.min&&un++,t[0][dn]>_t.max&&dn--),F.min=di[un],F.max=di[dn]}else F.show&&F.auto&&Wt(_t,ft,F,t[Y],F.sorted);F.idxs[0]=un,F.idxs[1]=dn}else if(Y>0&&F.show&&F.auto){let[it,ft]=F.facets,_t=it.scale,bt=ft.scale,[Ot,kt]=t[Y],Vt=M[_t],ue=M[bt];Vt!=null&&Wt(Vt,N[_t],it,Ot,it.sorted),ue!=null&&Wt(ue,N[bt],ft,kt,ft.sorted),F.min=ft.min,F.max=ft.max}});for(let F in M){let Y=M[F],it=N[F];if(Y.from==null&&(it==null||it.min==null)){let ft=Y.range(i,Y.min==He?null:Y.min,Y.max==-He?null:Y.max,F);Y.min=ft[0],Y.max=ft[1]}}}for(let F in M){let Y=M[F];if(Y.from!=null){let it=M[Y.from];if(it.min==null)Y.min=Y.max=null;else{let ft=Y.range(i,it.min,it.max,F);Y.min=ft[0],Y.max=ft[1]}}}let A={},D=!1;for(let F in M){let Y=M[F],it=v[F];if(it.min!=Y.min||it.max!=Y.max){it.min=Y.min,it.max=Y.max;let ft=it.distr;it._min=ft==3?Os(it.min):ft==4?yf(it.min,it.asinh):ft==100?it.fwd(it.min):it.min,it._max=ft==3?Os(it.max):ft==4?yf(it.max,it.asinh):ft==100?it.fwd(it.max):it.max,A[F]=D=!0}}if(D){y.forEach((F,Y)=>{s==2?Y>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)St=!0,Ln("setScale",F);st&&Q.left>=0&&(ot=yt=!0)}for(let F in N)N[F]=null}function Ht(M){let A=Af(un-1,0,rn-1),D=Af(dn+1,0,rn-1);for(;M[A]==null&&A>0;)A--;for(;M[D]==null&&D<rn-1;)D++;return[A,D]}function _e(){if(rn>0){let M=y.some(A=>A._focus)&&It!=Gt.alpha;M&&(u.globalAlpha=It=Gt.alpha),y.forEach((A,D)=>{if(D>0&&A.show&&(nn(D,!1),nn(D,!0),A._paths==null)){let F=It;It!=A.alpha&&(u.globalAlpha=It=A.alpha);let Y=s==2?[0,t[D][0].length-1]:Ht(t[D]);A._paths=A.paths(i,D,Y[0],Y[1]),It!=F&&(u.globalAlpha=It=F)}}),y.forEach((A,D)=>{if(D>0&&A.show){let F=It;It!=A.alpha&&(u.globalAlpha=It=A.alpha),A._paths!=null&&Fe(D,!1);{let Y=A._paths!=null?A._paths.gaps:null,it=A.points.show(i,D,un,dn,Y),ft=A.points.filter(i,D,it,Y);(it||ft)&&(A.points._paths=A.points.paths(i,D,un,dn,ft),Fe(D,!0))}It!=F&&(u.globalAlpha=It=F),Ln("drawSeries",D)}}),M&&(u.globalAlpha=It=1)}}function nn(M,A){let D=A?y[M].points:y[M];D._stroke=D.stroke(i,M),D._fill=D.fill(i,M)}function Fe(M,A){let D=A?y[M].points:y[M],{stroke:F,fill:Y,clip:it,flags:ft,_stroke:_t=D._stroke,_fill:bt=D._fill,_width:Ot=D.width}=D._paths;Ot=We(Ot*De,3);let kt=null,Vt=Ot%2/2;A&&bt==null&&(bt=Ot>0?"#fff":_t);let ue=D.pxAlign==1&&Vt>0;if(ue&&u.translate(Vt,Vt),!A){let Ie=L-Ot/2,Ae=T-Ot/2,ye=j+Ot,ne=mt+Ot;kt=new Path2D,kt.rect(Ie,Ae,ye,ne)}A?zt(_t,Ot,D.dash,D.cap,bt,F,Y,ft,it):Oe(M,_t,Ot,D.dash,D.cap,bt,F,Y,ft,kt,it),ue&&u.translate(-Vt,-Vt)}function Oe(M,A,D,F,Y,it,ft,_t,bt,Ot,kt){let Vt=!1;bt!=0&&E.forEach((ue,Ie)=>{if(ue.series[0]==M){let Ae=y[ue.series[1]],ye=t[ue.series[1]],ne=(Ae._paths||ml).band;fr(ne)&&(ne=ue.dir==1?ne[0]:ne[1]);let Yt,Ze=null;Ae.show&&ne&&l1(ye,un,dn)?(Ze=ue.fill(i,Ie)||it,Yt=Ae._paths.clip):ne=null,zt(A,D,F,Y,Ze,ft,_t,bt,Ot,kt,Yt,ne),Vt=!0}}),Vt||zt(A,D,F,Y,it,ft,_t,bt,Ot,kt)}let bn=qo|Pf;function zt(M,A,D,F,Y,it,ft,_t,bt,Ot,kt,Vt){Rt(M,A,D,F,Y),(bt||Ot||Vt)&&(u.save(),bt&&u.clip(bt),Ot&&u.clip(Ot)),Vt?(_t&bn)==bn?(u.clip(Vt),kt&&u.clip(kt),Me(Y,ft),gn(M,it,A)):_t&Pf?(Me(Y,ft),u.clip(Vt),gn(M,it,A)):_t&qo&&(u.save(),u.clip(Vt),kt&&u.clip(kt),Me(Y,ft),u.restore(),gn(M,it,A)):(Me(Y,ft),gn(M,it,A)),(bt||Ot||Vt)&&u.restore()}function gn(M,A,D){D>0&&(A instanceof Map?A.forEach((F,Y)=>{u.strokeStyle=Hr=Y,u.stroke(F)}):A!=null&&M&&u.stroke(A))}function Me(M,A){A instanceof Map?A.forEach((D,F)=>{u.fillStyle=qs=F,u.fill(D)}):A!=null&&M&&u.fill(A)}function _s(M,A,D,F){let Y=S[M],it;if(F<=0)it=[0,0];else{let ft=Y._space=Y.space(i,M,A,D,F),_t=Y._incrs=Y.incrs(i,M,A,D,F,ft);it=CT(A,D,_t,F,ft)}return Y._found=it}function _n(M,A,D,F,Y,it,ft,_t,bt,Ot){let kt=ft%2/2;x==1&&u.translate(kt,kt),Rt(_t,ft,bt,Ot,_t),u.beginPath();let Vt,ue,Ie,Ae,ye=Y+(F==0||F==3?-it:it);D==0?(ue=Y,Ae=ye):(Vt=Y,Ie=ye);for(let ne=0;ne<M.length;ne++)A[ne]!=null&&(D==0?Vt=Ie=M[ne]:ue=Ae=M[ne],u.moveTo(Vt,ue),u.lineTo(Ie,Ae));u.stroke(),x==1&&u.translate(-kt,-kt)}function Xr(M){let A=!0;return S.forEach((D,F)=>{if(!D.show)return;let Y=v[D.scale];if(Y.min==null){D._show&&(A=!1,D._show=!1,pe(!1));return}else D._show||(A=!1,D._show=!0,pe(!1));let it=D.side,ft=it%2,{min:_t,max:bt}=Y,[Ot,kt]=_s(F,_t,bt,ft==0?G:Ct);if(kt==0)return;let Vt=Y.distr==2,ue=D._splits=D.splits(i,F,_t,bt,Ot,kt,Vt),Ie=Y.distr==2?ue.map(Yt=>di[Yt]):ue,Ae=Y.distr==2?di[ue[1]]-di[ue[0]]:Ot,ye=D._values=D.values(i,D.filter(i,Ie,F,kt,Ae),F,kt,Ae);D._rotate=it==2?D.rotate(i,ye,F,kt):0;let ne=D._size;D._size=Di(D.size(i,ye,F,M)),ne!=null&&D._size!=ne&&(A=!1)}),A}function Qi(M){let A=!0;return ia.forEach((D,F)=>{let Y=D(i,F,Ki,M);Y!=Fi[F]&&(A=!1),Fi[F]=Y}),A}function xs(){for(let M=0;M<S.length;M++){let A=S[M];if(!A.show||!A._show)continue;let D=A.side,F=D%2,Y,it,ft=A.stroke(i,M),_t=D==0||D==3?-1:1,[bt,Ot]=A._found;if(A.label!=null){let jn=A.labelGap*_t,mi=Rn((A._lpos+jn)*De);Dt(A.labelFont[0],ft,"center",D==2?"top":n0),u.save(),F==1?(Y=it=0,u.translate(mi,Rn(T+mt/2)),u.rotate((D==3?-iu:iu)/2)):(Y=Rn(L+j/2),it=mi);let _r=X0(A.label)?A.label(i,M,bt,Ot):A.label;u.fillText(_r,Y,it),u.restore()}if(Ot==0)continue;let kt=v[A.scale],Vt=F==0?j:mt,ue=F==0?L:T,Ie=A._splits,Ae=kt.distr==2?Ie.map(jn=>di[jn]):Ie,ye=kt.distr==2?di[Ie[1]]-di[Ie[0]]:bt,ne=A.ticks,Yt=A.border,Ze=ne.show?ne.size:0,an=Rn(Ze*De),Dn=Rn((A.alignTo==2?A._size-Ze-A.gap:A.gap)*De),ze=A._rotate*-iu/180,ln=p(A._pos*De),fi=(an+Dn)*_t,Kn=ln+fi;it=F==0?Kn:0,Y=F==1?Kn:0;let Ti=A.font[0],Oi=A.align==1?zo:A.align==2?gf:ze>0?zo:ze<0?gf:F==0?"center":D==3?gf:zo,ns=ze||F==1?"middle":D==2?"top":n0;Dt(Ti,ft,Oi,ns);let pi=A.font[1]*A.lineGap,Ei=Ie.map(jn=>p(a(jn,kt,Vt,ue))),Bi=A._values;for(let jn=0;jn<Bi.length;jn++){let mi=Bi[jn];if(mi!=null){F==0?Y=Ei[jn]:it=Ei[jn],mi=""+mi;let _r=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let Qn=0;Qn<_r.length;Qn++){let xp=_r[Qn];ze?(u.save(),u.translate(Y,it+Qn*pi),u.rotate(ze),u.fillText(xp,0,0),u.restore()):u.fillText(xp,Y,it+Qn*pi)}}}ne.show&&_n(Ei,ne.filter(i,Ae,M,Ot,ye),F,D,ln,an,We(ne.width*De,3),ne.stroke(i,M),ne.dash,ne.cap);let is=A.grid;is.show&&_n(Ei,is.filter(i,Ae,M,Ot,ye),F,F==0?2:1,F==0?T:L,F==0?mt:j,We(is.width*De,3),is.stroke(i,M),is.dash,is.cap),Yt.show&&_n([ln],[1],F==0?1:0,F==0?1:2,F==1?T:L,F==1?mt:j,We(Yt.width*De,3),Yt.stroke(i,M),Yt.dash,Yt.cap)}Ln("drawAxes")}function pe(M){y.forEach((A,D)=>{D>0&&(A._paths=null,M&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let on=!1,Jn=!1,Be=[];function xn(){Jn=!1;for(let M=0;M<Be.length;M++)Ln(...Be[M]);Be.length=0}function Gn(){on||(S1(tp),on=!0)}function wl(M,A=!1){on=!0,Jn=A,M(i),tp(),A&&Be.length>0&&queueMicrotask(xn)}i.batch=wl;function tp(){if(dt&&(ge(),dt=!1),St&&(Et(),St=!1),Mt){if(je(f,zo,Zt),je(f,"top",ae),je(f,ul,G),je(f,dl,Ct),je(g,zo,Zt),je(g,"top",ae),je(g,ul,G),je(g,dl,Ct),je(h,ul,Qe),je(h,dl,sn),d.width=Rn(Qe*De),d.height=Rn(sn*De),S.forEach(({_el:M,_show:A,_size:D,_pos:F,side:Y})=>{if(M!=null)if(A){let it=Y===3||Y===0?D:0,ft=Y%2==1;je(M,ft?"left":"top",F-it),je(M,ft?"width":"height",D),je(M,ft?"top":"left",ft?ae:Zt),je(M,ft?"height":"width",ft?Ct:G),Tf(M,Fr)}else Si(M,Fr)}),Hr=qs=Wr=q=rt=tt=et=At=R=null,It=1,la(!0),Zt!=Tt||ae!=Ve||G!=Xt||Ct!=jt){pe(!1);let M=G/Xt,A=Ct/jt;if(st&&!ot&&Q.left>=0){Q.left*=M,Q.top*=A,qr&&ps(qr,Rn(Q.left),0,G,Ct),$r&&ps($r,0,Rn(Q.top),G,Ct);for(let D=0;D<de.length;D++){let F=de[D];F!=null&&(qe[D]*=M,Zn[D]*=A,ps(F,Di(qe[D]),Di(Zn[D]),G,Ct))}}if(Ye.show&&!lt&&Ye.left>=0&&Ye.width>0){Ye.left*=M,Ye.width*=M,Ye.top*=A,Ye.height*=A;for(let D in Cu)je(Jr,D,Ye[D])}Tt=Zt,Ve=ae,Xt=G,jt=Ct}Ln("setSize"),Mt=!1}Qe>0&&sn>0&&(u.clearRect(0,0,d.width,d.height),Ln("drawClear"),b.forEach(M=>M()),Ln("draw")),Ye.show&&lt&&(Tl(Ye),lt=!1),st&&ot&&(gr(null,!0,!1),ot=!1),nt.show&&nt.live&&yt&&(Au(),yt=!1),l||(l=!0,i.status=1,Ln("ready")),Xs=!1,on=!1}i.redraw=(M,A)=>{St=A||!1,M!==!1?Ys(w,P.min,P.max):Gn()};function wu(M,A){let D=v[M];if(D.from==null){if(rn==0){let F=D.range(i,A.min,A.max,M);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(rn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;M==w&&D.distr==2&&rn>0&&(A.min=Zi(A.min,t[0]),A.max=Zi(A.max,t[0]),A.min==A.max&&A.max++),N[M]=A,dt=!0,Gn()}}i.setScale=wu;let Tu,Eu,qr,$r,ep,np,Yr,Zr,ip,sp,$e,tn,$s=!1,Bn=Q.drag,Pn=Bn.x,In=Bn.y;st&&(Q.x&&(Tu=Li(qw,g)),Q.y&&(Eu=Li($w,g)),P.ori==0?(qr=Tu,$r=Eu):(qr=Eu,$r=Tu),$e=Q.left,tn=Q.top);let Ye=i.select=Sn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Jr=Ye.show?Li(Xw,Ye.over?g:f):null;function Tl(M,A){if(Ye.show){for(let D in M)Ye[D]=M[D],D in Cu&&je(Jr,D,M[D]);A!==!1&&Ln("setSelect")}}i.setSelect=Tl;function j_(M){if(y[M].show)W&&Tf(Ut[M],Fr);else if(W&&Si(Ut[M],Fr),st){let D=Pt?de[0]:de[M];D!=null&&ps(D,-10,-10,G,Ct)}}function Ys(M,A,D){wu(M,{min:A,max:D})}function ts(M,A,D,F){A.focus!=null&&ix(M),A.show!=null&&y.forEach((Y,it)=>{it>0&&(M==it||M==null)&&(Y.show=A.show,j_(it),s==2?(Ys(Y.facets[0].scale,null,null),Ys(Y.facets[1].scale,null,null)):Ys(Y.scale,null,null),Gn())}),D!==!1&&Ln("setSeries",M,A),F&&ca("setSeries",i,M,A)}i.setSeries=ts;function Q_(M,A){Sn(E[M],A)}function tx(M,A){M.fill=be(M.fill||null),M.dir=Re(M.dir,-1),A=A??E.length,E.splice(A,0,M)}function ex(M){M==null?E.length=0:E.splice(M,1)}i.addBand=tx,i.setBand=Q_,i.delBand=ex;function nx(M,A){y[M].alpha=A,st&&de[M]!=null&&(de[M].style.opacity=A),W&&Ut[M]&&(Ut[M].style.opacity=A)}let ys,Zs,mr,Kr={focus:!0};function ix(M){if(M!=mr){let A=M==null,D=Gt.alpha!=1;y.forEach((F,Y)=>{if(s==1||Y>0){let it=A||Y==0||Y==M;F._focus=A?null:it,D&&nx(Y,it?1:Gt.alpha)}}),mr=M,D&&Gn()}}W&&se&&ve(o0,ct,M=>{Q._lock||(ie(M),mr!=null&&ts(null,Kr,!0,yn.setSeries))});function es(M,A,D){let F=v[A];D&&(M=M/De-(F.ori==1?ae:Zt));let Y=G;F.ori==1&&(Y=Ct,M=Y-M),F.dir==-1&&(M=Y-M);let it=F._min,ft=F._max,_t=M/Y,bt=it+(ft-it)*_t,Ot=F.distr;return Ot==3?Ho(10,bt):Ot==4?h1(bt,F.asinh):Ot==100?F.bwd(bt):bt}function sx(M,A){let D=es(M,w,A);return Zi(D,t[0],un,dn)}i.valToIdx=M=>Zi(M,t[0]),i.posToIdx=sx,i.posToVal=es,i.valToPos=(M,A,D)=>v[A].ori==0?r(M,v[A],D?j:G,D?L:0):o(M,v[A],D?mt:Ct,D?T:0),i.setCursor=(M,A,D)=>{$e=M.left,tn=M.top,gr(null,A,D)};function rp(M,A){je(Jr,zo,Ye.left=M),je(Jr,ul,Ye.width=A)}function op(M,A){je(Jr,"top",Ye.top=M),je(Jr,dl,Ye.height=A)}let oa=P.ori==0?rp:op,aa=P.ori==1?rp:op;function rx(){if(W&&nt.live)for(let M=s==2?1:0;M<y.length;M++){if(M==0&&te)continue;let A=nt.values[M],D=0;for(let F in A)Lt[M][D++].firstChild.nodeValue=A[F]}}function Au(M,A){if(M!=null&&(M.idxs?M.idxs.forEach((D,F)=>{J[F]=D}):p1(M.idx)||J.fill(M.idx),nt.idx=J[0]),W&&nt.live){for(let D=0;D<y.length;D++)(D>0||s==1&&!te)&&ox(D,J[D]);rx()}yt=!1,A!==!1&&Ln("setLegend")}i.setLegend=Au;function ox(M,A){let D=y[M],F=M==0&&O==2?di:t[M],Y;te?Y=D.values(i,M,A)??qt:(Y=D.value(i,A==null?null:F[A],M,A),Y=Y==null?qt:{_:Y}),nt.values[M]=Y}function gr(M,A,D){ip=$e,sp=tn,[$e,tn]=Q.move(i,$e,tn),Q.left=$e,Q.top=tn,st&&(qr&&ps(qr,Rn($e),0,G,Ct),$r&&ps($r,0,Rn(tn),G,Ct));let F,Y=un>dn;ys=He,Zs=null;let it=P.ori==0?G:Ct,ft=P.ori==1?G:Ct;if($e<0||rn==0||Y){F=Q.idx=null;for(let _t=0;_t<y.length;_t++){let bt=de[_t];bt!=null&&ps(bt,-10,-10,G,Ct)}se&&ts(null,Kr,!0,M==null&&yn.setSeries),nt.live&&(J.fill(F),yt=!0)}else{let _t,bt,Ot;s==1&&(_t=P.ori==0?$e:tn,bt=es(_t,w),F=Q.idx=Zi(bt,t[0],un,dn),Ot=z(t[0][F],P,it,0));let kt=-10,Vt=-10,ue=0,Ie=0,Ae=!0,ye="",ne="";for(let Yt=s==2?1:0;Yt<y.length;Yt++){let Ze=y[Yt],an=J[Yt],Dn=an==null?null:s==1?t[Yt][an]:t[Yt][1][an],ze=Q.dataIdx(i,Yt,F,bt),ln=ze==null?null:s==1?t[Yt][ze]:t[Yt][1][ze];if(yt=yt||ln!=Dn||ze!=an,J[Yt]=ze,Yt>0&&Ze.show){let fi=ze==null?-10:ze==F?Ot:z(s==1?t[0][ze]:t[Yt][0][ze],P,it,0),Kn=ln==null?-10:C(ln,s==1?v[Ze.scale]:v[Ze.facets[1].scale],ft,0);if(se&&ln!=null){let Ti=P.ori==1?$e:tn,Oi=Cn(Gt.dist(i,Yt,ze,Kn,Ti));if(Oi<ys){let ns=Gt.bias;if(ns!=0){let pi=es(Ti,Ze.scale),Ei=ln>=0?1:-1,Bi=pi>=0?1:-1;Bi==Ei&&(Bi==1?ns==1?ln>=pi:ln<=pi:ns==1?ln<=pi:ln>=pi)&&(ys=Oi,Zs=Yt)}else ys=Oi,Zs=Yt}}if(yt||Pt){let Ti,Oi;P.ori==0?(Ti=fi,Oi=Kn):(Ti=Kn,Oi=fi);let ns,pi,Ei,Bi,is,jn,mi=!0,_r=pt.bbox;if(_r!=null){mi=!1;let Qn=_r(i,Yt);Ei=Qn.left,Bi=Qn.top,ns=Qn.width,pi=Qn.height}else Ei=Ti,Bi=Oi,ns=pi=pt.size(i,Yt);if(jn=pt.fill(i,Yt),is=pt.stroke(i,Yt),Pt)Yt==Zs&&ys<=Gt.prox&&(kt=Ei,Vt=Bi,ue=ns,Ie=pi,Ae=mi,ye=jn,ne=is);else{let Qn=de[Yt];Qn!=null&&(qe[Yt]=Ei,Zn[Yt]=Bi,f0(Qn,ns,pi,mi),u0(Qn,jn,is),ps(Qn,Di(Ei),Di(Bi),G,Ct))}}}}if(Pt){let Yt=Gt.prox,Ze=mr==null?ys<=Yt:ys>Yt||Zs!=mr;if(yt||Ze){let an=de[0];an!=null&&(qe[0]=kt,Zn[0]=Vt,f0(an,ue,Ie,Ae),u0(an,ye,ne),ps(an,Di(kt),Di(Vt),G,Ct))}}}if(Ye.show&&$s)if(M!=null){let[_t,bt]=yn.scales,[Ot,kt]=yn.match,[Vt,ue]=M.cursor.sync.scales,Ie=M.cursor.drag;if(Pn=Ie._x,In=Ie._y,Pn||In){let{left:Ae,top:ye,width:ne,height:Yt}=M.select,Ze=M.scales[Vt].ori,an=M.posToVal,Dn,ze,ln,fi,Kn,Ti=_t!=null&&Ot(_t,Vt),Oi=bt!=null&&kt(bt,ue);Ti&&Pn?(Ze==0?(Dn=Ae,ze=ne):(Dn=ye,ze=Yt),ln=v[_t],fi=z(an(Dn,Vt),ln,it,0),Kn=z(an(Dn+ze,Vt),ln,it,0),oa(Ji(fi,Kn),Cn(Kn-fi))):oa(0,it),Oi&&In?(Ze==1?(Dn=Ae,ze=ne):(Dn=ye,ze=Yt),ln=v[bt],fi=C(an(Dn,ue),ln,ft,0),Kn=C(an(Dn+ze,ue),ln,ft,0),aa(Ji(fi,Kn),Cn(Kn-fi))):aa(0,ft)}else Pu()}else{let _t=Cn(ip-ep),bt=Cn(sp-np);if(P.ori==1){let ue=_t;_t=bt,bt=ue}Pn=Bn.x&&_t>=Bn.dist,In=Bn.y&&bt>=Bn.dist;let Ot=Bn.uni;Ot!=null?Pn&&In&&(Pn=_t>=Ot,In=bt>=Ot,!Pn&&!In&&(bt>_t?In=!0:Pn=!0)):Bn.x&&Bn.y&&(Pn||In)&&(Pn=In=!0);let kt,Vt;Pn&&(P.ori==0?(kt=Yr,Vt=$e):(kt=Zr,Vt=tn),oa(Ji(kt,Vt),Cn(Vt-kt)),In||aa(0,ft)),In&&(P.ori==1?(kt=Yr,Vt=$e):(kt=Zr,Vt=tn),aa(Ji(kt,Vt),Cn(Vt-kt)),Pn||oa(0,it)),!Pn&&!In&&(oa(0,0),aa(0,0))}if(Bn._x=Pn,Bn._y=In,M==null){if(D){if(_p!=null){let[_t,bt]=yn.scales;yn.values[0]=_t!=null?es(P.ori==0?$e:tn,_t):null,yn.values[1]=bt!=null?es(P.ori==1?$e:tn,bt):null}ca(_f,i,$e,tn,G,Ct,F)}if(se){let _t=D&&yn.setSeries,bt=Gt.prox;mr==null?ys<=bt&&ts(Zs,Kr,!0,_t):ys>bt?ts(null,Kr,!0,_t):Zs!=mr&&ts(Zs,Kr,!0,_t)}}yt&&(nt.idx=F,Au()),A!==!1&&Ln("setCursor")}let Js=null;Object.defineProperty(i,"rect",{get(){return Js==null&&la(!1),Js}});function la(M=!1){M?Js=null:(Js=g.getBoundingClientRect(),Ln("syncRect",Js))}function ap(M,A,D,F,Y,it,ft){Q._lock||$s&&M!=null&&M.movementX==0&&M.movementY==0||(Ru(M,A,D,F,Y,it,ft,!1,M!=null),M!=null?gr(null,!0,!0):gr(A,!0,!1))}function Ru(M,A,D,F,Y,it,ft,_t,bt){if(Js==null&&la(!1),ie(M),M!=null)D=M.clientX-Js.left,F=M.clientY-Js.top;else{if(D<0||F<0){$e=-10,tn=-10;return}let[Ot,kt]=yn.scales,Vt=A.cursor.sync,[ue,Ie]=Vt.values,[Ae,ye]=Vt.scales,[ne,Yt]=yn.match,Ze=A.axes[0].side%2==1,an=P.ori==0?G:Ct,Dn=P.ori==1?G:Ct,ze=Ze?it:Y,ln=Ze?Y:it,fi=Ze?F:D,Kn=Ze?D:F;if(Ae!=null?D=ne(Ot,Ae)?a(ue,v[Ot],an,0):-10:D=an*(fi/ze),ye!=null?F=Yt(kt,ye)?a(Ie,v[kt],Dn,0):-10:F=Dn*(Kn/ln),P.ori==1){let Ti=D;D=F,F=Ti}}bt&&(A==null||A.cursor.event.type==_f)&&((D<=1||D>=G-1)&&(D=Nr(D,G)),(F<=1||F>=Ct-1)&&(F=Nr(F,Ct))),_t?(ep=D,np=F,[Yr,Zr]=Q.move(i,D,F)):($e=D,tn=F)}let Cu={width:0,height:0,left:0,top:0};function Pu(){Tl(Cu,!1)}let lp,cp,hp,up;function dp(M,A,D,F,Y,it,ft){$s=!0,Pn=In=Bn._x=Bn._y=!1,Ru(M,A,D,F,Y,it,ft,!0,!1),M!=null&&(ve(xf,bf,fp,!1),ca(s0,i,Yr,Zr,G,Ct,null));let{left:_t,top:bt,width:Ot,height:kt}=Ye;lp=_t,cp=bt,hp=Ot,up=kt}function fp(M,A,D,F,Y,it,ft){$s=Bn._x=Bn._y=!1,Ru(M,A,D,F,Y,it,ft,!1,!0);let{left:_t,top:bt,width:Ot,height:kt}=Ye,Vt=Ot>0||kt>0,ue=lp!=_t||cp!=bt||hp!=Ot||up!=kt;if(Vt&&ue&&Tl(Ye),Bn.setScale&&Vt&&ue){let Ie=_t,Ae=Ot,ye=bt,ne=kt;if(P.ori==1&&(Ie=bt,Ae=kt,ye=_t,ne=Ot),Pn&&Ys(w,es(Ie,w),es(Ie+Ae,w)),In)for(let Yt in v){let Ze=v[Yt];Yt!=w&&Ze.from==null&&Ze.min!=He&&Ys(Yt,es(ye+ne,Yt),es(ye,Yt))}Pu()}else Q.lock&&(Q._lock=!Q._lock,gr(A,!0,M!=null));M!=null&&(hn(xf,bf),ca(xf,i,$e,tn,G,Ct,null))}function ax(M,A,D,F,Y,it,ft){if(Q._lock)return;ie(M);let _t=$s;if($s){let bt=!0,Ot=!0,kt=10,Vt,ue;P.ori==0?(Vt=Pn,ue=In):(Vt=In,ue=Pn),Vt&&ue&&(bt=$e<=kt||$e>=G-kt,Ot=tn<=kt||tn>=Ct-kt),Vt&&bt&&($e=$e<Yr?0:G),ue&&Ot&&(tn=tn<Zr?0:Ct),gr(null,!0,!0),$s=!1}$e=-10,tn=-10,J.fill(null),gr(null,!0,!0),_t&&($s=_t)}function pp(M,A,D,F,Y,it,ft){Q._lock||(ie(M),ra(),Pu(),M!=null&&ca(a0,i,$e,tn,G,Ct,null))}function mp(){S.forEach(PT),H(i.width,i.height,!0)}Or(su,Go,mp);let jr={};jr.mousedown=dp,jr.mousemove=ap,jr.mouseup=fp,jr.dblclick=pp,jr.setSeries=(M,A,D,F)=>{let Y=yn.match[2];D=Y(i,A,D),D!=-1&&ts(D,F,!0,!1)},st&&(ve(s0,g,dp),ve(_f,g,ap),ve(r0,g,M=>{ie(M),la(!1)}),ve(o0,g,ax),ve(a0,g,pp),If.add(i),i.syncRect=la);let El=i.hooks=n.hooks||{};function Ln(M,A,D){Jn?Be.push([M,A,D]):M in El&&El[M].forEach(F=>{F.call(null,i,A,D)})}(n.plugins||[]).forEach(M=>{for(let A in M.hooks)El[A]=(El[A]||[]).concat(M.hooks[A])});let gp=(M,A,D)=>D,yn=Sn({key:null,setSeries:!1,filters:{pub:x0,sub:x0},scales:[w,y[1]?y[1].scale:null],match:[y0,y0,gp],values:[null,null]},Q.sync);yn.match.length==2&&yn.match.push(gp),Q.sync=yn;let _p=yn.key,Iu=m_(_p);function ca(M,A,D,F,Y,it,ft){yn.filters.pub(M,A,D,F,Y,it,ft)&&Iu.pub(M,A,D,F,Y,it,ft)}Iu.sub(i);function lx(M,A,D,F,Y,it,ft){yn.filters.sub(M,A,D,F,Y,it,ft)&&jr[M](null,A,D,F,Y,it,ft)}i.pub=lx;function cx(){Iu.unsub(i),If.delete(i),mn.clear(),Ef(su,Go,mp),c.remove(),ct?.remove(),Ln("destroy")}i.destroy=cx;function Lu(){Ln("init",n,t),sa(t||n.data,!1),N[w]?wu(w,N[w]):ra(),lt=Ye.show&&(Ye.width>0||Ye.height>0),ot=yt=!0,H(n.width,n.height)}return y.forEach(Gr),S.forEach(ms),e?e instanceof HTMLElement?(e.appendChild(c),Lu()):e(i,Lu):Lu(),i}cn.assign=Sn;cn.fmtNum=Bf;cn.rangeNum=ru;cn.rangeLog=lu;cn.rangeAsinh=Ff;cn.orient=kr;cn.pxRatio=De;cn.join=M1;cn.fmtDate=zf,cn.tzDate=L1;cn.sync=m_;{cn.addGap=pT,cn.clipGaps=uu;let n=cn.paths={points:M_};n.linear=b_,n.stepped=_T,n.bars=xT,n.spline=vT}var IT=n=>Ms(String(Number(n.toFixed(6)))),LT=364,ks=n=>pn()?LT:Math.max(n.clientWidth,200);function Jo(n){let t={stroke:Ee("muted"),grid:{stroke:Ee("grid"),width:1},ticks:{show:!1},font:"11px system-ui, sans-serif",values:(e,i)=>i.map(IT)};return[{...t,size:30,label:n,labelSize:18,labelFont:t.font},{...t,size:62}]}var zs=(n,t)=>t==null?"–":zn(t),Ko={live:!0,markers:{width:2,stroke:(n,t)=>n.series[t].stroke(n,t),dash:(n,t)=>n.series[t].dash?n.series[t].dash[0]<2?"dotted":"dashed":"solid",fill:()=>"transparent"}};function _l(n,t,e,i){if(n===null||t===null)return[0,1];let s=Math.max(t-n,Jt(i,e)),r=(n+t)/2;return[r-.58*s,r+.58*s]}var A_=new Map;function mu(n,t){let e=A_.get(t)??new Set;A_.set(t,e),n.root.querySelectorAll(".u-legend .u-series").forEach((i,s)=>{if(s===0||n.series.length<3)return;let r=i.querySelector("th"),{label:o}=n.series[s],a=()=>r.setAttribute("aria-pressed",String(n.series[s].show));e.has(o)&&n.setSeries(s,{show:!1});for(let[l,c]of Object.entries({tabindex:0,role:"button",title:`Show or hide ${o}`}))r.setAttribute(l,c);r.addEventListener("keydown",l=>{l.key!=="Enter"&&l.key!==" "||(l.preventDefault(),r.click())}),r.addEventListener("click",()=>{n.series[s].show?e.delete(o):e.add(o),a()}),a()})}var[zr,Vs,Ni,jo,Gs,Vr]=[720,320,78,16,46,46],DT={"font-family":"system-ui, sans-serif","font-size":12};function NT(n,t){let e=[];for(let i=Math.ceil(Math.log10(n)-1e-9);10**i<=t*(1+1e-9);i++)e.push(10**i);return e.map(i=>[i,`1e${Math.round(Math.log10(i))}`])}function R_(n,[t,e],i){let s=n.distr===3,r=s?Math.log10:u=>u,[o,a]=[r(n.min),r(n.max)],l=u=>t+(r(u)-o)/(a-o)*(e-t),c=En(n.min,n.max,i),d=s?NT(n.min,n.max):c.values.map(u=>[u,Mn(u,c.step)]);return{at:l,marks:d}}function Qo(n,t,e){let i=n.scales.y.dir===-1,s=R_(n.scales.x,[Ni,zr-jo],8),r=R_(n.scales.y,i?[Gs,Vs-Vr]:[Vs-Vr,Gs],5),o=Ft("svg",{viewBox:`0 0 ${zr} ${Vs}`,xmlns:"http://www.w3.org/2000/svg",...DT}),a=Ee("grid"),l=(h,f)=>Ft("text",{fill:Ee("text"),...h},f);for(let[h,f]of s.marks)o.append(Ft("line",{x1:s.at(h),x2:s.at(h),y1:Gs,y2:Vs-Vr,stroke:a})),o.append(l({x:s.at(h),y:Vs-Vr+17,"text-anchor":"middle"},f));for(let[h,f]of r.marks)o.append(Ft("line",{x1:Ni,x2:zr-jo,y1:r.at(h),y2:r.at(h),stroke:a})),o.append(l({x:Ni-7,y:r.at(h)+4,"text-anchor":"end"},f));let c=Ft("svg",{x:Ni,y:Gs,width:zr-Ni-jo,height:Vs-Gs-Vr,viewBox:`${Ni} ${Gs} ${zr-Ni-jo} ${Vs-Gs-Vr}`}),d=Ni;n.series.forEach((h,f)=>{if(f===0||!h.show)return;let g=typeof h.stroke=="function"?h.stroke(n,f):h.stroke,x=n.data[f],p=Array.from(n.data[0],(m,y)=>[m,x[y]]).filter(([m,y])=>y!==null&&Number.isFinite(y)&&m>=n.scales.x.min&&m<=n.scales.x.max);if(h.points?.show===!0)for(let[m,y]of p)c.append(Ft("circle",{cx:s.at(m).toFixed(1),cy:r.at(y).toFixed(1),r:1.8,fill:g}));else c.append(Ft("path",{d:p.map(([m,y],S)=>`${S?"L":"M"}${s.at(m).toFixed(1)} ${r.at(y).toFixed(1)}`).join(""),fill:"none",stroke:g,"stroke-width":h.width??1.4,"stroke-dasharray":h.dash?.join(" ")}));if(n.series.length>2){let m=h.dash?.join(" ");o.append(Ft("line",{x1:d,x2:d+22,y1:34,y2:34,stroke:g,"stroke-width":2,"stroke-dasharray":m})),o.append(l({x:d+27,y:38},h.label)),d+=42+6.4*h.label.length}}),o.append(c,Ft("rect",{x:Ni,y:Gs,width:zr-Ni-jo,height:Vs-Gs-Vr,fill:"none",stroke:Ee("frame")}),l({x:Ni,y:18,"font-weight":600},t),l({x:(Ni+zr-jo)/2,y:Vs-10,"text-anchor":"middle"},e)),o.style.position="absolute",document.body.append(o);let u=no([o]);return o.remove(),u}function ta(n,t,e){let i=n.series.map((l,c)=>c).filter(l=>l===0||n.series[l].show),s=l=>l===0?t:`${n.series[l].label}${e?`, ${e}`:""}`,{min:r,max:o}=n.scales.x,a=Array.from(n.data[0],(l,c)=>i.map(d=>n.data[d][c]));return[i.map(s),a.filter(([l])=>l>=r&&l<=o)]}function Hs(n,t){let e=0,i=n.length;for(;e<i;){let s=e+i>>1;n[s]<t?e=s+1:i=s}return e}function Yf(n,[t,e]){return[Math.max(Hs(n,t)-1,0),Math.min(Hs(n,e)+1,n.length)]}function ea(n,t,e){if(n.length===0||e<n[0]-1||e>n[n.length-1]+1)return NaN;let i=Math.min(Math.max(Hs(n,e),1),n.length-1),s=n[i]-n[i-1],r=s>0?Math.min(Math.max((e-n[i-1])/s,0),1):0;return t[i-1]+r*(t[i]-t[i-1])}function C_(n,t,e){let[i,s]=[1/0,-1/0],[r,o]=Yf(n,e);for(let a=r;a<o;a++)t[a]<i&&(i=t[a]),t[a]>s&&(s=t[a]);return[i,s]}var $f=(n,t)=>`${n.toFixed(1)} ${t.toFixed(1)}`;function P_(n,t,e,i,s){let[r,o]=Yf(n,e),a=o-r>2*Math.abs(s(e[1])-s(e[0])),l="",c="M",d=h=>{l+=c+$f(i(t[h]),s(n[h])),c="L"},u=r;for(;u<o;){if(!Number.isFinite(t[u])){c="M",u++;continue}if(!a){d(u++);continue}let h=Math.round(s(n[u])),[f,g,x]=[u,u,u];for(;x+1<o&&Math.round(s(n[x+1]))===h&&Number.isFinite(t[x+1]);)x++,t[x]<t[f]&&(f=x),t[x]>t[g]&&(g=x);for(let p of[...new Set([u,Math.min(f,g),Math.max(f,g),x])])d(p);u=x+1}return l}function gu(n,t,e,i,s,r){let[o,a]=Yf(n,i),l=Math.max(Math.floor((a-o)/(2*Math.abs(r(i[1])-r(i[0]))+1)),1),c=[],d=[];for(let u=o;u<a;u+=l){let[h,f]=[1/0,-1/0];for(let g=u;g<Math.min(u+l,a);g++)t[g]<h&&(h=t[g]),e[g]>f&&(f=e[g]);h<=f&&(c.push($f(s(f),r(n[u]))),d.push($f(s(h),r(n[u]))))}return c.length>1?`M${c.join("L")}L${d.reverse().join("L")}Z`:""}function I_(n,t,e){let i=new Float32Array(t.length),[s,r,o]=[0,0,0];for(let a=0;a<t.length;a++){for(;r<t.length&&n[r]<=n[a]+e;)o+=t[r++];for(;n[s]<n[a]-e;)o-=t[s++];i[a]=o/(r-s)}return i}function _u(n,t,e){let i=new Float32Array(t.length),s=0;for(let r=0;r<t.length;r++){for(;n[s]<n[r]-e;)s++;let o=-1/0;for(let a=s;a<t.length&&n[a]<=n[r]+e;a++)o=Math.max(o,t[a]);i[r]=o}return i}var Zf=[["contact_force_N","Contact force of the node","force",1e3],["tension_N","Effective tension","force",2e4],["torque_N_m","Torque","torque",500],["rotary_speed_rad_per_s","Rotary speed","rotary speed",1],["bending_moment_N_m","Bending moment","torque",500],["offset_high_m","Offset to the high side","diameter",.005],["offset_right_m","Offset to the right","diameter",.005]];var UT=cn.sync("time"),L_=216,FT=196;function Jf(n,t,e){let i=Z("div",{class:"histories"}),s=[],r=!1;function o(S){let v=S.history,E=t.map(_=>({..._,columns:_.columns.filter(([b])=>v[b])})).filter(_=>_.columns.length).filter(_=>_.columns.some(([b])=>v[b].some(B=>B!==0))).map(_=>({..._,times:v.time_s,values:_.columns.map(([b])=>v[b])})),w=e?l(S):null;return w?[...E,w]:E}let a="contact_force_N";function l(S){let{frames:v,contact:E}=S;if(v?.channels[a]){let w=v.md_m.length,_=xl(v.md_m,Bt.depth),[b,B,I,P]=Zf.find(([z])=>z===a),O=Float32Array.from(v.time_s,(z,C)=>v.channels[b][C*w+_]);return{title:`${B} at ${Te(v.md_m[_],"length",5)}`,dimension:I,least_span:P,columns:[[b,"node"]],times:v.time_s,values:[O],chooses:Zf.filter(([z])=>v.channels[z])}}if(E){let w=E.md_m.length,_=xl(E.md_m,Bt.depth),b=Float32Array.from(E.time_s,(B,I)=>E.side_force[I*w+_]);return{title:`Side force around ${Te(E.md_m[_],"length",5)}`,dimension:"force per length",least_span:100,columns:[["side_force_N_per_m","side force"]],times:E.time_s,values:[b]}}return null}function c(){s.forEach(E=>E.destroy()),s=[];let S=Je(n),v=S?o(S).map(E=>d(E,S)):[];i.replaceChildren(...v.map(E=>E.element));for(let{plot:E,body:w,it:_}of v)s.push(_.made=u(E,w,S))}function d(S,v){let E=Z("div",{class:"plot"}),w=ce(S.dimension),_=Z("h3",{},S.points&&S.columns.length===1?S.columns[0][1].replace(/^./,I=>I.toUpperCase()):S.title,w&&Z("span",{class:"unit"},` ${w}`));S.chooses&&_.append(Z("select",{class:"noprint","aria-label":"Quantity of the chosen node",onchange:I=>{a=I.target.value,c()}},S.chooses.map(([I,P])=>Z("option",{value:I,selected:I===a},P))));let b={plot:S,body:E,made:null},B=()=>`${kn(v.operation)}: ${S.title}`;return _.append(Nn(B,{svg:()=>Qo(b.made,`${B()}${w?`, ${w}`:""}`,"Time, s"),csv:()=>Wn(...ta(b.made,"time, s",w))})),{...b,it:b,element:Z("figure",{class:"card history"},_,E)}}function u(S,v,E){let w=h(S),_=[Array.from(S.times),...S.values.map(P=>Dl(P,S.dimension))],b=S.columns.map(([,P],O)=>{let z=P==="set";return{label:P,stroke:vs(z?6:[0,2,3][O]??O),width:z?1.2:1.4,dash:z?Ks(4):Ks([0,2,3][O]??O)??void 0,spanGaps:!!S.points,points:{show:!1},value:zs}});w!==null&&(_.push(_[0].map(()=>w)),b.push({label:"soft string",stroke:vs(1),width:1.4,dash:[7,4],points:{show:!1},value:zs}));let B=Bt.times??[0,Math.max(E.history.time_s.at(-1),.001)],I=new cn({width:ks(v),height:pn()?FT:L_,cursor:{sync:{key:UT.key,scales:["x",null]},drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:Ko,scales:{x:{time:!1,min:B[0],max:B[1]},y:{dir:S.points?-1:1,range:(P,O,z)=>_l(O,z,S.dimension,S.least_span)}},axes:Jo("Time, s"),series:[{label:"time, s",value:(P,O)=>O===null?"–":O.toFixed(2)},...b],hooks:{setScale:[(P,O)=>O==="x"&&f(P)],drawClear:[P=>g(P,E)],draw:[P=>x(P,E)]}},_,v);return p(I),mu(I,`${E.operation} ${S.title.replace(/ (at|around) .*/,"")}`),I}function h(S){let v=Ai(n,"soft");if(!S.soft||!v)return null;let E=v.profile[S.soft]?.[0];return Number.isFinite(E)?Jt(E,S.dimension):null}function f(S){if(r||S.scales.x.min==null||s.length===0)return;r=!0;let{min:v,max:E}=S.scales.x,_=Je(n).history.time_s.at(-1);for(let b of s)b!==S&&b.setScale("x",{min:v,max:E});Ge({times:v<=1e-6&&E>=_-1e-6?null:[v,E]}),r=!1}function g(S,v){let{ctx:E,bbox:w}=S,_=S.valToPos(v.window_s,"x",!0),b=Math.min(Math.max(_,w.left),w.left+w.width);E.save(),E.fillStyle=Ee("settling"),E.fillRect(w.left,w.top,b-w.left,w.height),E.restore()}function x(S,v){let{ctx:E,bbox:w}=S,_=devicePixelRatio,b=-1/0;E.save(),E.font=`${10*_}px system-ui, sans-serif`,E.textAlign="left",E.fillStyle=Ee("muted"),E.strokeStyle=Ee("muted"),E.setLineDash([2*_,3*_]);let B=Bt.moment===null?[]:[[Bt.moment,""]];for(let[I,P]of[...v.notes,...B]){let O=S.valToPos(I,"x",!0);if(O<w.left||O>w.left+w.width)continue;E.beginPath(),E.moveTo(O,w.top),E.lineTo(O,w.top+w.height),E.stroke();let z=E.measureText(P).width;P&&O>b&&O+z<w.left+w.width&&(E.fillText(P,O+3*_,w.top+11*_),b=O+z+8*_)}E.restore()}function p(S){let{over:v}=S,E=()=>Je(n).history.time_s.at(-1),w=(_,b)=>{let B=Math.max(_,0),I=Math.min(b,E());I-B>.001&&S.setScale("x",{min:B,max:I})};v.addEventListener("wheel",_=>{if(!_.ctrlKey&&!_.metaKey)return;_.preventDefault();let b=S.posToVal(_.clientX-v.getBoundingClientRect().left,"x"),B=Math.exp(_.deltaY*.002);w(b+(S.scales.x.min-b)*B,b+(S.scales.x.max-b)*B)},{passive:!1}),v.addEventListener("mousedown",_=>{if(!_.shiftKey)return;_.stopImmediatePropagation();let b=_.clientX,{min:B,max:I}=S.scales.x,P=O=>{let z=(b-O.clientX)/v.clientWidth*(I-B),C=Math.min(Math.max(z,-B),E()-I);w(B+C,I+C)};addEventListener("mousemove",P),addEventListener("mouseup",()=>removeEventListener("mousemove",P),{once:!0})},{capture:!0}),v.addEventListener("dblclick",()=>S.setScale("x",{min:0,max:E()}))}we(e?"units operation depth":"units operation",c),we("times",()=>{if(r)return;let S=Je(n);if(!S)return;let[v,E]=Bt.times??[0,S.history.time_s.at(-1)];r=!0;for(let w of s)w.setScale("x",{min:v,max:E});r=!1}),we("moment",()=>s.forEach(S=>S.redraw(!1,!1)));let m=0;new ResizeObserver(()=>{if(!(pn()||i.clientWidth===m)){m=i.clientWidth;for(let S of s)S.setSize({width:ks(S.root.parentElement),height:L_})}}).observe(i);let y=Z("p",{class:"hint noprint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics");return{element:Z("div",{},y,i),redraw:c}}function xl(n,t){let e=Math.min(Math.max(Hs(n,t??0),1),n.length-1);return Math.abs(n[e]-t)<Math.abs(n[e-1]-t)?e:e-1}var xu=58,D_=96,yu=10,N_=34,yl=430,OT=700;function BT(n,t){let e=n.filter(Number.isFinite).map(Math.abs).sort((i,s)=>i-s);return e[Math.floor(t*(e.length-1))]||1}function U_(n){let t="side_force",e=Z("canvas",{class:"map",role:"img","aria-label":"Contact over depth and time"}),i=Z("p",{class:"readout-line"}," "),s=Z("div",{class:"map-holder"},e),r=Z("div",{class:"tools noprint"},xr("What the map shows",[["side_force","Side force, by side"],["contact_force","Contact force"]],t,p=>{t=p,a()}),Nn("Contact over depth and time",{svg:()=>c(),csv:()=>Wn(...d())}),Z("span",{class:"hint"},"follows the depths and times in view above; click to choose a depth and a time")),o=p=>({depths:Bt.depths??[0,p.contact.md_m.at(-1)],times:Bt.times??[p.contact.from_s,p.contact.time_s.at(-1)]});function a(){let p=Je(n);if(!p?.contact)return;let m=Math.max(devicePixelRatio,2),y=pn()?OT:s.clientWidth||1200;e.width=y*m,e.height=yl*m,e.style.aspectRatio=`${y} / ${yl}`;let S=e.getContext("2d");S.scale(m,m),S.font="11px system-ui, sans-serif",l(S,p,y,(...v)=>u(S,...v))}function l(p,m,y,S){let{depths:v,times:E}=o(m),w={left:xu,top:yu,width:y-xu-D_,height:yl-yu-N_},_=BT(Array.from(m.contact[t]),.985),b=t==="side_force",B=Qr(b),I=P=>B(b?.5+.5*P/_:P/_);S(m,w,v,E,I),h(p,w,v,E,m),f(p,w,_,I)}function c(){let p=Je(n),m=1e3,y=new ko(m,yl);return y.fillStyle=Ee("paper"),y.fillRect(0,0,m,yl),l(y,p,m,(S,v,...E)=>{let w=Z("canvas",{width:v.width*2,height:v.height*2}),_=w.getContext("2d");_.scale(2,2),_.translate(-v.left,-v.top),u(_,S,v,...E),y.image(w.toDataURL(),v.left,v.top,v.width,v.height)}),y.file()}function d(){let{contact:p}=Je(n),{depths:m,times:y}=o(Je(n)),S=[];p.time_s.forEach((E,w)=>{E<y[0]||E>y[1]||p.md_m.forEach((_,b)=>{if(_<m[0]||_>m[1])return;let B=w*p.md_m.length+b,I=["side_force","contact_force"].map(P=>Jt(p[P][B],"force per length"));S.push([E,Jt(_,"length"),...I])})});let v=ce("force per length");return[["time, s",`md, ${ce("length")}`,`side force, ${v}`,`contact force, ${v}`],S]}function u(p,m,y,[S,v],[E,w],_){let{contact:b}=m,B=b.md_m.length,I=new ImageData(b.time_s.length,Math.round(y.height));for(let C=0;C<I.height;C++){let N=xl(b.md_m,S+(C+.5)/I.height*(v-S));for(let U=0;U<I.width;U++){let[k,$,V]=_(b[t][U*B+N]||0);I.data.set([k,$,V,255],4*(C*I.width+U))}}let P=new OffscreenCanvas(I.width,I.height);P.getContext("2d").putImageData(I,0,0),p.save(),p.beginPath(),p.rect(y.left,y.top,y.width,y.height),p.clip(),p.imageSmoothingEnabled=!1;let O=C=>y.left+(C-E)/(w-E)*y.width,z=b.from_s;b.time_s.forEach((C,N)=>{p.drawImage(P,N,0,1,I.height,O(z),y.top,O(C)-O(z)+.5,y.height),z=C}),p.restore()}function h(p,m,[y,S],[v,E],w){let _=O=>m.top+(O-y)/(S-y)*m.height,b=O=>m.left+(O-v)/(E-v)*m.width;p.fillStyle=p.strokeStyle=Ee("muted"),p.textBaseline="middle",p.textAlign="right";let B=En(Jt(y,"length"),Jt(S,"length"),9);for(let O of B.values)p.fillText(Mn(O,B.step),m.left-8,_(Hn(O,"length")));p.textAlign="center",p.textBaseline="top";let I=En(v,E,12);for(let O of I.values)p.fillText(Mn(O,I.step),b(O),m.top+m.height+6);p.fillText("time, s",m.left+m.width/2,m.top+m.height+20),p.save(),p.translate(9,m.top+m.height/2),p.rotate(-Math.PI/2),p.fillText(`MD, ${ce("length")}`,0,-4),p.restore(),p.strokeStyle=Ee("frame"),p.strokeRect(m.left,m.top,m.width,m.height);let P=(O,z,C,N)=>{p.beginPath(),p.moveTo(O,z),p.lineTo(C,N),p.stroke()};p.strokeStyle=Ee("text"),p.setLineDash([4,4]),w.window_s>v&&w.window_s<E&&(P(b(w.window_s),m.top,b(w.window_s),m.top+m.height),p.textAlign="left",p.fillStyle=Ee("text"),p.fillText("window ▸",b(w.window_s)+4,m.top+4)),p.setLineDash([1,3]);for(let{kind:O,to_m:z}of n.hole)O==="casing"&&z>y&&z<S&&(P(m.left,_(z),m.left+m.width,_(z)),p.textAlign="left",p.fillStyle=Ee("text"),p.fillText("shoe",m.left+4,_(z)-13));p.setLineDash([]),Bt.depth!==null&&Bt.depth>y&&Bt.depth<S&&P(m.left,_(Bt.depth),m.left+m.width,_(Bt.depth)),Bt.moment!==null&&Bt.moment>v&&Bt.moment<E&&P(b(Bt.moment),m.top,b(Bt.moment),m.top+m.height)}function f(p,m,y,S){let v=m.left+m.width+14,E=t==="side_force"?-y:0,w=120;for(let b=0;b<w;b++){let[B,I,P]=S(E+(b+.5)/w*(y-E));p.fillStyle=`rgb(${B} ${I} ${P})`,p.fillRect(v,m.top+m.height*(1-(b+1)/w),12,m.height/w+.6)}p.strokeStyle=Ee("frame"),p.strokeRect(v,m.top,12,m.height);let _=En(Jt(E,"force per length"),Jt(y,"force per length"),6);p.fillStyle=Ee("muted"),p.textAlign="left",p.textBaseline="middle";for(let b of _.values){let B=(Hn(b,"force per length")-E)/(y-E);p.fillText(Mn(b,_.step),v+17,m.top+m.height*(1-B))}p.fillText(ce("force per length"),v,m.top+m.height+12),t==="side_force"&&(p.save(),p.textAlign="center",p.translate(v+66,m.top+m.height*.25),p.rotate(-Math.PI/2),p.fillText("high side",0,0),p.restore(),p.save(),p.textAlign="center",p.translate(v+66,m.top+m.height*.75),p.rotate(-Math.PI/2),p.fillText("low side",0,0),p.restore())}function g(p){let m=Je(n);if(!m?.contact)return null;let y=e.getBoundingClientRect(),{depths:S,times:v}=o(m),E=(p.clientX-y.left-xu)/(y.width-xu-D_),w=(p.clientY-y.top-yu)/(y.height-yu-N_);return E<0||E>1||w<0||w>1?null:{depth:S[0]+w*(S[1]-S[0]),moment:v[0]+E*(v[1]-v[0])}}e.addEventListener("pointermove",p=>{let m=g(p);if(Ge({pointer:m?.depth??null}),!m)return void(i.textContent=" ");let{contact:y}=Je(n),S=Math.min(Math.max(Array.from(y.time_s).findIndex(w=>w>=m.moment),0),y.time_s.length-1),v=y[t][S*y.md_m.length+xl(y.md_m,m.depth)],E=t==="contact_force"||Math.abs(v)===0?"":v>0?", high side":", low side";i.textContent=`MD ${Te(m.depth,"length",5)}, ${zn(m.moment,4)} s: ${Te(Math.abs(v),"force per length",3)}${E}`}),e.addEventListener("pointerleave",()=>{Ge({pointer:null}),i.textContent=" "}),e.addEventListener("click",p=>{let m=g(p);m&&Ge(m)}),we("units operation depths times depth moment",a);let x=0;return new ResizeObserver(()=>{s.clientWidth!==x&&(x=s.clientWidth,a())}).observe(s),{element:Z("div",{},r,s,i),redraw:a}}var F_=260,kT=1e4,zT=[["rate_m_per_s","Rate of penetration against weight","rate of penetration","rate of penetration",5e-4],["torque_N_m","Torque against weight","torque","torque on bit",500]];function O_(n){let t=Z("div",{class:"histories"}),e=[];function i(){e.forEach(h=>h.destroy()),e=[];let a=Je(n)?.drill_off;if(!a)return t.replaceChildren();let l=Array.from(a.weight_N,(h,f)=>f).filter(h=>Number.isFinite(a.weight_N[h])).sort((h,f)=>a.weight_N[h]-a.weight_N[f]),c=(h,f)=>Dl(Array.from(l,g=>a[h][g]),f),d=c("weight_N","force"),u=zT.map(([h,f,g,x,p])=>{let m=Z("div",{class:"plot"}),y=Z("h3",{},f,Z("span",{class:"unit"},` ${ce(g)}`)),S=null,v=`Weight on bit, ${ce("force")}`;y.append(Nn(f,{svg:()=>Qo(S,`${f}, ${ce(g)}`,v),csv:()=>Wn(...ta(S,v,ce(g)))}));let E=()=>e.push(S=s(m,d,c(h,g),g,x,p));return{element:Z("figure",{class:"card history"},y,m),make:E}});t.replaceChildren(...u.map(h=>h.element));for(let h of u)h.make()}function s(a,l,c,d,u,h){let f=vs(0);return new cn({width:ks(a),height:F_,cursor:{drag:{x:!0,y:!0,uni:8},points:{size:6}},legend:Ko,scales:{x:{time:!1,range:(g,x,p)=>_l(x,p,"force",kT)},y:{range:(g,x,p)=>_l(x,p,d,h)}},axes:Jo(`Weight on bit, ${ce("force")}`),series:[{label:`weight, ${ce("force")}`,value:zs},{label:u,stroke:f,paths:()=>null,points:{show:!0,size:3.5,width:0,fill:`color-mix(in srgb, ${f} 55%, transparent)`},value:zs}]},[l,c],a)}we("units operation",i);let r=0;new ResizeObserver(()=>{if(!(pn()||t.clientWidth===r)){r=t.clientWidth;for(let a of e)a.setSize({width:ks(a.root.parentElement),height:F_})}}).observe(t);let o=Z("p",{class:"note"},"Each point is a sample of the window of the statistics.");return{element:Z("div",{class:"drill-off"},t,o),redraw:i}}var vu=class{constructor(t){this.well=t}at(t,e){let{md_m:i,north_m:s,east_m:r,tvd_m:o,high:a}=this.well,l=Math.min(Math.max(Hs(i,t),1),i.length-1),c=(t-i[l-1])/(i[l]-i[l-1]||1),d=f=>f[l-1]+c*(f[l]-f[l-1]);e.place=[d(r),-d(o),-d(s)],e.high=Kf([d(a[1]),-d(a[2]),-d(a[0])]);let u=[r,o,s].map(f=>f[l]-f[l-1]),h=Kf([u[0],-u[1],-u[2]]);return e.right=Kf(VT(h,e.high)),e}},Kf=n=>{let t=Math.hypot(...n)||1;return n.map(e=>e/t)},VT=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],vl=class extends On{constructor(t,e){super(),this.rings=t,this.sides=e;let i=t*e;this.setAttribute("position",new ii(new Float32Array(3*i),3)),this.setAttribute("normal",new ii(new Float32Array(3*i),3)),this.setAttribute("color",new ii(new Float32Array(3*i).fill(1),3));let s=[];for(let r=0;r+1<t;r++)for(let o=0;o<e;o++){let[a,l]=[r*e+o,r*e+(o+1)%e];s.push(a,l,a+e,l,l+e,a+e)}this.setIndex(s),this.turns=Array.from({length:e},(r,o)=>[Math.cos(2*Math.PI*o/e),Math.sin(2*Math.PI*o/e)])}ring(t,e,i,s,r){let{position:o,normal:a}=this.attributes;for(let l=0;l<this.sides;l++){let[c,d]=this.turns[l],u=3*(t*this.sides+l);for(let h=0;h<3;h++){let f=c*i[h]+d*s[h];a.array[u+h]=f,o.array[u+h]=e[h]+r*f}}}paint(t,e,i,s){let{color:r}=this.attributes;for(let o=0;o<this.sides;o++)r.array.set([e,i,s],3*(t*this.sides+o))}changed(){for(let t of Object.values(this.attributes))t.needsUpdate=!0;this.computeBoundingSphere()}};var GT=[["side_force_N_per_m","Side force, by side","force per length",!0],["contact_force_N","Contact force of the node","force",!0],["tension_N","Effective tension","force",!1],["torque_N_m","Torque","torque",!1],["bending_moment_N_m","Bending moment","torque",!1],["rotary_speed_rad_per_s","Rotary speed","rotary speed",!1],["von_mises_stress_max_Pa","Largest von Mises stress","pressure",!1],["contact_fraction","Share of time in contact","percent",!1]];function HT(n,t){let{profile:e}=t,i=e.md_m,s=e.lateral_offset_m??WT(n,e),r=XT(e);return{depths:i,high:s.map((o,a)=>-o*Math.cos(r[a])),right:s.map((o,a)=>o*Math.sin(r[a])),values:o=>e[o],has:o=>!!e[o]&&o!=="contact_force_N"}}function WT(n,t){return t.md_m.map(e=>{let i=o=>e>=o.from_m&&e<=o.to_m,s=n.hole.find(i),r=n.string.find(i);return s&&r?(s.diameter_m-r.contact_od_m)/2:0})}function XT(n){let t=[];for(let s=0;s<n.md_m.length;s++){let r=n.climb_rad?.[s];Number.isFinite(r)?t.push([n.md_m[s],Math.cos(r),Math.sin(r)]):!n.climb_rad&&n.side_force_N_per_m[s]!==0&&t.push([n.md_m[s],n.side_force_N_per_m[s]>0?-1:1,0])}if(t.length===0)return n.md_m.map(()=>0);let e=[0,1,2].map(s=>Float32Array.from(t,r=>r[s])),i=(s,r)=>{let o=ea(e[0],r,Math.min(Math.max(s,e[0][0]),e[0].at(-1)));return Number.isFinite(o)?o:0};return n.md_m.map(s=>Math.atan2(i(s,e[2]),i(s,e[1])))}function qT(n,t){let e=n.md_m.length,i=s=>n.channels[s].subarray(t*e,(t+1)*e);return{depths:n.md_m.map(s=>s+n.moved_m[t]),high:i("offset_high_m"),right:i("offset_right_m"),values:i,has:s=>!!n.channels[s]}}function jf(n,t,e){return t?.frames&&e!==null?qT(t.frames,e):HT(n,Ai(n,"dynamic")??Ai(n,"soft"))}var Qf=n=>GT.filter(([t])=>n.has(t));function B_(n,t,e,i,s){let r=t?.frames&&e!==null?t.frames.channels[i]:n.values(i),o=Array.from(r).filter(Number.isFinite).sort((d,u)=>d-u);if(o.length===0)return[0,1];let a=d=>o[Math.round(d*(o.length-1))];if(s){let d=Math.max(Math.abs(a(.01)),Math.abs(a(.99)))||1;return[-d,d]}let[l,c]=[a(.002),a(.998)];return l<c?[l,c]:[l-.5*Math.abs(l||1),c+.5*Math.abs(c||1)]}function k_(n,t){let e=Math.min(Math.max(Hs(n.time_s,t),1),n.time_s.length-1);return e<1?0:t-n.time_s[e-1]<n.time_s[e]-t?e-1:e}var $T=600,YT=10;function z_(n){let t=qh("The well in space, the string in it",$T);if(!t)return{element:Wh(),redraw:()=>{}};let e=new vu(n.well),i=n.well.md_m.at(-1),s=Math.max(...n.hole.map($=>$.diameter_m),.1),r=ZT(.03*i/s),o=null,a=null,l=null,c=Z("div",{class:"colour-key"}),d=Z("output",{}),u=Z("input",{type:"range",min:0,step:1,"aria-label":"Moment",oninput:()=>{let $=Je(n);Ge({moment:$.frames.time_s[Number(u.value)]})}}),h=Z("button",{type:"button",onclick:()=>l?w():E()},"Play"),f=Z("button",{type:"button",onclick:()=>{w(),Ge({moment:null})}},"Mean"),g=Z("div",{class:"moments"},h,f,u,d),x=Z("output",{}),p=Z("input",{type:"range",min:0,max:3.7,step:.01,value:Math.log10(r),"aria-label":"Exaggeration across the hole",oninput:()=>{r=10**Number(p.value),B()}}),m=Z("span",{}),y=[["From the side",()=>N(.02)],["From above",()=>[.001,1,.001]]].map(([$,V])=>Z("button",{type:"button",onclick:()=>U(V())},$)),S=()=>{Ge({depths:null}),U(N(.3))};y.unshift(Z("button",{type:"button",onclick:S},"Whole well"));let v=Z("div",{class:"tools noprint"},m,Z("label",{},"Across × ",p,x),y,Nn("The well in space",{png:()=>t.canvas,csv:()=>Wn(...z())}),Z("span",{class:"hint"},`${Xh}; shows the depths in view above`));function E(){h.textContent="Stop",l=setInterval(()=>{let{frames:$}=Je(n),V=(Number(u.value)+1)%$.time_s.length;Ge({moment:$.time_s[V]})},80)}function w(){clearInterval(l),l=null,h.textContent="Play"}let _=()=>Bt.depths??[n.well.md_m[0],i];function b([$,V]){let X=Array.from(n.well.md_m).filter(Q=>Q>$&&Q<V),J=(V-$)/300;return[...Array.from({length:301},(Q,W)=>$+W*J),...X].sort((Q,W)=>Q-W)}function B(){t.remove();let[$,V]=_(),X={};for(let J of n.hole){let nt=[Math.max(J.from_m,$),Math.min(J.to_m,V)];if(nt[1]<=nt[0])continue;let Q=b(nt),W=new vl(Q.length,28);Q.forEach((ct,gt)=>{e.at(ct,X),W.ring(gt,X.place,X.high,X.right,J.diameter_m/2*r)}),W.changed();let st=J.kind==="casing",ht=new Ds({color:Ee(st?"casing":"rock"),transparent:!0,opacity:st?.16:.26,side:li,depthWrite:!1});t.add(new $n(W,ht)).renderOrder=2}Hg(e,[$,V],s/2*r,N(.3)).forEach(t.add),O(),x.textContent=` ${zn(r,2)}`,t.render()}let I=null,P=null;function O(){let $=Je(n);a=$?.frames&&Bt.moment!==null?k_($.frames,Bt.moment):null;let V=jf(n,$,a),X=Qf(V);X.some(([oe])=>oe===o)||(o=X[0][0]);let[,J,nt,Q]=X.find(([oe])=>oe===o);m.replaceChildren(Al("Colour: ",X.map(([oe,Ce])=>[oe,Ce]),o,oe=>{o=oe,O(),t.render()}));let[W,st]=_(),ht=Array.from(V.depths,(oe,Ce)=>[oe,Ce]).filter(([oe])=>oe>=W-1&&oe<=st+1);(!I||P.geometry!==I||I.rings!==ht.length)&&(P&&t.remove([P]),I=new vl(Math.max(ht.length,2),YT),P=t.add(new $n(I,new Ds({vertexColors:!0})))),t.has(P)||t.add(P);let ct=V.values(o),gt=B_(V,$,a,o,Q),xt=Qr(Q),Ut=oe=>xt((oe-gt[0])/(gt[1]-gt[0])).map(Ce=>Ce/255),Lt={},Qt=new fe,te=n.string;ht.forEach(([oe,Ce],Pe)=>{e.at(Math.min(oe,i),Lt);let[mn,ve]=[V.high[Ce]*r||0,V.right[Ce]*r||0],hn=Lt.place.map((Zt,ae)=>Zt+mn*Lt.high[ae]+ve*Lt.right[ae]),Qe=te.find(Zt=>oe<=Zt.to_m)??te.at(-1);I.ring(Pe,hn,Lt.high,Lt.right,(Qe?.od_m??.12)/2*r);let[sn,G,Ct]=Number.isFinite(ct[Ce])?Ut(ct[Ce]):[.5,.5,.5];Qt.setRGB(sn,G,Ct,"srgb"),I.paint(Pe,Qt.r,Qt.g,Qt.b)}),I.changed();let qt=ce(nt)?`, ${ce(nt)}`:"",ke=Q?" (low side −, high side +)":"";c.replaceChildren(...kh(`${J}${qt}${ke}, ${kn(Bt.operation)}`,nt,gt,xt)),g.hidden=!$?.frames,$?.frames&&(u.max=$.frames.time_s.length-1,a!==null&&(u.value=a),f.disabled=a===null,d.textContent=a===null?"mean of the window":`${$.frames.time_s[a].toFixed(2)} s`)}function z(){let $=jf(n,Je(n),a),[,V,X]=Qf($).find(([W])=>W===o),J=$.values(o),nt=[`md, ${ce("length")}`,`to the high side, ${ce("diameter")}`,`to the right, ${ce("diameter")}`,`${V}, ${ce(X)}`],Q=Array.from($.depths,(W,st)=>[Jt(W,"length"),Jt($.high[st],"diameter"),Jt($.right[st],"diameter"),Jt(J[st],X)]);return[nt,Q]}function C(){let[$,V]=_();return Array.from({length:41},(X,J)=>e.at($+(V-$)*J/40,{}).place)}function N($){let[V,X]=_().map(st=>e.at(st,{}).place),[J,nt]=[X[0]-V[0],X[2]-V[2]],Q=Math.hypot(J,nt);if(Q<.001)return[.6,$,.8];let W=J-nt<0?-1:1;return[-nt/Q*W,$,J/Q*W]}function U($){let{low:V,high:X}=uf(e,_()),J=V.clone().add(X).multiplyScalar(.5),Q=[...df({low:V,high:X},N(.3)).flatMap(([W,st])=>[V.y,X.y].map(ht=>[W,ht,st])),...C()];t.lookAt(Q,$,J,[84,16]),t.holder.dataset.spans=t.spans(Q).map(W=>W.toFixed(2)).join(" ")}function k(){t.size(),B(),U(N(.3))}return we("units operation",()=>{w(),B()}),we("depths",()=>{B(),U(t.from().toArray())}),we("moment",()=>{O(),t.render()}),{element:Z("div",{},v,t.holder,g,c),redraw:k}}function ZT(n){let t=10**Math.floor(Math.log10(Math.max(n,1)));return[5,2,1].map(e=>e*t).find(e=>e<=Math.max(n,1))??1}var V_=260;function JT(n){let t=ce(n);return t===""?"1/Hz":/^\p{L}+$/u.test(t)?`${t}²/Hz`:`(${t})²/Hz`}function G_(n){let t=Z("div",{class:"histories"}),e=[];function i(){let c=new Map;for(let d of Je(n)?.spectra??[]){let u=`${d.signal} ${d.md_m!==null}`;c.has(u)||c.set(u,[]),c.get(u).push(d)}return[...c.values()]}function s(){e.forEach(d=>d.destroy()),e=[];let c=i().map(r);t.replaceChildren(...c.map(d=>d.element));for(let d of c)e.push(d.make())}function r(c){let[{signal:d,dimension:u,md_m:h}]=c,f=c.length===1&&h!==null?` at ${Te(h,"length",5)}`:"",g=`Density of ${kn(d)}${f}`,x=JT(u),p=Z("div",{class:"plot"}),m=null,y=Z("h3",{},g,Z("span",{class:"unit"},` ${x}`),Nn(g,{svg:()=>Qo(m,`${g}, ${x}`,"Frequency, Hz"),csv:()=>Wn(...ta(m,"frequency, Hz",x))})),S=()=>m=o(p,c,u,`${Je(n).operation} ${d}`);return{element:Z("figure",{class:"card history"},y,p),make:S}}function o(c,d,u,h){let f=Array.from(d[0].frequency_Hz).slice(1),g=u?Jt(1,u)**2:1,x=d.map(P=>Array.from(P.density).slice(1).map(O=>O>0?O*g:null)),p=d.length===1&&d[0].md_m===null,m=x.flat().filter(P=>P!==null),y=Math.max(...m),S=Math.max(Math.min(...m),y*1e-9),[v,E]=Jo("Frequency, Hz"),w=Math.max(Math.ceil(Math.log10(y/S)/6),1),_=P=>Math.abs(Math.log10(P)-Math.round(Math.log10(P)))<1e-6,b=(P,O)=>O.map(z=>_(z)&&Math.round(Math.log10(z))%w===0?z:null),B=(P,O)=>b(P,O).map(z=>z===null?"":`1e${Math.round(Math.log10(z))}`),I=new cn({width:ks(c),height:V_,cursor:{drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:Ko,scales:{x:{time:!1,distr:3,range:(P,O,z)=>[O,z]},y:{distr:3,range:()=>[S/1.5,y*1.5]}},axes:[{...v,grid:{...v.grid,filter:b},values:(P,O)=>O.map(z=>z===null?"":String(Number(z.toPrecision(3))))},{...E,grid:{...E.grid,filter:b},values:B}],series:[{label:"frequency, Hz",value:zs},...d.map((P,O)=>({label:p?kn(P.signal):`at ${Te(P.md_m,"length",5)}`,stroke:vs(O),dash:Ks(O)??void 0,width:1.4,points:{show:!1},value:zs}))]},[f,...x],c);return mu(I,`spectrum ${h}`),I}we("units operation",s);let a=0;new ResizeObserver(()=>{if(!(pn()||t.clientWidth===a)){a=t.clientWidth;for(let c of e)c.setSize({width:ks(c.root.parentElement),height:V_})}}).observe(t);let l=Z("p",{class:"hint noprint"},"of the window of the statistics; drag to zoom, double-click for all");return{element:Z("div",{},l,t),redraw:s}}var H_=4;function W_({cover:n,band:t,picture:e,head:i,height:s,total:r,full:o,view:a,zoom:l}){let c=f=>{let[g,x]=a();return i+(f-g)/(x-g)*s},d=f=>{let g=e.getBoundingClientRect(),[x,p]=a(),m=(f.clientY-g.top)/g.height*r;return x+(m-i)/s*(p-x)},u=null;function h(f){let[g,x]=a(),p=r/e.getBoundingClientRect().height*(x-g)/s,m=y=>{let S=(f.clientY-y.clientY)*p,v=Math.min(Math.max(S,o[0]-g),o[1]-x);l([g+v,x+v])};addEventListener("pointermove",m),addEventListener("pointerup",()=>removeEventListener("pointermove",m),{once:!0})}n.addEventListener("pointerdown",f=>{if(f.button===0){if(f.shiftKey)return h(f);u={depth:d(f),y:f.clientY},n.setPointerCapture(f.pointerId)}}),n.addEventListener("pointermove",f=>{let g=d(f);if(u&&Math.abs(f.clientY-u.y)>H_){let x=[c(u.depth),c(g)].sort((p,m)=>p-m);t.setAttribute("y",x[0]),t.setAttribute("height",x[1]-x[0]),t.setAttribute("visibility","visible")}Ge({pointer:g})}),n.addEventListener("pointerup",f=>{if(!u)return;let{depth:g,y:x}=u;u=null,t.setAttribute("visibility","hidden"),Math.abs(f.clientY-x)>H_?l([g,d(f)]):Ge({depth:Math.min(Math.max(g,o[0]),o[1])})}),n.addEventListener("pointerleave",()=>Ge({pointer:null})),n.addEventListener("dblclick",()=>l(o)),n.addEventListener("wheel",f=>{if(!f.ctrlKey&&!f.metaKey)return;f.preventDefault();let g=d(f),x=Math.exp(f.deltaY*.002);l(a().map(p=>g+(p-g)*x))},{passive:!1})}var KT=5,X_=n=>n.kind==="casing"?"casing":"open hole";function q_(n,t){let e=r=>t>=r.from_m&&t<=r.to_m,i=n.hole.find(e),s=n.string.find(e);return[i&&`${X_(i)} ${Te(i.diameter_m,"diameter")}`,s&&`${s.name} ${Te(s.od_m,"diameter")}`].filter(Boolean)}function $_(n,{left:t,width:e,top:i,height:s},[r,o],a){let l=t+e/2,c=Math.max(...n.hole.map(x=>x.diameter_m),...n.string.map(x=>x.contact_od_m)),d=x=>(e-22)/2*(x/c),u=Ft("g",{"clip-path":"inset(0)"}),h=x=>Math.min(Math.max(a(x),i-12),i+s+12);for(let x of n.hole){if(x.to_m<r||x.from_m>o)continue;let[p,m,y]=[h(x.from_m),h(x.to_m),d(x.diameter_m)],S=Ft("title",{},`${X_(x)} ${Te(x.diameter_m,"diameter")}, ${Te(x.from_m,"length",5)} to ${Te(x.to_m,"length",5)}, friction ${x.friction}`);u.append(Ft("rect",{x:l-y,y:p,width:2*y,height:Math.max(m-p,0),class:x.kind==="casing"?"bore":"rock"},S));for(let v of[-1,1]){let E=l+v*y;u.append(Ft("line",{x1:E,x2:E,y1:p,y2:m,class:x.kind==="casing"?"casing":"wall"})),x.kind==="casing"&&x.to_m<o&&u.append(Ft("path",{d:`M${E} ${m}h${v*8}L${E} ${m-9}Z`,class:"shoe"}))}}let f=n.string.at(-1),g=f&&f.to_m-f.from_m<KT?f:null;for(let x of n.string){if(x.to_m<r||x.from_m>o)continue;let[p,m,y]=[h(x.from_m),h(x.to_m),Math.max(d(x.od_m),1.5)],S=Ft("title",{},`${x.name}, OD ${Te(x.od_m,"diameter")}, ${Te(x.from_m,"length",5)} to ${Te(x.to_m,"length",5)}`),v=/pipe/i.test(x.name)&&!/heavy/i.test(x.name)?"pipe":"tool",E=x===g?Ft("path",{d:`M${l-y} ${Math.min(p,m-5)}h${2*y}v${Math.max(m-p,5)*.5}L${l} ${m+3}L${l-y} ${m-Math.max(m-p,5)*.5}Z`,class:"bit"}):Ft("rect",{x:l-y,y:p,width:2*y,height:Math.max(m-p,.7),class:v});E.append(S),u.append(E)}return u}var Mu=6;function jT(n,t){if(t.from==="well"){let e=n.well[t.column];return e.length?[{depths:n.well.md_m,values:e,well:!0}]:[]}return n.solved.flatMap(e=>{let i=t.from==="wear"?e.wear:e.profile,s=i[t.column];if(!s)return[];let r=i.md_m,[o,a]=(t.band??[]).map(c=>i[c]),l={solved:e,depths:r,values:s,low:o,high:a};return t.touches&&(l.values=_u(r,s,Mu)),t.swings&&(l.far={values:I_(r,s,Mu),low:o&&_u(r,o.map(c=>-c),Mu).map(c=>-c),high:a&&_u(r,a,Mu)}),[l]})}var Y_=n=>n.tracks.map(t=>({...t,curves:jT(n,t)})).filter(t=>t.curves.length);var QT=400,Z_=5,tE=700,eE=126,nE=120,Ui=54,Ml=88,Sl=14,Ws=82,iE=20;function J_(n){let t=Y_(n),e=Math.max(n.well.md_m.at(-1)??0,...n.solved.map(C=>C.profile.md_m?.at(-1)??0)),i=[0,e],s=()=>Bt.depths??i,r=Z("div",{class:"tracks"}),o=[],a=["from","to"].map((C,N)=>Z("input",{type:"number","aria-label":`Depths in view, ${C}`,step:"any",onchange:U=>{let k=[...s()];k[N]=Hn(Number(U.target.value),"length"),g(k)}})),l=Z("span",{}),c=Z("button",{type:"button",onclick:()=>g(i)},"All depths"),d=Z("div",{class:"tools noprint"},Z("label",{},"Depths from ",a[0]),Z("label",{},"to ",a[1]),l,c,Nn("Along the hole",{svg:()=>no(o.map(C=>C.picture)),csv:()=>Wn(...h())}),Z("span",{class:"hint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all")),u=C=>C.well||!Bt.hidden.has(Nu(C.solved));function h(){let[C,N]=s(),U=t.flatMap(k=>k.curves.filter(u).flatMap($=>{let{solved:V,depths:X,values:J,low:nt,high:Q}=$,W=(ht,ct)=>ht?Jt(ht[ct],k.dimension):null,st=V?[V.operation,V.model]:["",""];return Array.from(X,(ht,ct)=>[ht,ct]).filter(([ht])=>ht>=C&&ht<=N).map(([ht,ct])=>[k.title,ce(k.dimension),...st,Jt(ht,"length"),W(J,ct),W(nt,ct),W(Q,ct)])}));return[["quantity","unit","operation","model",`md, ${ce("length")}`,"value","p05","p95"],U]}function f({md_m:C,to_md_m:N}){let U=Math.max((N??C)-C,.02*e);g([C-.1*U,(N??C)+.1*U]),r.scrollIntoView({block:"nearest"})}function g([C,N]){let[U,k]=[Math.max(Math.min(C,N),i[0]),Math.min(Math.max(C,N),i[1])];k-U>=2&&Ge({depths:U<=i[0]&&k>=i[1]?null:[U,k]})}function x(){let C=pn()?tE:r.clientWidth||1360,N=pn()?nE:eE,U=Math.max(Math.floor((C-Ui-Ml-Sl)/(N+Sl)),1),k=Math.ceil(t.length/Math.min(U,t.length)),$=Math.ceil(t.length/k),V=k===1?640:pn()?370:500;o=Array.from({length:k},(nt,Q)=>p(t.slice(Q*$,(Q+1)*$),C,$,V)),r.replaceChildren(...o.map(nt=>nt.picture));let[X,J]=s();a[0].value=Jt(X,"length").toFixed(1),a[1].value=Jt(J,"length").toFixed(1),l.textContent=ce("length"),c.disabled=Bt.depths===null,B()}function p(C,N,U,k){let[$,V]=s(),X=qt=>Ws+(qt-$)/(V-$)*k,J=Ws+k+iE,nt=Ft("svg",{viewBox:`0 0 ${N} ${J}`,width:N,height:J,role:"img","aria-label":C.map(qt=>qt.title).join(", ")}),Q=Ui+Ml+Sl,W=(N-Q-Sl*(U-1)-2)/U;m(nt,[$,V],X,N,Q);let st={left:Ui,width:Ml,top:Ws,height:k},ht=Ft("svg",{x:0,y:Ws-10,width:N,height:k+18,viewBox:`0 ${Ws-10} ${N} ${k+18}`});ht.append($_(n,st,[$,V],X)),nt.append(ht,Ft("text",{x:Ui+Ml/2,y:16,class:"title middle"},"Hole, string"));let ct=C.map((qt,ke)=>{let oe={left:Q+ke*(W+Sl),width:W,top:Ws,height:k};return{track:qt,box:oe,text:y(nt,qt,oe,[$,V],X)}}),gt=Ft("line",{x1:Ui,x2:N,class:"cursor",visibility:"hidden"}),xt=Ft("line",{x1:Ui,x2:N,class:"chosen",visibility:"hidden"}),Ut=Ft("text",{x:2,class:"flag",visibility:"hidden"}),Lt=Ft("g",{class:"readout"}),Qt=Ft("rect",{x:Ui,width:N-Ui,class:"drag",visibility:"hidden"}),te=Ft("rect",{x:Ui,y:Ws,width:N-Ui,height:k,class:"cover"});return nt.append(Qt,xt,gt,Ut,Lt,te),te.addEventListener("pointermove",qt=>w(qt,nt,ct,[$,V],k)),te.addEventListener("pointerleave",cl),W_({cover:te,band:Qt,picture:nt,head:Ws,height:k,total:J,full:i,view:s,zoom:g}),{picture:nt,y:X,readouts:ct,cursor:gt,chosenLine:xt,flag:Ut,what:Lt}}function m(C,[N,U],k,$,V){let{values:X,step:J}=En(Jt(N,"length"),Jt(U,"length"),12);for(let nt of X){let Q=k(Hn(nt,"length"));C.append(Ft("line",{x1:V,x2:$,y1:Q,y2:Q,class:"grid"}),Ft("text",{x:Ui-8,y:Q+4,class:"tick end"},Mn(nt,J)))}C.append(Ft("text",{x:0,y:16,class:"title"},"MD"),Ft("text",{x:0,y:31,class:"unit"},ce("length")))}function y(C,N,U,[k,$],V){let X=[k,$],J=$-k>QT,nt=N.curves.filter(u).map(xt=>J&&xt.far?{...xt,...xt.far}:xt),Q=N.range;if(!Q){let xt=nt.flatMap(Ut=>[Ut.values,Ut.low,Ut.high].filter(Boolean).map(Lt=>C_(Ut.depths,Lt,X)));Q=kg(Math.min(...xt.map(Ut=>Ut[0])),Math.max(...xt.map(Ut=>Ut[1])),N.zero||N.sides,Hn(1,N.dimension),N.least_span)}let W=xt=>U.left+(xt-Q[0])/(Q[1]-Q[0])*U.width,st=Ft("svg",{x:U.left,y:U.top,width:U.width,height:U.height,viewBox:`${U.left} ${U.top} ${U.width} ${U.height}`}),ht=Bg(Jt(Q[0],N.dimension),Jt(Q[1],N.dimension),U.width);for(let xt of ht.values){let Ut=W(Hn(xt,N.dimension)),Lt=lf(Ut-U.left,U.width);C.append(Ft("line",{x1:Ut,x2:Ut,y1:U.top,y2:U.top+U.height,class:xt===0?"zero":"grid"}),Ft("text",{x:Ut,y:U.top-7,class:`tick ${Lt}`},Mn(xt,ht.step)))}for(let xt of n.hole.filter(Ut=>Ut.kind==="casing"&&Ut.to_m>k&&Ut.to_m<$))st.append(Ft("line",{x1:U.left,x2:U.left+U.width,y1:V(xt.to_m),y2:V(xt.to_m),class:"shoe-depth"}));v(st,U,X,V),N.sides&&_(st,N,X,W,V);for(let xt of nt){let{colour:Ut,dash:Lt,shape:Qt,place:te}=xt.well?{colour:"var(--text)"}:da(n,xt.solved),qt=!xt.well&&yr(n).length>1&&xt.solved.operation!==Bt.operation;xt.low&&xt.high&&st.append(Ft("path",{d:gu(xt.depths,xt.low,xt.high,X,W,V),fill:Ut,class:qt?"band faint":"band"})),st.append(Ft("path",{d:P_(xt.depths,xt.values,X,W,V),stroke:Ut,class:`curve${qt?" faint":""}`,"stroke-dasharray":Lt?.join(" ")})),Qt&&st.append(...S(xt,{colour:Ut,shape:Qt,place:te,faint:qt},X,W,V))}N.touches&&b(st,N,U,X,V);let ct=U.left+U.width/2;C.append(st,Ft("rect",{x:U.left,y:U.top,width:U.width,height:U.height,class:"frame"}),Ft("text",{x:ct,y:16,class:"title middle"},N.title),Ft("text",{x:ct,y:31,class:"unit middle"},ce(N.dimension))),N.sides&&C.append(Ft("text",{x:U.left,y:U.top+U.height+14,class:"side low"},"◂ low side"),Ft("text",{x:U.left+U.width,y:U.top+U.height+14,class:"side high end"},"high side ▸")),N.swings&&J&&C.append(Ft("text",{x:U.left,y:U.top+U.height+14,class:"side"},"joint to joint")),N.touches&&C.append(Ft("text",{x:U.left,y:U.top+U.height+14,class:"side"},"▌ always ",Ft("tspan",{class:"sometimes"},"▌")," at times"));let gt=Ft("text",{x:ct,y:48,class:"readout middle"});return C.append(gt),gt}function S(C,{colour:N,shape:U,place:k,faint:$},[V,X],J,nt){let Q=W=>(W+(k+(C.solved.model==="soft"?1.5:1))/(yr(n).length+1.5))/Z_;return Array.from({length:Z_},(W,st)=>V+Q(st)*(X-V)).map(W=>[W,ea(C.depths,C.values,W)]).filter(([W,st])=>Number.isFinite(st)&&W<=C.depths.at(-1)).map(([W,st])=>Ft("path",{d:U,transform:`translate(${J(st).toFixed(1)} ${nt(W).toFixed(1)})`,fill:C.solved.model==="soft"?"var(--paper)":N,stroke:C.solved.model==="soft"?N:"var(--paper)",class:`marker${$?" faint":""}`}))}function v(C,N,[U,k],$){for(let{level:V,md_m:X,to_md_m:J}of E()){if(X>k||(J??X)<U)continue;let[nt,Q]=[$(X),$(J??X)],W=Math.max(Q-nt,2),st={y:nt,height:W},ht=J!==null;if(ht&&C.append(Ft("rect",{x:N.left,width:N.width,...st,class:`found level-${V}`})),C.append(Ft("rect",{x:N.left+N.width-5,width:5,...st,class:`found-bar level-${V}`})),V!=="error"&&ht)for(let ct=nt+6;ct<Q;ct+=V==="warning"?10:6)C.append(Ft("rect",{x:N.left+N.width-5,width:5,y:ct,height:3,fill:"var(--paper)"}))}}let E=()=>eo(n,Bt.operation).filter(C=>C.md_m!==null).reverse();function w(C,N,U,[k,$],V){let X=N.getBoundingClientRect(),J=N.viewBox.baseVal.width/X.width,nt=(C.clientX-X.left)*J,Q=k+((C.clientY-X.top)*J-Ws)/V*($-k),W=U.find(({box:ct})=>nt>=ct.left&&nt<=ct.left+ct.width),st=(W?.track.curves??[]).filter(u).map(ct=>{let gt=ea(ct.depths,ct.values,Q),xt=ct.well?"well":Uu(n,ct.solved);return{colour:ct.well?"var(--text)":da(n,ct.solved).colour,text:`${xt}: ${Number.isFinite(gt)?Te(gt,W.track.dimension):"–"}`,class:!ct.well&&ct.solved.operation===Bt.operation?"mine":null}}),ht=.006*($-k);for(let ct of E().reverse()){let{level:gt,kind:xt,md_m:Ut,to_md_m:Lt}=ct;if(Q<Ut-ht||Q>(Lt??Ut)+ht)continue;let[Qt,te]=ss[gt];st.push({colour:`var(--${te})`,text:`${Qt}: ${Lp(xt)}`})}if(st.length===0)return cl();Jh(C,[W?.track.title,`MD ${Te(Q,"length",5)}`].filter(Boolean).join(", "),st)}function _(C,N,U,k,$){let V=Ai(n,"dynamic")??Ai(n,"soft"),X=N.curves.find(Q=>Q.solved===V);if(!X||!u(X))return;let J=new Float32Array(X.values.length),nt=Q=>X.values.map(W=>Q(W)?W:0);C.append(Ft("path",{d:gu(X.depths,J,nt(Q=>Q>0),U,k,$),class:"high-side"}),Ft("path",{d:gu(X.depths,nt(Q=>Q<0),J,U,k,$),class:"low-side"}))}function b(C,N,U,k,$){let V=Ai(n,"dynamic"),X=N.curves.find(st=>st.solved===V);if(!X)return;let J=st=>st<.01?0:st<=.99?1:2,nt=0,{depths:Q,values:W}=X;for(let st=1;st<=W.length;st++){if(st<W.length&&J(W[st])===J(W[nt]))continue;let ht=J(W[nt]),[ct,gt]=[$(Q[nt]),$(Q[Math.min(st,W.length-1)])];ht>0&&gt>U.top&&ct<U.top+U.height&&C.append(Ft("rect",{x:U.left,y:ct,width:6,height:Math.max(gt-ct,.7),class:ht===2?"always":"sometimes"})),nt=st}}function B(){let[C,N]=s();for(let{y:U,readouts:k,cursor:$,chosenLine:V,flag:X,what:J}of o){let nt=(W,st)=>{let ht=st!==null&&st>=C&&st<=N;if(W.setAttribute("visibility",ht?"visible":"hidden"),ht)for(let ct of["y1","y2"])W.setAttribute(ct,U(st));return ht};nt(V,Bt.depth);let Q=nt($,Bt.pointer);X.setAttribute("visibility",Q?"visible":"hidden"),X.setAttribute("y",Q?U(Bt.pointer)+4:0),X.textContent=Q?zn(Jt(Bt.pointer,"length"),5):"",J.replaceChildren(...(Q?q_(n,Bt.pointer):[]).map((W,st)=>Ft("text",{x:Ui+Ml/2,y:34+13*st,class:"readout middle small"},W.length>24?`${W.slice(0,23)}…`:W)));for(let{track:W,text:st}of k)st.replaceChildren(...Q?I(W):[])}}function I(C){return C.curves.filter(U=>u(U)&&(U.well||U.solved.operation===Bt.operation)).map((U,k)=>{let $=ea(U.depths,U.values,Bt.pointer),V=U.well?"var(--text)":da(n,U.solved).colour;return Ft("tspan",{fill:V,dx:k?6:0},Number.isFinite($)?zn(Jt($,C.dimension)):"–")})}function P(){let C=n.solved.map($=>{let{colour:V,dash:X,shape:J}=da(n,$),nt=Nu($),Q=Bt.hidden.has(nt),W=Uu(n,$);return Z("button",{type:"button",class:"key","aria-pressed":String(!Q),title:Q?`Show ${W}`:`Hide ${W}`,onclick:()=>{let st=new Set(Bt.hidden);st.delete(nt)||st.add(nt),Ge({hidden:st}),O.querySelector(`[data-curve="${nt}"]`)?.focus()},"data-curve":nt},Ft("svg",{width:30,height:12},Ft("line",{x1:1,x2:29,y1:6,y2:6,stroke:V,class:"curve","stroke-dasharray":X?.join(" ")}),J&&Ft("path",{d:J,transform:"translate(15 6)",fill:$.model==="soft"?"var(--paper)":V,stroke:$.model==="soft"?V:"var(--paper)",class:"marker"})),W)}),N=[...new Set(E().map($=>$.level))].reverse().map($=>Z("span",{class:"key"},Ft("svg",{width:20,height:12},Ft("rect",{width:20,height:12,class:`found level-${$}`}),Ft("rect",{x:15,width:5,height:12,class:`found-bar level-${$}`})),`${ss[$][0].toLowerCase()} here, ${kn(Bt.operation)}`)),U=n.runs.length?[Z("span",{class:"key"},Ft("svg",{width:26,height:10},Ft("rect",{width:26,height:10,fill:"var(--muted)",class:"band"})),"5–95 % of the time")]:[],k=["high","low"].map($=>Z("span",{class:"key"},Ft("svg",{width:14,height:10},Ft("rect",{width:14,height:10,class:`${$}-side`})),`on the ${$} side`));return[...C,...U,...k,...N]}let O=Z("div",{class:"legend"}),z=()=>{O.replaceChildren(...P()),x()};return we("units depths operation hidden",z),we("pointer depth",B),new ResizeObserver(()=>!pn()&&r.clientWidth!==Number(o[0]?.picture.getAttribute("width"))&&x()).observe(r),{element:Z("div",{},O,d,r),redraw:z,full:i,zoomTo:f}}function sE(n){let t=Nl(n);if(!t.length||t[0].level==="note")return null;let e=t.filter(s=>s.level===t[0].level).map(s=>s.solved.operation),i=s=>e.filter(r=>r===s).length;return e.reduce((s,r)=>i(r)>i(s)?r:s)}function rE(n,t){let e=eo(n,t).filter(s=>s.level!=="note"),i=e.length?`${kn(t)}: ${Rl(e)}`:null;return[t,[kn(t),...Sp(e)],i]}function K_(n){let t=yr(n),e=n.runs.at(-1);Object.assign(Bt,{operation:sE(n)??e?.operation??t.at(-1),depth:(n.well.md_m.at(-1)??0)/2});let i={answers:Vp(n),tracks:J_(n)};i.findings=Dp(n,i.tracks.zoomTo),n.runs.length&&(i.history=Jf(n,n.time_plots,!0),i.contact=U_(n)),n.runs.some(f=>f.drill_off)&&(i.bit=Jf(n,n.bit_plots,!1),i.drillOff=O_(n)),n.runs.some(f=>f.spectra.length)&&(i.spectra=G_(n)),n.runs.some(f=>f.bottom)&&(i.bottom=Yh(()=>Je(n)?.bottom,!0)),n.well.md_m.length>1&&(i.scene=z_(n));let s=(f,g,...x)=>Z("section",{id:f},Z("h2",{},g),x),r=f=>n.sheets.filter(g=>g.place===f).map(fa);function o(f){let g=f.history.time_s.length,x=g<f.samples?`${f.samples} samples are drawn as ${g}, the smallest and the largest of each few: peaks keep their height`:`all ${f.samples} samples are drawn`,{frames:p}=f,m=p&&(p.time_s.length<p.kept?`; ${p.time_s.length} of ${p.kept} frames`:`; all ${p.kept} frames`),y=p&&p.md_m.length<p.nodes?`, ${p.md_m.length} of ${p.nodes} nodes`:"";return`${kn(f.operation)}: ${x}${m??""}${y}.`}let a=document.getElementById("page"),l=t.length>1?xr("Operation",t.map(f=>rE(n,f)),Bt.operation,f=>Ge({operation:f,times:null,moment:null})):null;a.append(jh(n.title,Fl(n),()=>Object.values(i).forEach(f=>f.redraw())),s("answer","Answer",i.findings.element,l&&Z("div",{class:"operations"},l),i.answers.element),s("tracks","Along the hole",i.tracks.element));let c=[],d=(f,...g)=>c.push([s(...g),f]);if(i.history&&d(f=>f,"history","In time",i.history.element),i.spectra&&d(f=>f?.spectra.length,"spectra","Spectra",i.spectra.element),i.bit&&d(f=>f?.drill_off,"bit","Bit",i.bit.element,i.drillOff.element),i.bottom){let f=Z("p",{class:"note"},"As the operation left it.");d(g=>g?.bottom,"bottom","Bottom of the hole",i.bottom.element,f)}i.contact&&d(f=>f,"contact","Contact over depth and time",i.contact.element),a.append(...c.map(([f])=>f)),i.scene&&a.append(s("scene","In space",i.scene.element)),a.append(s("results","All numbers",r("results")),...n.runs.length?[s("numerics","Numerics",r("numerics"))]:[],s("inputs","Inputs, defaults included",r("inputs")),Z("footer",{},Z("p",{},`Made by ${n.program}. The tables beside this file hold every digit; this page holds what can be seen. `,n.runs.map(o).join(" ")),Kh()));let u=Zh([...a.querySelectorAll("section")]);a.querySelector("header").after(u.element);let h=()=>{c.forEach(([f,g])=>f.toggleAttribute("hidden",!g(Je(n)))),u.redraw();for(let f of a.querySelectorAll(".operations button"))f.setAttribute("aria-pressed",String(f.dataset.value===Bt.operation))};we("operation",h),h(),Object.values(i).forEach(f=>f.redraw())}var Su=t0();Cp(Su.dimensions,Su.units);(Su.bottoms?jg:K_)(Su);document.documentElement.dataset.ready="";})();

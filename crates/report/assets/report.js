(()=>{var Rx="http://www.w3.org/2000/svg";function Ap(n,t,e){for(let[i,s]of Object.entries(t??{}))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):n.setAttribute(i,s===!0?"":s));for(let i of e.flat(3))i!=null&&n.append(i);return n}function W(n,t,...e){return Ap(document.createElement(n),t,e)}function Pt(n,t,...e){return Ap(document.createElementNS(Rx,n),t,e)}function vr(n,t,e,i){let s=t.map(([r,o,a])=>W("button",{type:"button","aria-pressed":String(r===e),"data-value":r,"aria-label":a,title:a,onclick:l=>{for(let c of s)c.setAttribute("aria-pressed",String(c===l.currentTarget));i(r)}},o));return W("div",{class:"choice",role:"group","aria-label":n},s)}function Fl(n,t,e,i){return W("label",{class:"select"},n,W("select",{onchange:s=>i(s.target.value)},t.map(([s,r])=>W("option",{value:s,selected:s===e},r))))}var Bi={error:["Error","over","M5 1h6l4 4v6l-4 4h-6l-4-4v-6z"],warning:["Warning","near","M8 1.5L15.5 14.5H.5z"],note:["Note","accent","M8 1.5a6.5 6.5 0 1 0 .01 0z"]},xa=Object.keys(Bi),Cx={error:"M5.5 5.5l5 5m0-5l-5 5",warning:"M8 6v4.2m0 1.6v.6",note:"M8 7v4.5m0-7v.6"},Rp=(n,t)=>xa.indexOf(n.level)-xa.indexOf(t.level),Cp=n=>xa.find(t=>n.some(e=>e.level===t))??null;function ya(n){let[t,e,i]=Bi[n];return Pt("svg",{class:"level-mark",viewBox:"0 0 16 16",width:15,height:15,role:"img","aria-label":t},Pt("path",{d:i,fill:`var(--${e})`}),Pt("path",{d:Cx[n],stroke:"var(--paper)","stroke-width":1.8,fill:"none"}))}function Ol(n){return xa.flatMap(t=>{let e=n.filter(i=>i.level===t).length;return e?[`${e} ${Bi[t][0].toLowerCase()}${e>1?"s":""}`]:[]}).join(", ")}var Pp=n=>xa.flatMap(t=>{let e=n.filter(i=>i.level===t).length;return e?[W("span",{class:`count level-${t}`},ya(t),String(e))]:[]});var Ip=[null,[6,4],[1.5,3],[13,4],[3.5,2.5],[6,7],[1.5,6]],Lp=["M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z","M-3.2 -3.2h6.4v6.4h-6.4z","M0 -4.2L4 3.2H-4z","M0 -4.6L4.2 0L0 4.6L-4.2 0z","M0 4.2L4 -3.2H-4z","M-4 -1.2h2.8v-2.8h2.4v2.8h2.8v2.4h-2.8v2.8h-2.4v-2.8h-2.8z","M-4 -2.4L-2.4 -4L0 -1.6L2.4 -4L4 -2.4L1.6 0L4 2.4L2.4 4L0 1.6L-2.4 4L-4 2.4L-1.6 0z"],Mr=n=>Ip[n%Ip.length],Dp=n=>Lp[n%Lp.length];var Ee=n=>getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim(),vs=n=>Ee(`line-${n%7}`);function Px(n){let t=parseInt(n.slice(1),16);return[t>>16,t>>8&255,t&255]}var Ix=Array.from({length:10},(n,t)=>`amount-${t}`),Lx=["low-side-strong","low-side","middle","high-side","high-side-strong"];function Dx(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,o)=>r+s*(n[i+1][o]-r))}var Vu=512;function so(n){let t=(n?Lx:Ix).map(i=>Px(Ee(i))),e=Array.from({length:Vu+1},(i,s)=>Dx(t,s/Vu));return i=>e[Math.round(Math.min(Math.max(i,0),1)*Vu)]}var Bl=new Map,Dt={units:"si",theme:"auto",operation:null,depths:null,times:null,depth:null,moment:null,pointer:null,hidden:new Set};function we(n,t){for(let e of n.split(" "))Bl.has(e)||Bl.set(e,[]),Bl.get(e).push(t)}function ze(n){let t=new Set;for(let[e,i]of Object.entries(n))if(!Object.is(Dt[e],i)){Dt[e]=i;for(let s of Bl.get(e)??[])t.add(s)}for(let e of t)e()}var Hn=n=>n.replaceAll("_"," "),kl=(n,t)=>n.models.find(({name:e})=>e===t.model),Ms=(n,t)=>kl(n,t).long_name,Sr=n=>[...new Set(n.solved.map(t=>t.operation))];function js(n,t){let e=Sr(n),i=n.models.indexOf(kl(n,t)),s=n.models.length>1,r=e.length===1&&s?i:e.indexOf(t.operation);return{colour:vs(r),dash:Mr(s?i:r),hollow:!n.models[i].in_time,shape:e.length>1?Dp(r):null,place:r}}var zl=n=>`${n.model} ${n.operation}`;function Vl(n,t){if(Sr(n).length===1)return Ms(n,t);let e=Hn(t.operation);return n.models.length===1?e:`${e}, ${Ms(n,t)}`}var Qs=n=>n.models.flatMap(({name:t})=>n.solved.filter(e=>e.operation===Dt.operation&&e.model===t)),Np=n=>Qs(n).find(t=>kl(n,t).in_time),Gl=n=>Qs(n).find(t=>!kl(n,t).in_time),Je=n=>n.runs.find(t=>t.operation===Dt.operation);var Up="wholestring.";function Hl(n,t){try{let e=localStorage.getItem(Up+n);return t.includes(e)?e:null}catch{return null}}function Wl(n,t){try{localStorage.setItem(Up+n,t)}catch{}}var Fp=["si","metric","field"],Op={};function Bp(n,t){Op=n,Dt.units=Hl("units",Fp)??t,we("units",()=>Wl("units",Dt.units))}function Xl(n){return Op[n]?.[Fp.indexOf(Dt.units)]??{symbol:"",factor:1}}var re=n=>Xl(n).symbol,qt=(n,t)=>n/Xl(t).factor,zn=(n,t)=>n*Xl(t).factor;function $l(n,t){let e=Xl(t).factor;return Array.from(n,i=>Number.isFinite(i)?i/e:null)}function Tn(n,t=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.abs(n);if(e>=1e9||e<1e-4){let[o,a]=n.toExponential(t-1).split("e");return`${kp(String(Number(o)))}·10${Nx(Number(a))}`}let i=Math.floor(Math.log10(e))+1,s=Math.min(Math.max(t-i,0),6);if(i<=t)return Ss(n.toFixed(s));let r=10**(i-t);return Ss(String(Math.round(n/r)*r))}function Nx(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}var kp=n=>n.replace("-","−");function Ss(n){let[t,e]=n.split("."),[i,s]=Dt.units==="field"?[4,","]:[5," "],r=t.replace("-","").length>=i?t.replace(/\B(?=(\d{3})+$)/g,s):t;return kp(e===void 0?r:`${r}.${e}`)}function ss(n,t=6){let e=Tn(n,t);return/\.\d*0$/.test(e)?e.replace(/\.?0+$/,""):e}var Gu=n=>`${Ss(String(Math.round(qt(n,"length"))))} ${re("length")}`;function Te(n,t,e=4,i=Tn){let s=re(t),r=i(qt(n,t),e);return s===""?r:`${r} ${s}`}var Ux=8,ql=n=>n.solved.flatMap(t=>t.findings.map(e=>({...e,solved:t}))).sort(Rp),va=(n,t)=>ql(n).filter(e=>e.solved.operation===t),ro=n=>va(n,Dt.operation).filter(t=>t.md_m!==null).reverse(),Vp=n=>n.replaceAll("_"," ").replace(/^./,t=>t.toUpperCase());function Fx({md_m:n,to_md_m:t}){if(n===null)return null;let e=Gu(n);return t===null?`at ${e}`:`${e} to ${Gu(t)}`}var Hu=n=>typeof n=="number"?ss(n,4):Te(n.value,n.dimension,4,ss);function zp({value:n,limit:t},e){return n===null||Dt.units===e?null:t===null?Hu(n):`${Hu(n)} against ${Hu(t)}`}function Gp(n,t){let e=W("div",{class:"finding-list"}),i=new Set(n.solved.map(a=>a.operation)).size>1,s=new Set(n.solved.map(a=>a.model)).size>1;function r(a){let{level:l,solved:c,message:u}=a,[d]=Bi[l],h=Fx(a),f=i&&c.operation!==Dt.operation,_=[i&&Hn(c.operation),s&&Ms(n,c)].filter(Boolean).join(", ");return W("li",{class:`finding level-${l}`},W("span",{class:"level"},ya(l),` ${d}`),W("span",{class:"message"},_&&(f?W("button",{type:"button",class:"link",title:"Show this operation",onclick:()=>ze({operation:c.operation,times:null,moment:null})},_):W("strong",{},_)),_&&": ",u,W("span",{class:"note"},zp(a,n.message_units)&&` ${zp(a,n.message_units)}`,h&&" ",h&&W("button",{type:"button",class:"link",title:"Show these depths along the hole",onclick:()=>{ze({operation:c.operation,times:null,moment:null}),t(a)}},h))))}function o(){let a=ql(n),l=d=>d.level==="error"||d.level==="warning"&&d.solved.operation===Dt.operation,c=a.length>Ux?a.filter(d=>!l(d)):[],u=e.querySelector("details")?.open??!1;e.replaceChildren(...a.length?[W("ul",{class:"findings"},a.filter(d=>!c.includes(d)).map(r)),c.length>0&&W("details",{class:"prints",open:u},W("summary",{},`${c.length} more: ${Ol(c)}`),W("ul",{class:"findings"},c.map(r)))].filter(Boolean):[])}return we("units operation",o),{element:e,redraw:o}}function Wu(n,t,e){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e}));W("a",{href:i,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(i),6e4)}var Ox=n=>n.toLowerCase().replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-|-$/g,"")||"figure";function Bx(n){if(n==null||Number.isNaN(n))return"";if(typeof n=="number")return String(Number(n.toPrecision(9)));let t=/^[=+@\t\r]|^-(?![\d.])/.test(n)?`'${n}`:n;return/[",\n\r]/.test(t)?`"${t.replaceAll('"','""')}"`:t}var Wn=(n,t)=>[n,...t].map(e=>Array.from(e,Bx).join(",")).join(`\r
`)+`\r
`,kx=["fill","fill-opacity","stroke","stroke-width","stroke-dasharray","stroke-linejoin","opacity","font-family","font-size","font-weight","text-anchor","paint-order"];function oo(n){let t=n.map(a=>a.viewBox.baseVal),e=Math.max(...t.map(a=>a.width)),i=t.reduce((a,l)=>a+l.height,0),s=0,r=getComputedStyle(document.documentElement).getPropertyValue("--paper"),o=n.map((a,l)=>{let c=a.cloneNode(!0),u=[a,...a.querySelectorAll("*")];[c,...c.querySelectorAll("*")].forEach((f,_)=>{let y=getComputedStyle(u[_]);if(y.visibility==="hidden"||y.display==="none")return f.setAttribute("display","none");f.removeAttribute("style");for(let m of kx){let p=y.getPropertyValue(m);p&&f.setAttribute(m,p)}});let{width:d,height:h}=t[l];for(let[f,_]of Object.entries({x:0,y:s,width:d,height:h}))c.setAttribute(f,_);return s+=h,new XMLSerializer().serializeToString(c)});return`<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="${e}" height="${i}" viewBox="0 0 ${e} ${i}">
<rect width="100%" height="100%" fill="${r}"/>
${o.join(`
`)}
</svg>
`}function Mn(n,{svg:t,csv:e,png:i}){let s=()=>Ox(typeof n=="function"?n():n),r=(o,a)=>W("button",{type:"button",class:"download",title:`Download as ${o}`,"data-download":o.toLowerCase(),onclick:a},o);return W("span",{class:"downloads noprint"},t&&r("SVG",()=>Wu(`${s()}.svg`,t(),"image/svg+xml")),i&&r("PNG",()=>i().toBlob(o=>Wu(`${s()}.png`,o))),e&&r("CSV",()=>Wu(`${s()}.csv`,e(),"text/csv")))}var Wp=n=>Number.isInteger(n)&&Math.abs(n)<1e12?Ss(String(n)):ss(n);function bs(n,t,e=t?Tn:ss){return n===null||n===""?"–":typeof n=="string"?n:n.href?n.text:typeof n=="number"?Wp(n):n.values?zx(n):Te(n.value,n.dimension,t??6,e)}function zx({values:n,dimension:t}){return`${n.map(i=>ss(qt(i,t))).join(", ")} ${re(t)}`.trim()}function Xp(n){return n?.value===void 0?bs(n):ss(qt(n.value,n.dimension))}function $p(n,t,e){if(n===null||typeof n!="object")return bs(n);let i=o=>Math.abs(o)<1e-6*t?0:o,s=i(qt(n.value,n.dimension)),r=n.dimension==="ratio"&&Number.isInteger(s)?Wp(s):Tn(s,e);return n.std===void 0?r:`${r} ± ${Tn(i(qt(n.std,n.dimension)),2)}`}function Yl(n){let t=new Set(n.filter(e=>e!==null&&typeof e=="object").map(e=>e.dimension));return t.size===1?[...t][0]:null}var qp=n=>n&&re(n)!==""?W("span",{class:"unit"},` ${re(n)}`):null,Yp=n=>typeof n=="string"||!!n?.href,Zp=n=>Math.max(0,...n.map(t=>t?.dimension?Math.abs(qt(t.value,t.dimension)):0));function Vx(n){return n.rows.map(([t,...e])=>W("tr",{},W("th",{scope:"row"},t,qp(Yl(e))),e.map(i=>W("td",{class:"number"},$p(i,Zp(e),5)))))}function Gx(n){let t=({value:s,dimension:r,std:o})=>{let a=qt(s,r);return o===void 0&&Math.abs(a-Math.round(a))<=1e-9*Math.abs(a)},e=n.filter(s=>s?.dimension),i=Zp(e);return e.every(t)?Xp:s=>$p(s,i,4)}function Hp(n,t){let e=(n.rows[0]??[]).map((i,s)=>t(n.rows.map(r=>r[s])));return n.rows.map(i=>W("tr",{},i.map((s,r)=>W("td",{class:Yp(s)?null:"number"},s?.href?W("a",{href:s.href},s.text):e[r](s)))))}function Hx(n){return n.rows.map(([t,e])=>W("tr",{},W("th",{scope:"row"},t),W("td",{},bs(e))))}function Wx(n,t){let e=a=>a===null||typeof a!="object"?a:a.values||a.href?bs(a):qt(a.value,a.dimension),i=(a,l)=>l&&re(l)?`${a}, ${re(l)}`:a,s=a=>a.some(l=>l?.std!==void 0),r=a=>a?.std===void 0?null:qt(a.std,a.dimension);if(t){let a=n.heads.map((u,d)=>d>0&&s(n.rows.map(h=>h[d]))),l=n.heads.flatMap((u,d)=>a[d]?[u,`${u}, deviation`]:[u]),c=n.rows.map(([u,...d])=>[i(u,Yl(d)),...d.flatMap((h,f)=>a[f+1]?[e(h),r(h)]:[e(h)])]);return[l,c]}if(!n.heads.length){let a=l=>l?.dimension?re(l.dimension):"";return[["key","value","unit"],n.rows.map(([l,c])=>[l,e(c),a(c)])]}let o=n.heads.map((a,l)=>{let c=n.rows.map(u=>u[l]);return{head:i(a,Yl(c)),wide:s(c)}});return[o.flatMap(({head:a,wide:l})=>l?[a,`${a}, deviation`]:[a]),n.rows.map(a=>a.flatMap((l,c)=>o[c].wide?[e(l),r(l)]:[e(l)]))]}var ao=n=>Mn(n.title,{csv:()=>Wn(...Wx(n,["results","numerics"].includes(n.place)))});function rs(n){let t=W("tbody",{}),e=W("thead",{}),i=n.place==="cases",s=n.place!=="inputs"&&!i,r=()=>s?Vx(n):i?Hp(n,Gx):n.heads.length?Hp(n,()=>Xp):Hx(n),o=()=>{t.replaceChildren(...r());let u=d=>s?null:qp(Yl(n.rows.map(h=>h[d])));n.heads.length&&e.replaceChildren(W("tr",{},n.heads.map((d,h)=>{let f=i&&n.rows.every(_=>Yp(_[h]));return W("th",{scope:"col",class:f?"words":null},d,u(h))})))};we("units",o),o();let a=ao(n),l=W("div",{class:"scrolls"},W("table",{class:n.heads.length?"grid":"keys"},e,t));if(i)return W("div",{class:"page-table cases"},l);if(s)return W("div",{class:"page-table"},W("h3",{},n.title,a),l);let c=n.rows.length>24;return W("details",{class:`page-table prints${n.heads.length>4?" wide":""}${c?" long":""}`,open:!c},W("summary",{},n.title,c?` (${n.rows.length} rows)`:""),l,a)}function lo(n){let t=W("dl",{class:"facts"}),e=()=>t.replaceChildren(...n.facts.map(({label:i,value:s})=>W("div",{},W("dt",{},i),W("dd",{},bs(s,s?.dimension==="length"?5:4,ss)))));return we("units",e),e(),t}function Xx(n){return n>1?["over","over the limit"]:n>.8?["near","near the limit"]:["within","within the limit"]}function $x(n,t){let e=t.length===1?"see the finding above":`see the ${t.length} findings above`;return W("p",{class:`flag level-${n}`},ya(n),W("strong",{},` ${Bi[n][0]}`),`: ${e}`)}var Jp={part:.01,of:["force","torque"]};function Xu(n,t){if(!Jp.of.includes(n?.dimension))return n;let e=t.time_plots.filter(i=>i.dimension===n.dimension).map(i=>i.min_span);return Math.abs(n.value)<Jp.part*Math.max(...e)?{...n,value:0}:n}function qx(n,t,e,i){let s=i.filter(c=>t.finding_words.some(u=>c.kind.includes(u))),r=Cp(s),o=t.value?.dimension,a=[W("h3",{},t.label),W("p",{class:"number"},bs(Xu(t.value,n),o==="ratio"||o==="percent"?3:4))];t.largest!==null&&o&&a.push(W("p",{class:"note"},`mean; at most ${Te(Xu({value:t.largest,dimension:o},n).value,o)}`));for(let{label:c,value:u}of t.more)a.push(W("p",{class:"note"},`${bs(u,4)} ${c}`));e?.result?.value?.dimension===o&&o&&a.push(W("p",{class:"note"},`${e.name} ${bs(Xu(e.result.value,n),4)}`)),r&&a.push($x(r,s));let l=t.compared??t.largest??t.value?.value;if(t.limit!==null&&Number.isFinite(l)){let c=l/t.limit,u=r==="error"||r==="warning",[d,h]=u&&c<=.8?["","of the limit"]:Xx(c);a.push(W("div",{class:`limit ${d}`},W("div",{class:"bar"},W("div",{class:"used",style:`width:${Math.min(Math.max(c,0),1)*100}%`})),W("p",{class:"note"},W("strong",{},`${Math.round(c*100)} %${u&&c<=.8?"":","} ${h}`),W("br"),`${t.limit_label} ${o==="percent"||o==="ratio"?"":Te(t.limit,o)}`)))}else a.push(W("p",{class:"note"},t.limit_label));return W("div",{class:`card key-result${r?` has-${r}`:""}`},a)}function Kp(n){let t=W("div",{}),e=()=>{let i=Qs(n),[s]=i,r=Gl(n),o=l=>r&&r!==s&&{name:Ms(n,r),result:r.key_results.find(c=>c.label===l.label)},a=i.filter(l=>l.message).map(l=>W("p",{class:"warning"},`${Ms(n,l)}: ${l.message}`));t.replaceChildren(...a,W("div",{class:"key-results"},s.key_results.map(l=>qx(n,l,o(l),va(n,Dt.operation)))))};return we("units operation",e),{element:t,redraw:e}}function co(n){let t=n.map(s=>[s,W("a",{href:`#${s.id}`},s.querySelector("h2").firstChild.textContent)]),e=W("nav",{class:"contents noprint","aria-label":"Contents"},t.map(([,s])=>s)),i=()=>t.forEach(([s,r])=>r.toggleAttribute("hidden",s.hidden));return i(),{element:e,redraw:i}}var tr=W("div",{class:"tip noprint",role:"status",hidden:!0});function Zl(n,t,e){tr.isConnected||document.body.append(tr),tr.replaceChildren(W("strong",{},t),...e.map(({colour:a,text:l,class:c})=>W("div",{class:c},a&&W("span",{class:"swatch",style:`background:${a}`}),l))),tr.hidden=!1;let{width:i,height:s}=tr.getBoundingClientRect(),r=n.clientX+16+i>innerWidth?n.clientX-16-i:n.clientX+16,o=Math.min(n.clientY+12,innerHeight-s-4);tr.style.left=`${Math.max(r,4)}px`,tr.style.top=`${Math.max(o,4)}px`}var Ma=()=>tr.hidden=!0;function Yx(n){let t=n.split(" ").map(Number);return Array.from({length:Math.floor(t.length/3)},(e,i)=>{let[s,r,o]=t.slice(3*i,3*i+3);return{x:s,y:r,row:o}})}function Jl(n,t,e=null){let i=W("div",{class:"figure-holder"}),s=new Set;function r(c){let u=d=>d.dataset.keys.split(" ").filter(Boolean);for(let d of c.querySelectorAll(".series"))d.toggleAttribute("hidden",u(d).some(h=>s.has(h)));for(let d of c.querySelectorAll(".legend-key")){let h=s.has(d.dataset.keys);d.setAttribute("aria-pressed",String(!h)),d.classList.toggle("off",h)}}function o(c){for(let u of c.querySelectorAll(".legend-key")){if(![...c.querySelectorAll(".series")].some(_=>_.dataset.keys.split(" ").includes(u.dataset.keys)))continue;let h=()=>{s.delete(u.dataset.keys)||s.add(u.dataset.keys),r(c)},f={tabindex:0,role:"button","aria-label":`Show or hide ${u.textContent.trim()}`};for(let[_,y]of Object.entries(f))u.setAttribute(_,y);u.addEventListener("click",h),u.addEventListener("keydown",_=>{_.key!=="Enter"&&_.key!==" "||(_.preventDefault(),h())})}if(e)for(let u of c.querySelectorAll(".spots"))u.append(...Yx(u.dataset.spots).map(a));r(c)}function a({x:c,y:u,row:d}){let h=document.createElementNS("http://www.w3.org/2000/svg","circle");for(let[m,p]of Object.entries({class:"spot",cx:c,cy:u,r:4.5}))h.setAttribute(m,p);let{title:f,href:_}=e(d);if(h.setAttribute("aria-label",f),_){h.setAttribute("role","link"),h.setAttribute("tabindex",0),h.classList.add("leads");let m=()=>location.assign(_);h.addEventListener("click",m),h.addEventListener("keydown",p=>p.key==="Enter"&&m())}let y=m=>{let{title:p,rows:x}=e(d),M=h.getBoundingClientRect();Zl({clientX:m.clientX??M.right,clientY:m.clientY??M.bottom},p,x)};for(let m of["pointerenter","pointermove","focus"])h.addEventListener(m,y);for(let m of["pointerleave","blur"])h.addEventListener(m,Ma);return h}function l(){let u=document.getElementById(`${n}-${Dt.units}`)?.content.cloneNode(!0);i.replaceChildren(...u?.firstElementChild?[u]:[t]);let d=i.querySelector("svg");d&&o(d)}return we("units",l),l(),{element:i,file:()=>oo([...i.querySelectorAll("svg")]),there:()=>i.querySelector("svg")!==null}}var ho=()=>W("details",{},W("summary",{},"Plots by uPlot, 3D by three.js: their licences (MIT)"),W("pre",{},document.getElementById("licences").content.textContent));var jp=matchMedia("(prefers-color-scheme: dark)"),$u=!1,fn=()=>$u,Zx=()=>!$u&&(Dt.theme==="dark"||Dt.theme==="auto"&&jp.matches);function Qp(n){Dt.theme=Hl("theme",["auto","light","dark"])??Dt.theme;let t=()=>{document.documentElement.dataset.theme=Zx()?"dark":"light"},e=()=>{t(),n()};jp.addEventListener("change",e);let i=s=>()=>{$u=s;for(let r of document.querySelectorAll("details.prints"))s?(r.dataset.was=r.open?"open":"",r.open=!0):r.open=r.dataset.was==="open";e()};return addEventListener("beforeprint",i(!0)),addEventListener("afterprint",i(!1)),t(),s=>{ze({theme:s}),Wl("theme",s),e()}}function uo(n,t,e){let i=Qp(e);return W("header",{},W("div",{class:"title-line"},W("h1",{},n),W("div",{class:"controls noprint"},vr("Units",[["si","SI"],["metric","Metric"],["field","US field"]],Dt.units,s=>ze({units:s})),vr("Colours",[["auto","Auto"],["light","Light"],["dark","Dark"]],Dt.theme,i),W("button",{type:"button",onclick:()=>print()},"Print"))),t)}var Kl=(n,t,...e)=>W("section",{id:n},W("h2",{},t),e);function qu(n,t,e,...i){let{element:s,file:r,there:o}=Jl(e,"Nothing was solved.");return Kl(n,[t,Mn(t,{svg:o()?r:null})],s,i)}var Jx=n=>n.place==="cases"?[W("h3",{},n.title,ao(n)),rs(n)]:rs(n),Kx=n=>W("p",{class:"note"},n),jx={toolface:"Tool face",weight:"Weight on bit",inclination:"Inclination"};function tm(n){let t=n.page_tables.filter(o=>o.place!=="inputs"),e=n.page_tables.filter(o=>o.place==="inputs"),[i,...s]=t,r=document.getElementById("page");r.append(uo(n.title,lo(n),()=>{}),...n.message?[W("p",{class:"warning"},n.message)]:[],qu("views","The assembly in its hole","views",Kx("The wall is the two lines. A side force of the bit towards the high side builds inclination, one to the right turns the hole to the right. Directions are as one looks down the hole.")),Kl("contacts",["Contacts",ao(i)],rs(i)),qu("bending","Bending","bending"),...n.sweeps.map(([o])=>qu(o,jx[o]??o,o)),Kl("results","Numbers",s.flatMap(Jx)),...e.length?[Kl("inputs","Inputs, defaults included",e.map(rs))]:[],W("footer",{},W("p",{},`Made by ${n.program}. The tables beside this file hold every digit.`),ho())),r.querySelector("header").after(co([...r.querySelectorAll("section:has(h2)")]).element)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},dr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Lm=0,bd=1,Dm=2;var il=1,Nm=2,Vo=3,hs=0,oi=1,li=2,Ir=0,Go=1,wd=2,Td=3,Ed=4,Um=5;var Lr=100,Fm=101,Om=102,Bm=103,km=104,zm=200,Vm=201,Gm=202,Hm=203,Ad=204,Rd=205,Wm=206,Xm=207,$m=208,qm=209,Ym=210,Zm=211,Jm=212,Km=213,jm=214,Tc=0,Ec=1,Ac=2,Io=3,Rc=4,Cc=5,Pc=6,Ic=7,oh=0,Qm=1,tg=2,us=0,Cd=1,Pd=2,Id=3,Ld=4,Dd=5,Nd=6,Ud=7;var Fd=300,Dr=301,Ho=302,ah=303,lh=304,Lc=1e3,as=1001,Dc=1002,On=1003,eg=1004;var sl=1005;var si=1006,ch=1007;var Us=1008;var ci=1009,Od=1010,Bd=1011,Wo=1012,hh=1013,Hi=1014,Wi=1015,Xi=1016,uh=1017,dh=1018,Nr=1020,kd=35902,zd=35899,Vd=1021,Gd=1022,$i=1023,Is=1026,Fs=1027,Hd=1028,fh=1029,fr=1030,ph=1031;var mh=1033,rl=33776,ol=33777,al=33778,ll=33779,gh=35840,_h=35841,xh=35842,yh=35843,vh=36196,Mh=37492,Sh=37496,bh=37488,wh=37489,cl=37490,Th=37491,Eh=37808,Ah=37809,Rh=37810,Ch=37811,Ph=37812,Ih=37813,Lh=37814,Dh=37815,Nh=37816,Uh=37817,Fh=37818,Oh=37819,Bh=37820,kh=37821,zh=36492,Vh=36494,Gh=36495,Hh=36283,Wh=36284,hl=36285,Xh=36286;var Da=2300,Nc=2301,bc=2302,gd=2303,_d=2400,xd=2401,yd=2402;var ng=3200;var $h=0,ig=1,Os="",ei="srgb",Na="srgb-linear",Ua="linear",Ne="srgb";var wc=7680;var sg=519,rg=512,og=513,ag=514,Wd=515,lg=516,cg=517,Xd=518,$d=519,qd=35044;var Yd="300 es",Ri=2e3,Lo=2001;function Qx(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function ty(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Fa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function hg(){let n=Fa("canvas");return n.style.display="block",n}var em={},Do=null;function Oa(...n){let t="THREE."+n.shift();Do?Do("log",t,...n):console.log(t,...n)}function ug(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Kt(...n){n=ug(n);let t="THREE."+n.shift();if(Do)Do("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ee(...n){n=ug(n);let t="THREE."+n.shift();if(Do)Do("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Pa(...n){let t=n.join(" ");t in em||(em[t]=!0,Kt(...n))}function dg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var fg={[Tc]:Tc,[Ac]:Pc,[Rc]:Rc,[Io]:Cc,[Ec]:Ec,[Pc]:Ac,[Ic]:Ic,[Cc]:Io},Gi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Xn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],nm=1234567,Ia=Math.PI/180,No=180/Math.PI;function pr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xn[n&255]+Xn[n>>8&255]+Xn[n>>16&255]+Xn[n>>24&255]+"-"+Xn[t&255]+Xn[t>>8&255]+"-"+Xn[t>>16&15|64]+Xn[t>>24&255]+"-"+Xn[e&63|128]+Xn[e>>8&255]+"-"+Xn[e>>16&255]+Xn[e>>24&255]+Xn[i&255]+Xn[i>>8&255]+Xn[i>>16&255]+Xn[i>>24&255]).toLowerCase()}function xe(n,t,e){return Math.max(t,Math.min(e,n))}function Zd(n,t){return(n%t+t)%t}function ey(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function ny(n,t,e){return n!==t?(e-n)/(t-n):0}function La(n,t,e){return(1-e)*n+e*t}function iy(n,t,e,i){return La(n,t,1-Math.exp(-e*i))}function sy(n,t=1){return t-Math.abs(Zd(n,t*2)-t)}function ry(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function oy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function ay(n,t){return n+Math.floor(Math.random()*(t-n+1))}function ly(n,t){return n+Math.random()*(t-n)}function cy(n){return n*(.5-Math.random())}function hy(n){n!==void 0&&(nm=n);let t=nm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function uy(n){return n*Ia}function dy(n){return n*No}function fy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function py(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Jd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function my(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),d=r((t-i)/2),h=o((t-i)/2),f=r((i-t)/2),_=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*_,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*_,a*c);break;case"ZYZ":n.set(l*_,l*f,a*u,a*c);break;default:Kt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function qh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Kd(n,t){if(t.constructor===Float32Array)return n;let e=qh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function jd(n,t){if(t.constructor===Float32Array)return n;let e=qh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Qd={DEG2RAD:Ia,RAD2DEG:No,generateUUID:pr,clamp:xe,euclideanModulo:Zd,mapLinear:ey,inverseLerp:ny,lerp:La,damp:iy,pingpong:sy,smoothstep:ry,smootherstep:oy,randInt:ay,randFloat:ly,randFloatSpread:cy,seededRandom:hy,degToRad:uy,radToDeg:dy,isPowerOfTwo:fy,ceilPowerOfTwo:py,floorPowerOfTwo:Jd,setQuaternionFromProperEuler:my,normalize:jd,denormalize:Kd},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},yi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],_=r[o+2],y=r[o+3];if(d!==y||l!==h||c!==f||u!==_){let m=l*h+c*f+u*_+d*y;m<0&&(h=-h,f=-f,_=-_,y=-y,m=-m);let p=1-a;if(m<.9995){let x=Math.acos(m),M=Math.sin(x);p=Math.sin(p*x)/M,a=Math.sin(a*x)/M,l=l*p+h*a,c=c*p+f*a,u=u*p+_*a,d=d*p+y*a}else{l=l*p+h*a,c=c*p+f*a,u=u*p+_*a,d=d*p+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=x,c*=x,u*=x,d*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],_=r[o+3];return t[e]=a*_+u*d+l*f-c*h,t[e+1]=l*_+u*h+c*d-a*f,t[e+2]=c*_+u*f+a*h-l*d,t[e+3]=u*_-a*d-l*h-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*_,this._y=c*f*d-h*u*_,this._z=c*u*_+h*f*d,this._w=c*u*d-h*f*_;break;case"YXZ":this._x=h*u*d+c*f*_,this._y=c*f*d-h*u*_,this._z=c*u*_-h*f*d,this._w=c*u*d+h*f*_;break;case"ZXY":this._x=h*u*d-c*f*_,this._y=c*f*d+h*u*_,this._z=c*u*_+h*f*d,this._w=c*u*d-h*f*_;break;case"ZYX":this._x=h*u*d-c*f*_,this._y=c*f*d+h*u*_,this._z=c*u*_-h*f*d,this._w=c*u*d+h*f*_;break;case"YZX":this._x=h*u*d+c*f*_,this._y=c*f*d+h*u*_,this._z=c*u*_-h*f*d,this._w=c*u*d-h*f*_;break;case"XZY":this._x=h*u*d-c*f*_,this._y=c*f*d-h*u*_,this._z=c*u*_+h*f*d,this._w=c*u*d+h*f*_;break;default:Kt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],d=e[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(xe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(im.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(im.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Yu.copy(this).projectOnVector(t),this.sub(Yu)}reflect(t){return this.sub(Yu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(xe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Yu=new q,im=new yi,ae=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],_=i[8],y=s[0],m=s[3],p=s[6],x=s[1],M=s[4],v=s[7],T=s[2],w=s[5],g=s[8];return r[0]=o*y+a*x+l*T,r[3]=o*m+a*M+l*w,r[6]=o*p+a*v+l*g,r[1]=c*y+u*x+d*T,r[4]=c*m+u*M+d*w,r[7]=c*p+u*v+d*g,r[2]=h*y+f*x+_*T,r[5]=h*m+f*M+_*w,r[8]=h*p+f*v+_*g,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,_=e*d+i*h+s*f;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/_;return t[0]=d*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=h*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Pa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Zu.makeScale(t,e)),this}rotate(t){return Pa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Zu.makeRotation(-t)),this}translate(t,e){return Pa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Zu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Zu=new ae,sm=new ae().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rm=new ae().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function gy(){let n={enabled:!0,workingColorSpace:Na,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ne&&(s.r=Ps(s.r),s.g=Ps(s.g),s.b=Ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ne&&(s.r=Po(s.r),s.g=Po(s.g),s.b=Po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Os?Ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Na]:{primaries:t,whitePoint:i,transfer:Ua,toXYZ:sm,fromXYZ:rm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ei},outputColorSpaceConfig:{drawingBufferColorSpace:ei}},[ei]:{primaries:t,whitePoint:i,transfer:Ne,toXYZ:sm,fromXYZ:rm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ei}}}),n}var Se=gy();function Ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Po(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var fo,Uc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{fo===void 0&&(fo=Fa("canvas")),fo.width=t.width,fo.height=t.height;let s=fo.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=fo}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Fa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ps(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Ps(e[i]/255)*255):e[i]=Ps(e[i]);return{data:e,width:t.width,height:t.height}}else return Kt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},_y=0,Uo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:_y++}),this.uuid=pr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ju(s[o].image)):r.push(Ju(s[o]))}else r=Ju(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Ju(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Uc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Kt("Texture: Unable to serialize Texture."),{})}var xy=0,Ku=new q,ri=class n extends Gi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=as,s=as,r=si,o=Us,a=$i,l=ci,c=n.DEFAULT_ANISOTROPY,u=Os){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:xy++}),this.uuid=pr(),this.name="",this.source=new Uo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ae,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ku).x}get height(){return this.source.getSize(Ku).y}get depth(){return this.source.getSize(Ku).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Kt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Fd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Lc:t.x=t.x-Math.floor(t.x);break;case as:t.x=t.x<0?0:1;break;case Dc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Lc:t.y=t.y-Math.floor(t.y);break;case as:t.y=t.y<0?0:1;break;case Dc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=Fd;ri.DEFAULT_ANISOTROPY=1;var en=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],_=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-y)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+y)<.1&&Math.abs(_+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,v=(f+1)/2,T=(p+1)/2,w=(u+h)/4,g=(d+y)/4,b=(_+m)/4;return M>v&&M>T?M<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(M),s=w/i,r=g/i):v>T?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=w/s,r=b/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=g/r,s=b/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-_)*(m-_)+(d-y)*(d-y)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(m-_)/x,this.y=(d-y)/x,this.z=(h-u)/x,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=xe(this.x,t.x,e.x),this.y=xe(this.y,t.y,e.y),this.z=xe(this.z,t.z,e.z),this.w=xe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=xe(this.x,t,e),this.y=xe(this.y,t,e),this.z=xe(this.z,t,e),this.w=xe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fc=class extends Gi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:si,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new en(0,0,t,e),this.scissorTest=!1,this.viewport=new en(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:si,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Uo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends Fc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Ba=class extends ri{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Oc=class extends ri{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Xe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,d,h,f,_,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,d,h,f,_,y,m)}set(t,e,i,s,r,o,a,l,c,u,d,h,f,_,y,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=d,p[14]=h,p[3]=f,p[7]=_,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/po.setFromMatrixColumn(t,0).length(),r=1/po.setFromMatrixColumn(t,1).length(),o=1/po.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let h=o*u,f=o*d,_=a*u,y=a*d;e[0]=l*u,e[4]=-l*d,e[8]=c,e[1]=f+_*c,e[5]=h-y*c,e[9]=-a*l,e[2]=y-h*c,e[6]=_+f*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,f=l*d,_=c*u,y=c*d;e[0]=h+y*a,e[4]=_*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*u,e[9]=-a,e[2]=f*a-_,e[6]=y+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,f=l*d,_=c*u,y=c*d;e[0]=h-y*a,e[4]=-o*d,e[8]=_+f*a,e[1]=f+_*a,e[5]=o*u,e[9]=y-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,f=o*d,_=a*u,y=a*d;e[0]=l*u,e[4]=_*c-f,e[8]=h*c+y,e[1]=l*d,e[5]=y*c+h,e[9]=f*c-_,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,f=o*c,_=a*l,y=a*c;e[0]=l*u,e[4]=y-h*d,e[8]=_*d+f,e[1]=d,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*d+_,e[10]=h-y*d}else if(t.order==="XZY"){let h=o*l,f=o*c,_=a*l,y=a*c;e[0]=l*u,e[4]=-d,e[8]=c*u,e[1]=h*d+y,e[5]=o*u,e[9]=f*d-_,e[2]=_*d-f,e[6]=a*u,e[10]=y*d+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(yy,t,vy)}lookAt(t,e,i){let s=this.elements;return gi.subVectors(t,e),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),er.crossVectors(i,gi),er.lengthSq()===0&&(Math.abs(i.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),er.crossVectors(i,gi)),er.normalize(),jl.crossVectors(gi,er),s[0]=er.x,s[4]=jl.x,s[8]=gi.x,s[1]=er.y,s[5]=jl.y,s[9]=gi.y,s[2]=er.z,s[6]=jl.z,s[10]=gi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],_=i[2],y=i[6],m=i[10],p=i[14],x=i[3],M=i[7],v=i[11],T=i[15],w=s[0],g=s[4],b=s[8],P=s[12],I=s[1],C=s[5],U=s[9],O=s[13],L=s[2],B=s[6],$=s[10],V=s[14],J=s[3],G=s[7],Y=s[11],et=s[15];return r[0]=o*w+a*I+l*L+c*J,r[4]=o*g+a*C+l*B+c*G,r[8]=o*b+a*U+l*$+c*Y,r[12]=o*P+a*O+l*V+c*et,r[1]=u*w+d*I+h*L+f*J,r[5]=u*g+d*C+h*B+f*G,r[9]=u*b+d*U+h*$+f*Y,r[13]=u*P+d*O+h*V+f*et,r[2]=_*w+y*I+m*L+p*J,r[6]=_*g+y*C+m*B+p*G,r[10]=_*b+y*U+m*$+p*Y,r[14]=_*P+y*O+m*V+p*et,r[3]=x*w+M*I+v*L+T*J,r[7]=x*g+M*C+v*B+T*G,r[11]=x*b+M*U+v*$+T*Y,r[15]=x*P+M*O+v*V+T*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],d=t[6],h=t[10],f=t[14],_=t[3],y=t[7],m=t[11],p=t[15],x=l*f-c*h,M=a*f-c*d,v=a*h-l*d,T=o*f-c*u,w=o*h-l*u,g=o*d-a*u;return e*(y*x-m*M+p*v)-i*(_*x-m*T+p*w)+s*(_*M-y*T+p*g)-r*(_*v-y*w+m*g)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=t[9],h=t[10],f=t[11],_=t[12],y=t[13],m=t[14],p=t[15],x=e*a-i*o,M=e*l-s*o,v=e*c-r*o,T=i*l-s*a,w=i*c-r*a,g=s*c-r*l,b=u*y-d*_,P=u*m-h*_,I=u*p-f*_,C=d*m-h*y,U=d*p-f*y,O=h*p-f*m,L=x*O-M*U+v*C+T*I-w*P+g*b;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/L;return t[0]=(a*O-l*U+c*C)*B,t[1]=(s*U-i*O-r*C)*B,t[2]=(y*g-m*w+p*T)*B,t[3]=(h*w-d*g-f*T)*B,t[4]=(l*I-o*O-c*P)*B,t[5]=(e*O-s*I+r*P)*B,t[6]=(m*v-_*g-p*M)*B,t[7]=(u*g-h*v+f*M)*B,t[8]=(o*U-a*I+c*b)*B,t[9]=(i*I-e*U-r*b)*B,t[10]=(_*w-y*v+p*x)*B,t[11]=(d*v-u*w-f*x)*B,t[12]=(a*P-o*C-l*b)*B,t[13]=(e*C-i*P+s*b)*B,t[14]=(y*M-_*T-m*x)*B,t[15]=(u*T-d*M+h*x)*B,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,_=r*d,y=o*u,m=o*d,p=a*d,x=l*c,M=l*u,v=l*d,T=i.x,w=i.y,g=i.z;return s[0]=(1-(y+p))*T,s[1]=(f+v)*T,s[2]=(_-M)*T,s[3]=0,s[4]=(f-v)*w,s[5]=(1-(h+p))*w,s[6]=(m+x)*w,s[7]=0,s[8]=(_+M)*g,s[9]=(m-x)*g,s[10]=(1-(h+y))*g,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=po.set(s[0],s[1],s[2]).length(),a=po.set(s[4],s[5],s[6]).length(),l=po.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ki.copy(this);let c=1/o,u=1/a,d=1/l;return ki.elements[0]*=c,ki.elements[1]*=c,ki.elements[2]*=c,ki.elements[4]*=u,ki.elements[5]*=u,ki.elements[6]*=u,ki.elements[8]*=d,ki.elements[9]*=d,ki.elements[10]*=d,e.setFromRotationMatrix(ki),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2*r/(e-t),d=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s),_,y;if(l)_=r/(o-r),y=o*r/(o-r);else if(a===Ri)_=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Lo)_=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ri,l=!1){let c=this.elements,u=2/(e-t),d=2/(i-s),h=-(e+t)/(e-t),f=-(i+s)/(i-s),_,y;if(l)_=1/(o-r),y=o/(o-r);else if(a===Ri)_=-2/(o-r),y=-(o+r)/(o-r);else if(a===Lo)_=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=_,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},po=new q,ki=new Xe,yy=new q(0,0,0),vy=new q(1,1,1),er=new q,jl=new q,gi=new q,om=new Xe,am=new yi,Ls=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(xe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(xe(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xe(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Kt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return om.makeRotationFromQuaternion(t),this.setFromRotationMatrix(om,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return am.setFromEuler(this),this.setFromQuaternion(am,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ls.DEFAULT_ORDER="XYZ";var ka=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},My=0,lm=new q,mo=new yi,ws=new Xe,Ql=new q,Sa=new q,Sy=new q,by=new yi,cm=new q(1,0,0),hm=new q(0,1,0),um=new q(0,0,1),dm={type:"added"},wy={type:"removed"},go={type:"childadded",child:null},ju={type:"childremoved",child:null},Vn=class n extends Gi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:My++}),this.uuid=pr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new q,e=new Ls,i=new yi,s=new q(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xe},normalMatrix:{value:new ae}}),this.matrix=new Xe,this.matrixWorld=new Xe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ka,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return mo.setFromAxisAngle(t,e),this.quaternion.multiply(mo),this}rotateOnWorldAxis(t,e){return mo.setFromAxisAngle(t,e),this.quaternion.premultiply(mo),this}rotateX(t){return this.rotateOnAxis(cm,t)}rotateY(t){return this.rotateOnAxis(hm,t)}rotateZ(t){return this.rotateOnAxis(um,t)}translateOnAxis(t,e){return lm.copy(t).applyQuaternion(this.quaternion),this.position.add(lm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(cm,t)}translateY(t){return this.translateOnAxis(hm,t)}translateZ(t){return this.translateOnAxis(um,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ws.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ql.copy(t):Ql.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Sa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ws.lookAt(Sa,Ql,this.up):ws.lookAt(Ql,Sa,this.up),this.quaternion.setFromRotationMatrix(ws),s&&(ws.extractRotation(s.matrixWorld),mo.setFromRotationMatrix(ws),this.quaternion.premultiply(mo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ee("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(dm),go.child=t,this.dispatchEvent(go),go.child=null):ee("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(wy),ju.child=t,this.dispatchEvent(ju),ju.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ws.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ws.multiply(t.parent.matrixWorld)),t.applyMatrix4(ws),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(dm),go.child=t,this.dispatchEvent(go),go.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Sa,t,Sy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Sa,by,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),d=o(t.shapes),h=o(t.skeletons),f=o(t.animations),_=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new q(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ar=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ty={type:"move"},Fo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ar,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ar,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ar,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,_=.005;c.inputState.pinching&&h>f+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=f-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ty)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ar;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},pg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},nr={h:0,s:0,l:0},tc={h:0,s:0,l:0};function Qu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var fe=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ei){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=i,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Se.workingColorSpace){if(t=Zd(t,1),e=xe(e,0,1),i=xe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Qu(o,r,t+1/3),this.g=Qu(o,r,t),this.b=Qu(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=ei){function i(r){r!==void 0&&parseFloat(r)<1&&Kt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Kt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Kt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ei){let i=pg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Kt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ps(t.r),this.g=Ps(t.g),this.b=Ps(t.b),this}copyLinearToSRGB(t){return this.r=Po(t.r),this.g=Po(t.g),this.b=Po(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ei){return Se.workingToColorSpace($n.copy(this),t),Math.round(xe($n.r*255,0,255))*65536+Math.round(xe($n.g*255,0,255))*256+Math.round(xe($n.b*255,0,255))}getHexString(t=ei){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace($n.copy(this),e);let i=$n.r,s=$n.g,r=$n.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace($n.copy(this),e),t.r=$n.r,t.g=$n.g,t.b=$n.b,t}getStyle(t=ei){Se.workingToColorSpace($n.copy(this),t);let e=$n.r,i=$n.g,s=$n.b;return t!==ei?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(nr),this.setHSL(nr.h+t,nr.s+e,nr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(nr),t.getHSL(tc);let i=La(nr.h,tc.h,e),s=La(nr.s,tc.s,e),r=La(nr.l,tc.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$n=new fe;fe.NAMES=pg;var za=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ls,this.environmentIntensity=1,this.environmentRotation=new Ls,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},zi=new q,Ts=new q,td=new q,Es=new q,_o=new q,xo=new q,fm=new q,ed=new q,nd=new q,id=new q,sd=new en,rd=new en,od=new en,Cs=class n{constructor(t=new q,e=new q,i=new q){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),zi.subVectors(t,e),s.cross(zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){zi.subVectors(s,e),Ts.subVectors(i,e),td.subVectors(t,e);let o=zi.dot(zi),a=zi.dot(Ts),l=zi.dot(td),c=Ts.dot(Ts),u=Ts.dot(td),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,_=(o*u-a*l)*h;return r.set(1-f-_,_,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Es)===null?!1:Es.x>=0&&Es.y>=0&&Es.x+Es.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Es)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Es.x),l.addScaledVector(o,Es.y),l.addScaledVector(a,Es.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return sd.setScalar(0),rd.setScalar(0),od.setScalar(0),sd.fromBufferAttribute(t,e),rd.fromBufferAttribute(t,i),od.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(sd,r.x),o.addScaledVector(rd,r.y),o.addScaledVector(od,r.z),o}static isFrontFacing(t,e,i,s){return zi.subVectors(i,e),Ts.subVectors(t,e),zi.cross(Ts).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return zi.subVectors(this.c,this.b),Ts.subVectors(this.a,this.b),zi.cross(Ts).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;_o.subVectors(s,i),xo.subVectors(r,i),ed.subVectors(t,i);let l=_o.dot(ed),c=xo.dot(ed);if(l<=0&&c<=0)return e.copy(i);nd.subVectors(t,s);let u=_o.dot(nd),d=xo.dot(nd);if(u>=0&&d<=u)return e.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(_o,o);id.subVectors(t,r);let f=_o.dot(id),_=xo.dot(id);if(_>=0&&f<=_)return e.copy(r);let y=f*c-l*_;if(y<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(i).addScaledVector(xo,a);let m=u*_-f*d;if(m<=0&&d-u>=0&&f-_>=0)return fm.subVectors(r,s),a=(d-u)/(d-u+(f-_)),e.copy(s).addScaledVector(fm,a);let p=1/(m+y+h);return o=y*p,a=h*p,e.copy(i).addScaledVector(_o,o).addScaledVector(xo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ci=class{constructor(t=new q(1/0,1/0,1/0),e=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Vi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Vi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Vi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Vi):Vi.fromBufferAttribute(r,o),Vi.applyMatrix4(t.matrixWorld),this.expandByPoint(Vi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ec.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ec.copy(i.boundingBox)),ec.applyMatrix4(t.matrixWorld),this.union(ec)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Vi),Vi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ba),nc.subVectors(this.max,ba),yo.subVectors(t.a,ba),vo.subVectors(t.b,ba),Mo.subVectors(t.c,ba),ir.subVectors(vo,yo),sr.subVectors(Mo,vo),br.subVectors(yo,Mo);let e=[0,-ir.z,ir.y,0,-sr.z,sr.y,0,-br.z,br.y,ir.z,0,-ir.x,sr.z,0,-sr.x,br.z,0,-br.x,-ir.y,ir.x,0,-sr.y,sr.x,0,-br.y,br.x,0];return!ad(e,yo,vo,Mo,nc)||(e=[1,0,0,0,1,0,0,0,1],!ad(e,yo,vo,Mo,nc))?!1:(ic.crossVectors(ir,sr),e=[ic.x,ic.y,ic.z],ad(e,yo,vo,Mo,nc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Vi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Vi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(As[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),As[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),As[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),As[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),As[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),As[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),As[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),As[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(As),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},As=[new q,new q,new q,new q,new q,new q,new q,new q],Vi=new q,ec=new Ci,yo=new q,vo=new q,Mo=new q,ir=new q,sr=new q,br=new q,ba=new q,nc=new q,ic=new q,wr=new q;function ad(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){wr.fromArray(n,r);let a=s.x*Math.abs(wr.x)+s.y*Math.abs(wr.y)+s.z*Math.abs(wr.z),l=t.dot(wr),c=e.dot(wr),u=i.dot(wr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Sn=new q,sc=new Zt,Ey=0,ii=class extends Gi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ey++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=qd,this.updateRanges=[],this.gpuType=Wi,this.version=0,this._normalizationScale=t!==void 0?qh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)sc.fromBufferAttribute(this,e),sc.applyMatrix3(t),this.setXY(e,sc.x,sc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Sn.fromBufferAttribute(this,e),Sn.applyMatrix3(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Sn.fromBufferAttribute(this,e),Sn.applyMatrix4(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Sn.fromBufferAttribute(this,e),Sn.applyNormalMatrix(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Sn.fromBufferAttribute(this,e),Sn.transformDirection(t),this.setXYZ(e,Sn.x,Sn.y,Sn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Kd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):jd(t,this.array)}};var Va=class extends ii{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Ga=class extends ii{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var pn=class extends ii{constructor(t,e,i){super(new Float32Array(t),e,i)}},Ay=new Ci,wa=new q,ld=new q,Rr=class{constructor(t=new q,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Ay.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;wa.subVectors(t,this.center);let e=wa.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(wa,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ld.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(wa.copy(t.center).add(ld)),this.expandByPoint(wa.copy(t.center).sub(ld))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ry=0,Ai=new Xe,cd=new Vn,So=new q,_i=new Ci,Ta=new Ci,Fn=new q,Bn=class n extends Gi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ry++}),this.uuid=pr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Qx(t)?Ga:Va)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ae().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ai.makeRotationFromQuaternion(t),this.applyMatrix4(Ai),this}rotateX(t){return Ai.makeRotationX(t),this.applyMatrix4(Ai),this}rotateY(t){return Ai.makeRotationY(t),this.applyMatrix4(Ai),this}rotateZ(t){return Ai.makeRotationZ(t),this.applyMatrix4(Ai),this}translate(t,e,i){return Ai.makeTranslation(t,e,i),this.applyMatrix4(Ai),this}scale(t,e,i){return Ai.makeScale(t,e,i),this.applyMatrix4(Ai),this}lookAt(t){return cd.lookAt(t),cd.updateMatrix(),this.applyMatrix4(cd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(So).negate(),this.translate(So.x,So.y,So.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new pn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Kt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ci);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ee('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Rr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(t){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ta.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(_i.min,Ta.min),_i.expandByPoint(Fn),Fn.addVectors(_i.max,Ta.max),_i.expandByPoint(Fn)):(_i.expandByPoint(Ta.min),_i.expandByPoint(Ta.max))}_i.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Fn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Fn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Fn.fromBufferAttribute(a,c),l&&(So.fromBufferAttribute(t,c),Fn.add(So)),s=Math.max(s,i.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ee('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ee("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ii(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let P=0;P<i.count;P++)a[P]=new q,l[P]=new q;let u=new q,d=new q,h=new q,f=new Zt,_=new Zt,y=new Zt,m=new q,p=new q;function x(P,I,C){c[P]=c[I]=c[C]=1,u.fromBufferAttribute(i,P),d.fromBufferAttribute(i,I),h.fromBufferAttribute(i,C),f.fromBufferAttribute(r,P),_.fromBufferAttribute(r,I),y.fromBufferAttribute(r,C),d.sub(u),h.sub(u),_.sub(f),y.sub(f);let U=1/(_.x*y.y-y.x*_.y);isFinite(U)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(h,-_.y).multiplyScalar(U),p.copy(h).multiplyScalar(_.x).addScaledVector(d,-y.x).multiplyScalar(U),a[P].add(m),a[I].add(m),a[C].add(m),l[P].add(p),l[I].add(p),l[C].add(p))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let P=0,I=M.length;P<I;++P){let C=M[P],U=C.start,O=C.count;for(let L=U,B=U+O;L<B;L+=3)x(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let v=new q,T=new q,w=new q,g=new q;function b(P){w.fromBufferAttribute(s,P),g.copy(w);let I=a[P];v.copy(I),v.sub(w.multiplyScalar(w.dot(I))).normalize(),T.crossVectors(g,I);let U=T.dot(l[P])<0?-1:1;o.setXYZW(P,v.x,v.y,v.z,U)}for(let P=0,I=i.count;P<I;++P)c[P]&&b(P);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new ii(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,u=new q,d=new q;if(t)for(let h=0,f=t.count;h<f;h+=3){let _=t.getX(h+0),y=t.getX(h+1),m=t.getX(h+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,f=e.count;h<f;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Fn.fromBufferAttribute(t,e),Fn.normalize(),t.setXYZ(e,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,_=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let p=0;p<u;p++)h[_++]=c[f++]}return new ii(h,u,d)}if(this.index===null)return Kt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=t(h,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Bc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=qd,this.updateRanges=[],this.version=0,this.uuid=pr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=pm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=pm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function pm(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=pr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ti=new q,Ha=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?qh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.applyMatrix4(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.applyNormalMatrix(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.transformDirection(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Oa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new ii(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Oa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Kd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):jd(t,this.data.array)}},hd=new q,Cy=new q,Py=new ae,xi=class{constructor(t=new q(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=hd.subVectors(i,e).cross(Cy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(hd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Py.getNormalMatrix(t),s=this.coplanarPoint(hd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Iy=0,ls=class extends Gi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Iy++}),this.uuid=pr(),this.name="",this.type="Material",this.blending=Go,this.side=hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ad,this.blendDst=Rd,this.blendEquation=Lr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new fe(0,0,0),this.blendAlpha=0,this.depthFunc=Io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=sg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=wc,this.stencilZFail=wc,this.stencilZPass=wc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Kt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new fe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new xi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Zt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Oo=class extends ls{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new fe(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},bo,Ea=new q,wo=new q,To=new q,Eo=new Zt,Aa=new Zt,mg=new Xe,rc=new q,Ra=new q,oc=new q,mm=new Zt,ud=new Zt,gm=new Zt,Wa=class extends Vn{constructor(t=new Oo){if(super(),this.isSprite=!0,this.type="Sprite",bo===void 0){bo=new Bn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Bc(e,5);bo.setIndex([0,1,2,0,2,3]),bo.setAttribute("position",new Ha(i,3,0,!1)),bo.setAttribute("uv",new Ha(i,2,3,!1))}this.geometry=bo,this.material=t,this.center=new Zt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ee('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),wo.setFromMatrixScale(this.matrixWorld),mg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),To.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&wo.multiplyScalar(-To.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;ac(rc.set(-.5,-.5,0),To,o,wo,s,r),ac(Ra.set(.5,-.5,0),To,o,wo,s,r),ac(oc.set(.5,.5,0),To,o,wo,s,r),mm.set(0,0),ud.set(1,0),gm.set(1,1);let a=t.ray.intersectTriangle(rc,Ra,oc,!1,Ea);if(a===null&&(ac(Ra.set(-.5,.5,0),To,o,wo,s,r),ud.set(0,1),a=t.ray.intersectTriangle(rc,oc,Ra,!1,Ea),a===null))return;let l=t.ray.origin.distanceTo(Ea);l<t.near||l>t.far||e.push({distance:l,point:Ea.clone(),uv:Cs.getInterpolation(Ea,rc,Ra,oc,mm,ud,gm,new Zt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function ac(n,t,e,i,s,r){Eo.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Aa.x=r*Eo.x-s*Eo.y,Aa.y=s*Eo.x+r*Eo.y):Aa.copy(Eo),n.copy(t),n.x+=Aa.x,n.y+=Aa.y,n.applyMatrix4(mg)}var Rs=new q,dd=new q,lc=new q,cc=new q,Cr=class{constructor(t=new q,e=new q(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Rs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Rs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Rs.copy(this.origin).addScaledVector(this.direction,e),Rs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){dd.copy(t).add(e).multiplyScalar(.5),lc.copy(e).sub(t).normalize(),cc.copy(this.origin).sub(dd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(lc),a=cc.dot(this.direction),l=-cc.dot(lc),c=cc.lengthSq(),u=Math.abs(1-o*o),d,h,f,_;if(u>0)if(d=o*l-a,h=o*a-l,_=r*u,d>=0)if(h>=-_)if(h<=_){let y=1/u;d*=y,h*=y,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-_?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=_?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(dd).addScaledVector(lc,h),f}intersectSphere(t,e){if(t.radius<0)return null;Rs.subVectors(t.center,this.origin);let i=Rs.dot(this.direction),s=Rs.dot(Rs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-h.z)*d,l=(t.max.z-h.z)*d):(a=(t.max.z-h.z)*d,l=(t.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Rs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=t.x-o.x,h=t.y-o.y,f=t.z-o.z,_=e.x-o.x,y=e.y-o.y,m=e.z-o.z,p=i.x-o.x,x=i.y-o.y,M=i.z-o.z,v=Math.abs(l),T=Math.abs(c),w=Math.abs(u),g,b,P,I,C,U,O,L,B,$,V,J;if(v>=T&&v>=w?(P=l,U=d,B=_,J=p,l>=0?(g=c,b=u,I=h,C=f,O=y,L=m,$=x,V=M):(g=u,b=c,I=f,C=h,O=m,L=y,$=M,V=x)):T>=w?(P=c,U=h,B=y,J=x,c>=0?(g=u,b=l,I=f,C=d,O=m,L=_,$=M,V=p):(g=l,b=u,I=d,C=f,O=_,L=m,$=p,V=M)):(P=u,U=f,B=m,J=M,u>=0?(g=l,b=c,I=d,C=h,O=_,L=y,$=p,V=x):(g=c,b=l,I=h,C=d,O=y,L=_,$=x,V=p)),P===0)return null;let G=g/P,Y=b/P,et=1/P,lt=I-G*U,rt=C-Y*U,K=O-G*B,ut=L-Y*B,pt=$-G*J,yt=V-Y*J,_t=pt*ut-yt*K,Wt=lt*yt-rt*pt,oe=K*rt-ut*lt;if(s){if(_t<0||Wt<0||oe<0)return null}else if((_t<0||Wt<0||oe<0)&&(_t>0||Wt>0||oe>0))return null;let Ot=_t+Wt+oe;if(Ot===0)return null;let ce=et*(_t*U+Wt*B+oe*J);return(Ot>0?ce<0:ce>0)?null:this.at(ce/Ot,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},kc=class extends ls{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ls,this.combine=oh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},_m=new Xe,Tr=new Cr,hc=new Rr,xm=new q,uc=new q,dc=new q,fc=new q,fd=new q,pc=new q,ym=new q,mc=new q,qn=class extends Vn{constructor(t=new Bn,e=new kc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){pc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(fd.fromBufferAttribute(d,t),o?pc.addScaledVector(fd,u):pc.addScaledVector(fd.sub(e),u))}e.add(pc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),hc.copy(i.boundingSphere),hc.applyMatrix4(r),Tr.copy(t.ray).recast(t.near),!(hc.containsPoint(Tr.origin)===!1&&(Tr.intersectSphere(hc,xm)===null||Tr.origin.distanceToSquared(xm)>(t.far-t.near)**2))&&(_m.copy(r).invert(),Tr.copy(t.ray).applyMatrix4(_m),!(i.boundingBox!==null&&Tr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Tr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,y=h.length;_<y;_++){let m=h[_],p=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,T=M;v<T;v+=3){let w=a.getX(v),g=a.getX(v+1),b=a.getX(v+2);s=gc(this,p,t,i,c,u,d,w,g,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let _=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=_,p=y;m<p;m+=3){let x=a.getX(m),M=a.getX(m+1),v=a.getX(m+2);s=gc(this,o,t,i,c,u,d,x,M,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,y=h.length;_<y;_++){let m=h[_],p=o[m.materialIndex],x=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,T=M;v<T;v+=3){let w=v,g=v+1,b=v+2;s=gc(this,p,t,i,c,u,d,w,g,b),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let _=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=_,p=y;m<p;m+=3){let x=m,M=m+1,v=m+2;s=gc(this,o,t,i,c,u,d,x,M,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Ly(n,t,e,i,s,r,o,a){let l;if(t.side===oi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===hs,a),l===null)return null;mc.copy(a),mc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(mc);return c<e.near||c>e.far?null:{distance:c,point:mc.clone(),object:n}}function gc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,uc),n.getVertexPosition(l,dc),n.getVertexPosition(c,fc);let u=Ly(n,t,e,i,uc,dc,fc,ym);if(u){let d=new q;Cs.getBarycoord(ym,uc,dc,fc,d),s&&(u.uv=Cs.getInterpolatedAttribute(s,a,l,c,d,new Zt)),r&&(u.uv1=Cs.getInterpolatedAttribute(r,a,l,c,d,new Zt)),o&&(u.normal=Cs.getInterpolatedAttribute(o,a,l,c,d,new q),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new q,materialIndex:0};Cs.getNormal(uc,dc,fc,h.normal),u.face=h,u.barycoord=d}return u}var zc=class extends ri{constructor(t=null,e=1,i=1,s,r,o,a,l,c=On,u=On,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Er=new Rr,Dy=new Zt(.5,.5),_c=new q,or=class{constructor(t=new xi,e=new xi,i=new xi,s=new xi,r=new xi,o=new xi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ri,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],_=r[8],y=r[9],m=r[10],p=r[11],x=r[12],M=r[13],v=r[14],T=r[15];if(s[0].setComponents(c-o,f-u,p-_,T-x).normalize(),s[1].setComponents(c+o,f+u,p+_,T+x).normalize(),s[2].setComponents(c+a,f+d,p+y,T+M).normalize(),s[3].setComponents(c-a,f-d,p-y,T-M).normalize(),i)s[4].setComponents(l,h,m,v).normalize(),s[5].setComponents(c-l,f-h,p-m,T-v).normalize();else if(s[4].setComponents(c-l,f-h,p-m,T-v).normalize(),e===Ri)s[5].setComponents(c+l,f+h,p+m,T+v).normalize();else if(e===Lo)s[5].setComponents(l,h,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Er.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Er.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Er)}intersectsSprite(t){Er.center.set(0,0,0);let e=Dy.distanceTo(t.center);return Er.radius=.7071067811865476+e,Er.applyMatrix4(t.matrixWorld),this.intersectsSphere(Er)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(_c.x=s.normal.x>0?t.max.x:t.min.x,_c.y=s.normal.y>0?t.max.y:t.min.y,_c.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(_c)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},vm=new Xe,Vc=class n{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];vm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new or),i[s].setFromProjectionMatrix(vm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new or),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var ar=class extends ls{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new fe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Gc=new q,Hc=new q,Mm=new Xe,Ca=new Cr,xc=new Rr,pd=new q,Sm=new q,Wc=class extends Vn{constructor(t=new Bn,e=new ar){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Gc.fromBufferAttribute(e,s-1),Hc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Gc.distanceTo(Hc);t.setAttribute("lineDistance",new pn(i,1))}else Kt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),xc.copy(i.boundingSphere),xc.applyMatrix4(s),xc.radius+=r,t.ray.intersectsSphere(xc)===!1)return;Mm.copy(s).invert(),Ca.copy(t.ray).applyMatrix4(Mm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let y=f,m=_-1;y<m;y+=c){let p=u.getX(y),x=u.getX(y+1),M=yc(this,t,Ca,l,p,x,y);M&&e.push(M)}if(this.isLineLoop){let y=u.getX(_-1),m=u.getX(f),p=yc(this,t,Ca,l,y,m,_-1);p&&e.push(p)}}else{let f=Math.max(0,o.start),_=Math.min(h.count,o.start+o.count);for(let y=f,m=_-1;y<m;y+=c){let p=yc(this,t,Ca,l,y,y+1,y);p&&e.push(p)}if(this.isLineLoop){let y=yc(this,t,Ca,l,_-1,f,_-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function yc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Gc.fromBufferAttribute(a,s),Hc.fromBufferAttribute(a,r),e.distanceSqToSegment(Gc,Hc,pd,Sm)>i)return;pd.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(pd);if(!(c<t.near||c>t.far))return{distance:c,point:Sm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var bm=new q,wm=new q,Pr=class extends Wc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)bm.fromBufferAttribute(e,s),wm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+bm.distanceTo(wm);t.setAttribute("lineDistance",new pn(i,1))}else Kt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Xa=class extends ri{constructor(t=[],e=Dr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},$a=class extends ri{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ds=class extends ri{constructor(t,e,i=Hi,s,r,o,a=On,l=On,c,u=Is,d=1){if(u!==Is&&u!==Fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Uo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},qa=class extends Ds{constructor(t,e=Hi,i=Dr,s,r,o=On,a=On,l,c=Is){let u={width:t,height:t,depth:1},d=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ya=class extends ri{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Bo=class n extends Bn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;_("z","y","x",-1,-1,i,e,t,o,r,0),_("z","y","x",1,-1,i,e,-t,o,r,1),_("x","z","y",1,1,t,i,e,s,o,2),_("x","z","y",1,-1,t,i,-e,s,o,3),_("x","y","z",1,-1,t,e,i,s,r,4),_("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new pn(c,3)),this.setAttribute("normal",new pn(u,3)),this.setAttribute("uv",new pn(d,2));function _(y,m,p,x,M,v,T,w,g,b,P){let I=v/g,C=T/b,U=v/2,O=T/2,L=w/2,B=g+1,$=b+1,V=0,J=0,G=new q;for(let Y=0;Y<$;Y++){let et=Y*C-O;for(let lt=0;lt<B;lt++){let rt=lt*I-U;G[y]=rt*x,G[m]=et*M,G[p]=L,c.push(G.x,G.y,G.z),G[y]=0,G[m]=0,G[p]=w>0?1:-1,u.push(G.x,G.y,G.z),d.push(lt/g),d.push(1-Y/b),V+=1}}for(let Y=0;Y<b;Y++)for(let et=0;et<g;et++){let lt=h+et+B*Y,rt=h+et+B*(Y+1),K=h+(et+1)+B*(Y+1),ut=h+(et+1)+B*Y;l.push(lt,rt,ut),l.push(rt,K,ut),J+=6}a.addGroup(f,J,P),f+=J,h+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Za=class n extends Bn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=t/a,h=e/l,f=[],_=[],y=[],m=[];for(let p=0;p<u;p++){let x=p*h-o;for(let M=0;M<c;M++){let v=M*d-r;_.push(v,-x,0),y.push(0,0,1),m.push(M/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let x=0;x<a;x++){let M=x+c*p,v=x+c*(p+1),T=x+1+c*(p+1),w=x+1+c*p;f.push(M,v,w),f.push(v,T,w)}this.setIndex(f),this.setAttribute("position",new pn(_,3)),this.setAttribute("normal",new pn(y,3)),this.setAttribute("uv",new pn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function Ur(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Tm(s))s.isRenderTargetTexture?(Kt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Tm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Yn(n){let t={};for(let e=0;e<n.length;e++){let i=Ur(n[e]);for(let s in i)t[s]=i[s]}return t}function Tm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Ny(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function tf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var gg={clone:Ur,merge:Yn},Uy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Fy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,cs=class extends ls{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Uy,this.fragmentShader=Fy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Ur(t.uniforms),this.uniformsGroups=Ny(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new fe().setHex(s.value);break;case"v2":this.uniforms[i].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new q().fromArray(s.value);break;case"v4":this.uniforms[i].value=new en().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ae().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Xe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Xc=class extends cs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ns=class extends ls{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new fe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new fe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=$h,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ls,this.combine=oh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},$c=class extends ls{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ng,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},qc=class extends ls{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ao(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function vc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var lr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Yc=class extends lr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:_d,endingEnd:_d}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case xd:r=t,a=2*e-i;break;case yd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case xd:o=t,l=2*i-e;break;case yd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,_=(i-e)/(s-e),y=_*_,m=y*_,p=-h*m+2*h*y-h*_,x=(1+h)*m+(-1.5-2*h)*y+(-.5+h)*_+1,M=(-1-f)*m+(1.5+f)*y+.5*_,v=f*m-f*y;for(let T=0;T!==a;++T)r[T]=p*o[u+T]+x*o[c+T]+M*o[l+T]+v*o[d+T];return r}},Zc=class extends lr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Jc=class extends lr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Kc=class extends lr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let _=(i-e)/(s-e),y=1-_;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*_;return r}let h=a*2,f=t-1;for(let _=0;_!==a;++_){let y=o[c+_],m=o[l+_],p=f*h+_*2,x=d[p],M=d[p+1],v=t*h+_*2,T=u[v],w=u[v+1],g=By(i,e,x,T,s);r[_]=_g(g,y,M,w,m)}return r}};function _g(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Oy(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function By(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=_g(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Oy(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Mi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ao(e,this.TimeBufferType),this.values=Ao(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ao(t.times,Array),values:Ao(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),vc(t.settings)&&(i.settings={inTangents:Ao(t.settings.inTangents,Array),outTangents:Ao(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Jc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Zc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Yc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Kc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Da:e=this.InterpolantFactoryMethodDiscrete;break;case Nc:e=this.InterpolantFactoryMethodLinear;break;case bc:e=this.InterpolantFactoryMethodSmooth;break;case gd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Kt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Da;case this.InterpolantFactoryMethodLinear:return Nc;case this.InterpolantFactoryMethodSmooth:return bc;case this.InterpolantFactoryMethodBezier:return gd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;vc(this.settings)&&(Em(this.settings.inTangents,t),Em(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;vc(this.settings)&&(Am(this.settings.inTangents,t),Am(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ee("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ee("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ee("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ee("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&ty(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ee("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===bc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let _=0;_!==i;++_){let y=e[d+_];if(y!==e[h+_]||y!==e[f+_]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)e[h+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,vc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Em(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Am(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Mi.prototype.ValueTypeName="";Mi.prototype.TimeBufferType=Float32Array;Mi.prototype.ValueBufferType=Float32Array;Mi.prototype.DefaultInterpolation=Nc;var cr=class extends Mi{constructor(t,e,i){super(t,e,i)}};cr.prototype.ValueTypeName="bool";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Da;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var jc=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};jc.prototype.ValueTypeName="color";var Qc=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};Qc.prototype.ValueTypeName="number";var th=class extends lr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)yi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ja=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new th(this.times,this.values,this.getValueSize(),t)}};Ja.prototype.ValueTypeName="quaternion";Ja.prototype.InterpolantFactoryMethodSmooth=void 0;var hr=class extends Mi{constructor(t,e,i){super(t,e,i)}};hr.prototype.ValueTypeName="string";hr.prototype.ValueBufferType=Array;hr.prototype.DefaultInterpolation=Da;hr.prototype.InterpolantFactoryMethodLinear=void 0;hr.prototype.InterpolantFactoryMethodSmooth=void 0;var eh=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};eh.prototype.ValueTypeName="vector";var nh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],_=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},xg=new nh,ih=class{constructor(t){this.manager=t!==void 0?t:xg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};ih.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ka=class extends Vn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new fe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var md=new Xe,Rm=new q,Cm=new q,sh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=ci,this.map=null,this.mapPass=null,this.matrix=new Xe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new or,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Rm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Rm),Cm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Cm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){md.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(md,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Lo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(md)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Mc=new q,Sc=new yi,os=new q,ja=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xe,this.projectionMatrix=new Xe,this.projectionMatrixInverse=new Xe,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Mc,Sc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mc,Sc,os.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Mc,Sc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Mc,Sc,os.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},rr=new q,Pm=new Zt,Im=new Zt,ni=class extends ja{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=No*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Ia*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return No*2*Math.atan(Math.tan(Ia*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){rr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(rr.x,rr.y).multiplyScalar(-t/rr.z),rr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(rr.x,rr.y).multiplyScalar(-t/rr.z)}getViewSize(t,e){return this.getViewBounds(t,Pm,Im),e.subVectors(Im,Pm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Ia*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Qa=class extends ja{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},vd=class extends sh{constructor(){super(new Qa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},tl=class extends Ka{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new vd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},el=class extends Ka{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Ro=-90,Co=1,ko=class extends Vn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ni(Ro,Co,t,e);s.layers=this.layers,this.add(s);let r=new ni(Ro,Co,t,e);r.layers=this.layers,this.add(r);let o=new ni(Ro,Co,t,e);o.layers=this.layers,this.add(o);let a=new ni(Ro,Co,t,e);a.layers=this.layers,this.add(a);let l=new ni(Ro,Co,t,e);l.layers=this.layers,this.add(l);let c=new ni(Ro,Co,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ri)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Lo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=t.getRenderTarget(),h=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(d,h,f),t.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},rh=class extends ni{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var ef="\\[\\]\\.:\\/",ky=new RegExp("["+ef+"]","g"),nf="[^"+ef+"]",zy="[^"+ef.replace("\\.","")+"]",Vy=/((?:WC+[\/:])*)/.source.replace("WC",nf),Gy=/(WCOD+)?/.source.replace("WCOD",zy),Hy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nf),Wy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nf),Xy=new RegExp("^"+Vy+Gy+Hy+Wy+"$"),$y=["material","materials","bones","map"],Md=class{constructor(t,e,i){let s=i||Ke.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ke=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(ky,"")}static parseTrackName(t){let e=Xy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);$y.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Kt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ee("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ee("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ee("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ee("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ee("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ee("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ke.Composite=Md;Ke.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ke.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ke.prototype.GetterByBindingType=[Ke.prototype._getValue_direct,Ke.prototype._getValue_array,Ke.prototype._getValue_arrayElement,Ke.prototype._getValue_toArray];Ke.prototype.SetterByBindingTypeAndVersioning=[[Ke.prototype._setValue_direct,Ke.prototype._setValue_direct_setNeedsUpdate,Ke.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_array,Ke.prototype._setValue_array_setNeedsUpdate,Ke.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_arrayElement,Ke.prototype._setValue_arrayElement_setNeedsUpdate,Ke.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ke.prototype._setValue_fromArray,Ke.prototype._setValue_fromArray_setNeedsUpdate,Ke.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var zA=new Float32Array(1);var zo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=xe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(xe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Sd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var nl=class extends Gi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function sf(n,t,e,i){let s=qy(i);switch(e){case Vd:return n*t;case Hd:return n*t/s.components*s.byteLength;case fh:return n*t/s.components*s.byteLength;case fr:return n*t*2/s.components*s.byteLength;case ph:return n*t*2/s.components*s.byteLength;case Gd:return n*t*3/s.components*s.byteLength;case $i:return n*t*4/s.components*s.byteLength;case mh:return n*t*4/s.components*s.byteLength;case rl:case ol:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case al:case ll:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case _h:case yh:return Math.max(n,16)*Math.max(t,8)/4;case gh:case xh:return Math.max(n,8)*Math.max(t,8)/2;case vh:case Mh:case bh:case wh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Sh:case cl:case Th:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Eh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ah:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Rh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Ch:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Ph:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Ih:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Lh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Dh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Nh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Fh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Oh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Bh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case kh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case zh:case Vh:case Gh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Hh:case Wh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case hl:case Xh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function qy(n){switch(n){case ci:case Od:return{byteLength:1,components:1};case Wo:case Bd:case Xi:return{byteLength:2,components:1};case uh:case dh:return{byteLength:2,components:4};case Hi:case hh:case Wi:return{byteLength:4,components:1};case kd:case zd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Kt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function zg(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Zy(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,_)=>f.start-_.start);let h=0;for(let f=1;f<d.length;f++){let _=d[h],y=d[f];y.start<=_.start+_.count+1?_.count=Math.max(_.count,y.start+y.count-_.start):(++h,d[h]=y)}d.length=h+1;for(let f=0,_=d.length;f<_;f++){let y=d[f];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Jy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Ky=`#ifdef USE_ALPHAHASH
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
#endif`,jy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Qy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ev=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,nv=`#ifdef USE_AOMAP
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
#endif`,iv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,sv=`#ifdef USE_BATCHING
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
#endif`,rv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ov=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,av=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,lv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,cv=`#ifdef USE_IRIDESCENCE
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
#endif`,hv=`#ifdef USE_BUMPMAP
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
#endif`,uv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,dv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,fv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,pv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,mv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,gv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,_v=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,xv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,yv=`#define PI 3.141592653589793
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
} // validated`,vv=`vec3 transformedNormal = objectNormal;
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
#endif`,Mv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Sv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,bv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,wv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Tv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ev=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Av=`#ifdef USE_ENVMAP
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
#endif`,Rv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Cv=`#ifdef USE_ENVMAP
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
#endif`,Pv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Iv=`#ifdef USE_ENVMAP
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
#endif`,Lv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Dv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Nv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Uv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Fv=`#ifdef USE_GRADIENTMAP
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
}`,Ov=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Bv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,kv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,zv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Vv=`#ifdef USE_ENVMAP
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
#endif`,Gv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Hv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Wv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Xv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,$v=`PhysicalMaterial material;
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
#endif`,qv=`uniform sampler2D dfgLUT;
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
}`,Yv=`
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
#endif`,Zv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Jv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Kv=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,jv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Qv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,eM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,nM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,iM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,sM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,rM=`#if defined( USE_POINTS_UV )
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
#endif`,oM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,aM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,lM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,cM=`#if defined( USE_MORPHCOLORS )
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
#endif`,hM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uM=`#ifdef USE_MORPHTARGETS
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
#endif`,dM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,pM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,mM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_M=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,xM=`#ifdef USE_NORMALMAP
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
#endif`,yM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,vM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,MM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,SM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,bM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,wM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,TM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,EM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,AM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,RM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,CM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,PM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,IM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,LM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,DM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,NM=`float getShadowMask() {
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
}`,UM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,FM=`#ifdef USE_SKINNING
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
#endif`,OM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,BM=`#ifdef USE_SKINNING
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
#endif`,kM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,zM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,VM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,GM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,HM=`#ifdef USE_TRANSMISSION
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
#endif`,WM=`#ifdef USE_TRANSMISSION
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
#endif`,XM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$M=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,qM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,YM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ZM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,JM=`uniform sampler2D t2D;
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
}`,KM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jM=`uniform float backgroundBlurriness;
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
}`,QM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eS=`#include <common>
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
}`,nS=`#if DEPTH_PACKING == 3200
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
}`,iS=`#define DISTANCE
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
}`,sS=`#define DISTANCE
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
}`,rS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,oS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aS=`uniform float scale;
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
}`,lS=`uniform vec3 diffuse;
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
}`,cS=`#include <common>
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
}`,hS=`uniform vec3 diffuse;
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
}`,uS=`#define LAMBERT
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
}`,dS=`#define LAMBERT
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
}`,fS=`#define MATCAP
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
}`,pS=`#define MATCAP
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
}`,mS=`#define NORMAL
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
}`,gS=`#define NORMAL
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
}`,_S=`#define PHONG
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
}`,xS=`#define PHONG
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
}`,yS=`#define STANDARD
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
}`,vS=`#define STANDARD
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
}`,MS=`#define TOON
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
}`,SS=`#define TOON
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
}`,bS=`uniform float size;
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
}`,wS=`uniform vec3 diffuse;
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
}`,TS=`#include <common>
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
}`,ES=`uniform vec3 color;
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
}`,AS=`uniform float rotation;
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
}`,RS=`uniform vec3 diffuse;
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
}`,me={alphahash_fragment:Jy,alphahash_pars_fragment:Ky,alphamap_fragment:jy,alphamap_pars_fragment:Qy,alphatest_fragment:tv,alphatest_pars_fragment:ev,aomap_fragment:nv,aomap_pars_fragment:iv,batching_pars_vertex:sv,batching_vertex:rv,begin_vertex:ov,beginnormal_vertex:av,bsdfs:lv,iridescence_fragment:cv,bumpmap_pars_fragment:hv,clipping_planes_fragment:uv,clipping_planes_pars_fragment:dv,clipping_planes_pars_vertex:fv,clipping_planes_vertex:pv,color_fragment:mv,color_pars_fragment:gv,color_pars_vertex:_v,color_vertex:xv,common:yv,defaultnormal_vertex:vv,displacementmap_pars_vertex:Mv,displacementmap_vertex:Sv,emissivemap_fragment:bv,emissivemap_pars_fragment:wv,colorspace_fragment:Tv,colorspace_pars_fragment:Ev,envmap_fragment:Av,envmap_common_pars_fragment:Rv,envmap_pars_fragment:Cv,envmap_pars_vertex:Pv,envmap_physical_pars_fragment:Vv,envmap_vertex:Iv,fog_vertex:Lv,fog_pars_vertex:Dv,fog_fragment:Nv,fog_pars_fragment:Uv,gradientmap_pars_fragment:Fv,lightmap_pars_fragment:Ov,lights_lambert_fragment:Bv,lights_lambert_pars_fragment:kv,lights_pars_begin:zv,lights_toon_fragment:Gv,lights_toon_pars_fragment:Hv,lights_phong_fragment:Wv,lights_phong_pars_fragment:Xv,lights_physical_fragment:$v,lights_physical_pars_fragment:qv,lights_fragment_begin:Yv,lights_fragment_maps:Zv,lights_fragment_end:Jv,lightprobes_pars_fragment:Kv,logdepthbuf_fragment:jv,logdepthbuf_pars_fragment:Qv,logdepthbuf_pars_vertex:tM,logdepthbuf_vertex:eM,map_fragment:nM,map_pars_fragment:iM,map_particle_fragment:sM,map_particle_pars_fragment:rM,metalnessmap_fragment:oM,metalnessmap_pars_fragment:aM,morphinstance_vertex:lM,morphcolor_vertex:cM,morphnormal_vertex:hM,morphtarget_pars_vertex:uM,morphtarget_vertex:dM,normal_fragment_begin:fM,normal_fragment_maps:pM,normal_pars_fragment:mM,normal_pars_vertex:gM,normal_vertex:_M,normalmap_pars_fragment:xM,clearcoat_normal_fragment_begin:yM,clearcoat_normal_fragment_maps:vM,clearcoat_pars_fragment:MM,iridescence_pars_fragment:SM,opaque_fragment:bM,packing:wM,premultiplied_alpha_fragment:TM,project_vertex:EM,dithering_fragment:AM,dithering_pars_fragment:RM,roughnessmap_fragment:CM,roughnessmap_pars_fragment:PM,shadowmap_pars_fragment:IM,shadowmap_pars_vertex:LM,shadowmap_vertex:DM,shadowmask_pars_fragment:NM,skinbase_vertex:UM,skinning_pars_vertex:FM,skinning_vertex:OM,skinnormal_vertex:BM,specularmap_fragment:kM,specularmap_pars_fragment:zM,tonemapping_fragment:VM,tonemapping_pars_fragment:GM,transmission_fragment:HM,transmission_pars_fragment:WM,uv_pars_fragment:XM,uv_pars_vertex:$M,uv_vertex:qM,worldpos_vertex:YM,background_vert:ZM,background_frag:JM,backgroundCube_vert:KM,backgroundCube_frag:jM,cube_vert:QM,cube_frag:tS,depth_vert:eS,depth_frag:nS,distance_vert:iS,distance_frag:sS,equirect_vert:rS,equirect_frag:oS,linedashed_vert:aS,linedashed_frag:lS,meshbasic_vert:cS,meshbasic_frag:hS,meshlambert_vert:uS,meshlambert_frag:dS,meshmatcap_vert:fS,meshmatcap_frag:pS,meshnormal_vert:mS,meshnormal_frag:gS,meshphong_vert:_S,meshphong_frag:xS,meshphysical_vert:yS,meshphysical_frag:vS,meshtoon_vert:MS,meshtoon_frag:SS,points_vert:bS,points_frag:wS,shadow_vert:TS,shadow_frag:ES,sprite_vert:AS,sprite_frag:RS},Nt={common:{diffuse:{value:new fe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ae},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ae}},envmap:{envMap:{value:null},envMapRotation:{value:new ae},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ae}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ae}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ae},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ae},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ae},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ae}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ae}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ae}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new fe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new fe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0},uvTransform:{value:new ae}},sprite:{diffuse:{value:new fe(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ae},alphaMap:{value:null},alphaMapTransform:{value:new ae},alphaTest:{value:0}}},fs={basic:{uniforms:Yn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:Yn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:Yn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)},specular:{value:new fe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:Yn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:Yn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new fe(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:Yn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:Yn([Nt.points,Nt.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:Yn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:Yn([Nt.common,Nt.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:Yn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:Yn([Nt.sprite,Nt.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new ae},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ae}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:Yn([Nt.common,Nt.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:Yn([Nt.lights,Nt.fog,{color:{value:new fe(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};fs.physical={uniforms:Yn([fs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ae},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ae},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ae},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ae},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ae},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ae},sheen:{value:0},sheenColor:{value:new fe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ae},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ae},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ae},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ae},attenuationDistance:{value:0},attenuationColor:{value:new fe(0)},specularColor:{value:new fe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ae},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ae},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ae}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var Yh={r:0,b:0,g:0},CS=new Xe,Vg=new ae;Vg.set(-1,0,0,0,1,0,0,0,1);function PS(n,t,e,i,s,r){let o=new fe(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(x){let M=x.isScene===!0?x.background:null;if(M&&M.isTexture){let v=x.backgroundBlurriness>0;M=t.get(M,v)}return M}function _(x){let M=!1,v=f(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),M=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,M){let v=f(M);v&&v.isCubeTexture?(c===void 0&&(c=new qn(new Bo(1,1,1),new cs({name:"BackgroundCubeMaterial",uniforms:Ur(fs.backgroundCube.uniforms),vertexShader:fs.backgroundCube.vertexShader,fragmentShader:fs.backgroundCube.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,w,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(CS.makeRotationFromEuler(M.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Vg),c.material.toneMapped=Se.getTransfer(v.colorSpace)!==Ne,(u!==v||d!==v.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,d=v.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new qn(new Za(2,2),new cs({name:"BackgroundMaterial",uniforms:Ur(fs.background.uniforms),vertexShader:fs.background.vertexShader,fragmentShader:fs.background.fragmentShader,side:hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=Se.getTransfer(v.colorSpace)!==Ne,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||d!==v.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,d=v.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,M){x.getRGB(Yh,tf(n)),e.buffers.color.setClear(Yh.r,Yh.g,Yh.b,M,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,M=1){o.set(x),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:_,addToRenderList:y,dispose:p}}function IS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(C,U,O,L,B){let $=!1,V=d(C,L,O,U);r!==V&&(r=V,c(r.object)),$=f(C,L,O,B),$&&_(C,L,O,B),B!==null&&t.update(B,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,v(C,U,O,L),B!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function u(C){return n.deleteVertexArray(C)}function d(C,U,O,L){let B=L.wireframe===!0,$=i[U.id];$===void 0&&($={},i[U.id]=$);let V=C.isInstancedMesh===!0?C.id:0,J=$[V];J===void 0&&(J={},$[V]=J);let G=J[O.id];G===void 0&&(G={},J[O.id]=G);let Y=G[B];return Y===void 0&&(Y=h(l()),G[B]=Y),Y}function h(C){let U=[],O=[],L=[];for(let B=0;B<e;B++)U[B]=0,O[B]=0,L[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:O,attributeDivisors:L,object:C,attributes:{},index:null}}function f(C,U,O,L){let B=r.attributes,$=U.attributes,V=0,J=O.getAttributes();for(let G in J)if(J[G].location>=0){let et=B[G],lt=$[G];if(lt===void 0&&(G==="instanceMatrix"&&C.instanceMatrix&&(lt=C.instanceMatrix),G==="instanceColor"&&C.instanceColor&&(lt=C.instanceColor)),et===void 0||et.attribute!==lt||lt&&et.data!==lt.data)return!0;V++}return r.attributesNum!==V||r.index!==L}function _(C,U,O,L){let B={},$=U.attributes,V=0,J=O.getAttributes();for(let G in J)if(J[G].location>=0){let et=$[G];et===void 0&&(G==="instanceMatrix"&&C.instanceMatrix&&(et=C.instanceMatrix),G==="instanceColor"&&C.instanceColor&&(et=C.instanceColor));let lt={};lt.attribute=et,et&&et.data&&(lt.data=et.data),B[G]=lt,V++}r.attributes=B,r.attributesNum=V,r.index=L}function y(){let C=r.newAttributes;for(let U=0,O=C.length;U<O;U++)C[U]=0}function m(C){p(C,0)}function p(C,U){let O=r.newAttributes,L=r.enabledAttributes,B=r.attributeDivisors;O[C]=1,L[C]===0&&(n.enableVertexAttribArray(C),L[C]=1),B[C]!==U&&(n.vertexAttribDivisor(C,U),B[C]=U)}function x(){let C=r.newAttributes,U=r.enabledAttributes;for(let O=0,L=U.length;O<L;O++)U[O]!==C[O]&&(n.disableVertexAttribArray(O),U[O]=0)}function M(C,U,O,L,B,$,V){V===!0?n.vertexAttribIPointer(C,U,O,B,$):n.vertexAttribPointer(C,U,O,L,B,$)}function v(C,U,O,L){y();let B=L.attributes,$=O.getAttributes(),V=U.defaultAttributeValues;for(let J in $){let G=$[J];if(G.location>=0){let Y=B[J];if(Y===void 0&&(J==="instanceMatrix"&&C.instanceMatrix&&(Y=C.instanceMatrix),J==="instanceColor"&&C.instanceColor&&(Y=C.instanceColor)),Y!==void 0){let et=Y.normalized,lt=Y.itemSize,rt=t.get(Y);if(rt===void 0)continue;let K=rt.buffer,ut=rt.type,pt=rt.bytesPerElement,yt=ut===n.INT||ut===n.UNSIGNED_INT||Y.gpuType===hh;if(Y.isInterleavedBufferAttribute){let _t=Y.data,Wt=_t.isInterleavedBuffer===!0?_t.stride:_t.itemSize,oe=Y.offset;if(_t.isInstancedInterleavedBuffer||_t.isInstancedBufferAttribute){for(let Ot=0;Ot<G.locationSize;Ot++)p(G.location+Ot,_t.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=_t.meshPerAttribute*_t.count)}else for(let Ot=0;Ot<G.locationSize;Ot++)m(G.location+Ot);n.bindBuffer(n.ARRAY_BUFFER,K);for(let Ot=0;Ot<G.locationSize;Ot++)M(G.location+Ot,lt/G.locationSize,ut,et,Wt*pt,(oe+lt/G.locationSize*Ot)*pt,yt)}else{if(Y.isInstancedBufferAttribute){for(let _t=0;_t<G.locationSize;_t++)p(G.location+_t,Y.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Y.meshPerAttribute*Y.count)}else for(let _t=0;_t<G.locationSize;_t++)m(G.location+_t);n.bindBuffer(n.ARRAY_BUFFER,K);for(let _t=0;_t<G.locationSize;_t++)M(G.location+_t,lt/G.locationSize,ut,et,lt*pt,lt/G.locationSize*_t*pt,yt)}}else if(V!==void 0){let et=V[J];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(G.location,et);break;case 3:n.vertexAttrib3fv(G.location,et);break;case 4:n.vertexAttrib4fv(G.location,et);break;default:n.vertexAttrib1fv(G.location,et)}}}}x()}function T(){P();for(let C in i){let U=i[C];for(let O in U){let L=U[O];for(let B in L){let $=L[B];for(let V in $)u($[V].object),delete $[V];delete L[B]}}delete i[C]}}function w(C){if(i[C.id]===void 0)return;let U=i[C.id];for(let O in U){let L=U[O];for(let B in L){let $=L[B];for(let V in $)u($[V].object),delete $[V];delete L[B]}}delete i[C.id]}function g(C){for(let U in i){let O=i[U];for(let L in O){let B=O[L];if(B[C.id]===void 0)continue;let $=B[C.id];for(let V in $)u($[V].object),delete $[V];delete B[C.id]}}}function b(C){for(let U in i){let O=i[U],L=C.isInstancedMesh===!0?C.id:0,B=O[L];if(B!==void 0){for(let $ in B){let V=B[$];for(let J in V)u(V[J].object),delete V[J];delete B[$]}delete O[L],Object.keys(O).length===0&&delete i[U]}}}function P(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:P,resetDefaultState:I,dispose:T,releaseStatesOfGeometry:w,releaseStatesOfObject:b,releaseStatesOfProgram:g,initAttributes:y,enableAttribute:m,disableUnusedAttributes:x}}function LS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function DS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let g=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(g){return!(g!==$i&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(g){let b=g===Xi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(g!==ci&&g!==Wi&&!b&&i.convert(g)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(g){if(g==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Kt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Kt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Kt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),M=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:_,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:x,maxVaryings:M,maxFragmentUniforms:v,maxSamples:T,samples:w}}function NS(n){let t=this,e=null,i=0,s=!1,r=!1,o=new xi,a=new ae,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){e=u(d,h,0)},this.setState=function(d,h,f){let _=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,p=n.get(d);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,M=x*4,v=p.clippingState||null;l.value=v,v=u(_,h,M,f);for(let T=0;T!==M;++T)v[T]=e[T];p.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(d,h,f,_){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,_!==!0||m===null){let p=f+y*4,x=h.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<p)&&(m=new Float32Array(p));for(let M=0,v=f;M!==y;++M,v+=4)o.copy(d[M]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var fl=class extends vi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Xa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Bo(5,5,5),r=new cs({name:"CubemapFromEquirect",uniforms:Ur(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:oi,blending:Ir});r.uniforms.tEquirect.value=e;let o=new qn(s,r),a=e.minFilter;return e.minFilter===Us&&(e.minFilter=si),new ko(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},yg=256,US=3,FS=20,Gg=256,Hg=16,OS=3,BS=new q,kS=new fe,Jh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ko(1,10,null),this._boxMesh=new qn(new Bo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=BS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,_=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(kS));let m=new ko(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=_,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Sg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Mg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(yg,Jd(t))}_fromTexture(t,e){t.mapping===Dr||t.mapping===Ho?this._setSize(t.image.length===0?yg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=vg(t,!1,!1),i=Math.log2(t)-US;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=vg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Dr||t.mapping===Ho?(this._cubemapMaterial===null&&(this._cubemapMaterial=Sg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Mg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=zS(),this._integrationMaterial=VS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Hg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-OS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Gg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=GS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function vg(n,t,e){return new fl(n,{minFilter:Us,generateMipmaps:t,type:Xi,colorSpace:Na,depthBuffer:e})}function pl(n,t,e){return new cs({name:n,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:oi,blending:Ir,depthTest:!1,depthWrite:!1})}function zS(){return pl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Gg}u

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
	`)}function VS(){return pl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Hg}},`

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
	`)}function GS(){return pl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${FS}
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
	`)}function Mg(){return pl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Sg(){return pl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function HS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===ah||f===lh)if(t.has(h)){let _=t.get(h).texture;return a(_,h.mapping)}else{let _=h.image;if(_&&_.height>0){let y=new fl(_.height);return y.fromEquirectangularTexture(n,h),t.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,_=f===ah||f===lh,y=f===Dr||f===Ho;if(_||y){let m=e.get(h),p=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return i===null&&(i=new Jh(n)),m=_?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),m.texture;if(m!==void 0)return m.texture;{let x=h.image;return _&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new Jh(n)),m=_?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,f){return f===ah?h.mapping=Dr:f===lh&&(h.mapping=Ho),h}function l(h){let f=0,_=6;for(let y=0;y<_;y++)h[y]!==void 0&&f++;return f===_}function c(h){let f=h.target;f.removeEventListener("dispose",c);let _=t.get(f);_!==void 0&&(t.delete(f),_.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let _=e.get(f);_!==void 0&&(e.delete(f),_.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function WS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Pa("WebGLRenderer: "+i+" extension not supported."),s}}}function XS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){l(_.target)}function l(_){_.index!==null&&t.remove(_.index);for(let m in _.attributes)t.remove(_.attributes[m]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let y=r.get(_);y&&(t.remove(y),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,e.memory.geometries--}function c(_,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(_){let y=_.attributes;for(let m in y)t.update(y[m],n.ARRAY_BUFFER)}function d(_){let y=_.index,m=_.attributes.position,p=0;if(m===void 0)return;let x=y!==null?y.array.length:m.array.length/3-1,M=m.count>=65535?Ga:Va,v=new M(Math.ceil(x/3)*6,1),T=v.array;if(y!==null){let g=y.array;p=y.version;for(let b=0,P=0;b<x;b+=3){let I=g[b+0],C=g[b+1],U=g[b+2];T[P++]=I,T[P++]=C,T[P++]=C,T[P++]=U,T[P++]=U,T[P++]=I}}else{p=m.version;for(let g=0,b=0;g<x;g+=3){let P=g+0,I=g+1,C=g+2;T[b++]=P,T[b++]=I,T[b++]=I,T[b++]=C,T[b++]=C,T[b++]=P}}v.version=p;let w=r.get(_);w&&t.remove(w),r.set(_,v)}function h(_){let y=r.get(_);if(y){let m=_.index;m!==null&&y.version<m.version&&d(_)}else d(_);return r.get(_)}function f(){for(let _ in s){let y=s[_].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:f}}function $S(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),e.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),e.update(h,i,f))}function u(d,h,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let y=0;for(let m=0;m<f;m++)y+=h[m];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function qS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ee("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function YS(n,t,e){let i=new WeakMap,s=new en;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let P=function(){g.dispose(),i.delete(a),a.removeEventListener("dispose",P)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],M=0;f===!0&&(M=1),_===!0&&(M=2),y===!0&&(M=3);let v=a.attributes.position.count*M,T=1;v>t.maxTextureSize&&(T=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let w=new Float32Array(v*T*4*d),g=new Ba(w,v,T,d);g.type=Wi,g.needsUpdate=!0;let b=M*4;for(let I=0;I<d;I++){let C=m[I],U=p[I],O=x[I],L=v*T*4*I;for(let B=0;B<C.count;B++){let $=B*b;f===!0&&(s.fromBufferAttribute(C,B),w[L+$+0]=s.x,w[L+$+1]=s.y,w[L+$+2]=s.z,w[L+$+3]=0),_===!0&&(s.fromBufferAttribute(U,B),w[L+$+4]=s.x,w[L+$+5]=s.y,w[L+$+6]=s.z,w[L+$+7]=0),y===!0&&(s.fromBufferAttribute(O,B),w[L+$+8]=s.x,w[L+$+9]=s.y,w[L+$+10]=s.z,w[L+$+11]=O.itemSize===4?s.w:1)}}h={count:d,texture:g,size:new Zt(v,T)},i.set(a,h),a.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let _=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function ZS(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=t.get(c,d);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var JS={[Cd]:"LINEAR_TONE_MAPPING",[Pd]:"REINHARD_TONE_MAPPING",[Id]:"CINEON_TONE_MAPPING",[Ld]:"ACES_FILMIC_TONE_MAPPING",[Nd]:"AGX_TONE_MAPPING",[Ud]:"NEUTRAL_TONE_MAPPING",[Dd]:"CUSTOM_TONE_MAPPING"};function KS(n,t,e,i,s,r){let o=new vi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Bn;u.setAttribute("position",new pn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new pn([0,2,0,0,2,0],2));let d=new Xc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new qn(u,d),f=new Qa(-1,1,1,-1,0,1),_=null,y=null,m=!1,p,x=null,M=[],v=!1;this.setSize=function(T,w){o.setSize(T,w),a!==null&&a.setSize(T,w),l!==null&&l.setSize(T,w);for(let g=0;g<M.length;g++){let b=M[g];b.setSize&&b.setSize(T,w)}},this.setEffects=function(T){M=T,v=M.length>0&&M[0].isRenderPass===!0;let w=o.width,g=o.height;M.length>0&&a===null&&(a=new vi(w,g,{type:Xi,depthBuffer:!1,stencilBuffer:!1}),l=new vi(w,g,{type:Xi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&M.some(P=>P.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&c===null&&(c=new Ds(w,g),r===!0&&(c.format=Fs,c.type=Nr)),o.dispose(),o.depthTexture=b?c:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let P=0;P<M.length;P++){let I=M[P];I.setSize&&I.setSize(w,g),b&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(T,w){if(m||T.toneMapping===us&&M.length===0)return!1;if(x=w,w!==null){let g=w.width,b=w.height;(o.width!==g||o.height!==b)&&this.setSize(g,b)}return v===!1&&T.setRenderTarget(o),p=T.toneMapping,T.toneMapping=us,!0},this.hasRenderPass=function(){return v},this.end=function(T,w){T.toneMapping=p,m=!0;let g=o,b=a;for(let P=0;P<M.length;P++){let I=M[P];I.enabled!==!1&&(I.render(T,b,g,w),I.needsSwap!==!1&&(g=b,b=b===a?l:a))}if(_!==T.outputColorSpace||y!==T.toneMapping){_=T.outputColorSpace,y=T.toneMapping,d.defines={},Se.getTransfer(_)===Ne&&(d.defines.SRGB_TRANSFER="");let P=JS[y];P&&(d.defines[P]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=g.texture,T.setRenderTarget(x),T.render(h,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var Wg=new ri,Xg=new Ds(1,1),$g=new qa(1),qg=new Ba,Yg=new Oc,Zg=new Xa,bg=[],wg=[],Tg=new Float32Array(16),Eg=new Float32Array(9),Ag=new Float32Array(4);function $o(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=bg[s];if(r===void 0&&(r=new Float32Array(s),bg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function En(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function An(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function jh(n,t){let e=wg[t];e===void 0&&(e=new Int32Array(t),wg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function jS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function QS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(En(e,t))return;n.uniform2fv(this.addr,t),An(e,t)}}function tb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(En(e,t))return;n.uniform3fv(this.addr,t),An(e,t)}}function eb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(En(e,t))return;n.uniform4fv(this.addr,t),An(e,t)}}function nb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(En(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),An(e,t)}else{if(En(e,i))return;Ag.set(i),n.uniformMatrix2fv(this.addr,!1,Ag),An(e,i)}}function ib(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(En(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),An(e,t)}else{if(En(e,i))return;Eg.set(i),n.uniformMatrix3fv(this.addr,!1,Eg),An(e,i)}}function sb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(En(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),An(e,t)}else{if(En(e,i))return;Tg.set(i),n.uniformMatrix4fv(this.addr,!1,Tg),An(e,i)}}function rb(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function ob(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(En(e,t))return;n.uniform2iv(this.addr,t),An(e,t)}}function ab(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(En(e,t))return;n.uniform3iv(this.addr,t),An(e,t)}}function lb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(En(e,t))return;n.uniform4iv(this.addr,t),An(e,t)}}function cb(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function hb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(En(e,t))return;n.uniform2uiv(this.addr,t),An(e,t)}}function ub(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(En(e,t))return;n.uniform3uiv(this.addr,t),An(e,t)}}function db(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(En(e,t))return;n.uniform4uiv(this.addr,t),An(e,t)}}function Qh(n){return n.version===0&&(n.compareFunction=$d,n.needsUpdate=!0),n}function fb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Qh(Xg):r=Wg,e.setTexture2D(t||r,s)}function pb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Yg,s)}function mb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Qh($g):r=Zg,e.setTextureCube(t||r,s)}function gb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||qg,s)}function _b(n){switch(n){case 5126:return jS;case 35664:return QS;case 35665:return tb;case 35666:return eb;case 35674:return nb;case 35675:return ib;case 35676:return sb;case 5124:case 35670:return rb;case 35667:case 35671:return ob;case 35668:case 35672:return ab;case 35669:case 35673:return lb;case 5125:return cb;case 36294:return hb;case 36295:return ub;case 36296:return db;case 35678:case 36198:case 36298:case 36306:case 35682:return fb;case 35679:case 36299:case 36307:return pb;case 35680:case 36300:case 36308:case 36293:return mb;case 36289:case 36303:case 36311:case 36292:return gb}}function xb(n,t){n.uniform1fv(this.addr,t)}function yb(n,t){let e=$o(t,this.size,2);n.uniform2fv(this.addr,e)}function vb(n,t){let e=$o(t,this.size,3);n.uniform3fv(this.addr,e)}function Mb(n,t){let e=$o(t,this.size,4);n.uniform4fv(this.addr,e)}function Sb(n,t){let e=$o(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function bb(n,t){let e=$o(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function wb(n,t){let e=$o(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Tb(n,t){n.uniform1iv(this.addr,t)}function Eb(n,t){n.uniform2iv(this.addr,t)}function Ab(n,t){n.uniform3iv(this.addr,t)}function Rb(n,t){n.uniform4iv(this.addr,t)}function Cb(n,t){n.uniform1uiv(this.addr,t)}function Pb(n,t){n.uniform2uiv(this.addr,t)}function Ib(n,t){n.uniform3uiv(this.addr,t)}function Lb(n,t){n.uniform4uiv(this.addr,t)}function Db(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Qh(Xg):o=Wg;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Nb(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Yg,r[o])}function Ub(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Qh($g):o=Zg;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Fb(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);En(i,r)||(n.uniform1iv(this.addr,r),An(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||qg,r[o])}function Ob(n){switch(n){case 5126:return xb;case 35664:return yb;case 35665:return vb;case 35666:return Mb;case 35674:return Sb;case 35675:return bb;case 35676:return wb;case 5124:case 35670:return Tb;case 35667:case 35671:return Eb;case 35668:case 35672:return Ab;case 35669:case 35673:return Rb;case 5125:return Cb;case 36294:return Pb;case 36295:return Ib;case 36296:return Lb;case 35678:case 36198:case 36298:case 36306:case 35682:return Db;case 35679:case 36299:case 36307:return Nb;case 35680:case 36300:case 36308:case 36293:return Ub;case 36289:case 36303:case 36311:case 36292:return Fb}}var af=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=_b(e.type)}},lf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Ob(e.type)}},cf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},rf=/(\w+)(\])?(\[|\.)?/g;function Rg(n,t){n.seq.push(t),n.map[t.id]=t}function Bb(n,t,e){let i=n.name,s=i.length;for(rf.lastIndex=0;;){let r=rf.exec(i),o=rf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Rg(e,c===void 0?new af(a,n,t):new lf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new cf(a),Rg(e,d)),e=d}}}var Xo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Bb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Cg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var kb=37297,zb=0;function Vb(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Pg=new ae;function Gb(n){Se._getMatrix(Pg,Se.workingColorSpace,n);let t=`mat3( ${Pg.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(n)){case Ua:return[t,"LinearTransferOETF"];case Ne:return[t,"sRGBTransferOETF"];default:return Kt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Ig(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Vb(n.getShaderSource(t),a)}else return r}function Hb(n,t){let e=Gb(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Wb={[Cd]:"Linear",[Pd]:"Reinhard",[Id]:"Cineon",[Ld]:"ACESFilmic",[Nd]:"AgX",[Ud]:"Neutral",[Dd]:"Custom"};function Xb(n,t){let e=Wb[t];return e===void 0?(Kt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Zh=new q;function $b(){Se.getLuminanceCoefficients(Zh);let n=Zh.x.toFixed(4),t=Zh.y.toFixed(4),e=Zh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function qb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(dl).join(`
`)}function Yb(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Zb(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function dl(n){return n!==""}function Lg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Dg(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Jb=/^[ \t]*#include +<([\w\d./]+)>/gm;function hf(n){return n.replace(Jb,Kb)}function Kb(n,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return hf(e)}var jb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ng(n){return n.replace(jb,Qb)}function Qb(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ug(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var tw={[il]:"SHADOWMAP_TYPE_PCF",[Vo]:"SHADOWMAP_TYPE_VSM"};function ew(n){return tw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var nw={[Ho]:"ENVMAP_MODE_REFRACTION"};function iw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":nw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var sw={[oh]:"ENVMAP_BLENDING_MULTIPLY",[Qm]:"ENVMAP_BLENDING_MIX",[tg]:"ENVMAP_BLENDING_ADD"};function rw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":sw[n.combine]||"ENVMAP_BLENDING_NONE"}function ow(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=ew(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=iw(e),d=rw(e),h=qb(e),f=Yb(r),_=s.createProgram(),y,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(dl).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(dl).join(`
`),m.length>0&&(m+=`
`)):(y=[Ug(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(dl).join(`
`),m=[Ug(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==us?"#define TONE_MAPPING":"",e.toneMapping!==us?me.tonemapping_pars_fragment:"",e.toneMapping!==us?Xb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,Hb("linearToOutputTexel",e.outputColorSpace),$b(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(dl).join(`
`)),o=hf(o),o=Lg(o,e),o=Dg(o,e),a=hf(a),a=Lg(a,e),a=Dg(a,e),o=Ng(o),a=Ng(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Yd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Yd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=p+y+o,M=p+m+a,v=Cg(s,s.VERTEX_SHADER,x),T=Cg(s,s.FRAGMENT_SHADER,M);s.attachShader(_,v),s.attachShader(_,T),e.index0AttributeName!==void 0?s.bindAttribLocation(_,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function w(I){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(_)||"",U=s.getShaderInfoLog(v)||"",O=s.getShaderInfoLog(T)||"",L=C.trim(),B=U.trim(),$=O.trim(),V=!0,J=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,v,T);else{let G=Ig(s,v,"vertex"),Y=Ig(s,T,"fragment");ee("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+L+`
`+G+`
`+Y)}else L!==""?Kt("WebGLProgram: Program Info Log:",L):(B===""||$==="")&&(J=!1);J&&(I.diagnostics={runnable:V,programLog:L,vertexShader:{log:B,prefix:y},fragmentShader:{log:$,prefix:m}})}s.deleteShader(v),s.deleteShader(T),g=new Xo(s,_),b=Zb(s,_)}let g;this.getUniforms=function(){return g===void 0&&w(this),g};let b;this.getAttributes=function(){return b===void 0&&w(this),b};let P=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return P===!1&&(P=s.getProgramParameter(_,kb)),P},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=zb++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=v,this.fragmentShader=T,this}var aw=0,uf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new df(t),e.set(t,i)),i}},df=class{constructor(t){this.id=aw++,this.code=t,this.usedTimes=0}};function lw(n){return n===fr||n===cl||n===hl}function cw(n,t,e,i,s,r){let o=new ka,a=new uf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(g){return l.add(g),g===0?"uv":`uv${g}`}function _(g,b,P,I,C,U){let O=I.fog,L=C.geometry,B=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?I.environment:null,$=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,V=t.get(g.envMap||B,$),J=h[g.type],G=i.precision;g.precision!==null&&(G=i.getMaxPrecision(g.precision),G!==g.precision&&Kt("WebGLProgram.getParameters:",g.precision,"not supported, using",G,"instead."));let Y=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,et=Y!==void 0?Y.length:0,lt=0;L.morphAttributes.position!==void 0&&(lt=1),L.morphAttributes.normal!==void 0&&(lt=2),L.morphAttributes.color!==void 0&&(lt=3);let rt,K,ut,pt;if(J){let Ct=fs[J];rt=Ct.vertexShader,K=Ct.fragmentShader}else{rt=g.vertexShader,K=g.fragmentShader;let Ct=a.getVertexShaderStage(g),de=a.getFragmentShaderStage(g);a.update(g,Ct,de),ut=Ct.id,pt=de.id}let yt=n.getRenderTarget(),_t=n.state.buffers.depth.getReversed(),Wt=C.isInstancedMesh===!0,oe=C.isBatchedMesh===!0,Ot=!!g.map,ce=!!g.matcap,ue=!!V,ne=ue&&V.isPMREMTexture===!0,We=!!g.aoMap,he=!!g.lightMap,Ce=!!g.bumpMap&&g.wireframe===!1,Pe=!!g.normalMap,gn=!!g.displacementMap,ve=!!g.emissiveMap,hn=!!g.metalnessMap,Qe=!!g.roughnessMap,sn=g.anisotropy>0,k=g.clearcoat>0,Rt=g.diffuseRoughness>0,Yt=g.dispersion>0,ie=g.retroreflectivity>0,wt=g.iridescence>0,Ve=g.sheen>0,Ht=g.transmission>0,Jt=sn&&!!g.anisotropyMap,D=k&&!!g.clearcoatMap,E=k&&!!g.clearcoatNormalMap,Z=k&&!!g.clearcoatRoughnessMap,ft=Rt&&!!g.diffuseRoughnessMap,ct=wt&&!!g.iridescenceMap,vt=wt&&!!g.iridescenceThicknessMap,Mt=Ve&&!!g.sheenColorMap,it=Ve&&!!g.sheenRoughnessMap,ot=!!g.specularMap,gt=!!g.specularColorMap,z=!!g.specularIntensityMap,at=Ht&&!!g.transmissionMap,st=Ht&&!!g.thicknessMap,Tt=!!g.gradientMap,xt=!!g.alphaMap,bt=g.alphaTest>0,Xt=!!g.alphaHash,Qt=!!g.extensions,dt=us;g.toneMapped&&(yt===null||yt.isXRRenderTarget===!0)&&(dt=n.toneMapping);let zt=ne?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,te={shaderID:J,shaderType:g.type,shaderName:g.name,vertexShader:rt,fragmentShader:K,defines:g.defines,customVertexShaderID:ut,customFragmentShaderID:pt,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:G,batching:oe,batchingColor:oe&&C._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&C.instanceColor!==null,instancingMorph:Wt&&C.morphTexture!==null,outputColorSpace:yt===null?n.outputColorSpace:yt.isXRRenderTarget===!0?yt.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:Ot,matcap:ce,envMap:ue,envMapMode:ue&&V.mapping,envMapPMREM:ne,envMapMaxLod:ne?zt.length-1:null,envMapSize:ne?zt[0].width:null,aoMap:We,lightMap:he,bumpMap:Ce,normalMap:Pe,displacementMap:gn,emissiveMap:ve,normalMapObjectSpace:Pe&&g.normalMapType===ig,normalMapTangentSpace:Pe&&g.normalMapType===$h,packedNormalMap:Pe&&g.normalMapType===$h&&lw(g.normalMap.format),metalnessMap:hn,roughnessMap:Qe,anisotropy:sn,anisotropyMap:Jt,clearcoat:k,clearcoatMap:D,clearcoatNormalMap:E,clearcoatRoughnessMap:Z,diffuseRoughness:Rt,diffuseRoughnessMap:ft,dispersion:Yt,retroreflection:ie,iridescence:wt,iridescenceMap:ct,iridescenceThicknessMap:vt,sheen:Ve,sheenColorMap:Mt,sheenRoughnessMap:it,specularMap:ot,specularColorMap:gt,specularIntensityMap:z,transmission:Ht,transmissionMap:at,thicknessMap:st,gradientMap:Tt,opaque:g.transparent===!1&&g.blending===Go&&g.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Xt,combine:g.combine,mapUv:Ot&&f(g.map.channel),aoMapUv:We&&f(g.aoMap.channel),lightMapUv:he&&f(g.lightMap.channel),bumpMapUv:Ce&&f(g.bumpMap.channel),normalMapUv:Pe&&f(g.normalMap.channel),displacementMapUv:gn&&f(g.displacementMap.channel),emissiveMapUv:ve&&f(g.emissiveMap.channel),metalnessMapUv:hn&&f(g.metalnessMap.channel),roughnessMapUv:Qe&&f(g.roughnessMap.channel),anisotropyMapUv:Jt&&f(g.anisotropyMap.channel),clearcoatMapUv:D&&f(g.clearcoatMap.channel),clearcoatNormalMapUv:E&&f(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&f(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&f(g.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&f(g.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&f(g.iridescenceThicknessMap.channel),sheenColorMapUv:Mt&&f(g.sheenColorMap.channel),sheenRoughnessMapUv:it&&f(g.sheenRoughnessMap.channel),specularMapUv:ot&&f(g.specularMap.channel),specularColorMapUv:gt&&f(g.specularColorMap.channel),specularIntensityMapUv:z&&f(g.specularIntensityMap.channel),transmissionMapUv:at&&f(g.transmissionMap.channel),thicknessMapUv:st&&f(g.thicknessMap.channel),alphaMapUv:xt&&f(g.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Pe||sn),vertexNormals:!!L.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!L.attributes.uv&&(Ot||xt),fog:!!O,useFog:g.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||L.attributes.normal===void 0&&Pe===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:_t,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:lt,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:U.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:g.dithering,shadowMapEnabled:n.shadowMap.enabled&&P.length>0,shadowMapType:n.shadowMap.type,toneMapping:dt,decodeVideoTexture:Ot&&g.map.isVideoTexture===!0&&Se.getTransfer(g.map.colorSpace)===Ne,decodeVideoTextureEmissive:ve&&g.emissiveMap.isVideoTexture===!0&&Se.getTransfer(g.emissiveMap.colorSpace)===Ne,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===li,flipSided:g.side===oi,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:Qt&&g.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&g.extensions.multiDraw===!0||oe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function y(g){let b=[];if(g.shaderID?b.push(g.shaderID):(b.push(g.customVertexShaderID),b.push(g.customFragmentShaderID)),g.defines!==void 0)for(let P in g.defines)b.push(P),b.push(g.defines[P]);return g.isRawShaderMaterial===!1&&(m(b,g),p(b,g),b.push(n.outputColorSpace)),b.push(g.customProgramCacheKey),b.join()}function m(g,b){g.push(b.precision),g.push(b.outputColorSpace),g.push(b.envMapMode),g.push(b.envMapPMREM),g.push(b.envMapMaxLod),g.push(b.envMapSize),g.push(b.mapUv),g.push(b.alphaMapUv),g.push(b.lightMapUv),g.push(b.aoMapUv),g.push(b.bumpMapUv),g.push(b.normalMapUv),g.push(b.displacementMapUv),g.push(b.emissiveMapUv),g.push(b.metalnessMapUv),g.push(b.roughnessMapUv),g.push(b.anisotropyMapUv),g.push(b.clearcoatMapUv),g.push(b.clearcoatNormalMapUv),g.push(b.clearcoatRoughnessMapUv),g.push(b.diffuseRoughnessMapUv),g.push(b.iridescenceMapUv),g.push(b.iridescenceThicknessMapUv),g.push(b.sheenColorMapUv),g.push(b.sheenRoughnessMapUv),g.push(b.specularMapUv),g.push(b.specularColorMapUv),g.push(b.specularIntensityMapUv),g.push(b.transmissionMapUv),g.push(b.thicknessMapUv),g.push(b.combine),g.push(b.fogExp2),g.push(b.sizeAttenuation),g.push(b.morphTargetsCount),g.push(b.numSunLights),g.push(b.numDirLights),g.push(b.numPointLights),g.push(b.numSpotLights),g.push(b.numSpotLightMaps),g.push(b.numHemiLights),g.push(b.numRectAreaLights),g.push(b.numSunLightShadows),g.push(b.numDirLightShadows),g.push(b.numPointLightShadows),g.push(b.numSpotLightShadows),g.push(b.numSpotLightShadowsWithMaps),g.push(b.numLightProbes),g.push(b.numLightProbeGrids),g.push(b.shadowMapType),g.push(b.toneMapping),g.push(b.numClippingPlanes),g.push(b.numClipIntersection),g.push(b.depthPacking)}function p(g,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),g.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),g.push(o.mask)}function x(g){let b=h[g.type],P;if(b){let I=fs[b];P=gg.clone(I.uniforms)}else P=g.uniforms;return P}function M(g,b){let P=u.get(b);return P!==void 0?++P.usedTimes:(P=new ow(n,b,g,s),c.push(P),u.set(b,P)),P}function v(g){if(--g.usedTimes===0){let b=c.indexOf(g);c[b]=c[c.length-1],c.pop(),u.delete(g.cacheKey),g.destroy()}}function T(g){a.remove(g)}function w(){a.dispose()}return{getParameters:_,getProgramCacheKey:y,getUniforms:x,acquireProgram:M,releaseProgram:v,releaseShaderCache:T,programs:c,dispose:w}}function hw(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function uw(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Fg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Og(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,_,y,m,p){let x=n[t];return x===void 0?(x={id:h.id,object:h,geometry:f,material:_,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:m,group:p},n[t]=x):(x.id=h.id,x.object=h,x.geometry=f,x.material=_,x.materialVariant=o(h),x.groupOrder=y,x.renderOrder=h.renderOrder,x.z=m,x.group=p),t++,x}function l(h,f,_,y,m,p,x){x.reversedDepth===!0&&(m=-m);let M=a(h,f,_,y,m,p);_.transmission>0?i.push(M):_.transparent===!0?s.push(M):e.push(M)}function c(h,f,_,y,m,p){let x=a(h,f,_,y,m,p);_.transmission>0?i.unshift(x):_.transparent===!0?s.unshift(x):e.unshift(x)}function u(h,f){e.length>1&&e.sort(h||uw),i.length>1&&i.sort(f||Fg),s.length>1&&s.sort(f||Fg)}function d(){for(let h=t,f=n.length;h<f;h++){let _=n[h];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function dw(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Og,n.set(i,[o])):s>=r.length?(o=new Og,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function fw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new q,color:new fe};break;case"SpotLight":e={position:new q,direction:new q,color:new fe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new q,color:new fe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new q,skyColor:new fe,groundColor:new fe};break;case"RectAreaLight":e={color:new fe,position:new q,halfWidth:new q,halfHeight:new q};break}return n[t.id]=e,e}}}function pw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var mw=0;function gw(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function _w(n){let t=new fw,e=pw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new q);let s=new q,r=new Xe,o=new Xe;function a(c){let u=0,d=0,h=0;for(let U=0;U<9;U++)i.probe[U].set(0,0,0);let f=0,_=0,y=0,m=0,p=0,x=0,M=0,v=0,T=0,w=0,g=0,b=0,P=0,I=0;c.sort(gw);for(let U=0,O=c.length;U<O;U++){let L=c[U],B=L.color,$=L.intensity,V=L.distance,J=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===fr?J=L.shadow.map.texture:J=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=B.r*$,d+=B.g*$,h+=B.b*$;else if(L.isLightProbe){for(let G=0;G<9;G++)i.probe[G].addScaledVector(L.sh.coefficients[G],$);I++}else if(L.isSunLight){let G=t.get(L);if(G.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Y=L.shadow,et=e.get(L);et.shadowIntensity=Y.intensity,et.shadowBias=Y.bias,et.shadowNormalBias=Y.normalBias,et.shadowRadius=Y.radius,et.shadowMapSize.copy(Y.mapSize).multiply(Y.getFrameExtents()),i.sunShadow[_]=et,i.sunShadowMap[_]=J;let lt=Y.getViewportCount();for(let rt=0;rt<lt;rt++)i.sunShadowMatrix[y+rt]=Y.getMatrix(rt),i.sunShadowCascade[y+rt]=Y._cascadeData[rt];y+=lt,_++}i.sun[f]=G,f++}else if(L.isDirectionalLight){let G=t.get(L);if(G.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Y=L.shadow,et=e.get(L);et.shadowIntensity=Y.intensity,et.shadowBias=Y.bias,et.shadowNormalBias=Y.normalBias,et.shadowRadius=Y.radius,et.shadowMapSize=Y.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=J,i.directionalShadowMatrix[m]=L.shadow.matrix,T++}i.directional[m]=G,m++}else if(L.isSpotLight){let G=t.get(L);G.position.setFromMatrixPosition(L.matrixWorld),G.color.copy(B).multiplyScalar($),G.distance=V,G.coneCos=Math.cos(L.angle),G.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),G.decay=L.decay,i.spot[x]=G;let Y=L.shadow;if(L.map&&(i.spotLightMap[b]=L.map,b++,Y.updateMatrices(L),L.castShadow&&P++),i.spotLightMatrix[x]=Y.matrix,L.castShadow){let et=e.get(L);et.shadowIntensity=Y.intensity,et.shadowBias=Y.bias,et.shadowNormalBias=Y.normalBias,et.shadowRadius=Y.radius,et.shadowMapSize=Y.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=J,g++}x++}else if(L.isRectAreaLight){let G=t.get(L);G.color.copy(B).multiplyScalar($),G.halfWidth.set(L.width*.5,0,0),G.halfHeight.set(0,L.height*.5,0),i.rectArea[M]=G,M++}else if(L.isPointLight){let G=t.get(L);if(G.color.copy(L.color).multiplyScalar(L.intensity),G.distance=L.distance,G.decay=L.decay,L.castShadow){let Y=L.shadow,et=e.get(L);et.shadowIntensity=Y.intensity,et.shadowBias=Y.bias,et.shadowNormalBias=Y.normalBias,et.shadowRadius=Y.radius,et.shadowMapSize=Y.mapSize,et.shadowCameraNear=Y.camera.near,et.shadowCameraFar=Y.camera.far,i.pointShadow[p]=et,i.pointShadowMap[p]=J,i.pointShadowMatrix[p]=L.shadow.matrix,w++}i.point[p]=G,p++}else if(L.isHemisphereLight){let G=t.get(L);G.skyColor.copy(L.color).multiplyScalar($),G.groundColor.copy(L.groundColor).multiplyScalar($),i.hemi[v]=G,v++}}M>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Nt.LTC_FLOAT_1,i.rectAreaLTC2=Nt.LTC_FLOAT_2):(i.rectAreaLTC1=Nt.LTC_HALF_1,i.rectAreaLTC2=Nt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let C=i.hash;(C.sunLength!==f||C.directionalLength!==m||C.pointLength!==p||C.spotLength!==x||C.rectAreaLength!==M||C.hemiLength!==v||C.numSunShadows!==_||C.numDirectionalShadows!==T||C.numPointShadows!==w||C.numSpotShadows!==g||C.numSpotMaps!==b||C.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=M,i.point.length=p,i.hemi.length=v,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=g,i.spotShadowMap.length=g,i.spotLightMatrix.length=g+b-P,i.spotLightMap.length=b,i.numSpotLightShadowsWithMaps=P,i.numLightProbes=I,C.sunLength=f,C.directionalLength=m,C.pointLength=p,C.spotLength=x,C.rectAreaLength=M,C.hemiLength=v,C.numSunShadows=_,C.numDirectionalShadows=T,C.numPointShadows=w,C.numSpotShadows=g,C.numSpotMaps=b,C.numLightProbes=I,i.version=mw++)}function l(c,u){let d=0,h=0,f=0,_=0,y=0,m=0,p=u.matrixWorldInverse;for(let x=0,M=c.length;x<M;x++){let v=c[x];if(v.isSunLight){let T=i.sun[d];T.direction.setFromMatrixPosition(v.matrixWorld),T.direction.transformDirection(p),d++}else if(v.isDirectionalLight){let T=i.directional[h];T.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(p),h++}else if(v.isSpotLight){let T=i.spot[_];T.position.setFromMatrixPosition(v.matrixWorld),T.position.applyMatrix4(p),T.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(p),_++}else if(v.isRectAreaLight){let T=i.rectArea[y];T.position.setFromMatrixPosition(v.matrixWorld),T.position.applyMatrix4(p),o.identity(),r.copy(v.matrixWorld),r.premultiply(p),o.extractRotation(r),T.halfWidth.set(v.width*.5,0,0),T.halfHeight.set(0,v.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let T=i.point[f];T.position.setFromMatrixPosition(v.matrixWorld),T.position.applyMatrix4(p),f++}else if(v.isHemisphereLight){let T=i.hemi[m];T.direction.setFromMatrixPosition(v.matrixWorld),T.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function Bg(n){let t=new _w(n),e=[],i=[],s=[];function r(d){u.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){t.setupView(e,d)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function xw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Bg(n),t.set(s,[a])):r>=o.length?(a=new Bg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var yw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,vw=`uniform sampler2D shadow_pass;
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
}`,Mw=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],Sw=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],kg=new Xe,ul=new q,of=new q;function bw(n,t,e){let i=new or,s=new Zt,r=new Zt,o=new en,a=new $c,l=new qc,c={},u=e.maxTextureSize,d={[hs]:oi,[oi]:hs,[li]:li},h=new cs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:yw,fragmentShader:vw}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let _=new Bn;_.setAttribute("position",new ii(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new qn(_,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=il;let p=this.type;this.render=function(w,g,b){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===Nm&&(Kt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=il);let P=n.getRenderTarget(),I=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),U=n.state;U.setBlending(Ir),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let O=p!==this.type;O&&g.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(B=>B.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,B=w.length;L<B;L++){let $=w[L],V=$.shadow;if(V===void 0){Kt("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let J=V.getFrameExtents();s.multiply(J),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/J.x),s.x=r.x*J.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/J.y),s.y=r.y*J.y,V.mapSize.y=r.y));let G=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=G,V.map===null||O===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Vo){if($.isPointLight){Kt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new vi(s.x,s.y,{format:fr,type:Xi,minFilter:si,magFilter:si,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new Ds(s.x,s.y,Wi),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=Is,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=On,V.map.depthTexture.magFilter=On}else $.isPointLight?(V.map=new fl(s.x),V.map.depthTexture=new qa(s.x,Hi)):(V.map=new vi(s.x,s.y),V.map.depthTexture=new Ds(s.x,s.y,Hi)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=Is,this.type===il?(V.map.depthTexture.compareFunction=G?Xd:Wd,V.map.depthTexture.minFilter=si,V.map.depthTexture.magFilter=si):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=On,V.map.depthTexture.magFilter=On);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Y=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,b);let et=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:b.layers;for(let lt=0;lt<Y;lt++){let rt=V.getCamera(lt);if($.isPointLight){let K=V.camera,ut=V.matrix,pt=$.distance||K.far;pt!==K.far&&(K.far=pt,K.updateProjectionMatrix()),ul.setFromMatrixPosition($.matrixWorld),K.position.copy(ul),of.copy(K.position),of.add(Mw[lt]),K.up.copy(Sw[lt]),K.lookAt(of),K.updateMatrixWorld(),ut.makeTranslation(-ul.x,-ul.y,-ul.z),kg.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),V._frustum.setFromProjectionMatrix(kg,K.coordinateSystem,K.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,lt),n.clear();else{lt===0&&(n.setRenderTarget(V.map),n.clear());let K=V.getViewport(lt);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),U.viewport(o)}i=V.getFrustum(lt),v(g,b,rt,$,et,this.type)}V.isPointLightShadow!==!0&&this.type===Vo&&x(V,b),V.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(P,I,C)};function x(w,g){let b=t.update(y);h.defines.VSM_SAMPLES!==w.blurSamples&&(h.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new vi(s.x,s.y,{format:fr,type:Xi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),h.uniforms.shadow_pass.value=w.map.depthTexture,h.uniforms.resolution.value.set(w.map.width,w.map.height),h.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(g,null,b,h,y,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(g,null,b,f,y,null)}function M(w,g,b,P){let I=null,C=b.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(C!==void 0)I=C;else if(I=b.isPointLight===!0?l:a,n.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){let U=I.uuid,O=g.uuid,L=c[U];L===void 0&&(L={},c[U]=L);let B=L[O];B===void 0&&(B=I.clone(),L[O]=B,g.addEventListener("dispose",T)),I=B}if(I.visible=g.visible,I.wireframe=g.wireframe,P===Vo?I.side=g.shadowSide!==null?g.shadowSide:g.side:I.side=g.shadowSide!==null?g.shadowSide:d[g.side],I.alphaMap=g.alphaMap,I.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,I.map=g.map,I.clipShadows=g.clipShadows,I.clippingPlanes=g.clippingPlanes,I.clipIntersection=g.clipIntersection,I.displacementMap=g.displacementMap,I.displacementScale=g.displacementScale,I.displacementBias=g.displacementBias,I.wireframeLinewidth=g.wireframeLinewidth,I.linewidth=g.linewidth,b.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let U=n.properties.get(I);U.light=b}return I}function v(w,g,b,P,I,C){if(w.visible===!1)return;if(w.layers.test(I)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&C===Vo)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,w.matrixWorld);let L=t.update(w),B=w.material;if(Array.isArray(B)){let $=L.groups;for(let V=0,J=$.length;V<J;V++){let G=$[V],Y=B[G.materialIndex];if(Y&&Y.visible){let et=M(w,Y,P,C);w.onBeforeShadow(n,w,g,b,L,et,G),n.renderBufferDirect(b,null,L,et,w,G),w.onAfterShadow(n,w,g,b,L,et,G)}}}else if(B.visible){let $=M(w,B,P,C);w.onBeforeShadow(n,w,g,b,L,$,null),n.renderBufferDirect(b,null,L,$,w,null),w.onAfterShadow(n,w,g,b,L,$,null)}}let O=w.children;for(let L=0,B=O.length;L<B;L++)v(O[L],g,b,P,I,C)}function T(w){w.target.removeEventListener("dispose",T);for(let b in c){let P=c[b],I=w.target.uuid;I in P&&(P[I].dispose(),delete P[I])}}}function ww(n,t){function e(){let z=!1,at=new en,st=null,Tt=new en(0,0,0,0);return{setMask:function(xt){st!==xt&&!z&&(n.colorMask(xt,xt,xt,xt),st=xt)},setLocked:function(xt){z=xt},setClear:function(xt,bt,Xt,Qt,dt){dt===!0&&(xt*=Qt,bt*=Qt,Xt*=Qt),at.set(xt,bt,Xt,Qt),Tt.equals(at)===!1&&(n.clearColor(xt,bt,Xt,Qt),Tt.copy(at))},reset:function(){z=!1,st=null,Tt.set(-1,0,0,0)}}}function i(){let z=!1,at=!1,st=null,Tt=null,xt=null;return{setReversed:function(bt){if(at!==bt){let Xt=t.get("EXT_clip_control");bt?Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.ZERO_TO_ONE_EXT):Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.NEGATIVE_ONE_TO_ONE_EXT),at=bt;let Qt=xt;xt=null,this.setClear(Qt)}},getReversed:function(){return at},setTest:function(bt){bt?_t(n.DEPTH_TEST):Wt(n.DEPTH_TEST)},setMask:function(bt){st!==bt&&!z&&(n.depthMask(bt),st=bt)},setFunc:function(bt){if(at&&(bt=fg[bt]),Tt!==bt){switch(bt){case Tc:n.depthFunc(n.NEVER);break;case Ec:n.depthFunc(n.ALWAYS);break;case Ac:n.depthFunc(n.LESS);break;case Io:n.depthFunc(n.LEQUAL);break;case Rc:n.depthFunc(n.EQUAL);break;case Cc:n.depthFunc(n.GEQUAL);break;case Pc:n.depthFunc(n.GREATER);break;case Ic:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Tt=bt}},setLocked:function(bt){z=bt},setClear:function(bt){xt!==bt&&(xt=bt,at&&(bt=1-bt),n.clearDepth(bt))},reset:function(){z=!1,st=null,Tt=null,xt=null,at=!1}}}function s(){let z=!1,at=null,st=null,Tt=null,xt=null,bt=null,Xt=null,Qt=null,dt=null;return{setTest:function(zt){z||(zt?_t(n.STENCIL_TEST):Wt(n.STENCIL_TEST))},setMask:function(zt){at!==zt&&!z&&(n.stencilMask(zt),at=zt)},setFunc:function(zt,te,Ct){(st!==zt||Tt!==te||xt!==Ct)&&(n.stencilFunc(zt,te,Ct),st=zt,Tt=te,xt=Ct)},setOp:function(zt,te,Ct){(bt!==zt||Xt!==te||Qt!==Ct)&&(n.stencilOp(zt,te,Ct),bt=zt,Xt=te,Qt=Ct)},setLocked:function(zt){z=zt},setClear:function(zt){dt!==zt&&(n.clearStencil(zt),dt=zt)},reset:function(){z=!1,at=null,st=null,Tt=null,xt=null,bt=null,Xt=null,Qt=null,dt=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},f=new WeakMap,_=[],y=null,m=!1,p=null,x=null,M=null,v=null,T=null,w=null,g=null,b=new fe(0,0,0),P=0,I=!1,C=null,U=null,O=null,L=null,B=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,J=0,G=n.getParameter(n.VERSION);G.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(G)[1]),V=J>=1):G.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),V=J>=2);let Y=null,et={},lt=n.getParameter(n.SCISSOR_BOX),rt=n.getParameter(n.VIEWPORT),K=new en().fromArray(lt),ut=new en().fromArray(rt);function pt(z,at,st,Tt){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(z,bt),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xt=0;Xt<st;Xt++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(at,0,n.RGBA,1,1,Tt,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(at+Xt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let yt={};yt[n.TEXTURE_2D]=pt(n.TEXTURE_2D,n.TEXTURE_2D,1),yt[n.TEXTURE_CUBE_MAP]=pt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),yt[n.TEXTURE_2D_ARRAY]=pt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),yt[n.TEXTURE_3D]=pt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),_t(n.DEPTH_TEST),o.setFunc(Io),Ce(!1),Pe(bd),_t(n.CULL_FACE),We(Ir);function _t(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function Wt(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function oe(z,at){return h[z]!==at?(n.bindFramebuffer(z,at),h[z]=at,z===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=at),z===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=at),!0):!1}function Ot(z,at){let st=_,Tt=!1;if(z){st=f.get(at),st===void 0&&(st=[],f.set(at,st));let xt=z.textures;if(st.length!==xt.length||st[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Xt=xt.length;bt<Xt;bt++)st[bt]=n.COLOR_ATTACHMENT0+bt;st.length=xt.length,Tt=!0}}else st[0]!==n.BACK&&(st[0]=n.BACK,Tt=!0);Tt&&n.drawBuffers(st)}function ce(z){return y!==z?(n.useProgram(z),y=z,!0):!1}let ue={[Lr]:n.FUNC_ADD,[Fm]:n.FUNC_SUBTRACT,[Om]:n.FUNC_REVERSE_SUBTRACT};ue[Bm]=n.MIN,ue[km]=n.MAX;let ne={[zm]:n.ZERO,[Vm]:n.ONE,[Gm]:n.SRC_COLOR,[Ad]:n.SRC_ALPHA,[Ym]:n.SRC_ALPHA_SATURATE,[$m]:n.DST_COLOR,[Wm]:n.DST_ALPHA,[Hm]:n.ONE_MINUS_SRC_COLOR,[Rd]:n.ONE_MINUS_SRC_ALPHA,[qm]:n.ONE_MINUS_DST_COLOR,[Xm]:n.ONE_MINUS_DST_ALPHA,[Zm]:n.CONSTANT_COLOR,[Jm]:n.ONE_MINUS_CONSTANT_COLOR,[Km]:n.CONSTANT_ALPHA,[jm]:n.ONE_MINUS_CONSTANT_ALPHA};function We(z,at,st,Tt,xt,bt,Xt,Qt,dt,zt){if(z===Ir){m===!0&&(Wt(n.BLEND),m=!1);return}if(m===!1&&(_t(n.BLEND),m=!0),z!==Um){if(z!==p||zt!==I){if((x!==Lr||T!==Lr)&&(n.blendEquation(n.FUNC_ADD),x=Lr,T=Lr),zt)switch(z){case Go:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case wd:n.blendFunc(n.ONE,n.ONE);break;case Td:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ed:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ee("WebGLState: Invalid blending: ",z);break}else switch(z){case Go:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case wd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Td:ee("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ed:ee("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ee("WebGLState: Invalid blending: ",z);break}M=null,v=null,w=null,g=null,b.set(0,0,0),P=0,p=z,I=zt}return}xt=xt||at,bt=bt||st,Xt=Xt||Tt,(at!==x||xt!==T)&&(n.blendEquationSeparate(ue[at],ue[xt]),x=at,T=xt),(st!==M||Tt!==v||bt!==w||Xt!==g)&&(n.blendFuncSeparate(ne[st],ne[Tt],ne[bt],ne[Xt]),M=st,v=Tt,w=bt,g=Xt),(Qt.equals(b)===!1||dt!==P)&&(n.blendColor(Qt.r,Qt.g,Qt.b,dt),b.copy(Qt),P=dt),p=z,I=!1}function he(z,at){z.side===li?Wt(n.CULL_FACE):_t(n.CULL_FACE);let st=z.side===oi;at&&(st=!st),Ce(st),z.blending===Go&&z.transparent===!1?We(Ir):We(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Tt=z.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),ve(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?_t(n.SAMPLE_ALPHA_TO_COVERAGE):Wt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ce(z){C!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),C=z)}function Pe(z){z!==Lm?(_t(n.CULL_FACE),z!==U&&(z===bd?n.cullFace(n.BACK):z===Dm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Wt(n.CULL_FACE),U=z}function gn(z){z!==O&&(V&&n.lineWidth(z),O=z)}function ve(z,at,st){z?(_t(n.POLYGON_OFFSET_FILL),(L!==at||B!==st)&&(L=at,B=st,o.getReversed()&&(at=-at,st=-st),n.polygonOffset(at,st))):Wt(n.POLYGON_OFFSET_FILL)}function hn(z){z?_t(n.SCISSOR_TEST):Wt(n.SCISSOR_TEST)}function Qe(z){z===void 0&&(z=n.TEXTURE0+$-1),Y!==z&&(n.activeTexture(z),Y=z)}function sn(z,at,st){st===void 0&&(Y===null?st=n.TEXTURE0+$-1:st=Y);let Tt=et[st];Tt===void 0&&(Tt={type:void 0,texture:void 0},et[st]=Tt),(Tt.type!==z||Tt.texture!==at)&&(Y!==st&&(n.activeTexture(st),Y=st),n.bindTexture(z,at||yt[z]),Tt.type=z,Tt.texture=at)}function k(){let z=et[Y];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(z){ee("WebGLState:",z)}}function Yt(){try{n.compressedTexImage3D(...arguments)}catch(z){ee("WebGLState:",z)}}function ie(){try{n.texSubImage2D(...arguments)}catch(z){ee("WebGLState:",z)}}function wt(){try{n.texSubImage3D(...arguments)}catch(z){ee("WebGLState:",z)}}function Ve(){try{n.compressedTexSubImage2D(...arguments)}catch(z){ee("WebGLState:",z)}}function Ht(){try{n.compressedTexSubImage3D(...arguments)}catch(z){ee("WebGLState:",z)}}function Jt(){try{n.texStorage2D(...arguments)}catch(z){ee("WebGLState:",z)}}function D(){try{n.texStorage3D(...arguments)}catch(z){ee("WebGLState:",z)}}function E(){try{n.texImage2D(...arguments)}catch(z){ee("WebGLState:",z)}}function Z(){try{n.texImage3D(...arguments)}catch(z){ee("WebGLState:",z)}}function ft(z){return d[z]!==void 0?d[z]:n.getParameter(z)}function ct(z,at){d[z]!==at&&(n.pixelStorei(z,at),d[z]=at)}function vt(z){K.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),K.copy(z))}function Mt(z){ut.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),ut.copy(z))}function it(z,at){let st=c.get(at);st===void 0&&(st=new WeakMap,c.set(at,st));let Tt=st.get(z);Tt===void 0&&(Tt=n.getUniformBlockIndex(at,z.name),n.uniformBlockBinding(at,Tt,Tt),st.set(z,Tt))}function ot(z,at,st){let xt=c.get(at).get(z);l[xt]!==st&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,st),l[xt]=st)}function gt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},Y=null,et={},h={},l={},f=new WeakMap,_=[],y=null,m=!1,p=null,x=null,M=null,v=null,T=null,w=null,g=null,b=new fe(0,0,0),P=0,I=!1,C=null,U=null,O=null,L=null,B=null,K.set(0,0,n.canvas.width,n.canvas.height),ut.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:_t,disable:Wt,bindFramebuffer:oe,drawBuffers:Ot,useProgram:ce,setBlending:We,setMaterial:he,setFlipSided:Ce,setCullFace:Pe,setLineWidth:gn,setPolygonOffset:ve,setScissorTest:hn,activeTexture:Qe,bindTexture:sn,unbindTexture:k,compressedTexImage2D:Rt,compressedTexImage3D:Yt,texImage2D:E,texImage3D:Z,pixelStorei:ct,getParameter:ft,updateUBOMapping:it,uniformBlockBinding:ot,texStorage2D:Jt,texStorage3D:D,texSubImage2D:ie,texSubImage3D:wt,compressedTexSubImage2D:Ve,compressedTexSubImage3D:Ht,scissor:vt,viewport:Mt,reset:gt}}function Tw(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,u=new WeakMap,d=new Set,h,f=new WeakMap,_=new Set,y=new FinalizationRegistry(D=>_.delete(D)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(D,E){return m?new OffscreenCanvas(D,E):Fa("canvas")}function x(D,E,Z){let ft=1,ct=Jt(D);if((ct.width>Z||ct.height>Z)&&(ft=Z/Math.max(ct.width,ct.height)),ft<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){let vt=Math.floor(ft*ct.width),Mt=Math.floor(ft*ct.height);h===void 0&&(h=p(vt,Mt));let it=E?p(vt,Mt):h;return it.width=vt,it.height=Mt,it.getContext("2d").drawImage(D,0,0,vt,Mt),Kt("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+vt+"x"+Mt+")."),it}else return"data"in D&&Kt("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),D;return D}function M(D){return D.generateMipmaps}function v(D){n.generateMipmap(D)}function T(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(D,E,Z,ft,ct,vt=!1){if(D!==null){if(n[D]!==void 0)return n[D];Kt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let Mt;ft&&(Mt=t.get("EXT_texture_norm16"),Mt||Kt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=E;if(E===n.RED&&(Z===n.FLOAT&&(it=n.R32F),Z===n.HALF_FLOAT&&(it=n.R16F),Z===n.UNSIGNED_BYTE&&(it=n.R8),Z===n.UNSIGNED_SHORT&&Mt&&(it=Mt.R16_EXT),Z===n.SHORT&&Mt&&(it=Mt.R16_SNORM_EXT)),E===n.RED_INTEGER&&(Z===n.UNSIGNED_BYTE&&(it=n.R8UI),Z===n.UNSIGNED_SHORT&&(it=n.R16UI),Z===n.UNSIGNED_INT&&(it=n.R32UI),Z===n.BYTE&&(it=n.R8I),Z===n.SHORT&&(it=n.R16I),Z===n.INT&&(it=n.R32I)),E===n.RG&&(Z===n.FLOAT&&(it=n.RG32F),Z===n.HALF_FLOAT&&(it=n.RG16F),Z===n.UNSIGNED_BYTE&&(it=n.RG8),Z===n.UNSIGNED_SHORT&&Mt&&(it=Mt.RG16_EXT),Z===n.SHORT&&Mt&&(it=Mt.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(Z===n.UNSIGNED_BYTE&&(it=n.RG8UI),Z===n.UNSIGNED_SHORT&&(it=n.RG16UI),Z===n.UNSIGNED_INT&&(it=n.RG32UI),Z===n.BYTE&&(it=n.RG8I),Z===n.SHORT&&(it=n.RG16I),Z===n.INT&&(it=n.RG32I)),E===n.RGB_INTEGER&&(Z===n.UNSIGNED_BYTE&&(it=n.RGB8UI),Z===n.UNSIGNED_SHORT&&(it=n.RGB16UI),Z===n.UNSIGNED_INT&&(it=n.RGB32UI),Z===n.BYTE&&(it=n.RGB8I),Z===n.SHORT&&(it=n.RGB16I),Z===n.INT&&(it=n.RGB32I)),E===n.RGBA_INTEGER&&(Z===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),Z===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),Z===n.UNSIGNED_INT&&(it=n.RGBA32UI),Z===n.BYTE&&(it=n.RGBA8I),Z===n.SHORT&&(it=n.RGBA16I),Z===n.INT&&(it=n.RGBA32I)),E===n.RGB&&(Z===n.UNSIGNED_SHORT&&Mt&&(it=Mt.RGB16_EXT),Z===n.SHORT&&Mt&&(it=Mt.RGB16_SNORM_EXT),Z===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),Z===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),E===n.RGBA){let ot=vt?Ua:Se.getTransfer(ct);Z===n.FLOAT&&(it=n.RGBA32F),Z===n.HALF_FLOAT&&(it=n.RGBA16F),Z===n.UNSIGNED_BYTE&&(it=ot===Ne?n.SRGB8_ALPHA8:n.RGBA8),Z===n.UNSIGNED_SHORT&&Mt&&(it=Mt.RGBA16_EXT),Z===n.SHORT&&Mt&&(it=Mt.RGBA16_SNORM_EXT),Z===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),Z===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function g(D,E){let Z;return D?E===null||E===Hi||E===Nr?Z=n.DEPTH24_STENCIL8:E===Wi?Z=n.DEPTH32F_STENCIL8:E===Wo&&(Z=n.DEPTH24_STENCIL8,Kt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Hi||E===Nr?Z=n.DEPTH_COMPONENT24:E===Wi?Z=n.DEPTH_COMPONENT32F:E===Wo&&(Z=n.DEPTH_COMPONENT16),Z}function b(D,E){return M(D)===!0||D.isFramebufferTexture&&D.minFilter!==On&&D.minFilter!==si?Math.log2(Math.max(E.width,E.height))+1:D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?E.mipmaps.length:1}function P(D){let E=new WeakRef(D);i.get(D).__ref=E,_.add(E),y.register(D,E,E)}function I(D){let E=i.get(D).__ref;E!==void 0&&(_.delete(E),y.unregister(E))}function C(D){O(D.target)}function U(D){L(D.target)}function O(D){D.removeEventListener("dispose",C),I(D),$(D),D.isVideoTexture&&u.delete(D),D.isHTMLTexture&&d.delete(D)}function L(D){D.removeEventListener("dispose",U),I(D),J(D)}function B(){for(let D of _){let E=D.deref();E!==void 0&&(E.isRenderTarget===!0?L(E):O(E))}_.clear(),d.clear()}function $(D){let E=i.get(D);if(E.__webglInit===void 0)return;let Z=D.source,ft=f.get(Z);if(ft){let ct=ft[E.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&V(D),Object.keys(ft).length===0&&f.delete(Z)}i.remove(D)}function V(D){let E=i.get(D);n.deleteTexture(E.__webglTexture);let Z=D.source,ft=f.get(Z);delete ft[E.__cacheKey],o.memory.textures--}function J(D){let E=i.get(D);E.__depthDisposeCallback&&E.__depthDisposeCallback();let Z=D.depthTexture;if(Z&&Z.renderTarget===D&&O(Z),D.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(E.__webglFramebuffer[ct]))for(let vt=0;vt<E.__webglFramebuffer[ct].length;vt++)n.deleteFramebuffer(E.__webglFramebuffer[ct][vt]);else n.deleteFramebuffer(E.__webglFramebuffer[ct]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[ct])}else{if(Array.isArray(E.__webglFramebuffer))for(let ct=0;ct<E.__webglFramebuffer.length;ct++)n.deleteFramebuffer(E.__webglFramebuffer[ct]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let ct=0;ct<E.__webglColorRenderbuffer.length;ct++)E.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[ct]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let ft=D.textures;for(let ct=0,vt=ft.length;ct<vt;ct++){let Mt=i.get(ft[ct]);Mt.__webglTexture&&(n.deleteTexture(Mt.__webglTexture),o.memory.textures--),i.remove(ft[ct])}i.remove(D)}let G=0;function Y(){G=0}function et(){return G}function lt(D){G=D}function rt(){let D=G;return D>=s.maxTextures&&Kt("WebGLTextures: Trying to use "+(D+1)+" texture units while this GPU supports only "+s.maxTextures),G+=1,D}function K(D){let E=[];return E.push(D.wrapS),E.push(D.wrapT),E.push(D.wrapR||0),E.push(D.magFilter),E.push(D.minFilter),E.push(D.anisotropy),E.push(D.internalFormat),E.push(D.format),E.push(D.type),E.push(D.generateMipmaps),E.push(D.mipmapsAutoUpdate),E.push(D.premultiplyAlpha),E.push(D.flipY),E.push(D.unpackAlignment),E.push(D.colorSpace),E.join()}function ut(D,E){let Z=i.get(D);if(D.isVideoTexture&&Ve(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&Z.__version!==D.version){let ft=D.image;if(ft===null)Kt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Kt("WebGLRenderer: Texture marked for update but image is incomplete");else{he(Z,D,E);return}}else D.isExternalTexture&&(Z.__webglTexture=D.sourceTexture?D.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Z.__webglTexture,n.TEXTURE0+E)}function pt(D,E){let Z=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&Z.__version!==D.version){he(Z,D,E);return}else D.isExternalTexture&&(Z.__webglTexture=D.sourceTexture?D.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Z.__webglTexture,n.TEXTURE0+E)}function yt(D,E){let Z=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&Z.__version!==D.version){he(Z,D,E);return}e.bindTexture(n.TEXTURE_3D,Z.__webglTexture,n.TEXTURE0+E)}function _t(D,E){let Z=i.get(D);if(D.version>0&&Z.__version!==D.version){Ce(Z,D,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture,n.TEXTURE0+E)}let Wt={[Lc]:n.REPEAT,[as]:n.CLAMP_TO_EDGE,[Dc]:n.MIRRORED_REPEAT},oe={[On]:n.NEAREST,[eg]:n.NEAREST_MIPMAP_NEAREST,[sl]:n.NEAREST_MIPMAP_LINEAR,[si]:n.LINEAR,[ch]:n.LINEAR_MIPMAP_NEAREST,[Us]:n.LINEAR_MIPMAP_LINEAR},Ot={[rg]:n.NEVER,[$d]:n.ALWAYS,[og]:n.LESS,[Wd]:n.LEQUAL,[ag]:n.EQUAL,[Xd]:n.GEQUAL,[lg]:n.GREATER,[cg]:n.NOTEQUAL};function ce(D,E){if(E.type===Wi&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===si||E.magFilter===ch||E.magFilter===sl||E.magFilter===Us||E.minFilter===si||E.minFilter===ch||E.minFilter===sl||E.minFilter===Us)&&Kt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,Wt[E.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,Wt[E.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,Wt[E.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,oe[E.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,oe[E.minFilter]),E.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,Ot[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===On||E.minFilter!==sl&&E.minFilter!==Us||E.type===Wi&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let Z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(D,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function ue(D,E){let Z=!1;D.__webglInit===void 0&&(D.__webglInit=!0,E.addEventListener("dispose",C),P(E));let ft=E.source,ct=f.get(ft);ct===void 0&&(ct={},f.set(ft,ct));let vt=K(E);if(vt!==D.__cacheKey){ct[vt]===void 0&&(ct[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),ct[vt].usedTimes++;let Mt=ct[D.__cacheKey];Mt!==void 0&&(ct[D.__cacheKey].usedTimes--,Mt.usedTimes===0&&V(E)),D.__cacheKey=vt,D.__webglTexture=ct[vt].texture}return Z}function ne(D,E,Z){return Math.floor(Math.floor(D/Z)/E)}function We(D,E,Z,ft){let vt=D.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,Z,ft,E.data);else{vt.sort((z,at)=>z.start-at.start);let Mt=0;for(let z=1;z<vt.length;z++){let at=vt[Mt],st=vt[z],Tt=at.start+at.count,xt=ne(st.start,E.width,4),bt=ne(at.start,E.width,4);st.start<=Tt+1&&xt===bt&&ne(st.start+st.count-1,E.width,4)===xt?at.count=Math.max(at.count,st.start+st.count-at.start):(++Mt,vt[Mt]=st)}vt.length=Mt+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),ot=e.getParameter(n.UNPACK_SKIP_PIXELS),gt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let z=0,at=vt.length;z<at;z++){let st=vt[z],Tt=Math.floor(st.start/4),xt=Math.ceil(st.count/4),bt=Tt%E.width,Xt=Math.floor(Tt/E.width),Qt=xt,dt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Xt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Xt,Qt,dt,Z,ft,E.data)}D.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(n.UNPACK_SKIP_ROWS,gt)}}function he(D,E,Z){let ft=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(ft=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(ft=n.TEXTURE_3D);let ct=ue(D,E),vt=E.source;e.bindTexture(ft,D.__webglTexture,n.TEXTURE0+Z);let Mt=i.get(vt);if(vt.version!==Mt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+Z),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let dt=Se.getPrimaries(Se.workingColorSpace),zt=E.colorSpace===Os?null:Se.getPrimaries(E.colorSpace),te=E.colorSpace===Os||dt===zt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let ot=x(E.image,!1,s.maxTextureSize);ot=Ht(E,ot);let gt=r.convert(E.format,E.colorSpace),z=r.convert(E.type),at=w(E.internalFormat,gt,z,E.normalized,E.colorSpace,E.isVideoTexture);ce(ft,E);let st,Tt=E.mipmaps,xt=E.isVideoTexture!==!0,bt=Mt.__version===void 0||ct===!0,Xt=vt.dataReady,Qt=b(E,ot);if(E.isDepthTexture)at=g(E.format===Fs,E.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,at,ot.width,ot.height):e.texImage2D(n.TEXTURE_2D,0,at,ot.width,ot.height,0,gt,z,null));else if(E.isDataTexture)if(Tt.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Qt,at,Tt[0].width,Tt[0].height);for(let dt=0,zt=Tt.length;dt<zt;dt++)st=Tt[dt],xt?Xt&&e.texSubImage2D(n.TEXTURE_2D,dt,0,0,st.width,st.height,gt,z,st.data):e.texImage2D(n.TEXTURE_2D,dt,at,st.width,st.height,0,gt,z,st.data);E.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,Qt,at,ot.width,ot.height),Xt&&We(E,ot,gt,z)):e.texImage2D(n.TEXTURE_2D,0,at,ot.width,ot.height,0,gt,z,ot.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,at,Tt[0].width,Tt[0].height,ot.depth);for(let dt=0,zt=Tt.length;dt<zt;dt++)if(st=Tt[dt],E.format!==$i)if(gt!==null)if(xt){if(Xt)if(E.layerUpdates.size>0){let te=sf(st.width,st.height,E.format,E.type);for(let Ct of E.layerUpdates){let de=st.data.subarray(Ct*te/st.data.BYTES_PER_ELEMENT,(Ct+1)*te/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,dt,0,0,Ct,st.width,st.height,1,gt,de)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,dt,0,0,0,st.width,st.height,ot.depth,gt,st.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,dt,at,st.width,st.height,ot.depth,0,st.data,0,0);else Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Xt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,dt,0,0,0,st.width,st.height,ot.depth,gt,z,st.data):e.texImage3D(n.TEXTURE_2D_ARRAY,dt,at,st.width,st.height,ot.depth,0,gt,z,st.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Qt,at,Tt[0].width,Tt[0].height);for(let dt=0,zt=Tt.length;dt<zt;dt++)st=Tt[dt],E.format!==$i?gt!==null?xt?Xt&&e.compressedTexSubImage2D(n.TEXTURE_2D,dt,0,0,st.width,st.height,gt,st.data):e.compressedTexImage2D(n.TEXTURE_2D,dt,at,st.width,st.height,0,st.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Xt&&e.texSubImage2D(n.TEXTURE_2D,dt,0,0,st.width,st.height,gt,z,st.data):e.texImage2D(n.TEXTURE_2D,dt,at,st.width,st.height,0,gt,z,st.data)}else if(E.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,at,ot.width,ot.height,ot.depth),Xt)if(E.layerUpdates.size>0){let dt=sf(ot.width,ot.height,E.format,E.type);for(let zt of E.layerUpdates){let te=ot.data.subarray(zt*dt/ot.data.BYTES_PER_ELEMENT,(zt+1)*dt/ot.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,zt,ot.width,ot.height,1,gt,z,te)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ot.width,ot.height,ot.depth,gt,z,ot.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,at,ot.width,ot.height,ot.depth,0,gt,z,ot.data);else if(E.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,Qt,at,ot.width,ot.height,ot.depth),Xt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ot.width,ot.height,ot.depth,gt,z,ot.data)):e.texImage3D(n.TEXTURE_3D,0,at,ot.width,ot.height,ot.depth,0,gt,z,ot.data);else if(E.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,Qt,at,ot.width,ot.height);else{let dt=ot.width,zt=ot.height;for(let te=0;te<Qt;te++)e.texImage2D(n.TEXTURE_2D,te,at,dt,zt,0,gt,z,null),dt>>=1,zt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let dt=n.canvas;if(dt.hasAttribute("layoutsubtree")||dt.setAttribute("layoutsubtree","true"),ot.parentNode!==dt){dt.appendChild(ot),d.add(E),dt.onpaint=zt=>{let te=zt.changedElements;for(let Ct of d)te.includes(Ct.image)&&(Ct.needsUpdate=!0)},dt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ot);else{let te=n.RGBA,Ct=n.RGBA,de=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,te,Ct,de,ot)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(xt&&bt){let dt=Jt(Tt[0]);e.texStorage2D(n.TEXTURE_2D,Qt,at,dt.width,dt.height)}for(let dt=0,zt=Tt.length;dt<zt;dt++)st=Tt[dt],xt?Xt&&e.texSubImage2D(n.TEXTURE_2D,dt,0,0,gt,z,st):e.texImage2D(n.TEXTURE_2D,dt,at,gt,z,st);E.generateMipmaps=!1}else if(xt){if(bt){let dt=Jt(ot);e.texStorage2D(n.TEXTURE_2D,Qt,at,dt.width,dt.height)}Xt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,gt,z,ot)}else e.texImage2D(n.TEXTURE_2D,0,at,gt,z,ot);M(E)&&E.mipmapsAutoUpdate===!0&&v(ft),Mt.__version=vt.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function Ce(D,E,Z){if(E.image.length!==6)return;let ft=ue(D,E),ct=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+Z);let vt=i.get(ct);if(ct.version!==vt.__version||ft===!0){e.activeTexture(n.TEXTURE0+Z);let Mt=Se.getPrimaries(Se.workingColorSpace),it=E.colorSpace===Os?null:Se.getPrimaries(E.colorSpace),ot=E.colorSpace===Os||Mt===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ot);let gt=E.isCompressedTexture||E.image[0].isCompressedTexture,z=E.image[0]&&E.image[0].isDataTexture,at=[];for(let Ct=0;Ct<6;Ct++)!gt&&!z?at[Ct]=x(E.image[Ct],!0,s.maxCubemapSize):at[Ct]=z?E.image[Ct].image:E.image[Ct],at[Ct]=Ht(E,at[Ct]);let st=at[0],Tt=r.convert(E.format,E.colorSpace),xt=r.convert(E.type),bt=w(E.internalFormat,Tt,xt,E.normalized,E.colorSpace),Xt=E.isVideoTexture!==!0,Qt=vt.__version===void 0||ft===!0,dt=ct.dataReady,zt=b(E,st);ce(n.TEXTURE_CUBE_MAP,E);let te;if(E.isDepthTexture){if(bt=g(E.format===Fs,E.type),Qt)if(Xt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,st.width,st.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,st.width,st.height,0,Tt,xt,null)}else if(gt){Xt&&Qt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,zt,bt,st.width,st.height);for(let Ct=0;Ct<6;Ct++){te=at[Ct].mipmaps;for(let de=0;de<te.length;de++){let $e=te[de];E.format!==$i?Tt!==null?Xt?dt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,0,0,$e.width,$e.height,Tt,$e.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,bt,$e.width,$e.height,0,$e.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,0,0,$e.width,$e.height,Tt,xt,$e.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de,bt,$e.width,$e.height,0,Tt,xt,$e.data)}}}else{if(te=E.mipmaps,Xt&&Qt){te.length>0&&zt++;let Ct=Jt(at[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,zt,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(z){Xt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,at[Ct].width,at[Ct].height,Tt,xt,at[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,at[Ct].width,at[Ct].height,0,Tt,xt,at[Ct].data);for(let de=0;de<te.length;de++){let Zn=te[de].image[Ct].image;Xt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,0,0,Zn.width,Zn.height,Tt,xt,Zn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,bt,Zn.width,Zn.height,0,Tt,xt,Zn.data)}}else{Xt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Tt,xt,at[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,Tt,xt,at[Ct]);for(let de=0;de<te.length;de++){let $e=te[de];Xt?dt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,0,0,Tt,xt,$e.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,de+1,bt,Tt,xt,$e.image[Ct])}}}M(E)&&E.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),vt.__version=ct.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function Pe(D,E,Z,ft,ct,vt){let Mt=r.convert(Z.format,Z.colorSpace),it=r.convert(Z.type),ot=w(Z.internalFormat,Mt,it,Z.normalized,Z.colorSpace),gt=i.get(E),z=i.get(Z);if(z.__renderTarget=E,!gt.__hasExternalTextures){let at=Math.max(1,E.width>>vt),st=Math.max(1,E.height>>vt);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,vt,ot,at,st,E.depth,0,Mt,it,null):e.texImage2D(ct,vt,ot,at,st,0,Mt,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,D),wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ft,ct,z.__webglTexture,0,ie(E)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ft,ct,z.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function gn(D,E,Z){if(n.bindRenderbuffer(n.RENDERBUFFER,D),E.depthBuffer){let ft=E.depthTexture,ct=ft&&ft.isDepthTexture?ft.type:null,vt=g(E.stencilBuffer,ct),Mt=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ie(E),vt,E.width,E.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,ie(E),vt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,vt,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Mt,n.RENDERBUFFER,D)}else{let ft=E.textures;for(let ct=0;ct<ft.length;ct++){let vt=ft[ct],Mt=r.convert(vt.format,vt.colorSpace),it=r.convert(vt.type),ot=w(vt.internalFormat,Mt,it,vt.normalized,vt.colorSpace);wt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ie(E),ot,E.width,E.height):Z?n.renderbufferStorageMultisample(n.RENDERBUFFER,ie(E),ot,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,ot,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ve(D,E,Z){let ft=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,D),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(E.depthTexture);ct.__renderTarget=E;let vt=ft?E.depthTexture.image[0]:E.depthTexture.image;(!ct.__webglTexture||vt.width!==E.width||vt.height!==E.height)&&(vt.width=E.width,vt.height=E.height,E.depthTexture.needsUpdate=!0),ft?_t(E.depthTexture,0):ut(E.depthTexture,0);let Mt=ct.__webglTexture,it=ie(E),ot=ft?n.TEXTURE_CUBE_MAP_POSITIVE_X+Z:n.TEXTURE_2D,gt=E.depthTexture.format===Fs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===Is)wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,ot,Mt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,gt,ot,Mt,0);else if(E.depthTexture.format===Fs)wt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,ot,Mt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,gt,ot,Mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function hn(D){let E=i.get(D),Z=D.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==D.depthTexture){let ft=D.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),ft){let ct=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,ft.removeEventListener("dispose",ct)};ft.addEventListener("dispose",ct),E.__depthDisposeCallback=ct}E.__boundDepthTexture=ft}if(D.depthTexture&&!E.__autoAllocateDepthBuffer)if(Z)for(let ft=0;ft<6;ft++)ve(E.__webglFramebuffer[ft],D,ft);else D.texture.mipmaps.length>0?ve(E.__webglFramebuffer[0],D,0):ve(E.__webglFramebuffer,D,0);else if(Z){E.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[ft]),E.__webglDepthbuffer[ft]===void 0)E.__webglDepthbuffer[ft]=n.createRenderbuffer(),gn(E.__webglDepthbuffer[ft],D,!1);else{let ct=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=E.__webglDepthbuffer[ft];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,vt)}}else if(D.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),gn(E.__webglDepthbuffer,D,!1);else{let ct=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Qe(D,E,Z){let ft=i.get(D);E!==void 0&&Pe(ft.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Z!==void 0&&hn(D)}function sn(D){let E=D.texture,Z=i.get(D),ft=i.get(E);D.addEventListener("dispose",U),P(D);let ct=D.textures,vt=D.isWebGLCubeRenderTarget===!0,Mt=ct.length>1;if(Mt||(ft.__webglTexture===void 0&&(ft.__webglTexture=n.createTexture()),ft.__version=E.version,o.memory.textures++),vt){Z.__webglFramebuffer=[];for(let it=0;it<6;it++)if(E.mipmaps.length>0){Z.__webglFramebuffer[it]=[];for(let ot=0;ot<E.mipmaps.length;ot++)Z.__webglFramebuffer[it][ot]=n.createFramebuffer()}else Z.__webglFramebuffer[it]=n.createFramebuffer()}else{if(E.mipmaps.length>0){Z.__webglFramebuffer=[];for(let it=0;it<E.mipmaps.length;it++)Z.__webglFramebuffer[it]=n.createFramebuffer()}else Z.__webglFramebuffer=n.createFramebuffer();if(Mt)for(let it=0,ot=ct.length;it<ot;it++){let gt=i.get(ct[it]);gt.__webglTexture===void 0&&(gt.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&wt(D)===!1){Z.__webglMultisampledFramebuffer=n.createFramebuffer(),Z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let it=0;it<ct.length;it++){let ot=ct[it];Z.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Z.__webglColorRenderbuffer[it]);let gt=r.convert(ot.format,ot.colorSpace),z=r.convert(ot.type),at=w(ot.internalFormat,gt,z,ot.normalized,ot.colorSpace,D.isXRRenderTarget===!0),st=ie(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,st,at,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,Z.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(Z.__webglDepthRenderbuffer=n.createRenderbuffer(),gn(Z.__webglDepthRenderbuffer,D,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,ft.__webglTexture),ce(n.TEXTURE_CUBE_MAP,E);for(let it=0;it<6;it++)if(E.mipmaps.length>0)for(let ot=0;ot<E.mipmaps.length;ot++)Pe(Z.__webglFramebuffer[it][ot],D,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,ot);else Pe(Z.__webglFramebuffer[it],D,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);M(E)?v(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(Mt){for(let it=0,ot=ct.length;it<ot;it++){let gt=ct[it],z=i.get(gt),at=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(at=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(at,z.__webglTexture),ce(at,gt),Pe(Z.__webglFramebuffer,D,gt,n.COLOR_ATTACHMENT0+it,at,0),M(gt)&&v(at)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(it=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,ft.__webglTexture),ce(it,E),E.mipmaps.length>0)for(let ot=0;ot<E.mipmaps.length;ot++)Pe(Z.__webglFramebuffer[ot],D,E,n.COLOR_ATTACHMENT0,it,ot);else Pe(Z.__webglFramebuffer,D,E,n.COLOR_ATTACHMENT0,it,0);M(E)?v(it):E.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}D.depthBuffer&&hn(D)}function k(D){let E=D.textures;for(let Z=0,ft=E.length;Z<ft;Z++){let ct=E[Z];if(M(ct)&&ct.mipmapsAutoUpdate===!0){let vt=T(D),Mt=i.get(ct).__webglTexture;e.bindTexture(vt,Mt),v(vt),e.unbindTexture()}}}let Rt=[];function Yt(D){if(D.samples>0){if(wt(D)===!1){let E=D.textures,Z=D.width,ft=D.height,ct=n.COLOR_BUFFER_BIT,vt=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=i.get(D),it=E.length>1;if(it)for(let gt=0;gt<E.length;gt++)e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),D.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let gt=0;gt<E.length;gt++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[gt]);let z=i.get(E[gt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,Z,ft,0,0,Z,ft,ct,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+gt),D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&Rt.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let gt=0;gt<E.length;gt++){e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[gt]);let z=i.get(E[gt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&l){let E=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function ie(D){return Math.min(s.maxSamples,D.samples)}function wt(D){let E=i.get(D);return D.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Ve(D){let E=o.render.frame;u.get(D)!==E&&(u.set(D,E),D.update())}function Ht(D,E){let Z=D.colorSpace,ft=D.format,ct=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||Z!==Na&&Z!==Os&&(Se.getTransfer(Z)===Ne?(ft!==$i||ct!==ci)&&Kt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ee("WebGLTextures: Unsupported texture color space:",Z)),E}function Jt(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=rt,this.resetTextureUnits=Y,this.getTextureUnits=et,this.setTextureUnits=lt,this.setTexture2D=ut,this.setTexture2DArray=pt,this.setTexture3D=yt,this.setTextureCube=_t,this.rebindTextures=Qe,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=hn,this.setupFrameBufferTexture=Pe,this.useMultisampledRTT=wt,this.dispose=B}function Ew(n,t){function e(i,s=Os){let r,o=Se.getTransfer(s);if(i===ci)return n.UNSIGNED_BYTE;if(i===uh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===dh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===kd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===zd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Od)return n.BYTE;if(i===Bd)return n.SHORT;if(i===Wo)return n.UNSIGNED_SHORT;if(i===hh)return n.INT;if(i===Hi)return n.UNSIGNED_INT;if(i===Wi)return n.FLOAT;if(i===Xi)return n.HALF_FLOAT;if(i===Vd)return n.ALPHA;if(i===Gd)return n.RGB;if(i===$i)return n.RGBA;if(i===Is)return n.DEPTH_COMPONENT;if(i===Fs)return n.DEPTH_STENCIL;if(i===Hd)return n.RED;if(i===fh)return n.RED_INTEGER;if(i===fr)return n.RG;if(i===ph)return n.RG_INTEGER;if(i===mh)return n.RGBA_INTEGER;if(i===rl||i===ol||i===al||i===ll)if(o===Ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===gh||i===_h||i===xh||i===yh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===gh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===_h)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===xh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===yh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===vh||i===Mh||i===Sh||i===bh||i===wh||i===cl||i===Th)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===vh||i===Mh)return o===Ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Sh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===bh)return r.COMPRESSED_R11_EAC;if(i===wh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===cl)return r.COMPRESSED_RG11_EAC;if(i===Th)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Eh||i===Ah||i===Rh||i===Ch||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Uh||i===Fh||i===Oh||i===Bh||i===kh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Eh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ah)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Rh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ch)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ph)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ih)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Lh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Dh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Nh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Uh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Fh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Oh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Bh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===kh)return o===Ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===zh||i===Vh||i===Gh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===zh)return o===Ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Gh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Hh||i===Wh||i===hl||i===Xh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Hh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Wh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===hl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Nr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var Aw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Rw=`
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

}`,ff=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Ya(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new cs({vertexShader:Aw,fragmentShader:Rw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new qn(new Za(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},pf=class extends Gi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,_=null,y=typeof XRWebGLBinding<"u",m=new ff,p={},x=e.getContextAttributes(),M=null,v=null,T=[],w=[],g=new Zt,b=null,P=null,I=new ni;I.viewport=new en;let C=new ni;C.viewport=new en;let U=[I,C],O=new rh,L=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let ut=T[K];return ut===void 0&&(ut=new Fo,T[K]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(K){let ut=T[K];return ut===void 0&&(ut=new Fo,T[K]=ut),ut.getGripSpace()},this.getHand=function(K){let ut=T[K];return ut===void 0&&(ut=new Fo,T[K]=ut),ut.getHandSpace()};function $(K){let ut=w.indexOf(K.inputSource);if(ut===-1)return;let pt=T[ut];pt!==void 0&&(pt.update(K.inputSource,K.frame,c||o),pt.dispatchEvent({type:K.type,data:K.inputSource}))}function V(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",J);for(let K=0;K<T.length;K++){let ut=w[K];ut!==null&&(w[K]=null,T[K].disconnect(ut))}L=null,B=null,m.reset();for(let K in p)delete p[K];if(t.setRenderTarget(M),f=null,h=null,d=null,s=null,v=null,rt.stop(),i.isPresenting=!1,t.setPixelRatio(b),t.setSize(g.width,g.height,!1),P!==null){let K=P.camera;K.fov=P.fov,K.zoom=P.zoom,K.updateProjectionMatrix(),P=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,i.isPresenting===!0&&Kt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,i.isPresenting===!0&&Kt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",V),s.addEventListener("inputsourceschange",J),x.xrCompatible!==!0&&await e.makeXRCompatible(),b=t.getPixelRatio(),t.getSize(g),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let pt=null,yt=null,_t=null;x.depth&&(_t=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,pt=x.stencil?Fs:Is,yt=x.stencil?Nr:Hi);let Wt={colorFormat:e.RGBA8,depthFormat:_t,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Wt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),v=new vi(h.textureWidth,h.textureHeight,{format:$i,type:ci,depthTexture:new Ds(h.textureWidth,h.textureHeight,yt,void 0,void 0,void 0,void 0,void 0,void 0,pt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let pt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,pt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new vi(f.framebufferWidth,f.framebufferHeight,{format:$i,type:ci,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),rt.setContext(s),rt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function J(K){for(let ut=0;ut<K.removed.length;ut++){let pt=K.removed[ut],yt=w.indexOf(pt);yt>=0&&(w[yt]=null,T[yt].disconnect(pt))}for(let ut=0;ut<K.added.length;ut++){let pt=K.added[ut],yt=w.indexOf(pt);if(yt===-1){for(let Wt=0;Wt<T.length;Wt++)if(Wt>=w.length){w.push(pt),yt=Wt;break}else if(w[Wt]===null){w[Wt]=pt,yt=Wt;break}if(yt===-1)break}let _t=T[yt];_t&&_t.connect(pt)}}function G(K,ut){ut===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(ut.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let ut=K.near,pt=K.far;m.texture!==null&&(m.depthNear>0&&(ut=m.depthNear),m.depthFar>0&&(pt=m.depthFar)),O.near=C.near=I.near=ut,O.far=C.far=I.far=pt,(L!==O.near||B!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),L=O.near,B=O.far),O.layers.mask=K.layers.mask|6,I.layers.mask=O.layers.mask&-5,C.layers.mask=O.layers.mask&-3;let yt=K.parent,_t=O.cameras;G(O,yt);for(let Wt=0;Wt<_t.length;Wt++)G(_t[Wt],yt);O.projectionMatrix.copy(I.projectionMatrix),O.projectionMatrixInverse.copy(I.projectionMatrixInverse),P===null&&K.isPerspectiveCamera&&(P={camera:K,fov:K.fov,zoom:K.zoom}),Y(K,O,yt)};function Y(K,ut,pt){pt===null?K.matrix.copy(ut.matrixWorld):(K.matrix.copy(pt.matrixWorld),K.matrix.invert(),K.matrix.multiply(ut.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(ut.projectionMatrix),K.projectionMatrixInverse.copy(ut.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=No*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(K){l=K,h!==null&&(h.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(K){return p[K]};let et=null;function lt(K,ut){if(u=ut.getViewerPose(c||o),_=ut,u!==null){let pt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let yt=!1;pt.length!==O.cameras.length&&(O.cameras.length=0,yt=!0);for(let Ot=0;Ot<pt.length;Ot++){let ce=pt[Ot],ue=null;if(f!==null)ue=f.getViewport(ce);else{let We=d.getViewSubImage(h,ce);ue=We.viewport,Ot===0&&(t.setRenderTargetTextures(v,We.colorTexture,We.depthStencilTexture),t.setRenderTarget(v))}let ne=U[Ot];ne===void 0&&(ne=new ni,ne.layers.enable(Ot),ne.viewport=new en,U[Ot]=ne),ne.matrix.fromArray(ce.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(ce.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ue.x,ue.y,ue.width,ue.height),Ot===0&&(O.matrix.copy(ne.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),yt===!0&&O.cameras.push(ne)}let _t=s.enabledFeatures;if(_t&&_t.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=i.getBinding();let Ot=d.getDepthInformation(pt[0]);Ot&&Ot.isValid&&Ot.texture&&m.init(Ot,s.renderState)}if(_t&&_t.includes("camera-access")&&y){t.state.unbindTexture(),d=i.getBinding();for(let Ot=0;Ot<pt.length;Ot++){let ce=pt[Ot].camera;if(ce){let ue=p[ce];ue||(ue=new Ya,p[ce]=ue);let ne=d.getCameraImage(ce);ue.sourceTexture=ne}}}}for(let pt=0;pt<T.length;pt++){let yt=w[pt],_t=T[pt];yt!==null&&_t!==void 0&&_t.update(yt,ut,c||o)}et&&et(K,ut),ut.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ut}),_=null}let rt=new zg;rt.setAnimationLoop(lt),this.setAnimationLoop=function(K){et=K},this.dispose=function(){}}},Cw=new Xe,Jg=new ae;Jg.set(-1,0,0,0,1,0,0,0,1);function Pw(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,tf(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,x,M,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),d(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),h(m,p),p.isMeshPhysicalMaterial&&f(m,p,v)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,x,M):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===oi&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===oi&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let x=t.get(p),M=x.envMap,v=x.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(Cw.makeRotationFromEuler(v)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Jg),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,x,M){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*x,m.scale.value=M*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function d(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function h(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,x){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===oi&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let x=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Iw(n,t,e,i){let s={},r={};function o(x,M){let v=M.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,M){let v=s[x.id];v===void 0&&(_(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",m));let T=M.program;i.updateUBOMapping(x,T);let w=t.render.frame;r[x.id]!==w&&(c(x),r[x.id]=w)}function l(x){let M=n.createBuffer(),v=x.__size,T=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,v,T),n.bindBuffer(n.UNIFORM_BUFFER,null),M}function c(x){let M=s[x.id],v=x.uniforms,T=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,M);for(let w=0,g=v.length;w<g;w++){let b=v[w];if(Array.isArray(b))for(let P=0,I=b.length;P<I;P++)u(b[P],w,P,T);else u(b,w,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,M,v,T){if(h(x,M,v,T)===!0){let w=x.__offset,g=x.value;if(Array.isArray(g)){let b=0;for(let P=0;P<g.length;P++){let I=g[P],C=y(I,!0);d(I,x.__data,b),b+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else d(g,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,x.__data)}}function d(x,M,v){typeof x=="number"||typeof x=="boolean"?M[v]=x:x.isMatrix3?(M[v]=x.elements[0],M[v+1]=x.elements[1],M[v+2]=x.elements[2],M[v+3]=0,M[v+4]=x.elements[3],M[v+5]=x.elements[4],M[v+6]=x.elements[5],M[v+7]=0,M[v+8]=x.elements[6],M[v+9]=x.elements[7],M[v+10]=x.elements[8],M[v+11]=0):ArrayBuffer.isView(x)?M.set(x.subarray(0,M.length-v),v):x.toArray(M,v)}function h(x,M,v,T){let w=x.value,g=M+"_"+v;if(Array.isArray(w)){T[g]===void 0&&(T[g]=[]);let b=T[g],P=!1;for(let I=0;I<w.length;I++)f(w[I],b,I)===!0&&(P=!0);return P}return f(w,T,g)}function f(x,M,v){if(M[v]===void 0)return typeof x=="number"||typeof x=="boolean"?M[v]=x:ArrayBuffer.isView(x)?M[v]=x.slice():M[v]=x.clone(),!0;{let T=M[v];if(typeof x=="number"||typeof x=="boolean"){if(T!==x)return M[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(T.equals(x)===!1)return T.copy(x),!0}}return!1}function _(x){let M=x.uniforms,v=0,T=16;for(let g=0,b=M.length;g<b;g++){let P=Array.isArray(M[g])?M[g]:[M[g]];for(let I=0,C=P.length;I<C;I++){let U=P[I],O=Array.isArray(U.value)?U.value:[U.value],L=Array.isArray(M[g])||Array.isArray(U.value),B=v;for(let V=0,J=O.length;V<J;V++){let G=O[V],Y=y(G,L),et=v%T,lt=et%Y.boundary,rt=et+lt;v+=lt,rt!==0&&T-rt<Y.storage&&(v+=T-rt),V===0&&(B=v),v+=Y.storage}let $=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new $((v-B)/Float32Array.BYTES_PER_ELEMENT),U.__offset=B}}let w=v%T;return w>0&&(v+=T-w),x.__size=v,x.__cache={},this}function y(x,M){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?Kt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):Kt("WebGLRenderer: Unsupported uniform value type.",x),M===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let M=x.target;M.removeEventListener("dispose",m),n.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function p(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:p}}var Lw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ds=null;function Dw(){return ds===null&&(ds=new zc(Lw,16,16,fr,Xi),ds.name="DFG_LUT",ds.minFilter=si,ds.magFilter=si,ds.wrapS=as,ds.wrapT=as,ds.generateMipmaps=!1,ds.needsUpdate=!0),ds}var Kh=class{constructor(t={}){let{canvas:e=hg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=ci}=t;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let y=f,m=new Set([mh,ph,fh]),p=new Set([ci,Hi,Wo,Nr,uh,dh]),x=new Uint32Array(4),M=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},T=null,w=null,g=[],b=[],P=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=us,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,C=!1,U=null,O=null,L=null,B=null;this._outputColorSpace=ei;let $=0,V=0,J=null,G=-1,Y=null,et=new en,lt=new en,rt=null,K=new fe(0),ut=0,pt=e.width,yt=e.height,_t=1,Wt=null,oe=null,Ot=new en(0,0,pt,yt),ce=new en(0,0,pt,yt),ue=!1,ne=new or,We=new Vc,he=!1,Ce=!1,Pe=new Xe,gn=new q,ve=new en,hn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qe=!1;function sn(){return J===null?_t:1}let k=i;function Rt(R,H){return e.getContext(R,H)}let Yt,ie,wt,Ve,Ht,Jt,D,E,Z,ft,ct,vt,Mt,it,ot,gt,z,at,st,Tt,xt,bt,Xt;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",zt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let H="webgl2";if(k=Rt(H,R),k===null)throw Rt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(R){throw e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ee("WebGLRenderer: "+R.message),R}function Qt(){Yt=new WS(k),Yt.init(),xt=new Ew(k,Yt),ie=new DS(k,Yt,t,xt),wt=new ww(k,Yt),ie.reversedDepthBuffer&&h&&wt.buffers.depth.setReversed(!0),O=k.createFramebuffer(),L=k.createFramebuffer(),B=k.createFramebuffer(),Ve=new qS(k),Ht=new hw,Jt=new Tw(k,Yt,wt,Ht,ie,xt,Ve),D=new HS(I),E=new Zy(k),bt=new IS(k,E),Z=new XS(k,E,Ve,bt),ft=new ZS(k,Z,E,bt,Ve),at=new YS(k,ie,Jt),ot=new NS(Ht),ct=new cw(I,D,Yt,ie,bt,ot),vt=new Pw(I,Ht),Mt=new dw,it=new xw(Yt),z=new PS(I,D,wt,ft,_,l),gt=new bw(I,ft,ie),Xt=new Iw(k,Ve,ie,wt),st=new LS(k,Yt,Ve),Tt=new $S(k,Yt,Ve),Ve.programs=ct.programs,I.capabilities=ie,I.extensions=Yt,I.properties=Ht,I.renderLists=Mt,I.shadowMap=gt,I.state=wt,I.info=Ve}y!==ci&&(P=new KS(y,e.width,e.height,a,s,r));let dt=new pf(I,k);this.xr=dt,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=Yt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Yt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return _t},this.setPixelRatio=function(R){R!==void 0&&(_t=R,this.setSize(pt,yt,!1))},this.getSize=function(R){return R.set(pt,yt)},this.setSize=function(R,H,nt=!0){if(dt.isPresenting){Kt("WebGLRenderer: Can't change size while VR device is presenting.");return}pt=R,yt=H,e.width=Math.floor(R*_t),e.height=Math.floor(H*_t),nt===!0&&(e.style.width=R+"px",e.style.height=H+"px"),P!==null&&P.setSize(e.width,e.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(pt*_t,yt*_t).floor()},this.setDrawingBufferSize=function(R,H,nt){pt=R,yt=H,_t=nt,e.width=Math.floor(R*nt),e.height=Math.floor(H*nt),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(y===ci){ee("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Kt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}P.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(et)},this.getViewport=function(R){return R.copy(Ot)},this.setViewport=function(R,H,nt,j){R.isVector4?Ot.set(R.x,R.y,R.z,R.w):Ot.set(R,H,nt,j),wt.viewport(et.copy(Ot).multiplyScalar(sn()).round())},this.getScissor=function(R){return R.copy(ce)},this.setScissor=function(R,H,nt,j){R.isVector4?ce.set(R.x,R.y,R.z,R.w):ce.set(R,H,nt,j),wt.scissor(lt.copy(ce).multiplyScalar(sn()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(R){wt.setScissorTest(ue=R)},this.setOpaqueSort=function(R){Wt=R},this.setTransparentSort=function(R){oe=R},this.getClearColor=function(R){return R.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,nt=!0){let j=0;if(R){let Q=!1;if(J!==null){let Et=J.texture.format;Q=m.has(Et)}if(Q){let Et=J.texture.type,It=p.has(Et),At=z.getClearColor(),Lt=z.getClearAlpha(),Gt=At.r,se=At.g,ge=At.b;It?(x[0]=Gt,x[1]=se,x[2]=ge,x[3]=Lt,k.clearBufferuiv(k.COLOR,0,x)):(M[0]=Gt,M[1]=se,M[2]=ge,M[3]=Lt,k.clearBufferiv(k.COLOR,0,M))}else j|=k.COLOR_BUFFER_BIT}H&&(j|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&(j|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),j!==0&&k.clear(j)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),U=R},this.dispose=function(){e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),z.dispose(),Mt.dispose(),it.dispose(),Jt.dispose(),Ht.dispose(),D.dispose(),ft.dispose(),Z.dispose(),bt.dispose(),Xt.dispose(),ct.dispose(),dt.dispose(),dt.removeEventListener("sessionstart",Ll),dt.removeEventListener("sessionend",Ki),ms.stop()};function zt(R){R.preventDefault(),Oa("WebGLRenderer: Context Lost."),C=!0}function te(){Oa("WebGLRenderer: Context Restored."),C=!1;let R=Ve.autoReset,H=gt.enabled,nt=gt.autoUpdate,j=gt.needsUpdate,Q=gt.type;Qt(),Ve.autoReset=R,gt.enabled=H,gt.autoUpdate=nt,gt.needsUpdate=j,gt.type=Q}function Ct(R){ee("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function de(R){let H=R.target;H.removeEventListener("dispose",de),$e(H)}function $e(R){Zn(R),Ht.remove(R)}function Zn(R){let H=Ht.get(R).programs;H!==void 0&&(H.forEach(function(nt){ct.releaseProgram(nt)}),R.isShaderMaterial&&ct.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,nt,j,Q,Et){H===null&&(H=hn);let It=Q.isMesh&&Q.matrixWorld.determinantAffine()<0,At=fa(R,H,nt,j,Q);wt.setMaterial(j,It);let Lt=nt.index,Gt=1;if(j.wireframe===!0){if(Lt=Z.getWireframeAttribute(nt),Lt===void 0)return;Gt=2}let se=nt.drawRange,ge=nt.attributes.position,Vt=se.start*Gt,_e=(se.start+se.count)*Gt;Et!==null&&(Vt=Math.max(Vt,Et.start*Gt),_e=Math.min(_e,(Et.start+Et.count)*Gt)),Lt!==null?(Vt=Math.max(Vt,0),_e=Math.min(_e,Lt.count)):ge!=null&&(Vt=Math.max(Vt,0),_e=Math.min(_e,ge.count));let nn=_e-Vt;if(nn<0||nn===1/0)return;bt.setup(Q,j,At,nt,Lt);let Fe,Oe=st;if(Lt!==null&&(Fe=E.get(Lt),Oe=Tt,Oe.setIndex(Fe)),Q.isMesh)j.wireframe===!0?(wt.setLineWidth(j.wireframeLinewidth*sn()),Oe.setMode(k.LINES)):Oe.setMode(k.TRIANGLES);else if(Q.isLine){let wn=j.linewidth;wn===void 0&&(wn=1),wt.setLineWidth(wn*sn()),Q.isLineSegments?Oe.setMode(k.LINES):Q.isLineLoop?Oe.setMode(k.LINE_LOOP):Oe.setMode(k.LINE_STRIP)}else Q.isPoints?Oe.setMode(k.POINTS):Q.isSprite&&Oe.setMode(k.TRIANGLES);if(Q.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))Oe.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let wn=Q._multiDrawStarts,Bt=Q._multiDrawCounts,_n=Q._multiDrawCount,Me=Lt?E.get(Lt).bytesPerElement:1,_s=Ht.get(j).currentProgram.getUniforms();for(let xn=0;xn<_n;xn++)_s.setValue(k,"_gl_DrawID",xn),Oe.render(wn[xn]/Me,Bt[xn])}else if(Q.isInstancedMesh)Oe.renderInstances(Vt,nn,Q.count);else if(nt.isInstancedBufferGeometry){let wn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Bt=Math.min(nt.instanceCount,wn);Oe.renderInstances(Vt,nn,Bt)}else Oe.render(Vt,nn)};function ha(R,H,nt,j){U!==null&&R.isNodeMaterial&&U.setObject(j,R),he===!0&&ot.setState(R,nt,!1),R.transparent===!0&&R.side===li&&R.forceSinglePass===!1?(R.side=oi,R.needsUpdate=!0,ji(R,H,j),R.side=hs,R.needsUpdate=!0,ji(R,H,j),R.side=li):ji(R,H,j)}this.compile=function(R,H,nt=null){nt===null&&(nt=R),U!==null&&U.renderStart(R,H,nt),w=it.get(nt),w.init(H),b.push(w),nt.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(w.pushLight(Q),Q.castShadow&&w.pushShadow(Q))}),R!==nt&&R.traverseVisible(function(Q){Q.isLight&&Q.layers.test(H.layers)&&(w.pushLight(Q),Q.castShadow&&w.pushShadow(Q))}),w.setupLights(),U!==null&&U.updateLights(w.state.lightsArray),Ce=this.localClippingEnabled,he=ot.init(this.clippingPlanes,Ce),he===!0&&ot.setGlobalState(this.clippingPlanes,H),U!==null&&gt.render(w.state.shadowsArray,nt,H);let j=new Set;return R.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Et=Q.material;if(Et)if(Array.isArray(Et))for(let It=0;It<Et.length;It++){let At=Et[It];ha(At,nt,H,Q),j.add(At)}else ha(Et,nt,H,Q),j.add(Et)}),w=b.pop(),U!==null&&U.renderEnd(),j},this.compileAsync=function(R,H,nt=null){let j=this.compile(R,H,nt);return new Promise(Q=>{function Et(){if(j.forEach(function(It){let Lt=Ht.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&j.delete(It)}),j.size===0){Q(R);return}setTimeout(Et,10)}Yt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let qr=null;function Iu(R){qr&&qr(R)}function Ll(){ms.stop()}function Ki(){ms.start()}let ms=new zg;ms.setAnimationLoop(Iu),typeof self<"u"&&ms.setContext(self),this.setAnimationLoop=function(R){qr=R,dt.setAnimationLoop(R),R===null?ms.stop():ms.start()},dt.addEventListener("sessionstart",Ll),dt.addEventListener("sessionend",Ki),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){ee("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;U!==null&&U.renderStart(R,H);let nt=dt.enabled===!0&&dt.isPresenting===!0,j=P!==null&&(J===null||nt)&&P.begin(I,J);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),dt.enabled===!0&&dt.isPresenting===!0&&(P===null||P.isCompositing()===!1)&&(dt.cameraAutoUpdate===!0&&dt.updateCamera(H),H=dt.getCamera()),R.isScene===!0&&R.onBeforeRender(I,R,H,J),w=it.get(R,b.length),w.init(H),w.state.textureUnits=Jt.getTextureUnits(),b.push(w),Pe.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?We.setFromArrayCamera(H):ne.setFromProjectionMatrix(Pe,Ri,H.reversedDepth),Ce=this.localClippingEnabled,he=ot.init(this.clippingPlanes,Ce),T=Mt.get(R,g.length),T.init(),g.push(T),this.info.render.frame++,dt.enabled===!0&&dt.isPresenting===!0){let It=I.xr.getDepthSensingMesh();It!==null&&gs(It,H,-1/0,I.sortObjects)}gs(R,H,0,I.sortObjects),T.finish(),U!==null&&U.updateLights(w.state.lightsArray),I.sortObjects===!0&&T.sort(Wt,oe),Qe=dt.enabled===!1||dt.isPresenting===!1||dt.hasDepthSensing()===!1,Qe&&z.addToRenderList(T,R),this.info.autoReset===!0&&this.info.reset(),he===!0&&ot.beginShadows();let Q=w.state.shadowsArray;if(gt.render(Q,R,H),he===!0&&ot.endShadows(),(j&&P.hasRenderPass())===!1){let It=T.opaque,At=T.transmissive;if(w.setupLights(),H.isArrayCamera){let Lt=H.cameras;if(At.length>0)for(let Gt=0,se=Lt.length;Gt<se;Gt++){let ge=Lt[Gt];Ui(It,At,R,ge)}Qe&&z.render(R);for(let Gt=0,se=Lt.length;Gt<se;Gt++){let ge=Lt[Gt];ua(T,R,ge,ge.viewport)}}else At.length>0&&Ui(It,At,R,H),Qe&&z.render(R),ua(T,R,H)}J!==null&&V===0&&(Jt.updateMultisampleRenderTarget(J),Jt.updateRenderTargetMipmap(J)),j&&P.end(I),R.isScene===!0&&R.onAfterRender(I,R,H),bt.resetDefaultState(),G=-1,Y=null,b.pop(),b.length>0?(w=b[b.length-1],Jt.setTextureUnits(w.state.textureUnits),he===!0&&ot.setGlobalState(I.clippingPlanes,w.state.camera)):w=null,g.pop(),g.length>0?T=g[g.length-1]:T=null,U!==null&&U.renderEnd()};function gs(R,H,nt,j){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)nt=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)w.pushLight(R),R.castShadow&&w.pushShadow(R);else if(R.isSprite){let It=H.isArrayCamera?We:ne;if(!R.frustumCulled||R.intersectsFrustum(It)){j&&ve.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Pe);let At=ft.update(R),Lt=R.material;Lt.visible&&T.push(R,At,Lt,nt,ve.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let It=H.isArrayCamera?We:ne;if(!R.frustumCulled||R.intersectsFrustum(It)){let At=ft.update(R),Lt=R.material;if(j&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ve.copy(R.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),ve.copy(At.boundingSphere.center)),ve.applyMatrix4(R.matrixWorld).applyMatrix4(Pe)),Array.isArray(Lt)){let Gt=At.groups;for(let se=0,ge=Gt.length;se<ge;se++){let Vt=Gt[se],_e=Lt[Vt.materialIndex];_e&&_e.visible&&T.push(R,At,_e,nt,ve.z,Vt,H)}}else Lt.visible&&T.push(R,At,Lt,nt,ve.z,null,H)}}}let Et=R.children;for(let It=0,At=Et.length;It<At;It++)gs(Et[It],H,nt,j)}function ua(R,H,nt,j){let{opaque:Q,transmissive:Et,transparent:It}=R;w.setupLightsView(nt),he===!0&&ot.setGlobalState(I.clippingPlanes,nt),j&&wt.viewport(et.copy(j)),Q.length>0&&rn(Q,H,nt),Et.length>0&&rn(Et,H,nt),It.length>0&&rn(It,H,nt),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ui(R,H,nt,j){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[j.id]===void 0){let Vt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[j.id]=new vi(1,1,{generateMipmaps:!0,type:Vt?Xi:ci,minFilter:Us,samples:Math.max(4,ie.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let Et=w.state.transmissionRenderTarget[j.id],It=j.viewport||et;Et.setSize(It.z*I.transmissionResolutionScale,It.w*I.transmissionResolutionScale);let At=I.getRenderTarget(),Lt=I.getActiveCubeFace(),Gt=I.getActiveMipmapLevel();I.setRenderTarget(Et),I.getClearColor(K),ut=I.getClearAlpha(),ut<1&&I.setClearColor(16777215,.5),I.clear(),Qe&&z.render(nt);let se=I.toneMapping;I.toneMapping=us;let ge=j.viewport;if(j.viewport!==void 0&&(j.viewport=void 0),w.setupLightsView(j),he===!0&&ot.setGlobalState(I.clippingPlanes,j),rn(R,nt,j),Jt.updateMultisampleRenderTarget(Et),Jt.updateRenderTargetMipmap(Et),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let _e=0,nn=H.length;_e<nn;_e++){let Fe=H[_e],{object:Oe,geometry:wn,material:Bt,group:_n}=Fe;if(Bt.side===li&&Oe.layers.test(j.layers)){let Me=Bt.side;Bt.side=oi,Bt.needsUpdate=!0,un(Oe,nt,j,wn,Bt,_n),Bt.side=Me,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Jt.updateMultisampleRenderTarget(Et),Jt.updateRenderTargetMipmap(Et))}I.setRenderTarget(At,Lt,Gt),I.setClearColor(K,ut),ge!==void 0&&(j.viewport=ge),I.toneMapping=se}function rn(R,H,nt){let j=H.isScene===!0?H.overrideMaterial:null;for(let Q=0,Et=R.length;Q<Et;Q++){let It=R[Q],{object:At,geometry:Lt,group:Gt}=It,se=It.material;se.allowOverride===!0&&j!==null&&(se=j),At.layers.test(nt.layers)&&un(At,H,nt,Lt,se,Gt)}}function un(R,H,nt,j,Q,Et){U!==null&&Q.isNodeMaterial&&U.setObject(R,Q),R.onBeforeRender(I,H,nt,j,Q,Et),R.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Q.onBeforeRender(I,H,nt,j,R,Et),Q.transparent===!0&&Q.side===li&&Q.forceSinglePass===!1?(Q.side=oi,Q.needsUpdate=!0,I.renderBufferDirect(nt,H,j,Q,R,Et),Q.side=hs,Q.needsUpdate=!0,I.renderBufferDirect(nt,H,j,Q,R,Et),Q.side=li):I.renderBufferDirect(nt,H,j,Q,R,Et),R.onAfterRender(I,H,nt,j,Q,Et)}function dn(R){let H=0;for(let nt of R)nt.texture!==null&&H++;return H}function ji(R,H,nt){H.isScene!==!0&&(H=hn);let j=Ht.get(R),Q=w.state.lights,Et=w.state.shadowsArray,It=Q.state.version,At=ct.getParameters(R,Q.state,Et,H,nt,w.state.lightProbeGridArray),Lt=ct.getProgramCacheKey(At),Gt=j.programs;j.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,j.fog=H.fog;let se=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;j.envMap=D.get(R.envMap||j.environment,se),j.envMapRotation=j.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Gt===void 0&&(R.addEventListener("dispose",de),Gt=new Map,j.programs=Gt,j.programVariants=new Map);let ge=Gt.get(Lt);if(ge!==void 0){if(j.currentProgram===ge&&j.lightsStateVersion===It)return da(R,At),ge}else At.uniforms=ct.getUniforms(R),U!==null&&R.isNodeMaterial&&U.build(R,nt,At),R.onBeforeCompile(At,I),ge=ct.acquireProgram(At,Lt),Gt.set(Lt,ge),j.uniforms=At.uniforms;let Vt=j.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Vt.clippingPlanes=ot.uniform),da(R,At),j.needsLights=qs(R),j.lightsStateVersion=It,j.needsLights&&(Vt.ambientLightColor.value=Q.state.ambient,Vt.lightProbe.value=Q.state.probe,Vt.sunLights.value=Q.state.sun,Vt.sunLightShadows.value=Q.state.sunShadow,Vt.directionalLights.value=Q.state.directional,Vt.directionalLightShadows.value=Q.state.directionalShadow,Vt.spotLights.value=Q.state.spot,Vt.spotLightShadows.value=Q.state.spotShadow,Vt.rectAreaLights.value=Q.state.rectArea,Vt.ltc_1.value=Q.state.rectAreaLTC1,Vt.ltc_2.value=Q.state.rectAreaLTC2,Vt.pointLights.value=Q.state.point,Vt.pointLightShadows.value=Q.state.pointShadow,Vt.hemisphereLights.value=Q.state.hemi,Vt.sunShadowMatrix.value=Q.state.sunShadowMatrix,Vt.sunShadowCascade.value=Q.state.sunShadowCascade,Vt.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,Vt.spotLightMatrix.value=Q.state.spotLightMatrix,Vt.spotLightMap.value=Q.state.spotLightMap,Vt.pointShadowMatrix.value=Q.state.pointShadowMatrix),j.numLightProbeGrids=dn(w.state.lightProbeGridArray),j.currentProgram=ge,j.uniformsList=null,ge}function di(R,H,nt,j,Q){let Et=Ht.get(R),It=Et.currentProgram.id+","+j+","+Q,At=Et.programVariants.get(It);return At===void 0?(At=ji(R,H,nt),Et.programVariants.set(It,At)):(Et.currentProgram=At,Et.uniformsList=null,Et.outputColorSpace=j,Et.toneMapping=Q),At}function $s(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=Xo.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function da(R,H){let nt=Ht.get(R);nt.outputColorSpace=H.outputColorSpace,nt.batching=H.batching,nt.batchingColor=H.batchingColor,nt.instancing=H.instancing,nt.instancingColor=H.instancingColor,nt.instancingMorph=H.instancingMorph,nt.skinning=H.skinning,nt.morphTargets=H.morphTargets,nt.morphNormals=H.morphNormals,nt.morphColors=H.morphColors,nt.morphTargetsCount=H.morphTargetsCount,nt.numClippingPlanes=H.numClippingPlanes,nt.numIntersection=H.numClipIntersection,nt.vertexAlphas=H.vertexAlphas,nt.vertexTangents=H.vertexTangents,nt.toneMapping=H.toneMapping}function fa(R,H,nt,j,Q){H.isScene!==!0&&(H=hn),Jt.resetTextureUnits();let Et=H.fog,It=j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial?H.environment:null,At=J===null?I.outputColorSpace:J.isXRRenderTarget===!0?J.texture.colorSpace:Se.workingColorSpace,Lt=j.isMeshStandardMaterial||j.isMeshLambertMaterial&&!j.envMap||j.isMeshPhongMaterial&&!j.envMap,Gt=D.get(j.envMap||It,Lt),se=j.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,ge=!!nt.attributes.tangent&&(!!j.normalMap||j.anisotropy>0),Vt=!!nt.morphAttributes.position,_e=!!nt.morphAttributes.normal,nn=!!nt.morphAttributes.color,Fe=us;j.toneMapped&&(J===null||J.isXRRenderTarget===!0)&&(Fe=I.toneMapping);let Oe=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,wn=Oe!==void 0?Oe.length:0,Bt=Ht.get(j),_n=w.state.lights;if(he===!0&&(Ce===!0||R!==Y)){let Be=R===Y&&j.id===G;ot.setState(j,R,Be)}let Me=!1,_s=!1;j.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==_n.state.version||Q.isBatchedMesh&&Bt.batching===!1||!Q.isBatchedMesh&&Bt.batching===!0||Q.isBatchedMesh&&Bt.batchingColor===!0&&Q._colorsTexture===null||Q.isBatchedMesh&&Bt.batchingColor===!1&&Q._colorsTexture!==null||Q.isInstancedMesh&&Bt.instancing===!1||!Q.isInstancedMesh&&Bt.instancing===!0||Q.isSkinnedMesh&&Bt.skinning===!1||!Q.isSkinnedMesh&&Bt.skinning===!0||Q.isInstancedMesh&&Bt.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Bt.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Bt.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Bt.instancingMorph===!1&&Q.morphTexture!==null||Bt.envMap!==Gt||j.fog===!0&&Bt.fog!==Et||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==ot.numPlanes||Bt.numIntersection!==ot.numIntersection)||Bt.vertexAlphas!==se||Bt.vertexTangents!==ge||Bt.morphTargets!==Vt||Bt.morphNormals!==_e||Bt.morphColors!==nn||Bt.morphTargetsCount!==wn||Bt.numLightProbeGrids!==dn(w.state.lightProbeGridArray)?Me=!0:(Bt.outputColorSpace!==At||Bt.toneMapping!==Fe)&&(_s=!0):(Me=!0,Bt.__version=j.version);let xn=Bt.currentProgram;(Me===!0||_s===!0)&&(xn=_s===!0?di(j,H,Q,At,Fe):ji(j,H,Q),U&&j.isNodeMaterial&&U.onUpdateProgram(j,xn,Bt));let Jr=!1,Qi=!1,xs=!1,pe=xn.getUniforms(),on=Bt.uniforms;if(wt.useProgram(xn.program)&&(Jr=!0,Qi=!0,xs=!0),j.id!==G&&(G=j.id,Qi=!0),Jr||Y!==R){wt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),pe.setValue(k,"projectionMatrix",R.projectionMatrix),pe.setValue(k,"viewMatrix",R.matrixWorldInverse);let yn=pe.map.cameraPosition;yn!==void 0&&yn.setValue(k,gn.setFromMatrixPosition(R.matrixWorld)),ie.logarithmicDepthBuffer&&pe.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(j.isMeshPhongMaterial||j.isMeshToonMaterial||j.isMeshLambertMaterial||j.isMeshBasicMaterial||j.isMeshStandardMaterial||j.isShaderMaterial)&&pe.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),Y!==R&&(Y=R,Qi=!0,xs=!0)}if(Bt.needsLights&&(_n.state.sunShadowMap.length>0&&pe.setValue(k,"sunShadowMap",_n.state.sunShadowMap,Jt),_n.state.directionalShadowMap.length>0&&pe.setValue(k,"directionalShadowMap",_n.state.directionalShadowMap,Jt),_n.state.spotShadowMap.length>0&&pe.setValue(k,"spotShadowMap",_n.state.spotShadowMap,Jt),_n.state.pointShadowMap.length>0&&pe.setValue(k,"pointShadowMap",_n.state.pointShadowMap,Jt)),Q.isSkinnedMesh){pe.setOptional(k,Q,"bindMatrix"),pe.setOptional(k,Q,"bindMatrixInverse");let Be=Q.skeleton;Be&&(Be.boneTexture===null&&Be.computeBoneTexture(),pe.setValue(k,"boneTexture",Be.boneTexture,Jt))}Q.isBatchedMesh&&(pe.setOptional(k,Q,"batchingTexture"),pe.setValue(k,"batchingTexture",Q._matricesTexture,Jt),pe.setOptional(k,Q,"batchingIdTexture"),pe.setValue(k,"batchingIdTexture",Q._indirectTexture,Jt),pe.setOptional(k,Q,"batchingColorTexture"),Q._colorsTexture!==null&&pe.setValue(k,"batchingColorTexture",Q._colorsTexture,Jt));let Jn=nt.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&at.update(Q,nt,xn),(Qi||Bt.receiveShadow!==Q.receiveShadow)&&(Bt.receiveShadow=Q.receiveShadow,pe.setValue(k,"receiveShadow",Q.receiveShadow)),(j.isMeshStandardMaterial||j.isMeshLambertMaterial||j.isMeshPhongMaterial)&&j.envMap===null&&H.environment!==null&&(on.envMapIntensity.value=H.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=Dw()),Qi){if(pe.setValue(k,"toneMappingExposure",I.toneMappingExposure),Bt.needsLights&&Yr(on,xs),Et&&j.fog===!0&&vt.refreshFogUniforms(on,Et),vt.refreshMaterialUniforms(on,j,_t,yt,w.state.transmissionRenderTarget[R.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let Be=v,yn=0;for(let Gn of w.state.lightProbeGridArray)Gn.texture!==null&&(Be.textures[yn]=Gn.texture,Be.min[yn]=Gn.boundingBox.min,Be.max[yn]=Gn.boundingBox.max,Be.resolution[yn]=Gn.resolution,yn++);for(let Gn in Be)Be[Gn].length=yn;on.probesSH.value=Be.textures,on.probesMin.value=Be.min,on.probesMax.value=Be.max,on.probesResolution.value=Be.resolution}Xo.upload(k,$s(Bt),on,Jt)}if(j.isShaderMaterial&&j.uniformsNeedUpdate===!0&&(Xo.upload(k,$s(Bt),on,Jt),j.uniformsNeedUpdate=!1),j.isSpriteMaterial&&pe.setValue(k,"center",Q.center),pe.setValue(k,"modelViewMatrix",Q.modelViewMatrix),pe.setValue(k,"normalMatrix",Q.normalMatrix),pe.setValue(k,"modelMatrix",Q.matrixWorld),j.uniformsGroups!==void 0){let Be=j.uniformsGroups;for(let yn=0,Gn=Be.length;yn<Gn;yn++){let Dl=Be[yn];Xt.update(Dl,xn),Xt.bind(Dl,xn)}}return xn}function Yr(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function qs(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return J},this.setRenderTargetTextures=function(R,H,nt){let j=Ht.get(R);j.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,j.__autoAllocateDepthBuffer===!1&&(j.__useRenderToTexture=!1),Ht.get(R.texture).__webglTexture=H,Ht.get(R.depthTexture).__webglTexture=j.__autoAllocateDepthBuffer?void 0:nt,j.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let nt=Ht.get(R);nt.__webglFramebuffer=H,nt.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,nt=0){J=R,$=H,V=nt;let j=null,Q=!1,Et=!1;if(R){let At=Ht.get(R);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(k.FRAMEBUFFER,At.__webglFramebuffer),et.copy(R.viewport),lt.copy(R.scissor),rt=R.scissorTest,wt.viewport(et),wt.scissor(lt),wt.setScissorTest(rt),G=-1;return}else if(At.__webglFramebuffer===void 0)Jt.setupRenderTarget(R);else if(At.__hasExternalTextures)Jt.rebindTextures(R,Ht.get(R.texture).__webglTexture,Ht.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let se=R.depthTexture;if(At.__boundDepthTexture!==se){if(se!==null&&Ht.has(se)&&(R.width!==se.image.width||R.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Jt.setupDepthRenderbuffer(R)}}let Lt=R.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Et=!0);let Gt=Ht.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Gt[H])?j=Gt[H][nt]:j=Gt[H],Q=!0):R.samples>0&&Jt.useMultisampledRTT(R)===!1?j=Ht.get(R).__webglMultisampledFramebuffer:Array.isArray(Gt)?j=Gt[nt]:j=Gt,et.copy(R.viewport),lt.copy(R.scissor),rt=R.scissorTest}else et.copy(Ot).multiplyScalar(_t).floor(),lt.copy(ce).multiplyScalar(_t).floor(),rt=ue;if(nt!==0&&(j=O),wt.bindFramebuffer(k.FRAMEBUFFER,j)&&wt.drawBuffers(R,j),wt.viewport(et),wt.scissor(lt),wt.setScissorTest(rt),Q){let At=Ht.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,At.__webglTexture,nt)}else if(Et){let At=H;for(let Lt=0;Lt<R.textures.length;Lt++){let Gt=Ht.get(R.textures[Lt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Lt,Gt.__webglTexture,nt,At)}}else if(R!==null&&nt!==0){let At=Ht.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,At.__webglTexture,nt)}G=-1};function Zr(R){let H=Ht.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=ie.textureFormatReadable(R.format),H.__typeReadable=ie.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,nt,j,Q,Et,It,At=0){if(!(R&&R.isWebGLRenderTarget)){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){wt.bindFramebuffer(k.FRAMEBUFFER,Lt);try{let Gt=R.textures[At],se=Gt.format,ge=Gt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+At);let Vt=Zr(Gt);if(Vt.__formatReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-j&&nt>=0&&nt<=R.height-Q&&k.readPixels(H,nt,j,Q,xt.convert(se),xt.convert(ge),Et)}finally{let Gt=J!==null?Ht.get(J).__webglFramebuffer:null;wt.bindFramebuffer(k.FRAMEBUFFER,Gt)}}},this.readRenderTargetPixelsAsync=async function(R,H,nt,j,Q,Et,It,At=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(H>=0&&H<=R.width-j&&nt>=0&&nt<=R.height-Q){wt.bindFramebuffer(k.FRAMEBUFFER,Lt);let Gt=R.textures[At],se=Gt.format,ge=Gt.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+At);let Vt=Zr(Gt);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.bufferData(k.PIXEL_PACK_BUFFER,Et.byteLength,k.STREAM_READ),k.readPixels(H,nt,j,Q,xt.convert(se),xt.convert(ge),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let nn=J!==null?Ht.get(J).__webglFramebuffer:null;wt.bindFramebuffer(k.FRAMEBUFFER,nn);let Fe=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await dg(k,Fe,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Et),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(_e),k.deleteSync(Fe),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,nt=0){let j=Math.pow(2,-nt),Q=Math.floor(R.image.width*j),Et=Math.floor(R.image.height*j),It=H!==null?H.x:0,At=H!==null?H.y:0;Jt.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,nt,0,0,It,At,Q,Et),wt.unbindTexture()},this.copyTextureToTexture=function(R,H,nt=null,j=null,Q=0,Et=0){let It,At,Lt,Gt,se,ge,Vt,_e,nn,Fe=R.isCompressedTexture?R.mipmaps[Et]:R.image;if(nt!==null)It=nt.max.x-nt.min.x,At=nt.max.y-nt.min.y,Lt=nt.isBox3?nt.max.z-nt.min.z:1,Gt=nt.min.x,se=nt.min.y,ge=nt.isBox3?nt.min.z:0;else{let pe=Math.pow(2,-Q);It=Math.floor(Fe.width*pe),At=Math.floor(Fe.height*pe),R.isDataArrayTexture?Lt=Fe.depth:R.isData3DTexture?Lt=Math.floor(Fe.depth*pe):Lt=1,Gt=0,se=0,ge=0}j!==null?(Vt=j.x,_e=j.y,nn=j.z):(Vt=0,_e=0,nn=0);let Oe=xt.convert(H.format),wn=xt.convert(H.type),Bt;H.isData3DTexture?(Jt.setTexture3D(H,0),Bt=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Jt.setTexture2DArray(H,0),Bt=k.TEXTURE_2D_ARRAY):(Jt.setTexture2D(H,0),Bt=k.TEXTURE_2D),wt.activeTexture(k.TEXTURE0),wt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),wt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),wt.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let _n=wt.getParameter(k.UNPACK_ROW_LENGTH),Me=wt.getParameter(k.UNPACK_IMAGE_HEIGHT),_s=wt.getParameter(k.UNPACK_SKIP_PIXELS),xn=wt.getParameter(k.UNPACK_SKIP_ROWS),Jr=wt.getParameter(k.UNPACK_SKIP_IMAGES);wt.pixelStorei(k.UNPACK_ROW_LENGTH,Fe.width),wt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Fe.height),wt.pixelStorei(k.UNPACK_SKIP_PIXELS,Gt),wt.pixelStorei(k.UNPACK_SKIP_ROWS,se),wt.pixelStorei(k.UNPACK_SKIP_IMAGES,ge);let Qi=R.isDataArrayTexture||R.isData3DTexture,xs=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let pe=Ht.get(R),on=Ht.get(H),Jn=Ht.get(pe.__renderTarget),Be=Ht.get(on.__renderTarget);wt.bindFramebuffer(k.READ_FRAMEBUFFER,Jn.__webglFramebuffer),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Be.__webglFramebuffer);for(let yn=0;yn<Lt;yn++)Qi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(R).__webglTexture,Q,ge+yn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Ht.get(H).__webglTexture,Et,nn+yn)),k.blitFramebuffer(Gt,se,Gt+It,se+At,Vt,_e,Vt+It,_e+At,k.DEPTH_BUFFER_BIT,k.NEAREST);wt.bindFramebuffer(k.READ_FRAMEBUFFER,null),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Q!==0||R.isRenderTargetTexture||Ht.has(R)){let pe=Ht.get(R),on=Ht.get(H);wt.bindFramebuffer(k.READ_FRAMEBUFFER,L),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,B);for(let Jn=0;Jn<Lt;Jn++)Qi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pe.__webglTexture,Q,ge+Jn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pe.__webglTexture,Q),xs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,on.__webglTexture,Et,nn+Jn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,on.__webglTexture,Et),Q!==0?k.blitFramebuffer(Gt,se,Gt+It,se+At,Vt,_e,Vt+It,_e+At,k.COLOR_BUFFER_BIT,k.NEAREST):xs?k.copyTexSubImage3D(Bt,Et,Vt,_e,nn+Jn,Gt,se,It,At):k.copyTexSubImage2D(Bt,Et,Vt,_e,Gt,se,It,At);wt.bindFramebuffer(k.READ_FRAMEBUFFER,null),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else xs?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Bt,Et,Vt,_e,nn,It,At,Lt,Oe,wn,Fe.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Bt,Et,Vt,_e,nn,It,At,Lt,Oe,Fe.data):k.texSubImage3D(Bt,Et,Vt,_e,nn,It,At,Lt,Oe,wn,Fe):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Et,Vt,_e,It,At,Oe,wn,Fe.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Et,Vt,_e,Fe.width,Fe.height,Oe,Fe.data):k.texSubImage2D(k.TEXTURE_2D,Et,Vt,_e,It,At,Oe,wn,Fe);wt.pixelStorei(k.UNPACK_ROW_LENGTH,_n),wt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Me),wt.pixelStorei(k.UNPACK_SKIP_PIXELS,_s),wt.pixelStorei(k.UNPACK_SKIP_ROWS,xn),wt.pixelStorei(k.UNPACK_SKIP_IMAGES,Jr),Et===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Bt),wt.unbindTexture()},this.initRenderTarget=function(R){Ht.get(R).__webglFramebuffer===void 0&&Jt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Jt.setTextureCube(R,0):R.isData3DTexture?Jt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Jt.setTexture2DArray(R,0):Jt.setTexture2D(R,0),wt.unbindTexture()},this.resetState=function(){$=0,V=0,J=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var ml=()=>{let n=so(!1);return t=>n(1-t)};function qi({radius_m:n}){let[t,e]=[n[0],n.at(-1)],i=n.length>1?(e-t)/(n.length-1)/2:t;return[Math.max(t-i,0),e+i]}var qo=({depth_m:n})=>n.reduce((t,e)=>e>t?e:t,0);function mf(n,t,e){let[i,s]=qi(n),r=n.radius_m.length,o=n.angle_rad.length,a=Math.floor((Math.hypot(t,e)-i)/(s-i)*r);if(a<0||a>=r)return NaN;let l=Math.atan2(e,t)/(2*Math.PI),c=Math.min(Math.floor((l-Math.floor(l))*o),o-1);return n.depth_m[a*o+c]}function Rn(n,t,e){let i=t-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],step:1};let s=i/Math.max(e,1),r=10**Math.floor(Math.log10(s)),o=[1,2,2.5,5,10].map(l=>l*r).find(l=>l>=s*.999),a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=t+o*1e-9;l++)a.push(l*o);return{values:a,step:o}}var gf=(n,t)=>n<8?"start":n>t-8?"end":"middle",Nw={start:0,middle:.5,end:1};function Kg(n,t,e){for(let r=Math.floor(e/24);r>1;r--){let o=Rn(n,t,r),a=o.values.map(l=>{let c=(l-n)/(t-n)*e,u=6.2*mn(l,o.step).length,d=c-Nw[gf(c,e)]*u;return[d,d+u]});if(a.every(([l],c)=>c===0||a[c-1][1]+5<=l))return o}return Rn(n,t,1)}function mn(n,t){let e=Math.abs(n)<t*1e-6?0:n,i=0;for(;i<8&&Math.abs(t*10**i-Math.round(t*10**i))>1e-6;)i++;return Ss(e.toFixed(i))}function jg(n,t,e,i,s){if(!(n<=t)||n===0&&t===0)return[0,i];(e||n>0&&n<.35*t)&&(n=Math.min(n,0)),(e||t<0&&t>.35*n)&&(t=Math.max(t,0));let r=s-(t-n);if(r>0){let l=.001*s;return n>=-l&&n<r/2?[0,Math.max(t,s)]:t<=l&&-t<r/2?[Math.min(n,-s),0]:[n-r/2,t+r/2]}let a=.05*(t-n||Math.abs(t)*.2||1);return[n===0?0:n-a,t===0?0:t+a]}function tu(n,t,e,i){let s=Array.from({length:21},(l,c)=>`rgb(${i(c/20).join(" ")}) ${c*5}%`),r=e.map(l=>qt(l,t)),{values:o,step:a}=Rn(r[0],r[1],4);return[W("span",{},n),W("div",{class:"ramp",style:`background:linear-gradient(to right, ${s.join(",")})`}),W("div",{class:"ramp-ticks"},o.map(l=>W("span",{style:`left:${(l-r[0])/(r[1]-r[0])*100}%`},mn(l,a))))]}var Uw={top:"hanging",middle:"central",bottom:"text-after-edge"},Yo=class{fillStyle="#000";strokeStyle="#000";textAlign="left";textBaseline="alphabetic";font="";#i=[];#n="";#t=[];#s=[];constructor(t,e){this.picture=Pt("svg",{viewBox:`0 0 ${t} ${e}`,xmlns:"http://www.w3.org/2000/svg","font-family":"system-ui, sans-serif","font-size":11})}#e(t,e,...i){let s=this.#t.join(" ")||null;this.picture.append(Pt(t,{...e,transform:s},...i))}save(){this.#s.push([...this.#t])}restore(){this.#t=this.#s.pop()??[]}translate(t,e){this.#t.push(`translate(${t} ${e})`)}rotate(t){this.#t.push(`rotate(${t*180/Math.PI})`)}setLineDash(t){this.#i=t}beginPath(){this.#n=""}moveTo(t,e){this.#n+=`M${t} ${e}`}lineTo(t,e){this.#n+=`L${t} ${e}`}stroke(){this.#e("path",{d:this.#n,fill:"none",stroke:this.strokeStyle,"stroke-dasharray":this.#i.join(" ")||null})}fillRect(t,e,i,s){this.#e("rect",{x:t,y:e,width:i,height:s,fill:this.fillStyle})}strokeRect(t,e,i,s){this.#e("rect",{x:t,y:e,width:i,height:s,fill:"none",stroke:this.strokeStyle})}fillText(t,e,i){let s={center:"middle",right:"end"}[this.textAlign]??"start";this.#e("text",{x:e,y:i,fill:this.fillStyle,"text-anchor":s,"dominant-baseline":Uw[this.textBaseline]??"auto"},t)}image(t,e,i,s,r){this.#e("image",{x:e,y:i,width:s,height:r,href:t,preserveAspectRatio:"none"})}file(){let{width:t,height:e}=this.picture.viewBox.baseVal;return this.picture.setAttribute("width",t),this.picture.setAttribute("height",e),`<?xml version="1.0" encoding="UTF-8"?>
${new XMLSerializer().serializeToString(this.picture)}
`}};var hi=44,_f=34,Pi=18,gl=8,eu=400,Fw=270;function Qg(n,t){let e=W("canvas",{class:"plan",role:"img","aria-label":"The bottom of the hole from above"}),i=W("p",{class:"readout-line"}," "),s=Mn("Bottom of the hole",{svg:()=>l(),csv:()=>Wn(...c())}),r=W("div",{class:"plan-holder"},e,i,s),o=eu;function a(){let h=n();if(!h)return;o=fn()?Fw:Math.min(Math.max((r.clientWidth||eu)-hi-gl,150),eu);let f=Math.max(devicePixelRatio,2),[_,y]=[hi+o+gl,Pi+o+_f];[e.width,e.height]=[_*f,y*f],e.style.width=`${_}px`,e.style.height=`${y}px`;let m=e.getContext("2d");m.scale(f,f),m.font="11px system-ui, sans-serif";let p=1.04*qi(h)[1];u(m,h,p,Math.round(o*f)),d(m,p)}function l(){let h=n(),f=new Yo(hi+o+gl,Pi+o+_f);f.fillStyle=Ee("paper"),f.fillRect(0,0,hi+o+gl,Pi+o+_f);let _=W("canvas",{width:2*o,height:2*o}),y=_.getContext("2d");y.scale(2,2),y.translate(-hi,-Pi);let m=1.04*qi(h)[1];return u(y,h,m,2*o),f.image(_.toDataURL(),hi,Pi,o,o),d(f,m),f.file()}function c(){let{radius_m:h,angle_rad:f,depth_m:_}=n(),y=Array.from(h).flatMap((p,x)=>Array.from(f,(M,v)=>[qt(p,"diameter"),qt(M,"angle"),qt(_[x*f.length+v],"diameter")])),m=re("diameter");return[[`radius, ${m}`,`angle, ${re("angle")}`,`depth, ${m}`],y]}function u(h,f,_,y){let m=ml(),p=qo(f)||1,x=new ImageData(y,y),M=T=>(2*((T+.5)/y)-1)*_;for(let T=0;T<y;T++)for(let w=0;w<y;w++){let g=mf(f,-M(T),M(w));Number.isFinite(g)&&x.data.set([...m(g/p),255],4*(T*y+w))}let v=new OffscreenCanvas(y,y);v.getContext("2d").putImageData(x,0,0),h.drawImage(v,hi,Pi,o,o)}function d(h,f){let _=qt(f,"diameter"),{values:y,step:m}=Rn(-_,_,6),p=M=>.5+zn(M,"diameter")/(2*f);h.fillStyle=Ee("muted"),h.textAlign="center",h.textBaseline="top";for(let M of y)h.fillText(mn(M,m),hi+p(M)*o,Pi+o+5);let x=t?"to the right":"across";h.fillText(`${x}, ${re("diameter")}`,hi+o/2,Pi+o+19),h.textAlign="right",h.textBaseline="middle";for(let M of y)h.fillText(mn(M,m),hi-6,Pi+(1-p(M))*o);t&&(h.textAlign="center",h.textBaseline="bottom",h.fillText("high side ▴",hi+o/2,Pi-4)),h.strokeStyle=Ee("frame"),h.strokeRect(hi,Pi,o,o)}return e.addEventListener("pointermove",h=>{let f=n();if(!f)return;let _=e.getBoundingClientRect(),y=1.04*qi(f)[1],m=T=>(2*(T/o)-1)*y,p=m(h.clientX-_.left-hi),x=-m(h.clientY-_.top-Pi),M=mf(f,x,p),v=(Math.atan2(p,x)+2*Math.PI)%(2*Math.PI);i.textContent=Number.isFinite(M)?`radius ${Te(Math.hypot(x,p),"diameter",3)}, ${Te(v,"angle",3)}: ${Te(M,"diameter",3)} deep`:" "}),e.addEventListener("pointerleave",()=>i.textContent=" "),new ResizeObserver(()=>{let h=Math.min(Math.max(r.clientWidth-hi-gl,150),eu);!fn()&&r.clientWidth&&h!==o&&a()}).observe(r),{element:r,draw:a}}var nu=17;function Fr(n,t,e,i="text",s=.5){let r=W("canvas",{}),o=r.getContext("2d"),a="600 44px system-ui, sans-serif";o.font=a,r.width=Math.ceil(o.measureText(n).width)+8,r.height=56,o.font=a,o.textBaseline="middle",o.fillStyle=Ee(i),o.fillText(n,4,30);let l=new $a(r);l.colorSpace=ei;let c=new Wa(new Oo({map:l,depthTest:!1,transparent:!0}));return c.position.set(...t),c.center.set(s,.5),c.userData.pixels=[e*r.width/r.height,e],c.renderOrder=3,c}function xf(n,[t,e]){let i=new q(1/0,1/0,1/0),s=i.clone().negate();for(let o=0;o<=100;o++){let a=new q(...n.at(t+(e-t)*o/100,{}).place);i.min(a),s.max(a)}let r=.22*s.clone().sub(i).length();for(let o of["x","y","z"]){let l=Math.max(r-(s[o]-i[o]),0)/2+(o==="y"?0:.03*r);i[o]-=l,s[o]+=l}return{low:i,high:s}}function yf({low:n,high:t},[e,,i]){let[s,r]=e>=0?[n.x,t.x]:[t.x,n.x],[o,a]=i>=0?[n.z,t.z]:[t.z,n.z];return[[s,o],[r,o],[s,a]]}function Ow(n,[t,e],i,s,r){let a=1/0;for(let l=0;l<=100;l++){let[c,u,d]=n.at(t+(e-t)*l/100,{}).place;Math.abs(u-i)<=(e-t)/100&&(a=Math.min(a,Math.abs(s([c,d])-s(r))))}return a}function t0(n,t,e,i){let s=xf(n,t),{low:r,high:o}=s,[a,...l]=yf(s,i),c=([g,b])=>g*i[2]-b*i[0],[u,d]=l.sort((g,b)=>c(g)-c(b)),h=o.clone().sub(r).length(),f=re("length"),_=Rn(qt(t[0],"length"),qt(t[1],"length"),8),y=_.values.map(g=>{let{place:b,high:P}=n.at(zn(g,"length"),{}),I=e+.012*h;return Fr(`${mn(g,_.step)} ${f}`,b.map((C,U)=>C+I*P[U]),nu,"text",0)}),m=[],p=(g,b)=>m.push(...g,...b),x=Rn(qt(-o.y,"length"),qt(-r.y,"length"),5),M=g=>Math.min(...x.values.map(b=>Ow(n,t,-zn(b,"length"),c,g))),v=M(d)>M(u)+.1*h?d:u,T=x.values.map(g=>{let b=-zn(g,"length"),P=([I,C])=>[I,b,C];return p(P(a),P(d)),p(P(a),P(u)),Fr(`TVD ${mn(g,x.step)} ${f}`,P(v),nu,"muted",v===u?1.06:-.06)});for(let[g,b]of[a,d,u])p([g,r.y,b],[g,o.y,b]);let w=new Bn;return w.setAttribute("position",new pn(m,3)),[new Pr(w,new ar({color:Ee("frame"),transparent:!0,opacity:.35})),Fr("N",[(r.x+o.x)/2,o.y,r.z-.04*h],nu+2),Fr("E",[o.x+.04*h,o.y,(r.z+o.z)/2],nu+2),...T,...y]}var e0={type:"change"},Mf={type:"start"},i0={type:"end"},iu=new Cr,n0=new xi,Bw=Math.cos(70*Qd.DEG2RAD),Cn=new q,ui=2*Math.PI,Le={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},vf=1e-6,su=class extends nl{constructor(t,e=null){super(t,e),this.state=Le.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ur.ROTATE,MIDDLE:ur.DOLLY,RIGHT:ur.PAN},this.touches={ONE:dr.ROTATE,TWO:dr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new yi,this._lastTargetPosition=new q,this._quat=new yi().setFromUnitVectors(t.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new zo,this._sphericalDelta=new zo,this._scale=1,this._panOffset=new q,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new q,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=zw.bind(this),this._onPointerDown=kw.bind(this),this._onPointerUp=Vw.bind(this),this._onContextMenu=Yw.bind(this),this._onMouseWheel=Ww.bind(this),this._onKeyDown=Xw.bind(this),this._onTouchStart=$w.bind(this),this._onTouchMove=qw.bind(this),this._onMouseDown=Gw.bind(this),this._onMouseMove=Hw.bind(this),this._interceptControlDown=Zw.bind(this),this._interceptControlUp=Jw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Le.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(e0),this.update(),this.state=Le.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Cn.copy(e).sub(this.target),Cn.applyQuaternion(this._quat),this._spherical.setFromVector3(Cn),this.autoRotate&&this.state===Le.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ui:i>Math.PI&&(i-=ui),s<-Math.PI?s+=ui:s>Math.PI&&(s-=ui),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Cn.setFromSpherical(this._spherical),Cn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(iu.origin.copy(this.object.position),iu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(iu.direction))<Bw?this.object.lookAt(this.target):(n0.setFromNormalAndCoplanarPoint(this.object.up,this.target),iu.intersectPlane(n0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>vf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>vf||this._lastTargetPosition.distanceToSquared(this.target)>vf?(this.dispatchEvent(e0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ui/60*this.autoRotateSpeed*t:ui/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Cn.setFromMatrixColumn(e,0),Cn.multiplyScalar(-t),this._panOffset.add(Cn)}_panUp(t,e){this.screenSpacePanning===!0?Cn.setFromMatrixColumn(e,1):(Cn.setFromMatrixColumn(e,0),Cn.crossVectors(this.object.up,Cn)),Cn.multiplyScalar(t),this._panOffset.add(Cn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Cn.copy(s).sub(this.target);let r=Cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function kw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function zw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function Vw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(i0),this.state=Le.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Gw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Le.DOLLY;break;case ur.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Le.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Le.ROTATE}break;case ur.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Le.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Le.PAN}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(Mf)}function Hw(n){switch(this.state){case Le.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Le.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Le.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Ww(n){this.enabled===!1||this.enableZoom===!1||this.state!==Le.NONE||(n.preventDefault(),this.dispatchEvent(Mf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(i0))}function Xw(n){this.enabled!==!1&&this._handleKeyDown(n)}function $w(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case dr.ROTATE:if(this.enableRotate===!1){this.state=Le.NONE;break}this._handleTouchStartRotate(n),this.state=Le.TOUCH_ROTATE;break;case dr.PAN:if(this.enablePan===!1){this.state=Le.NONE;break}this._handleTouchStartPan(n),this.state=Le.TOUCH_PAN;break;default:this.state=Le.NONE}break;case 2:switch(this.touches.TWO){case dr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Le.TOUCH_DOLLY_PAN;break;case dr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Le.TOUCH_DOLLY_ROTATE;break;default:this.state=Le.NONE}break;default:this.state=Le.NONE}this.state!==Le.NONE&&this.dispatchEvent(Mf)}function qw(n){switch(this._trackPointer(n),this.state){case Le.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Le.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Le.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Le.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Le.NONE}}function Yw(n){this.enabled!==!1&&n.preventDefault()}function Zw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Jw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ru=()=>W("p",{class:"warning"},"This view needs WebGL, which this browser does not give."),Kw=n=>new Ci().setFromArray(n.flat()).getCenter(new q),ou="drag to turn, right-drag to move, Ctrl + wheel to go nearer";function au(n,t,e=0){let i=W("canvas",{class:"space",style:`height:${t}px`,role:"img","aria-label":n}),s;try{s=new Kh({canvas:i,antialias:!0,alpha:!0,preserveDrawingBuffer:!0})}catch{return null}let r=new za,o=new ni(38,1,1,1e5),a=new su(o,i);a.enableDamping=!1,a.enableZoom=!1;let l=new tl(16777215,2.2);r.add(new el(16777215,1.6),l);let c=W("canvas",{class:"space-paper"}),u=W("div",{class:"space-holder"},i,c),d=[];i.addEventListener("wheel",M=>{if(!M.ctrlKey&&!M.metaKey)return;M.preventDefault();let v=o.position.clone().sub(a.target).multiplyScalar(Math.exp(M.deltaY*.002));o.position.copy(a.target).add(v),_()},{passive:!1}),a.addEventListener("change",_);function h(M){return d.push(M),r.add(M),M}function f(M=d){for(let v of M)r.remove(v),v.geometry?.dispose(),v.material.map?.dispose(),v.material.dispose();d=d.filter(v=>!M.includes(v))}function _(){let M=e*o.position.distanceTo(a.target);l.position.copy(o.position).add(new q(-M,M,0).applyQuaternion(o.quaternion)),l.target.position.copy(a.target),l.target.updateMatrixWorld(),u.dataset.labels=JSON.stringify(m()),s.render(r,o),fn()&&([c.width,c.height]=[i.width,i.height],c.getContext("2d").drawImage(i,0,0))}function y(M,v,T=Kw(M),w=[.07*(i.clientWidth||1200),.04*t]){let g=i.clientWidth||1200,b=new q(...v).normalize(),P=M.map(L=>new q(...L)),I=Math.tan(o.fov*Math.PI/360),C=[1-2*w[0]/g,1-2*w[1]/t].map(L=>Math.max(L,.3)),U=T.clone(),O=2*Math.max(...P.map(L=>L.distanceTo(T)),.001);for(let L=0;L<12;L++){o.position.copy(U).addScaledVector(b,O),o.near=O/1e3,o.far=O*1e3,o.updateProjectionMatrix(),o.lookAt(U),o.updateMatrixWorld();let B=new Ci().setFromPoints(P.map(Y=>Y.clone().project(o))),[$,V]=[(B.min.x+B.max.x)/2,(B.min.y+B.max.y)/2],J=new q().setFromMatrixColumn(o.matrixWorld,0),G=new q().setFromMatrixColumn(o.matrixWorld,1);U.addScaledVector(J,$*O*I*(g/t)).addScaledVector(G,V*O*I),O*=Math.max((B.max.x-B.min.x)/2/C[0],(B.max.y-B.min.y)/2/C[1])||1}a.target.copy(U),o.position.copy(U).addScaledVector(b,O),o.near=O/200,o.far=O*20,o.updateProjectionMatrix(),a.update(),_()}function m(){o.updateMatrixWorld();let[M,v]=[i.clientWidth||1200,Math.tan(o.fov*Math.PI/360)],T=[];for(let w of d.filter(g=>g.userData.pixels)){let[g,b]=w.userData.pixels,P=-w.position.clone().applyMatrix4(o.matrixWorldInverse).z,I=2*v*P/t;w.scale.set(g*I,b*I,1);let C=w.position.clone().project(o),U=(C.x+1)/2*M-w.center.x*g,O=(1-C.y)/2*t-b/2,L={left:U,top:O,right:U+g,bottom:O+b},B=$=>L.left<$.right+4&&$.left<L.right+4&&L.top<$.bottom&&$.top<L.bottom;w.visible=P>0&&L.left>=0&&L.right<=M&&!T.some(B),w.visible&&T.push(L)}return T}function p(){let M=u.clientWidth||1200;s.setPixelRatio(Math.min(devicePixelRatio*(devicePixelRatio<1.5?1.5:1),2.5)),s.setSize(M,t,!1),o.aspect=M/t,o.updateProjectionMatrix()}let x=0;return new ResizeObserver(()=>{u.clientWidth!==x&&(x=u.clientWidth,p(),_())}).observe(u),{holder:u,canvas:i,spans:M=>{let v=new Ci().setFromPoints(M.map(T=>new q(...T).project(o)));return[(v.max.x-v.min.x)/2,(v.max.y-v.min.y)/2]},add:h,has:M=>d.includes(M),remove:f,render:_,lookAt:y,size:p,from:()=>o.position.clone().sub(a.target)}}var jw=460,s0=[-.35,.95,.9];function cu(n,t){let e=au("The bottom of the hole in space",jw,.9),i=Qg(n,t),s=W("div",{class:"colour-key"}),r=1,o=null,a=W("output",{}),l=W("input",{type:"range",min:0,max:1.3,step:.01,"aria-label":"Exaggeration of depth",oninput:()=>{r=10**Number(l.value),d()}}),c=[["At an angle",s0],["From above",[0,1,.001]],["From the side",[0,.12,1]]].map(([m,p])=>W("button",{type:"button",onclick:()=>h(p)},m)),u=W("div",{class:"tools noprint"},W("label",{},"Depth × ",l,a),c,W("span",{class:"hint"},ou));function d(){let m=n();if(!m)return;let[,p]=qi(m),x=qo(m),M=re("diameter");s.replaceChildren(...tu(`Depth below the rim, ${M}`,"diameter",[0,x],ml())),e&&(e.remove(),e.add(t1(m,x,r)),e.add(e1(m,r)),n1(p,t?o0(m)*r:null).forEach(e.add),a.textContent=` ${Tn(r,2)}`,e.render())}function h(m){let p=n();if(!p||!e)return;let[,x]=qi(p),M=qo(p)*r,v=p.depth_m.reduce((b,P)=>P<b?P:b,0)*r,w=Array.from({length:24},(b,P)=>P*Math.PI/12).flatMap(b=>[v,M].map(P=>lu(x,b,P))),g=[-1,1].map(b=>[.7*b*x,0,1.25*x]);t&&g.push([0,.2*x-v,-x]),e.lookAt([...w,...g],m,new q(0,-(v+M)/2,.22*x))}function f(){let m=n();if(o=m,!m)return;let p=.3*qi(m)[1]/(qo(m)||1);r=[10,5,2].find(x=>x<=p)??1,l.value=Math.log10(r),d(),h(s0)}function _(){i.draw(),e&&e.size(),n()===o?d():f()}we("units",()=>{i.draw(),d()}),we("operation",()=>{i.draw(),f()});let y=e?[u,W("div",{class:"bottom"},e.holder,i.element)]:[ru(),i.element];return{element:W("div",{},y,s),redraw:_}}var lu=(n,t,e)=>[n*Math.sin(t),-e,-n*Math.cos(t)];function Qw(n){let[t,e]=qi(n),i=n.angle_rad.length,s=n.radius_m.length-1,r=u=>n.depth_m.subarray(u*i,(u+1)*i),o=Array.from(n.radius_m,(u,d)=>[u,r(d)]),a=r(0),l=a.filter(Number.isFinite),c=l.reduce((u,d)=>u+d,0)/l.length;return o.unshift(t>0?[t,a]:[0,a.map(()=>c)]),o.push([e,r(s)]),o}function t1(n,t,e){let i=Qw(n),s=n.angle_rad.length,r=ml(),o=new fe,[a,l,c]=[[],[],[]];for(let[h,f]of i)f.forEach((_,y)=>{let m=Number.isFinite(_)?_:0;a.push(...lu(h,n.angle_rad[y],m*e));let[p,x,M]=r(m/(t||1)).map(v=>v/255);o.setRGB(p,x,M,"srgb"),l.push(o.r,o.g,o.b)});let u=(h,f)=>Number.isFinite(i[h][1][f]);for(let h=0;h+1<i.length;h++)for(let f=0;f<s;f++){let _=(f+1)%s;if(![u(h,f),u(h,_),u(h+1,f),u(h+1,_)].every(Boolean))continue;let[y,m]=[h*s+f,h*s+_];c.push(y,m,y+s,m,m+s,y+s)}let d=new Bn;return d.setAttribute("position",new pn(a,3)),d.setAttribute("color",new pn(l,3)),d.setIndex(c),d.computeVertexNormals(),new qn(d,new Ns({vertexColors:!0,side:li}))}var r0=n=>n.depth_m.subarray((n.radius_m.length-1)*n.angle_rad.length),o0=n=>Math.min(0,...r0(n).filter(Number.isFinite));function e1(n,t){let[,e]=qi(n),i=n.angle_rad.length,s=r0(n),r=o0(n)*t-.02*e,[o,a]=[[],[]];s.forEach((c,u)=>{let d=n.angle_rad[u];o.push(...lu(e,d,r)),o.push(...lu(e,d,(Number.isFinite(c)?c:0)*t));let[h,f]=[2*u,2*((u+1)%i)];a.push(h,h+1,f,f,h+1,f+1)});let l=new Bn;return l.setAttribute("position",new pn(o,3)),l.setIndex(a),l.computeVertexNormals(),new qn(l,new Ns({color:Ee("rock"),side:hs}))}function n1(n,t){let{values:e,step:i}=Rn(0,qt(1.4*n,"diameter"),3),s=zn(e.at(-1),"diameter"),r=1.12*n,[o,a]=[-s/2,s/2],l=.025*n,c=[o,0,r,a,0,r];for(let f of[o,a])c.push(f,0,r-l,f,0,r+l);let u=new Bn;u.setAttribute("position",new pn(c,3));let d=.075*n,h=`${mn(e.at(-1),i)} ${re("diameter")}`;return[new Pr(u,new ar({color:Ee("text")})),Fr(h,[0,0,r+1.1*d],18),...t===null?[]:[Fr("high side",[0,1.2*d-t,-n],18)]]}var hu=(n,t,...e)=>W("section",{id:n},W("h2",{},t),e);function a0(n,t,e){let{element:i,file:s,there:r}=Jl(e,"No point was finished.");return hu(n,[t,Mn(t,{svg:r()?s:null})],i)}function l0(n){let{bottoms:t}=n,e=t.length-1,i=t.length?cu(()=>t[e].bottom,!1):null,s=W("div",{class:"tools noprint"}),r=W("p",{class:"note"}),o=({weight_N:h,rotary_rad_per_s:f})=>`${Te(h,"force",3)} at ${Te(f,"rotary speed",3)}`,a=()=>{let h=t.map((f,_)=>[String(_),o(f)]);s.replaceChildren(Fl("Point: ",h,String(e),f=>{e=Number(f),l(),i.redraw()})),l()},l=()=>r.textContent=`After ${o(t[e])}.`,[c,...u]=n.page_tables,d=document.getElementById("page");d.append(uo(n.title,lo(n),()=>i?.redraw()),...n.message?[W("p",{class:"warning"},n.message)]:[],a0("drill-off","Drill-off","drill-off"),a0("energy","Specific energy","specific-energy")),i&&(a(),we("units",a),d.append(hu("bottom","Bottom of the hole",s,i.element,r))),d.append(hu("points",["Points",ao(c)],rs(c)),...u.length?[hu("inputs","Inputs, defaults included",u.map(rs))]:[],W("footer",{},W("p",{},`Made by ${n.program}. The tables beside this file hold every digit.`),ho())),d.querySelector("header").after(co([...d.querySelectorAll("section:has(h2)")]).element),i?.redraw()}function c0(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function i1(n){if(n.f32!==void 0)return new Float32Array(c0(n.f32));let[t,e,i]=n.i16,s=new Int16Array(c0(t)),r=new Float32Array(s.length);for(let o=0;o<s.length;o++)r[o]=s[o]===-32768?NaN:e+i*s[o];return r}function Sf(n){return Array.isArray(n)?n.map(Sf):n===null||typeof n!="object"?n:typeof n.f32=="string"||Array.isArray(n.i16)?i1(n):Object.fromEntries(Object.entries(n).map(([t,e])=>[t,Sf(e)]))}function h0(){return Sf(JSON.parse(document.getElementById("report").textContent))}var s1="uplot",r1="u-hz",o1="u-vt",a1="u-title",l1="u-wrap",c1="u-under",h1="u-over",u1="u-axis",kr="u-off",d1="u-select",f1="u-cursor-x",p1="u-cursor-y",m1="u-cursor-pt",g1="u-legend",_1="u-live",x1="u-inline",y1="u-series",v1="u-marker",u0="u-label",M1="u-value",xl="width",yl="height";var d0="bottom",Zo="left",bf="right",zf="#000",f0=zf+"0",wf="mousemove",p0="mousedown",Tf="mouseup",m0="mouseenter",g0="mouseleave",_0="dblclick",S1="resize",b1="scroll",x0="change",mu="dppxchange",Vf="--",na=typeof window<"u",Pf=na?document:null,Ko=na?window:null,w1=na?navigator:null,De,uu;function If(){let n=devicePixelRatio;De!=n&&(De=n,uu&&Df(x0,uu,If),uu=matchMedia(`(min-resolution: ${De-.001}dppx) and (max-resolution: ${De+.001}dppx)`),zr(x0,uu,If),Ko.dispatchEvent(new CustomEvent(mu)))}function Si(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Lf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function je(n,t,e){n.style[t]=e+"px"}function Yi(n,t,e,i){let s=Pf.createElement(n);return t!=null&&Si(s,t),e?.insertBefore(s,i),s}function Ii(n,t){return Yi("div",n,t)}var y0=new WeakMap;function ps(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=y0.get(n);r!=o&&(n.style.transform=r,y0.set(n,r),t<0||e<0||t>i||e>s?Si(n,kr):Lf(n,kr))}var v0=new WeakMap;function M0(n,t,e){let i=t+e,s=v0.get(n);i!=s&&(v0.set(n,i),n.style.background=t,n.style.borderColor=e)}var S0=new WeakMap;function b0(n,t,e,i){let s=t+""+e,r=S0.get(n);s!=r&&(S0.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Gf={passive:!0},T1={...Gf,capture:!0};function zr(n,t,e,i){t.addEventListener(n,e,i?T1:Gf)}function Df(n,t,e,i){t.removeEventListener(n,e,Gf)}na&&If();function Zi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:bi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function K0(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var j0=n=>n!=null,Q0=n=>n!=null&&n>0,xu=K0(j0),E1=K0(Q0);function A1(n,t,e,i=0,s=!1){let r=s?E1:xu,o=s?Q0:j0;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ge,l??-Ge]}function yu(n,t,e,i){let s=E0(n),r=E0(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Bs:t_,a=s==1?bi:Li,l=r==1?Li:bi,c=a(o(In(n))),u=l(o(In(t))),d=jo(e,c),h=jo(e,u);return e==10&&(c<0&&(d=He(d,-c)),u<0&&(h=He(h,-u))),i||e==2?(n=d*s,t=h*r):(n=s_(n,d),t=vu(t,h)),[n,t]}function Hf(n,t,e,i){let s=yu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Wf=.1,w0={mode:3,pad:Wf},Ml={pad:0,soft:null,mode:0},R1={min:Ml,max:Ml};function gu(n,t,e,i){return Mu(e)?T0(n,t,e):(Ml.pad=e,Ml.soft=i?0:null,Ml.mode=i?3:0,T0(n,t,R1))}function Re(n,t){return n??t}function C1(n,t,e){for(t=Re(t,0),e=Re(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function T0(n,t,e){let i=e.min,s=e.max,r=Re(i.pad,0),o=Re(s.pad,0),a=Re(i.hard,-Ge),l=Re(s.hard,Ge),c=Re(i.soft,Ge),u=Re(s.soft,-Ge),d=Re(i.mode,0),h=Re(s.mode,0),f=t-n,_=Bs(f),y=ai(In(n),In(t)),m=Bs(y),p=In(m-_);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,d==2&&c!=Ge&&(r=0),h==2&&u!=-Ge&&(o=0)));let x=f||y||1e3,M=Bs(x),v=jo(10,bi(M)),T=x*(f==0?n==0?.1:1:r),w=He(s_(n-T,v/10),24),g=n>=c&&(d==1||d==3&&w<=c||d==2&&w>=c)?c:Ge,b=ai(a,w<g&&n>=g?g:Ji(g,w)),P=x*(f==0?t==0?.1:1:o),I=He(vu(t+P,v/10),24),C=t<=u&&(h==1||h==3&&I>=u||h==2&&I<=u)?u:-Ge,U=Ji(l,I>C&&t<=C?C:ai(C,I));return b==U&&b==0&&(U=100),[b,U]}var P1=new Intl.NumberFormat(na?w1.language:"en-US"),Xf=n=>P1.format(n),wi=Math,pu=wi.PI,In=wi.abs,bi=wi.floor,Pn=wi.round,Li=wi.ceil,Ji=wi.min,ai=wi.max,jo=wi.pow,E0=wi.sign,Bs=wi.log10,t_=wi.log2,I1=(n,t=1)=>wi.sinh(n)*t,Ef=(n,t=1)=>wi.asinh(n/t),Ge=1/0;function A0(n){return(Bs((n^n>>31)-(n>>31))|0)+1}function Nf(n,t,e){return Ji(ai(n,t),e)}function e_(n){return typeof n=="function"}function be(n){return e_(n)?n:()=>n}var L1=()=>{},n_=n=>n,i_=(n,t)=>t,D1=n=>null,R0=n=>!0,C0=(n,t)=>n==t,N1=/\.\d*?(?=9{6,}|0{6,})/gm,Vr=n=>{if(o_(n)||gr.has(n))return n;let t=`${n}`,e=t.match(N1);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Vr(s)}e${r}`}return He(n,i)};function Or(n,t){return Vr(He(Vr(n/t))*t)}function vu(n,t){return Vr(Li(Vr(n/t))*t)}function s_(n,t){return Vr(bi(Vr(n/t))*t)}function He(n,t=0){if(o_(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Pn(i)/e}var gr=new Map;function r_(n){return((""+n).split(".")[1]||"").length}function bl(n,t,e,i){let s=[],r=i.map(r_);for(let o=t;o<e;o++){let a=In(o),l=He(jo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:He(u,d);s.push(h),gr.set(h,d)}}return s}var Sl={},$f=[],Qo=[null,null],mr=Array.isArray,o_=Number.isInteger,U1=n=>n===void 0;function P0(n){return typeof n=="string"}function Mu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function F1(n){return n!=null&&typeof n=="object"}var O1=Object.getPrototypeOf(Uint8Array),a_="__proto__";function ta(n,t=Mu){let e;if(mr(n)){let i=n.find(s=>s!=null);if(mr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=ta(n[s],t)}else e=n.slice()}else if(n instanceof O1)e=n.slice();else if(t(n)){e={};for(let i in n)i!=a_&&(e[i]=ta(n[i],t))}else e=n;return e}function bn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=a_&&(Mu(n[s])?bn(n[s],ta(i[s])):n[s]=ta(i[s]))}return n}var B1=0,k1=1,z1=2;function V1(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function G1(n,t){if(X1(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return $1(o[0])||(o=W1(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=t?t[o][c]:k1,f=[];for(let _=0;_<u.length;_++){let y=u[_],m=r.get(l[_]);y===null?h!=B1&&(d[m]=y,h==z1&&f.push(m)):d[m]=y}V1(d,f,s),i.push(d)}}return i}var H1=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function W1(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function X1(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function $1(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ai(1,bi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var l_=["January","February","March","April","May","June","July","August","September","October","November","December"],c_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function h_(n){return n.slice(0,3)}var q1=c_.map(h_),Y1=l_.map(h_),Z1={MMMM:l_,MMM:Y1,WWWW:c_,WWW:q1};function _l(n){return(n<10?"0":"")+n}function J1(n){return(n<10?"00":n<100?"0":"")+n}var K1={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>_l(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>_l(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>_l(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>_l(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>_l(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>J1(n.getMilliseconds())};function qf(n,t){t=t||Z1;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?K1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var j1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Q1(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==j1?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var u_=n=>n%1==0,_u=[1,2,2.5,5],tT=bl(10,-32,0,_u),d_=bl(10,0,32,_u),eT=d_.filter(u_),Br=tT.concat(d_),Yf=`
`,f_="{YYYY}",I0=Yf+f_,p_="{M}/{D}",vl=Yf+p_,du=vl+"/{YY}",m_="{aa}",nT="{h}:{mm}",Jo=nT+m_,L0=Yf+Jo,D0=":{ss}",Ue=null;function g_(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?bl(10,0,3,_u).filter(u_):bl(10,-3,0,_u)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,f_,Ue,Ue,Ue,Ue,Ue,Ue,1],[s*28,"{MMM}",I0,Ue,Ue,Ue,Ue,Ue,1],[s,p_,I0,Ue,Ue,Ue,Ue,Ue,1],[i,"{h}"+m_,du,Ue,vl,Ue,Ue,Ue,1],[e,Jo,du,Ue,vl,Ue,Ue,Ue,1],[t,D0,du+" "+Jo,Ue,vl+" "+Jo,Ue,L0,Ue,1],[n,D0+".{fff}",du+" "+Jo,Ue,vl+" "+Jo,Ue,L0,Ue,1]];function u(d){return(h,f,_,y,m,p)=>{let x=[],M=m>=o,v=m>=r&&m<o,T=d(_),w=He(T*n,3),g=Af(T.getFullYear(),M?0:T.getMonth(),v||M?1:T.getDate()),b=He(g*n,3);if(v||M){let P=v?m/r:0,I=M?m/o:0,C=w==b?w:He(Af(g.getFullYear()+I,g.getMonth()+P,1)*n,3),U=new Date(Pn(C/n)),O=U.getFullYear(),L=U.getMonth();for(let B=0;C<=y;B++){let $=Af(O+I*B,L+P*B,1),V=$-d(He($*n,3));C=He((+$+V)*n,3),C<=y&&x.push(C)}}else{let P=m>=s?s:m,I=bi(_)-bi(w),C=b+I+vu(w-b,P);x.push(C);let U=d(C),O=U.getHours()+U.getMinutes()/e+U.getSeconds()/i,L=m/i,B=h.axes[f]._space,$=p/B;for(;C=He(C+m,n==1?0:3),!(C>y);)if(L>1){let V=bi(He(O+L,6))%24,Y=d(C).getHours()-V;Y>1&&(Y=-1),C-=Y*i,O=(O+L)%24;let et=x[x.length-1];He((C-et)/m,3)*$>=.7&&x.push(C)}else x.push(C)}return x}}return[l,c,u]}var[iT,sT,rT]=g_(1),[oT,aT,lT]=g_(.001);bl(2,-53,53,[1]);function N0(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function U0(n,t){return(e,i,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,c,u,d,h,f;return i.map(_=>{let y=n(_),m=y.getFullYear(),p=y.getMonth(),x=y.getDate(),M=y.getHours(),v=y.getMinutes(),T=y.getSeconds(),w=m!=l&&a[2]||p!=c&&a[3]||x!=u&&a[4]||M!=d&&a[5]||v!=h&&a[6]||T!=f&&a[7]||a[1];return l=m,c=p,u=x,d=M,h=v,f=T,w(y)})}}function cT(n,t){let e=qf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Af(n,t,e){return new Date(n,t,e)}function F0(n,t){return t(n)}var hT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function O0(n,t){return(e,i,s,r)=>r==null?Vf:t(n(i))}function uT(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function dT(n,t){return n.series[t].fill(n,t)}var fT={show:!0,live:!0,isolate:!1,mount:L1,markers:{show:!0,width:2,stroke:uT,fill:dT,dash:"solid"},idx:null,idxs:null,values:[]};function pT(n,t){let e=n.cursor.points,i=Ii(),s=e.size(n,t);je(i,xl,s),je(i,yl,s);let r=s/-2;je(i,"marginLeft",r),je(i,"marginTop",r);let o=e.width(n,t,s);return o&&je(i,"borderWidth",o),i}function mT(n,t){let e=n.series[t].points;return e._fill||e._stroke}function gT(n,t){let e=n.series[t].points;return e._stroke||e._fill}function _T(n,t){return n.series[t].points.size}var Rf=[0,0];function xT(n,t,e){return Rf[0]=t,Rf[1]=e,Rf}function fu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Cf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var yT={show:!0,x:!0,y:!0,lock:!1,move:xT,points:{one:!1,show:pT,size:_T,width:0,stroke:gT,fill:mT},bind:{mousedown:fu,mouseup:fu,click:fu,dblclick:fu,mousemove:Cf,mouseleave:Cf,mouseenter:Cf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},__={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Zf=bn({},__,{filter:i_}),x_=bn({},Zf,{size:10}),y_=bn({},__,{show:!1}),Jf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',v_="bold "+Jf,M_=1.5,B0={show:!0,scale:"x",stroke:zf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:v_,side:2,grid:Zf,ticks:x_,border:y_,font:Jf,lineGap:M_,rotate:0},vT="Value",MT="Time",k0={show:!0,scale:"x",auto:!1,sorted:1,min:Ge,max:-Ge,idxs:[]};function ST(n,t,e,i,s){return t.map(r=>r==null?"":Xf(r))}function bT(n,t,e,i,s,r,o){let a=[],l=gr.get(s)||0;e=o?e:He(vu(e,s),l);for(let c=e;c<=i;c=He(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Uf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Bs:t_,u=bi(c(e));s=jo(l,u),l==10&&(s=Br[Zi(s,Br)]);let d=e,h=s*l;l==10&&(h=Br[Zi(h,Br)]);do a.push(d),d=d+s,l==10&&!gr.has(d)&&(d=He(d,gr.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Br[Zi(h,Br)]));while(d<=i);return a}function wT(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Uf(n,t,ai(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Uf(n,t,ai(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var S_=/./,TT=/[12357]/,ET=/[125]/,z0=/1/,Ff=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function AT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?S_:l(7,o)-u>=c?TT:l(5,o)-u>=c?ET:z0;if(d==z0){let h=In(l(1,o)-u);if(h<c)return Ff(t.slice().reverse(),a.distr,d,Li(c/h)).reverse()}return Ff(t,a.distr,d,1)}function RT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=In(l(1,o)-l(2,o));return c<a?Ff(t.slice().reverse(),3,S_,Li(a/c)).reverse():t}function CT(n,t,e,i){return i==null?Vf:t==null?"":Xf(t)}var V0={show:!0,scale:"y",stroke:zf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:v_,side:3,grid:Zf,ticks:x_,border:y_,font:Jf,lineGap:M_,rotate:0};function PT(n,t){let e=3+(n||1)*2;return He(e*t,3)}function IT(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=In(o-r),l=n.series[t],c=a/(l.points.space*De);return i[1]-i[0]<=c}var G0={scale:null,auto:!0,sorted:0,min:Ge,max:-Ge},b_=(n,t,e,i,s)=>s,H0={show:!0,auto:!0,sorted:0,gaps:b_,alpha:1,facets:[bn({},G0,{scale:"x"}),bn({},G0,{scale:"y"})]},W0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:b_,alpha:1,points:{show:IT,filter:null},values:null,min:Ge,max:-Ge,idxs:[],path:null,clip:null};function LT(n,t,e,i,s){return e/10}var w_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},DT=bn({},w_,{time:!1,ori:1}),X0={};function T_(n,t){let e=X0[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(X0[n]=e)),e}var ea=1,Of=2;function Gr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,_=a.width,y=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,d,m,p,h,f,_,y,bu,ia,Tu,A_,C_):e(s,l,c,u,d,p,m,f,h,y,_,wu,sa,Qf,R_,P_)}function Kf(n,t){let e=0,i=0,s=Re(n.bands,$f);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function NT(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ks(n,t,e,i,s,r){return Gr(n,t,(o,a,l,c,u,d,h,f,_,y,m)=>{let p=o.pxRound,x=c.dir*(c.ori==0?1:-1),M=c.ori==0?ia:sa,v,T;x==1?(v=e,T=i):(v=i,T=e);let w=p(d(a[v],c,y,f)),g=p(h(l[v],u,m,_)),b=p(d(a[T],c,y,f)),P=p(h(r==1?u.max:u.min,u,m,_)),I=new Path2D(s);return M(I,b,P),M(I,w,P),M(I,w,g),I})}function Su(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Tu:Qf,l=e;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function UT(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function jf(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let f=r(n[d]),_=h==d?f:r(n[h]),y=d-s;f=o<=0&&y>=0&&y<l?r(n[y]):f;let p=h+s;_=o>=0&&p>=0&&p<l?r(n[p]):_,_>=f&&a.push([f,_])}return a}function $0(n){return n==0?n_:n==1?Pn:t=>Or(t,n)}function E_(n){let t=n==0?bu:wu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ji(c,a/2,l/2),u=Ji(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var bu=(n,t,e)=>{n.moveTo(t,e)},wu=(n,t,e)=>{n.moveTo(e,t)},ia=(n,t,e)=>{n.lineTo(t,e)},sa=(n,t,e)=>{n.lineTo(e,t)},Tu=E_(0),Qf=E_(1),A_=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},R_=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},C_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},P_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function I_(n){return(t,e,i,s,r)=>Gr(t,e,(o,a,l,c,u,d,h,f,_,y,m)=>{let{pxRound:p,points:x}=o,M,v;c.ori==0?(M=bu,v=A_):(M=wu,v=R_);let T=He(x.width*De,3),w=(x.size-x.width)/2*De,g=He(w*2,3),b=new Path2D,P=new Path2D,{left:I,top:C,width:U,height:O}=t.bbox;Tu(P,I-g,C-g,U+g*2,O+g*2);let L=B=>{if(l[B]!=null){let $=p(d(a[B],c,y,f)),V=p(h(l[B],u,m,_));M(b,$+w,V),v(b,$,V,w,0,pu*2)}};if(r)r.forEach(L);else for(let B=i;B<=s;B++)L(B);return{stroke:T>0?b:null,fill:b,clip:P,flags:ea|Of}})}function L_(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var FT=L_(ia),OT=L_(sa);function D_(n){let t=Re(n?.alignGaps,0);return(e,i,s,r)=>Gr(e,i,(o,a,l,c,u,d,h,f,_,y,m)=>{[s,r]=xu(l,s,r);let p=o.pxRound,x=O=>p(d(O,c,y,f)),M=O=>p(h(O,u,m,_)),v,T;c.ori==0?(v=ia,T=FT):(v=sa,T=OT);let w=c.dir*(c.ori==0?1:-1),g={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ea},b=g.stroke,P=!1;if(r-s>=y*4){let O=rt=>e.posToVal(rt,c.key,!0),L=null,B=null,$,V,J,G=x(a[w==1?s:r]),Y=x(a[s]),et=x(a[r]),lt=O(w==1?Y+1:et-1);for(let rt=w==1?s:r;rt>=s&&rt<=r;rt+=w){let K=a[rt],pt=(w==1?K<lt:K>lt)?G:x(K),yt=l[rt];pt==G?yt!=null?(V=yt,L==null?(v(b,pt,M(V)),$=L=B=V):V<L?L=V:V>B&&(B=V)):yt===null&&(P=!0):(L!=null&&T(b,G,M(L),M(B),M($),M(V)),yt!=null?(V=yt,v(b,pt,M(V)),L=B=$=V):(L=B=null,yt===null&&(P=!0)),G=pt,lt=O(G+w))}L!=null&&L!=B&&J!=G&&T(b,G,M(L),M(B),M($),M(V))}else for(let O=w==1?s:r;O>=s&&O<=r;O+=w){let L=l[O];L===null?P=!0:L!=null&&v(b,x(a[O]),M(L))}let[C,U]=Kf(e,i);if(o.fill!=null||C!=0){let O=g.fill=new Path2D(b),L=o.fillTo(e,i,o.min,o.max,C),B=M(L),$=x(a[s]),V=x(a[r]);w==-1&&([V,$]=[$,V]),v(O,V,B),v(O,$,B)}if(!o.spanGaps){let O=[];P&&O.push(...jf(a,l,s,r,w,x,t)),g.gaps=O=o.gaps(e,i,s,r,O),g.clip=Su(O,c.ori,f,_,y,m)}return U!=0&&(g.band=U==2?[ks(e,i,s,r,b,-1),ks(e,i,s,r,b,1)]:ks(e,i,s,r,b,U)),g})}function BT(n){let t=Re(n.align,1),e=Re(n.ascDesc,!1),i=Re(n.alignGaps,0),s=Re(n.extend,!1);return(r,o,a,l)=>Gr(r,o,(c,u,d,h,f,_,y,m,p,x,M)=>{[a,l]=xu(d,a,l);let v=c.pxRound,{left:T,width:w}=r.bbox,g=Y=>v(_(Y,h,x,m)),b=Y=>v(y(Y,f,M,p)),P=h.ori==0?ia:sa,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ea},C=I.stroke,U=h.dir*(h.ori==0?1:-1),O=b(d[U==1?a:l]),L=g(u[U==1?a:l]),B=L,$=L;s&&t==-1&&($=T,P(C,$,O)),P(C,L,O);for(let Y=U==1?a:l;Y>=a&&Y<=l;Y+=U){let et=d[Y];if(et==null)continue;let lt=g(u[Y]),rt=b(et);t==1?P(C,lt,O):P(C,B,rt),P(C,lt,rt),O=rt,B=lt}let V=B;s&&t==1&&(V=T+w,P(C,V,O));let[J,G]=Kf(r,o);if(c.fill!=null||J!=0){let Y=I.fill=new Path2D(C),et=c.fillTo(r,o,c.min,c.max,J),lt=b(et);P(Y,V,lt),P(Y,$,lt)}if(!c.spanGaps){let Y=[];Y.push(...jf(u,d,a,l,U,g,i));let et=c.width*De/2,lt=e||t==1?et:-et,rt=e||t==-1?-et:et;Y.forEach(K=>{K[0]+=lt,K[1]+=rt}),I.gaps=Y=c.gaps(r,o,a,l,Y),I.clip=Su(Y,h.ori,m,p,x,M)}return G!=0&&(I.band=G==2?[ks(r,o,a,l,C,-1),ks(r,o,a,l,C,1)]:ks(r,o,a,l,C,G)),I})}function q0(n,t,e,i,s,r,o=Ge){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=In(n[l]-n[a]);u<c&&(c=u,o=In(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function kT(n){n=n||Sl;let t=Re(n.size,[.6,Ge,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Re(t[1],Ge),l=Re(t[2],1),c=Re(n.disp,Sl),u=Re(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,_,y,m)=>Gr(f,_,(p,x,M,v,T,w,g,b,P,I,C)=>{let U=p.pxRound,O=e,L=i*De,B=a*De,$=l*De,V,J;v.ori==0?[V,J]=r(f,_):[J,V]=r(f,_);let G=v.dir*(v.ori==0?1:-1),Y=v.ori==0?Tu:Qf,et=v.ori==0?u:(Rt,Yt,ie,wt,Ve,Ht,Jt)=>{u(Rt,Yt,ie,Ve,wt,Jt,Ht)},lt=Re(f.bands,$f).find(Rt=>Rt.series[0]==_),rt=lt!=null?lt.dir:0,K=p.fillTo(f,_,p.min,p.max,rt),ut=U(g(K,T,C,P)),pt,yt,_t,Wt=I,oe=U(p.width*De),Ot=!1,ce=null,ue=null,ne=null,We=null;d!=null&&(oe==0||h!=null)&&(Ot=!0,ce=d.values(f,_,y,m),ue=new Map,new Set(ce).forEach(Rt=>{Rt!=null&&ue.set(Rt,new Path2D)}),oe>0&&(ne=h.values(f,_,y,m),We=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&We.set(Rt,new Path2D)})));let{x0:he,size:Ce}=c;if(he!=null&&Ce!=null){O=1,x=he.values(f,_,y,m),he.unit==2&&(x=x.map(ie=>f.posToVal(b+ie*I,v.key,!0)));let Rt=Ce.values(f,_,y,m);Ce.unit==2?yt=Rt[0]*I:yt=w(Rt[0],v,I,b)-w(0,v,I,b),Wt=q0(x,M,w,v,I,b,Wt),_t=Wt-yt+L}else Wt=q0(x,M,w,v,I,b,Wt),_t=Wt*o+L,yt=Wt-_t;_t<1&&(_t=0),oe>=yt/2&&(oe=0),_t<5&&(U=n_);let Pe=_t>0,gn=Wt-_t-(Pe?oe:0);yt=U(Nf(gn,$,B)),pt=(O==0?yt/2:O==G?0:yt)-O*G*((O==0?L/2:0)+(Pe?oe/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},hn=Ot?null:new Path2D,Qe=null;if(lt!=null)Qe=f.data[lt.series[1]];else{let{y0:Rt,y1:Yt}=c;Rt!=null&&Yt!=null&&(M=Yt.values(f,_,y,m),Qe=Rt.values(f,_,y,m))}let sn=V*yt,k=J*yt;for(let Rt=G==1?y:m;Rt>=y&&Rt<=m;Rt+=G){let Yt=M[Rt];if(Yt==null)continue;if(Qe!=null){let Z=Qe[Rt]??0;if(Yt-Z==0)continue;ut=g(Z,T,C,P)}let ie=v.distr!=2||c!=null?x[Rt]:Rt,wt=w(ie,v,I,b),Ve=g(Re(Yt,K),T,C,P),Ht=U(wt-pt),Jt=U(ai(Ve,ut)),D=U(Ji(Ve,ut)),E=Jt-D;if(Yt!=null){let Z=Yt<0?k:sn,ft=Yt<0?sn:k;Ot?(oe>0&&ne[Rt]!=null&&Y(We.get(ne[Rt]),Ht,D+bi(oe/2),yt,ai(0,E-oe),Z,ft),ce[Rt]!=null&&Y(ue.get(ce[Rt]),Ht,D+bi(oe/2),yt,ai(0,E-oe),Z,ft)):Y(hn,Ht,D+bi(oe/2),yt,ai(0,E-oe),Z,ft),et(f,_,Rt,Ht-oe/2,D,yt+oe,E)}}return oe>0?ve.stroke=Ot?We:hn:Ot||(ve._fill=p.width==0?p._fill:p._stroke??p._fill,ve.width=0),ve.fill=Ot?ue:hn,ve})}function zT(n,t){let e=Re(t?.alignGaps,0);return(i,s,r,o)=>Gr(i,s,(a,l,c,u,d,h,f,_,y,m,p)=>{[r,o]=xu(c,r,o);let x=a.pxRound,M=V=>x(h(V,u,m,_)),v=V=>x(f(V,d,p,y)),T,w,g;u.ori==0?(T=bu,g=ia,w=C_):(T=wu,g=sa,w=P_);let b=u.dir*(u.ori==0?1:-1),P=M(l[b==1?r:o]),I=P,C=[],U=[];for(let V=b==1?r:o;V>=r&&V<=o;V+=b)if(c[V]!=null){let G=l[V],Y=M(G);C.push(I=Y),U.push(v(c[V]))}let O={stroke:n(C,U,T,g,w,x),fill:null,clip:null,band:null,gaps:null,flags:ea},L=O.stroke,[B,$]=Kf(i,s);if(a.fill!=null||B!=0){let V=O.fill=new Path2D(L),J=a.fillTo(i,s,a.min,a.max,B),G=v(J);g(V,I,G),g(V,P,G)}if(!a.spanGaps){let V=[];V.push(...jf(l,c,r,o,b,M,e)),O.gaps=V=a.gaps(i,s,r,o,V),O.clip=Su(V,u.ori,_,y,m,p)}return $!=0&&(O.band=$==2?[ks(i,s,r,o,L,-1),ks(i,s,r,o,L,1)]:ks(i,s,r,o,L,$)),O})}function VT(n){return zT(GT,n)}function GT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,t[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,t[h+1]-l[h+1]*d[h]/3,n[h+1],t[h+1])}return a}var Bf=new Set;function Y0(){for(let n of Bf)n.syncRect(!0)}na&&(zr(S1,Ko,Y0),zr(b1,Ko,Y0,!0),zr(mu,Ko,()=>{cn.pxRatio=De}));var HT=D_(),WT=I_();function Z0(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>kf(r,o,t,e))}function XT(n,t){return n.map((e,i)=>i==0?{}:bn({},t,e))}function kf(n,t,e,i){return bn({},t==0?e:i,n)}function N_(n,t,e){return t==null?Qo:[t,e]}var $T=N_;function qT(n,t,e){return t==null?Qo:gu(t,e,Wf,!0)}function U_(n,t,e,i){return t==null?Qo:yu(t,e,n.scales[i].log,!1)}var YT=U_;function F_(n,t,e,i){return t==null?Qo:Hf(t,e,n.scales[i].log,!1)}var ZT=F_;function JT(n,t,e,i,s){let r=ai(A0(n),A0(t)),o=t-n,a=Zi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?gr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function J0(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Pn((e=+s)*De))+"px"),[n,t,e]}function KT(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=He(t[2]*De,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function cn(n,t,e){let i={mode:Re(n.mode,1)},s=i.mode;function r(S,A,N,F){let X=A.valToPct(S);return F+N*(A.dir==-1?1-X:X)}function o(S,A,N,F){let X=A.valToPct(S);return F+N*(A.dir==-1?X:1-X)}function a(S,A,N,F){return A.ori==0?r(S,A,N,F):o(S,A,N,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ii(s1);if(n.id!=null&&(c.id=n.id),Si(c,n.class),n.title){let S=Ii(a1,c);S.textContent=n.title}let u=Yi("canvas"),d=i.ctx=u.getContext("2d"),h=Ii(l1,c);zr("click",h,S=>{S.target===_&&(qe!=Qr||tn!=to)&&kn.click(i,S)},!0);let f=i.under=Ii(c1,h);h.appendChild(u);let _=i.over=Ii(h1,h);n=ta(n);let y=+Re(n.pxAlign,1),m=$0(y);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let p=n.ms||.001,x=i.series=s==1?Z0(n.series||[],k0,W0,!1):XT(n.series||[null],H0),M=i.axes=Z0(n.axes||[],B0,V0,!0),v=i.scales={},T=i.bands=n.bands||[];T.forEach(S=>{S.fill=be(S.fill||null),S.dir=Re(S.dir,-1)});let w=s==2?x[1].facets[0].scale:x[0].scale,g={axes:xs,series:_e},b=(n.drawOrder||["axes","series"]).map(S=>g[S]);function P(S){let A=S.distr==3?N=>Bs(N>0?N:S.clamp(i,N,S.min,S.max,S.key)):S.distr==4?N=>Ef(N,S.asinh):S.distr==100?N=>S.fwd(N):N=>N;return N=>{let F=A(N),{_min:X,_max:tt}=S,ht=tt-X;return(F-X)/ht}}function I(S){let A=v[S];if(A==null){let N=(n.scales||Sl)[S]||Sl;if(N.from!=null){I(N.from);let F=bn({},v[N.from],N,{key:S});F.valToPct=P(F),v[S]=F}else{A=v[S]=bn({},S==w?w_:DT,N),A.key=S;let F=A.time,X=A.range,tt=mr(X);if((S!=w||s==2&&!F)&&(tt&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?w0:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?w0:{mode:1,hard:X[1],soft:X[1]}},tt=!1),!tt&&Mu(X))){let ht=X;X=(mt,St,Ut)=>St==null?Qo:gu(St,Ut,ht)}A.range=be(X||(F?$T:S==w?A.distr==3?YT:A.distr==4?ZT:N_:A.distr==3?U_:A.distr==4?F_:qT)),A.auto=be(tt?!1:A.auto),A.clamp=be(A.clamp||LT),A._min=A._max=null,A.valToPct=P(A)}}}I("x"),I("y"),s==1&&x.forEach(S=>{I(S.scale)}),M.forEach(S=>{I(S.scale)});for(let S in n.scales)I(S);let C=v[w],U=C.distr,O,L;C.ori==0?(Si(c,r1),O=r,L=o):(Si(c,o1),O=o,L=r);let B={};for(let S in v){let A=v[S];(A.min!=null||A.max!=null)&&(B[S]={min:A.min,max:A.max},A.min=A.max=null)}let $=n.tzDate||(S=>new Date(Pn(S/p))),V=n.fmtDate||qf,J=p==1?rT($):lT($),G=U0($,N0(p==1?sT:aT,V)),Y=O0($,F0(hT,V)),et=[],lt=i.legend=bn({},fT,n.legend),rt=i.cursor=bn({},yT,{drag:{y:s==2}},n.cursor),K=lt.show,ut=rt.show,pt=lt.markers;lt.idxs=et,pt.width=be(pt.width),pt.dash=be(pt.dash),pt.stroke=be(pt.stroke),pt.fill=be(pt.fill);let yt,_t,Wt,oe=[],Ot=[],ce,ue=!1,ne={};if(lt.live){let S=x[1]?x[1].values:null;ue=S!=null,ce=ue?S(i,1,0):{_:0};for(let A in ce)ne[A]=Vf}if(K)if(yt=Yi("table",g1,c),Wt=Yi("tbody",null,yt),lt.mount(i,yt),ue){_t=Yi("thead",null,yt,Wt);let S=Yi("tr",null,_t);Yi("th",null,S);for(var We in ce)Yi("th",u0,S).textContent=We}else Si(yt,x1),lt.live&&Si(yt,_1);let he={show:!0},Ce={show:!1};function Pe(S,A){if(A==0&&(ue||!lt.live||s==2))return Qo;let N=[],F=Yi("tr",y1,Wt,Wt.childNodes[A]);Si(F,S.class),S.show||Si(F,kr);let X=Yi("th",null,F);if(pt.show){let mt=Ii(v1,X);if(A>0){let St=pt.width(i,A);St&&(mt.style.border=St+"px "+pt.dash(i,A)+" "+pt.stroke(i,A)),mt.style.background=pt.fill(i,A)}}let tt=Ii(u0,X);S.label instanceof HTMLElement?tt.appendChild(S.label):tt.textContent=S.label,A>0&&(pt.show||(tt.style.color=S.width>0?pt.stroke(i,A):pt.fill(i,A)),ve("click",X,mt=>{if(rt._lock)return;Qt(mt);let St=x.indexOf(S);if((mt.ctrlKey||mt.metaKey)!=lt.isolate){let Ut=x.some((Ft,kt)=>kt>0&&kt!=St&&Ft.show);x.forEach((Ft,kt)=>{kt>0&&ts(kt,Ut?kt==St?he:Ce:he,!0,vn.setSeries)})}else ts(St,{show:!S.show},!0,vn.setSeries)},!1),te&&ve(m0,X,mt=>{rt._lock||(Qt(mt),ts(x.indexOf(S),no,!0,vn.setSeries))},!1));for(var ht in ce){let mt=Yi("td",M1,F);mt.textContent="--",N.push(mt)}return[F,N]}let gn=new Map;function ve(S,A,N,F=!0){let X=gn.get(A)||{},tt=rt.bind[S](i,A,N,F);tt&&(zr(S,A,X[S]=tt),gn.set(A,X))}function hn(S,A,N){let F=gn.get(A)||{};for(let X in F)(S==null||X==S)&&(Df(X,A,F[X]),delete F[X]);S==null&&gn.delete(A)}let Qe=0,sn=0,k=0,Rt=0,Yt=0,ie=0,wt=Yt,Ve=ie,Ht=k,Jt=Rt,D=0,E=0,Z=0,ft=0;i.bbox={};let ct=!1,vt=!1,Mt=!1,it=!1,ot=!1,gt=!1;function z(S,A,N){(N||S!=i.width||A!=i.height)&&at(S,A),pe(!1),Mt=!0,vt=!0,Gn()}function at(S,A){i.width=Qe=k=S,i.height=sn=Rt=A,Yt=ie=0,bt(),Xt();let N=i.bbox;D=N.left=Or(Yt*De,.5),E=N.top=Or(ie*De,.5),Z=N.width=Or(k*De,.5),ft=N.height=Or(Rt*De,.5)}let st=3;function Tt(){let S=!1,A=0;for(;!S;){A++;let N=Jr(A),F=Qi(A);S=A==st||N&&F,S||(at(i.width,i.height),vt=!0)}}function xt({width:S,height:A}){z(S,A)}i.setSize=xt;function bt(){let S=!1,A=!1,N=!1,F=!1;M.forEach((X,tt)=>{if(X.show&&X._show){let{side:ht,_size:mt}=X,St=ht%2,Ut=X.label!=null?X.labelSize:0,Ft=mt+Ut;Ft>0&&(St?(k-=Ft,ht==3?(Yt+=Ft,F=!0):N=!0):(Rt-=Ft,ht==0?(ie+=Ft,S=!0):A=!0))}}),Ki[0]=S,Ki[1]=N,Ki[2]=A,Ki[3]=F,k-=Ui[1]+Ui[3],Yt+=Ui[3],Rt-=Ui[2]+Ui[0],ie+=Ui[0]}function Xt(){let S=Yt+k,A=ie+Rt,N=Yt,F=ie;function X(tt,ht){switch(tt){case 1:return S+=ht,S-ht;case 2:return A+=ht,A-ht;case 3:return N-=ht,N+ht;case 0:return F-=ht,F+ht}}M.forEach((tt,ht)=>{if(tt.show&&tt._show){let mt=tt.side;tt._pos=X(mt,tt._size),tt.label!=null&&(tt._lpos=X(mt,tt.labelSize))}})}if(rt.dataIdx==null){let S=rt.hover,A=S.skip=new Set(S.skip??[]);A.add(void 0);let N=S.prox=be(S.prox),F=S.bias??=0;rt.dataIdx=(X,tt,ht,mt)=>{if(tt==0)return ht;let St=ht,Ut=N(X,tt,ht,mt)??Ge,Ft=Ut>=0&&Ut<Ge,kt=C.ori==0?k:Rt,le=rt.left,Ie=t[0],Ae=t[tt];if(A.has(Ae[ht])){St=null;let ye=null,jt=null,$t;if(F==0||F==-1)for($t=ht;ye==null&&$t-- >0;)A.has(Ae[$t])||(ye=$t);if(F==0||F==1)for($t=ht;jt==null&&$t++<Ae.length;)A.has(Ae[$t])||(jt=$t);if(ye!=null||jt!=null)if(Ft){let Ze=ye==null?-1/0:O(Ie[ye],C,kt,0),an=jt==null?1/0:O(Ie[jt],C,kt,0),Un=le-Ze,ke=an-le;Un<=ke?Un<=Ut&&(St=ye):ke<=Ut&&(St=jt)}else St=jt==null?ye:ye==null?jt:ht-ye<=jt-ht?ye:jt}else Ft&&In(le-O(Ie[ht],C,kt,0))>Ut&&(St=null);return St}}let Qt=S=>{rt.event=S};rt.idxs=et,rt._lock=!1;let dt=rt.points;dt.show=be(dt.show),dt.size=be(dt.size),dt.stroke=be(dt.stroke),dt.width=be(dt.width),dt.fill=be(dt.fill);let zt=i.focus=bn({},n.focus||{alpha:.3},rt.focus),te=zt.prox>=0,Ct=te&&dt.one,de=[],$e=[],Zn=[];function ha(S,A){let N=dt.show(i,A);if(N instanceof HTMLElement)return Si(N,m1),Si(N,S.class),ps(N,-10,-10,k,Rt),_.insertBefore(N,de[A]),N}function qr(S,A){if(s==1||A>0){let N=s==1&&v[S.scale].time,F=S.value;S.value=N?P0(F)?O0($,F0(F,V)):F||Y:F||CT,S.label=S.label||(N?MT:vT)}if(Ct||A>0){S.width=S.width==null?1:S.width,S.paths=S.paths||HT||D1,S.fillTo=be(S.fillTo||NT),S.pxAlign=+Re(S.pxAlign,y),S.pxRound=$0(S.pxAlign),S.stroke=be(S.stroke||null),S.fill=be(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let N=PT(ai(1,S.width),1),F=S.points=bn({},{size:N,width:ai(1,N*.2),stroke:S.stroke,space:N*2,paths:WT,_stroke:null,_fill:null},S.points);F.show=be(F.show),F.filter=be(F.filter),F.fill=be(F.fill),F.stroke=be(F.stroke),F.paths=be(F.paths),F.pxAlign=S.pxAlign}if(K){let N=Pe(S,A);oe.splice(A,0,N[0]),Ot.splice(A,0,N[1]),lt.values.push(null)}if(ut){et.splice(A,0,null);let N=null;Ct?A==0&&(N=ha(S,A)):A>0&&(N=ha(S,A)),de.splice(A,0,N),$e.splice(A,0,0),Zn.splice(A,0,0)}Nn("addSeries",A)}function Iu(S,A){A=A??x.length,S=s==1?kf(S,A,k0,W0):kf(S,A,{},H0),x.splice(A,0,S),qr(x[A],A)}i.addSeries=Iu;function Ll(S){if(x.splice(S,1),K){lt.values.splice(S,1),Ot.splice(S,1);let A=oe.splice(S,1)[0];hn(null,A.firstChild),A.remove()}ut&&(et.splice(S,1),de.splice(S,1)[0].remove(),$e.splice(S,1),Zn.splice(S,1)),Nn("delSeries",S)}i.delSeries=Ll;let Ki=[!1,!1,!1,!1];function ms(S,A){if(S._show=S.show,S.show){let N=S.side%2,F=v[S.scale];F==null&&(S.scale=N?x[1].scale:w,F=v[S.scale]);let X=F.time;S.size=be(S.size),S.space=be(S.space),S.rotate=be(S.rotate),mr(S.incrs)&&S.incrs.forEach(ht=>{!gr.has(ht)&&gr.set(ht,r_(ht))}),S.incrs=be(S.incrs||(F.distr==2?eT:X?p==1?iT:oT:Br)),S.splits=be(S.splits||(X&&F.distr==1?J:F.distr==3?Uf:F.distr==4?wT:bT)),S.stroke=be(S.stroke),S.grid.stroke=be(S.grid.stroke),S.ticks.stroke=be(S.ticks.stroke),S.border.stroke=be(S.border.stroke);let tt=S.values;S.values=mr(tt)&&!mr(tt[0])?be(tt):X?mr(tt)?U0($,N0(tt,V)):P0(tt)?cT($,tt):tt||G:tt||ST,S.filter=be(S.filter||(F.distr>=3&&F.log==10?AT:F.distr==3&&F.log==2?RT:i_)),S.font=J0(S.font),S.labelFont=J0(S.labelFont),S._size=S.size(i,null,A,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Ki[A]=!0,S._el=Ii(u1,h))}}function gs(S,A,N,F){let[X,tt,ht,mt]=N,St=A%2,Ut=0;return St==0&&(mt||tt)&&(Ut=A==0&&!X||A==2&&!ht?Pn(B0.size/3):0),St==1&&(X||ht)&&(Ut=A==1&&!tt||A==3&&!mt?Pn(V0.size/2):0),Ut}let ua=i.padding=(n.padding||[gs,gs,gs,gs]).map(S=>be(Re(S,gs))),Ui=i._padding=ua.map((S,A)=>S(i,A,Ki,0)),rn,un=null,dn=null,ji=s==1?x[0].idxs:null,di=null,$s=!1;function da(S,A){if(t=S??[],i.data=i._data=t,s==2){rn=0;for(let N=1;N<x.length;N++)rn+=t[N][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),di=t[0],rn=di.length;let N=t;if(U==2){N=t.slice();let F=N[0]=Array(rn);for(let X=0;X<rn;X++)F[X]=X}i._data=t=N}if(pe(!0),Nn("setData"),U==2&&(Mt=!0),A!==!1){let N=C;N.auto(i,$s)?fa():Zs(w,N.min,N.max),it=it||rt.left>=0,gt=!0,Gn()}}i.setData=da;function fa(){$s=!0;let S,A;s==1&&(rn>0?(un=ji[0]=0,dn=ji[1]=rn-1,S=t[0][un],A=t[0][dn],U==2?(S=un,A=dn):S==A&&(U==3?[S,A]=yu(S,S,C.log,!1):U==4?[S,A]=Hf(S,S,C.log,!1):C.time?A=S+Pn(86400/p):[S,A]=gu(S,A,Wf,!0))):(un=ji[0]=S=null,dn=ji[1]=A=null)),Zs(w,S,A)}let Yr,qs,Zr,R,H,nt,j,Q,Et,It;function At(S,A,N,F,X,tt){S??=f0,N??=$f,F??="butt",X??=f0,tt??="round",S!=Yr&&(d.strokeStyle=Yr=S),X!=qs&&(d.fillStyle=qs=X),A!=Zr&&(d.lineWidth=Zr=A),tt!=H&&(d.lineJoin=H=tt),F!=nt&&(d.lineCap=nt=F),N!=R&&d.setLineDash(R=N)}function Lt(S,A,N,F){A!=qs&&(d.fillStyle=qs=A),S!=j&&(d.font=j=S),N!=Q&&(d.textAlign=Q=N),F!=Et&&(d.textBaseline=Et=F)}function Gt(S,A,N,F,X=0){if(F.length>0&&S.auto(i,$s)&&(A==null||A.min==null)){let tt=Re(un,0),ht=Re(dn,F.length-1),mt=N.min==null?A1(F,tt,ht,X,S.distr==3):[N.min,N.max];S.min=Ji(S.min,N.min=mt[0]),S.max=ai(S.max,N.max=mt[1])}}let se={min:null,max:null};function ge(){for(let F in v){let X=v[F];B[F]==null&&(X.min==null||B[w]!=null&&X.auto(i,$s))&&(B[F]=se)}for(let F in v){let X=v[F];B[F]==null&&X.from!=null&&B[X.from]!=null&&(B[F]=se)}B[w]!=null&&pe(!0);let S={};for(let F in B){let X=B[F];if(X!=null){let tt=S[F]=ta(v[F],F1);if(X.min!=null)bn(tt,X);else if(F!=w||s==2)if(rn==0&&tt.from==null){let ht=tt.range(i,null,null,F);tt.min=ht[0],tt.max=ht[1]}else tt.min=Ge,tt.max=-Ge}}if(rn>0){x.forEach((F,X)=>{if(s==1){let tt=F.scale,ht=B[tt];if(ht==null)return;let mt=S[tt];if(X==0){let St=mt.range(i,mt.min,mt.max,tt);mt.min=St[0],mt.max=St[1],un=Zi(mt.min,t[0]),dn=Zi(mt.max,t[0]),dn-un>1&&(t[0][un]<mt.min&&un++,t[0][dn]>mt.max&&dn--),F.min=di[un],F.max=di[dn]}else F.show&&F.auto&&Gt(mt,ht,F,t[X],F.sorted);F.idxs[0]=un,F.idxs[1]=dn}else if(X>0&&F.show&&F.auto){let[tt,ht]=F.facets,mt=tt.scale,St=ht.scale,[Ut,Ft]=t[X],kt=S[mt],le=S[St];kt!=null&&Gt(kt,B[mt],tt,Ut,tt.sorted),le!=null&&Gt(le,B[St],ht,Ft,ht.sorted),F.min=ht.min,F.max=ht.max}});for(let F in S){let X=S[F],tt=B[F];if(X.from==null&&(tt==null||tt.min==null)){let ht=X.range(i,X.min==Ge?null:X.min,X.max==-Ge?null:X.max,F);X.min=ht[0],X.max=ht[1]}}}for(let F in S){let X=S[F];if(X.from!=null){let tt=S[X.from];if(tt.min==null)X.min=X.max=null;else{let ht=X.range(i,tt.min,tt.max,F);X.min=ht[0],X.max=ht[1]}}}let A={},N=!1;for(let F in S){let X=S[F],tt=v[F];if(tt.min!=X.min||tt.max!=X.max){tt.min=X.min,tt.max=X.max;let ht=tt.distr;tt._min=ht==3?Bs(tt.min):ht==4?Ef(tt.min,tt.asinh):ht==100?tt.fwd(tt.min):tt.min,tt._max=ht==3?Bs(tt.max):ht==4?Ef(tt.max,tt.asinh):ht==100?tt.fwd(tt.max):tt.max,A[F]=N=!0}}if(N){x.forEach((F,X)=>{s==2?X>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)Mt=!0,Nn("setScale",F);ut&&rt.left>=0&&(it=gt=!0)}for(let F in B)B[F]=null}function Vt(S){let A=Nf(un-1,0,rn-1),N=Nf(dn+1,0,rn-1);for(;S[A]==null&&A>0;)A--;for(;S[N]==null&&N<rn-1;)N++;return[A,N]}function _e(){if(rn>0){let S=x.some(A=>A._focus)&&It!=zt.alpha;S&&(d.globalAlpha=It=zt.alpha),x.forEach((A,N)=>{if(N>0&&A.show&&(nn(N,!1),nn(N,!0),A._paths==null)){let F=It;It!=A.alpha&&(d.globalAlpha=It=A.alpha);let X=s==2?[0,t[N][0].length-1]:Vt(t[N]);A._paths=A.paths(i,N,X[0],X[1]),It!=F&&(d.globalAlpha=It=F)}}),x.forEach((A,N)=>{if(N>0&&A.show){let F=It;It!=A.alpha&&(d.globalAlpha=It=A.alpha),A._paths!=null&&Fe(N,!1);{let X=A._paths!=null?A._paths.gaps:null,tt=A.points.show(i,N,un,dn,X),ht=A.points.filter(i,N,tt,X);(tt||ht)&&(A.points._paths=A.points.paths(i,N,un,dn,ht),Fe(N,!0))}It!=F&&(d.globalAlpha=It=F),Nn("drawSeries",N)}}),S&&(d.globalAlpha=It=1)}}function nn(S,A){let N=A?x[S].points:x[S];N._stroke=N.stroke(i,S),N._fill=N.fill(i,S)}function Fe(S,A){let N=A?x[S].points:x[S],{stroke:F,fill:X,clip:tt,flags:ht,_stroke:mt=N._stroke,_fill:St=N._fill,_width:Ut=N.width}=N._paths;Ut=He(Ut*De,3);let Ft=null,kt=Ut%2/2;A&&St==null&&(St=Ut>0?"#fff":mt);let le=N.pxAlign==1&&kt>0;if(le&&d.translate(kt,kt),!A){let Ie=D-Ut/2,Ae=E-Ut/2,ye=Z+Ut,jt=ft+Ut;Ft=new Path2D,Ft.rect(Ie,Ae,ye,jt)}A?Bt(mt,Ut,N.dash,N.cap,St,F,X,ht,tt):Oe(S,mt,Ut,N.dash,N.cap,St,F,X,ht,Ft,tt),le&&d.translate(-kt,-kt)}function Oe(S,A,N,F,X,tt,ht,mt,St,Ut,Ft){let kt=!1;St!=0&&T.forEach((le,Ie)=>{if(le.series[0]==S){let Ae=x[le.series[1]],ye=t[le.series[1]],jt=(Ae._paths||Sl).band;mr(jt)&&(jt=le.dir==1?jt[0]:jt[1]);let $t,Ze=null;Ae.show&&jt&&C1(ye,un,dn)?(Ze=le.fill(i,Ie)||tt,$t=Ae._paths.clip):jt=null,Bt(A,N,F,X,Ze,ht,mt,St,Ut,Ft,$t,jt),kt=!0}}),kt||Bt(A,N,F,X,tt,ht,mt,St,Ut,Ft)}let wn=ea|Of;function Bt(S,A,N,F,X,tt,ht,mt,St,Ut,Ft,kt){At(S,A,N,F,X),(St||Ut||kt)&&(d.save(),St&&d.clip(St),Ut&&d.clip(Ut)),kt?(mt&wn)==wn?(d.clip(kt),Ft&&d.clip(Ft),Me(X,ht),_n(S,tt,A)):mt&Of?(Me(X,ht),d.clip(kt),_n(S,tt,A)):mt&ea&&(d.save(),d.clip(kt),Ft&&d.clip(Ft),Me(X,ht),d.restore(),_n(S,tt,A)):(Me(X,ht),_n(S,tt,A)),(St||Ut||kt)&&d.restore()}function _n(S,A,N){N>0&&(A instanceof Map?A.forEach((F,X)=>{d.strokeStyle=Yr=X,d.stroke(F)}):A!=null&&S&&d.stroke(A))}function Me(S,A){A instanceof Map?A.forEach((N,F)=>{d.fillStyle=qs=F,d.fill(N)}):A!=null&&S&&d.fill(A)}function _s(S,A,N,F){let X=M[S],tt;if(F<=0)tt=[0,0];else{let ht=X._space=X.space(i,S,A,N,F),mt=X._incrs=X.incrs(i,S,A,N,F,ht);tt=JT(A,N,mt,F,ht)}return X._found=tt}function xn(S,A,N,F,X,tt,ht,mt,St,Ut){let Ft=ht%2/2;y==1&&d.translate(Ft,Ft),At(mt,ht,St,Ut,mt),d.beginPath();let kt,le,Ie,Ae,ye=X+(F==0||F==3?-tt:tt);N==0?(le=X,Ae=ye):(kt=X,Ie=ye);for(let jt=0;jt<S.length;jt++)A[jt]!=null&&(N==0?kt=Ie=S[jt]:le=Ae=S[jt],d.moveTo(kt,le),d.lineTo(Ie,Ae));d.stroke(),y==1&&d.translate(-Ft,-Ft)}function Jr(S){let A=!0;return M.forEach((N,F)=>{if(!N.show)return;let X=v[N.scale];if(X.min==null){N._show&&(A=!1,N._show=!1,pe(!1));return}else N._show||(A=!1,N._show=!0,pe(!1));let tt=N.side,ht=tt%2,{min:mt,max:St}=X,[Ut,Ft]=_s(F,mt,St,ht==0?k:Rt);if(Ft==0)return;let kt=X.distr==2,le=N._splits=N.splits(i,F,mt,St,Ut,Ft,kt),Ie=X.distr==2?le.map($t=>di[$t]):le,Ae=X.distr==2?di[le[1]]-di[le[0]]:Ut,ye=N._values=N.values(i,N.filter(i,Ie,F,Ft,Ae),F,Ft,Ae);N._rotate=tt==2?N.rotate(i,ye,F,Ft):0;let jt=N._size;N._size=Li(N.size(i,ye,F,S)),jt!=null&&N._size!=jt&&(A=!1)}),A}function Qi(S){let A=!0;return ua.forEach((N,F)=>{let X=N(i,F,Ki,S);X!=Ui[F]&&(A=!1),Ui[F]=X}),A}function xs(){for(let S=0;S<M.length;S++){let A=M[S];if(!A.show||!A._show)continue;let N=A.side,F=N%2,X,tt,ht=A.stroke(i,S),mt=N==0||N==3?-1:1,[St,Ut]=A._found;if(A.label!=null){let jn=A.labelGap*mt,mi=Pn((A._lpos+jn)*De);Lt(A.labelFont[0],ht,"center",N==2?"top":d0),d.save(),F==1?(X=tt=0,d.translate(mi,Pn(E+ft/2)),d.rotate((N==3?-pu:pu)/2)):(X=Pn(D+Z/2),tt=mi);let yr=e_(A.label)?A.label(i,S,St,Ut):A.label;d.fillText(yr,X,tt),d.restore()}if(Ut==0)continue;let Ft=v[A.scale],kt=F==0?Z:ft,le=F==0?D:E,Ie=A._splits,Ae=Ft.distr==2?Ie.map(jn=>di[jn]):Ie,ye=Ft.distr==2?di[Ie[1]]-di[Ie[0]]:St,jt=A.ticks,$t=A.border,Ze=jt.show?jt.size:0,an=Pn(Ze*De),Un=Pn((A.alignTo==2?A._size-Ze-A.gap:A.gap)*De),ke=A._rotate*-pu/180,ln=m(A._pos*De),fi=(an+Un)*mt,Kn=ln+fi;tt=F==0?Kn:0,X=F==1?Kn:0;let Ti=A.font[0],Fi=A.align==1?Zo:A.align==2?bf:ke>0?Zo:ke<0?bf:F==0?"center":N==3?bf:Zo,ns=ke||F==1?"middle":N==2?"top":d0;Lt(Ti,ht,Fi,ns);let pi=A.font[1]*A.lineGap,Ei=Ie.map(jn=>m(a(jn,Ft,kt,le))),Oi=A._values;for(let jn=0;jn<Oi.length;jn++){let mi=Oi[jn];if(mi!=null){F==0?X=Ei[jn]:tt=Ei[jn],mi=""+mi;let yr=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let Qn=0;Qn<yr.length;Qn++){let Ep=yr[Qn];ke?(d.save(),d.translate(X,tt+Qn*pi),d.rotate(ke),d.fillText(Ep,0,0),d.restore()):d.fillText(Ep,X,tt+Qn*pi)}}}jt.show&&xn(Ei,jt.filter(i,Ae,S,Ut,ye),F,N,ln,an,He(jt.width*De,3),jt.stroke(i,S),jt.dash,jt.cap);let is=A.grid;is.show&&xn(Ei,is.filter(i,Ae,S,Ut,ye),F,F==0?2:1,F==0?E:D,F==0?ft:Z,He(is.width*De,3),is.stroke(i,S),is.dash,is.cap),$t.show&&xn([ln],[1],F==0?1:0,F==0?1:2,F==1?E:D,F==1?ft:Z,He($t.width*De,3),$t.stroke(i,S),$t.dash,$t.cap)}Nn("drawAxes")}function pe(S){x.forEach((A,N)=>{N>0&&(A._paths=null,S&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let on=!1,Jn=!1,Be=[];function yn(){Jn=!1;for(let S=0;S<Be.length;S++)Nn(...Be[S]);Be.length=0}function Gn(){on||(H1(lp),on=!0)}function Dl(S,A=!1){on=!0,Jn=A,S(i),lp(),A&&Be.length>0&&queueMicrotask(yn)}i.batch=Dl;function lp(){if(ct&&(ge(),ct=!1),Mt&&(Tt(),Mt=!1),vt){if(je(f,Zo,Yt),je(f,"top",ie),je(f,xl,k),je(f,yl,Rt),je(_,Zo,Yt),je(_,"top",ie),je(_,xl,k),je(_,yl,Rt),je(h,xl,Qe),je(h,yl,sn),u.width=Pn(Qe*De),u.height=Pn(sn*De),M.forEach(({_el:S,_show:A,_size:N,_pos:F,side:X})=>{if(S!=null)if(A){let tt=X===3||X===0?N:0,ht=X%2==1;je(S,ht?"left":"top",F-tt),je(S,ht?"width":"height",N),je(S,ht?"top":"left",ht?ie:Yt),je(S,ht?"height":"width",ht?Rt:k),Lf(S,kr)}else Si(S,kr)}),Yr=qs=Zr=H=nt=j=Q=Et=R=null,It=1,ga(!0),Yt!=wt||ie!=Ve||k!=Ht||Rt!=Jt){pe(!1);let S=k/Ht,A=Rt/Jt;if(ut&&!it&&rt.left>=0){rt.left*=S,rt.top*=A,Kr&&ps(Kr,Pn(rt.left),0,k,Rt),jr&&ps(jr,0,Pn(rt.top),k,Rt);for(let N=0;N<de.length;N++){let F=de[N];F!=null&&($e[N]*=S,Zn[N]*=A,ps(F,Li($e[N]),Li(Zn[N]),k,Rt))}}if(Ye.show&&!ot&&Ye.left>=0&&Ye.width>0){Ye.left*=S,Ye.width*=S,Ye.top*=A,Ye.height*=A;for(let N in Ou)je(eo,N,Ye[N])}wt=Yt,Ve=ie,Ht=k,Jt=Rt}Nn("setSize"),vt=!1}Qe>0&&sn>0&&(d.clearRect(0,0,u.width,u.height),Nn("drawClear"),b.forEach(S=>S()),Nn("draw")),Ye.show&&ot&&(Nl(Ye),ot=!1),ut&&it&&(xr(null,!0,!1),it=!1),lt.show&&lt.live&&gt&&(Uu(),gt=!1),l||(l=!0,i.status=1,Nn("ready")),$s=!1,on=!1}i.redraw=(S,A)=>{Mt=A||!1,S!==!1?Zs(w,C.min,C.max):Gn()};function Lu(S,A){let N=v[S];if(N.from==null){if(rn==0){let F=N.range(i,A.min,A.max,S);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(rn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;S==w&&N.distr==2&&rn>0&&(A.min=Zi(A.min,t[0]),A.max=Zi(A.max,t[0]),A.min==A.max&&A.max++),B[S]=A,ct=!0,Gn()}}i.setScale=Lu;let Du,Nu,Kr,jr,cp,hp,Qr,to,up,dp,qe,tn,Ys=!1,kn=rt.drag,Ln=kn.x,Dn=kn.y;ut&&(rt.x&&(Du=Ii(f1,_)),rt.y&&(Nu=Ii(p1,_)),C.ori==0?(Kr=Du,jr=Nu):(Kr=Nu,jr=Du),qe=rt.left,tn=rt.top);let Ye=i.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),eo=Ye.show?Ii(d1,Ye.over?_:f):null;function Nl(S,A){if(Ye.show){for(let N in S)Ye[N]=S[N],N in Ou&&je(eo,N,S[N]);A!==!1&&Nn("setSelect")}}i.setSelect=Nl;function gx(S){if(x[S].show)K&&Lf(oe[S],kr);else if(K&&Si(oe[S],kr),ut){let N=Ct?de[0]:de[S];N!=null&&ps(N,-10,-10,k,Rt)}}function Zs(S,A,N){Lu(S,{min:A,max:N})}function ts(S,A,N,F){A.focus!=null&&Mx(S),A.show!=null&&x.forEach((X,tt)=>{tt>0&&(S==tt||S==null)&&(X.show=A.show,gx(tt),s==2?(Zs(X.facets[0].scale,null,null),Zs(X.facets[1].scale,null,null)):Zs(X.scale,null,null),Gn())}),N!==!1&&Nn("setSeries",S,A),F&&_a("setSeries",i,S,A)}i.setSeries=ts;function _x(S,A){bn(T[S],A)}function xx(S,A){S.fill=be(S.fill||null),S.dir=Re(S.dir,-1),A=A??T.length,T.splice(A,0,S)}function yx(S){S==null?T.length=0:T.splice(S,1)}i.addBand=xx,i.setBand=_x,i.delBand=yx;function vx(S,A){x[S].alpha=A,ut&&de[S]!=null&&(de[S].style.opacity=A),K&&oe[S]&&(oe[S].style.opacity=A)}let ys,Js,_r,no={focus:!0};function Mx(S){if(S!=_r){let A=S==null,N=zt.alpha!=1;x.forEach((F,X)=>{if(s==1||X>0){let tt=A||X==0||X==S;F._focus=A?null:tt,N&&vx(X,tt?1:zt.alpha)}}),_r=S,N&&Gn()}}K&&te&&ve(g0,yt,S=>{rt._lock||(Qt(S),_r!=null&&ts(null,no,!0,vn.setSeries))});function es(S,A,N){let F=v[A];N&&(S=S/De-(F.ori==1?ie:Yt));let X=k;F.ori==1&&(X=Rt,S=X-S),F.dir==-1&&(S=X-S);let tt=F._min,ht=F._max,mt=S/X,St=tt+(ht-tt)*mt,Ut=F.distr;return Ut==3?jo(10,St):Ut==4?I1(St,F.asinh):Ut==100?F.bwd(St):St}function Sx(S,A){let N=es(S,w,A);return Zi(N,t[0],un,dn)}i.valToIdx=S=>Zi(S,t[0]),i.posToIdx=Sx,i.posToVal=es,i.valToPos=(S,A,N)=>v[A].ori==0?r(S,v[A],N?Z:k,N?D:0):o(S,v[A],N?ft:Rt,N?E:0),i.setCursor=(S,A,N)=>{qe=S.left,tn=S.top,xr(null,A,N)};function fp(S,A){je(eo,Zo,Ye.left=S),je(eo,xl,Ye.width=A)}function pp(S,A){je(eo,"top",Ye.top=S),je(eo,yl,Ye.height=A)}let pa=C.ori==0?fp:pp,ma=C.ori==1?fp:pp;function bx(){if(K&&lt.live)for(let S=s==2?1:0;S<x.length;S++){if(S==0&&ue)continue;let A=lt.values[S],N=0;for(let F in A)Ot[S][N++].firstChild.nodeValue=A[F]}}function Uu(S,A){if(S!=null&&(S.idxs?S.idxs.forEach((N,F)=>{et[F]=N}):U1(S.idx)||et.fill(S.idx),lt.idx=et[0]),K&&lt.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!ue)&&wx(N,et[N]);bx()}gt=!1,A!==!1&&Nn("setLegend")}i.setLegend=Uu;function wx(S,A){let N=x[S],F=S==0&&U==2?di:t[S],X;ue?X=N.values(i,S,A)??ne:(X=N.value(i,A==null?null:F[A],S,A),X=X==null?ne:{_:X}),lt.values[S]=X}function xr(S,A,N){up=qe,dp=tn,[qe,tn]=rt.move(i,qe,tn),rt.left=qe,rt.top=tn,ut&&(Kr&&ps(Kr,Pn(qe),0,k,Rt),jr&&ps(jr,0,Pn(tn),k,Rt));let F,X=un>dn;ys=Ge,Js=null;let tt=C.ori==0?k:Rt,ht=C.ori==1?k:Rt;if(qe<0||rn==0||X){F=rt.idx=null;for(let mt=0;mt<x.length;mt++){let St=de[mt];St!=null&&ps(St,-10,-10,k,Rt)}te&&ts(null,no,!0,S==null&&vn.setSeries),lt.live&&(et.fill(F),gt=!0)}else{let mt,St,Ut;s==1&&(mt=C.ori==0?qe:tn,St=es(mt,w),F=rt.idx=Zi(St,t[0],un,dn),Ut=O(t[0][F],C,tt,0));let Ft=-10,kt=-10,le=0,Ie=0,Ae=!0,ye="",jt="";for(let $t=s==2?1:0;$t<x.length;$t++){let Ze=x[$t],an=et[$t],Un=an==null?null:s==1?t[$t][an]:t[$t][1][an],ke=rt.dataIdx(i,$t,F,St),ln=ke==null?null:s==1?t[$t][ke]:t[$t][1][ke];if(gt=gt||ln!=Un||ke!=an,et[$t]=ke,$t>0&&Ze.show){let fi=ke==null?-10:ke==F?Ut:O(s==1?t[0][ke]:t[$t][0][ke],C,tt,0),Kn=ln==null?-10:L(ln,s==1?v[Ze.scale]:v[Ze.facets[1].scale],ht,0);if(te&&ln!=null){let Ti=C.ori==1?qe:tn,Fi=In(zt.dist(i,$t,ke,Kn,Ti));if(Fi<ys){let ns=zt.bias;if(ns!=0){let pi=es(Ti,Ze.scale),Ei=ln>=0?1:-1,Oi=pi>=0?1:-1;Oi==Ei&&(Oi==1?ns==1?ln>=pi:ln<=pi:ns==1?ln<=pi:ln>=pi)&&(ys=Fi,Js=$t)}else ys=Fi,Js=$t}}if(gt||Ct){let Ti,Fi;C.ori==0?(Ti=fi,Fi=Kn):(Ti=Kn,Fi=fi);let ns,pi,Ei,Oi,is,jn,mi=!0,yr=dt.bbox;if(yr!=null){mi=!1;let Qn=yr(i,$t);Ei=Qn.left,Oi=Qn.top,ns=Qn.width,pi=Qn.height}else Ei=Ti,Oi=Fi,ns=pi=dt.size(i,$t);if(jn=dt.fill(i,$t),is=dt.stroke(i,$t),Ct)$t==Js&&ys<=zt.prox&&(Ft=Ei,kt=Oi,le=ns,Ie=pi,Ae=mi,ye=jn,jt=is);else{let Qn=de[$t];Qn!=null&&($e[$t]=Ei,Zn[$t]=Oi,b0(Qn,ns,pi,mi),M0(Qn,jn,is),ps(Qn,Li(Ei),Li(Oi),k,Rt))}}}}if(Ct){let $t=zt.prox,Ze=_r==null?ys<=$t:ys>$t||Js!=_r;if(gt||Ze){let an=de[0];an!=null&&($e[0]=Ft,Zn[0]=kt,b0(an,le,Ie,Ae),M0(an,ye,jt),ps(an,Li(Ft),Li(kt),k,Rt))}}}if(Ye.show&&Ys)if(S!=null){let[mt,St]=vn.scales,[Ut,Ft]=vn.match,[kt,le]=S.cursor.sync.scales,Ie=S.cursor.drag;if(Ln=Ie._x,Dn=Ie._y,Ln||Dn){let{left:Ae,top:ye,width:jt,height:$t}=S.select,Ze=S.scales[kt].ori,an=S.posToVal,Un,ke,ln,fi,Kn,Ti=mt!=null&&Ut(mt,kt),Fi=St!=null&&Ft(St,le);Ti&&Ln?(Ze==0?(Un=Ae,ke=jt):(Un=ye,ke=$t),ln=v[mt],fi=O(an(Un,kt),ln,tt,0),Kn=O(an(Un+ke,kt),ln,tt,0),pa(Ji(fi,Kn),In(Kn-fi))):pa(0,tt),Fi&&Dn?(Ze==1?(Un=Ae,ke=jt):(Un=ye,ke=$t),ln=v[St],fi=L(an(Un,le),ln,ht,0),Kn=L(an(Un+ke,le),ln,ht,0),ma(Ji(fi,Kn),In(Kn-fi))):ma(0,ht)}else Bu()}else{let mt=In(up-cp),St=In(dp-hp);if(C.ori==1){let le=mt;mt=St,St=le}Ln=kn.x&&mt>=kn.dist,Dn=kn.y&&St>=kn.dist;let Ut=kn.uni;Ut!=null?Ln&&Dn&&(Ln=mt>=Ut,Dn=St>=Ut,!Ln&&!Dn&&(St>mt?Dn=!0:Ln=!0)):kn.x&&kn.y&&(Ln||Dn)&&(Ln=Dn=!0);let Ft,kt;Ln&&(C.ori==0?(Ft=Qr,kt=qe):(Ft=to,kt=tn),pa(Ji(Ft,kt),In(kt-Ft)),Dn||ma(0,ht)),Dn&&(C.ori==1?(Ft=Qr,kt=qe):(Ft=to,kt=tn),ma(Ji(Ft,kt),In(kt-Ft)),Ln||pa(0,tt)),!Ln&&!Dn&&(pa(0,0),ma(0,0))}if(kn._x=Ln,kn._y=Dn,S==null){if(N){if(Tp!=null){let[mt,St]=vn.scales;vn.values[0]=mt!=null?es(C.ori==0?qe:tn,mt):null,vn.values[1]=St!=null?es(C.ori==1?qe:tn,St):null}_a(wf,i,qe,tn,k,Rt,F)}if(te){let mt=N&&vn.setSeries,St=zt.prox;_r==null?ys<=St&&ts(Js,no,!0,mt):ys>St?ts(null,no,!0,mt):Js!=_r&&ts(Js,no,!0,mt)}}gt&&(lt.idx=F,Uu()),A!==!1&&Nn("setCursor")}let Ks=null;Object.defineProperty(i,"rect",{get(){return Ks==null&&ga(!1),Ks}});function ga(S=!1){S?Ks=null:(Ks=_.getBoundingClientRect(),Nn("syncRect",Ks))}function mp(S,A,N,F,X,tt,ht){rt._lock||Ys&&S!=null&&S.movementX==0&&S.movementY==0||(Fu(S,A,N,F,X,tt,ht,!1,S!=null),S!=null?xr(null,!0,!0):xr(A,!0,!1))}function Fu(S,A,N,F,X,tt,ht,mt,St){if(Ks==null&&ga(!1),Qt(S),S!=null)N=S.clientX-Ks.left,F=S.clientY-Ks.top;else{if(N<0||F<0){qe=-10,tn=-10;return}let[Ut,Ft]=vn.scales,kt=A.cursor.sync,[le,Ie]=kt.values,[Ae,ye]=kt.scales,[jt,$t]=vn.match,Ze=A.axes[0].side%2==1,an=C.ori==0?k:Rt,Un=C.ori==1?k:Rt,ke=Ze?tt:X,ln=Ze?X:tt,fi=Ze?F:N,Kn=Ze?N:F;if(Ae!=null?N=jt(Ut,Ae)?a(le,v[Ut],an,0):-10:N=an*(fi/ke),ye!=null?F=$t(Ft,ye)?a(Ie,v[Ft],Un,0):-10:F=Un*(Kn/ln),C.ori==1){let Ti=N;N=F,F=Ti}}St&&(A==null||A.cursor.event.type==wf)&&((N<=1||N>=k-1)&&(N=Or(N,k)),(F<=1||F>=Rt-1)&&(F=Or(F,Rt))),mt?(cp=N,hp=F,[Qr,to]=rt.move(i,N,F)):(qe=N,tn=F)}let Ou={width:0,height:0,left:0,top:0};function Bu(){Nl(Ou,!1)}let gp,_p,xp,yp;function vp(S,A,N,F,X,tt,ht){Ys=!0,Ln=Dn=kn._x=kn._y=!1,Fu(S,A,N,F,X,tt,ht,!0,!1),S!=null&&(ve(Tf,Pf,Mp,!1),_a(p0,i,Qr,to,k,Rt,null));let{left:mt,top:St,width:Ut,height:Ft}=Ye;gp=mt,_p=St,xp=Ut,yp=Ft}function Mp(S,A,N,F,X,tt,ht){Ys=kn._x=kn._y=!1,Fu(S,A,N,F,X,tt,ht,!1,!0);let{left:mt,top:St,width:Ut,height:Ft}=Ye,kt=Ut>0||Ft>0,le=gp!=mt||_p!=St||xp!=Ut||yp!=Ft;if(kt&&le&&Nl(Ye),kn.setScale&&kt&&le){let Ie=mt,Ae=Ut,ye=St,jt=Ft;if(C.ori==1&&(Ie=St,Ae=Ft,ye=mt,jt=Ut),Ln&&Zs(w,es(Ie,w),es(Ie+Ae,w)),Dn)for(let $t in v){let Ze=v[$t];$t!=w&&Ze.from==null&&Ze.min!=Ge&&Zs($t,es(ye+jt,$t),es(ye,$t))}Bu()}else rt.lock&&(rt._lock=!rt._lock,xr(A,!0,S!=null));S!=null&&(hn(Tf,Pf),_a(Tf,i,qe,tn,k,Rt,null))}function Tx(S,A,N,F,X,tt,ht){if(rt._lock)return;Qt(S);let mt=Ys;if(Ys){let St=!0,Ut=!0,Ft=10,kt,le;C.ori==0?(kt=Ln,le=Dn):(kt=Dn,le=Ln),kt&&le&&(St=qe<=Ft||qe>=k-Ft,Ut=tn<=Ft||tn>=Rt-Ft),kt&&St&&(qe=qe<Qr?0:k),le&&Ut&&(tn=tn<to?0:Rt),xr(null,!0,!0),Ys=!1}qe=-10,tn=-10,et.fill(null),xr(null,!0,!0),mt&&(Ys=mt)}function Sp(S,A,N,F,X,tt,ht){rt._lock||(Qt(S),fa(),Bu(),S!=null&&_a(_0,i,qe,tn,k,Rt,null))}function bp(){M.forEach(KT),z(i.width,i.height,!0)}zr(mu,Ko,bp);let io={};io.mousedown=vp,io.mousemove=mp,io.mouseup=Mp,io.dblclick=Sp,io.setSeries=(S,A,N,F)=>{let X=vn.match[2];N=X(i,A,N),N!=-1&&ts(N,F,!0,!1)},ut&&(ve(p0,_,vp),ve(wf,_,mp),ve(m0,_,S=>{Qt(S),ga(!1)}),ve(g0,_,Tx),ve(_0,_,Sp),Bf.add(i),i.syncRect=ga);let Ul=i.hooks=n.hooks||{};function Nn(S,A,N){Jn?Be.push([S,A,N]):S in Ul&&Ul[S].forEach(F=>{F.call(null,i,A,N)})}(n.plugins||[]).forEach(S=>{for(let A in S.hooks)Ul[A]=(Ul[A]||[]).concat(S.hooks[A])});let wp=(S,A,N)=>N,vn=bn({key:null,setSeries:!1,filters:{pub:R0,sub:R0},scales:[w,x[1]?x[1].scale:null],match:[C0,C0,wp],values:[null,null]},rt.sync);vn.match.length==2&&vn.match.push(wp),rt.sync=vn;let Tp=vn.key,ku=T_(Tp);function _a(S,A,N,F,X,tt,ht){vn.filters.pub(S,A,N,F,X,tt,ht)&&ku.pub(S,A,N,F,X,tt,ht)}ku.sub(i);function Ex(S,A,N,F,X,tt,ht){vn.filters.sub(S,A,N,F,X,tt,ht)&&io[S](null,A,N,F,X,tt,ht)}i.pub=Ex;function Ax(){ku.unsub(i),Bf.delete(i),gn.clear(),Df(mu,Ko,bp),c.remove(),yt?.remove(),Nn("destroy")}i.destroy=Ax;function zu(){Nn("init",n,t),da(t||n.data,!1),B[w]?Lu(w,B[w]):fa(),ot=Ye.show&&(Ye.width>0||Ye.height>0),it=gt=!0,z(n.width,n.height)}return x.forEach(qr),M.forEach(ms),e?e instanceof HTMLElement?(e.appendChild(c),zu()):e(i,zu):zu(),i}cn.assign=bn;cn.fmtNum=Xf;cn.rangeNum=gu;cn.rangeLog=yu;cn.rangeAsinh=Hf;cn.orient=Gr;cn.pxRatio=De;cn.join=G1;cn.fmtDate=qf,cn.tzDate=Q1;cn.sync=T_;{cn.addGap=UT,cn.clipGaps=Su;let n=cn.paths={points:I_};n.linear=D_,n.stepped=BT,n.bars=kT,n.spline=VT}var jT=n=>Ss(String(Number(n.toFixed(6)))),QT=364,zs=n=>fn()?QT:Math.max(n.clientWidth,200);function ra(n){let t={stroke:Ee("muted"),grid:{stroke:Ee("grid"),width:1},ticks:{show:!1},font:"11px system-ui, sans-serif",values:(e,i)=>i.map(jT)};return[{...t,size:30,label:n,labelSize:18,labelFont:t.font},{...t,size:62}]}var Vs=(n,t)=>t==null?"–":Tn(t),oa={live:!0,markers:{width:2,stroke:(n,t)=>n.series[t].stroke(n,t),dash:(n,t)=>n.series[t].dash?n.series[t].dash[0]<2?"dotted":"dashed":"solid",fill:()=>"transparent"}};function wl(n,t,e,i){if(n===null||t===null)return[0,1];let s=Math.max(t-n,qt(i,e)),r=(n+t)/2;return[r-.58*s,r+.58*s]}var O_=new Map;function Eu(n,t){let e=O_.get(t)??new Set;O_.set(t,e),n.root.querySelectorAll(".u-legend .u-series").forEach((i,s)=>{if(s===0||n.series.length<3)return;let r=i.querySelector("th"),{label:o}=n.series[s],a=()=>r.setAttribute("aria-pressed",String(n.series[s].show));e.has(o)&&n.setSeries(s,{show:!1});for(let[l,c]of Object.entries({tabindex:0,role:"button",title:`Show or hide ${o}`}))r.setAttribute(l,c);r.addEventListener("keydown",l=>{l.key!=="Enter"&&l.key!==" "||(l.preventDefault(),r.click())}),r.addEventListener("click",()=>{n.series[s].show?e.delete(o):e.add(o),a()}),a()})}var[Hr,Gs,Di,aa,Hs,Wr]=[720,320,78,16,46,46],tE={"font-family":"system-ui, sans-serif","font-size":12};function eE(n,t){let e=[];for(let i=Math.ceil(Math.log10(n)-1e-9);10**i<=t*(1+1e-9);i++)e.push(10**i);return e.map(i=>[i,`1e${Math.round(Math.log10(i))}`])}function B_(n,[t,e],i){let s=n.distr===3,r=s?Math.log10:d=>d,[o,a]=[r(n.min),r(n.max)],l=d=>t+(r(d)-o)/(a-o)*(e-t),c=Rn(n.min,n.max,i),u=s?eE(n.min,n.max):c.values.map(d=>[d,mn(d,c.step)]);return{at:l,marks:u}}function la(n,t,e){let i=n.scales.y.dir===-1,s=B_(n.scales.x,[Di,Hr-aa],8),r=B_(n.scales.y,i?[Hs,Gs-Wr]:[Gs-Wr,Hs],5),o=Pt("svg",{viewBox:`0 0 ${Hr} ${Gs}`,xmlns:"http://www.w3.org/2000/svg",...tE}),a=Ee("grid"),l=(h,f)=>Pt("text",{fill:Ee("text"),...h},f);for(let[h,f]of s.marks)o.append(Pt("line",{x1:s.at(h),x2:s.at(h),y1:Hs,y2:Gs-Wr,stroke:a})),o.append(l({x:s.at(h),y:Gs-Wr+17,"text-anchor":"middle"},f));for(let[h,f]of r.marks)o.append(Pt("line",{x1:Di,x2:Hr-aa,y1:r.at(h),y2:r.at(h),stroke:a})),o.append(l({x:Di-7,y:r.at(h)+4,"text-anchor":"end"},f));let c=Pt("svg",{x:Di,y:Hs,width:Hr-Di-aa,height:Gs-Hs-Wr,viewBox:`${Di} ${Hs} ${Hr-Di-aa} ${Gs-Hs-Wr}`}),u=Di;n.series.forEach((h,f)=>{if(f===0||!h.show)return;let _=typeof h.stroke=="function"?h.stroke(n,f):h.stroke,y=n.data[f],m=Array.from(n.data[0],(p,x)=>[p,y[x]]).filter(([p,x])=>x!==null&&Number.isFinite(x)&&p>=n.scales.x.min&&p<=n.scales.x.max);if(h.points?.show===!0)for(let[p,x]of m)c.append(Pt("circle",{cx:s.at(p).toFixed(1),cy:r.at(x).toFixed(1),r:1.8,fill:_}));else c.append(Pt("path",{d:m.map(([p,x],M)=>`${M?"L":"M"}${s.at(p).toFixed(1)} ${r.at(x).toFixed(1)}`).join(""),fill:"none",stroke:_,"stroke-width":h.width??1.4,"stroke-dasharray":h.dash?.join(" ")}));if(n.series.length>2){let p=h.dash?.join(" ");o.append(Pt("line",{x1:u,x2:u+22,y1:34,y2:34,stroke:_,"stroke-width":2,"stroke-dasharray":p})),o.append(l({x:u+27,y:38},h.label)),u+=42+6.4*h.label.length}}),o.append(c,Pt("rect",{x:Di,y:Hs,width:Hr-Di-aa,height:Gs-Hs-Wr,fill:"none",stroke:Ee("frame")}),l({x:Di,y:18,"font-weight":600},t),l({x:(Di+Hr-aa)/2,y:Gs-10,"text-anchor":"middle"},e)),o.style.position="absolute",document.body.append(o);let d=oo([o]);return o.remove(),d}function ca(n,t,e){let i=n.series.map((l,c)=>c).filter(l=>l===0||n.series[l].show),s=l=>l===0?t:`${n.series[l].label}${e?`, ${e}`:""}`,{min:r,max:o}=n.scales.x,a=Array.from(n.data[0],(l,c)=>i.map(u=>n.data[u][c]));return[i.map(s),a.filter(([l])=>l>=r&&l<=o)]}function Ws(n,t){let e=0,i=n.length;for(;e<i;){let s=e+i>>1;n[s]<t?e=s+1:i=s}return e}function Xr(n,[t,e]){return[Math.max(Ws(n,t)-1,0),Math.min(Ws(n,e)+1,n.length)]}function $r(n,t,e){if(n.length===0||e<n[0]-1||e>n[n.length-1]+1)return NaN;let i=Math.min(Math.max(Ws(n,e),1),n.length-1),s=n[i]-n[i-1],r=s>0?Math.min(Math.max((e-n[i-1])/s,0),1):0;return t[i-1]+r*(t[i]-t[i-1])}function k_(n,t,e){let[i,s]=[1/0,-1/0],[r,o]=Xr(n,e);for(let a=r;a<o;a++)t[a]<i&&(i=t[a]),t[a]>s&&(s=t[a]);return[i,s]}var tp=(n,t)=>`${n.toFixed(1)} ${t.toFixed(1)}`;function ep(n,t,e,i,s){let[r,o]=Xr(n,e),a=o-r>2*Math.abs(s(e[1])-s(e[0])),l="",c="M",u=h=>{l+=c+tp(i(t[h]),s(n[h])),c="L"},d=r;for(;d<o;){if(!Number.isFinite(t[d])){c="M",d++;continue}if(!a){u(d++);continue}let h=Math.round(s(n[d])),[f,_,y]=[d,d,d];for(;y+1<o&&Math.round(s(n[y+1]))===h&&Number.isFinite(t[y+1]);)y++,t[y]<t[f]&&(f=y),t[y]>t[_]&&(_=y);for(let m of[...new Set([d,Math.min(f,_),Math.max(f,_),y])])u(m);d=y+1}return l}function Au(n,t,e,i,s,r){let[o,a]=Xr(n,i),l=Math.max(Math.floor((a-o)/(2*Math.abs(r(i[1])-r(i[0]))+1)),1),c=[],u=[];for(let d=o;d<a;d+=l){let[h,f]=[1/0,-1/0];for(let _=d;_<Math.min(d+l,a);_++)t[_]<h&&(h=t[_]),e[_]>f&&(f=e[_]);h<=f&&(c.push(tp(s(f),r(n[d]))),u.push(tp(s(h),r(n[d]))))}return c.length>1?`M${c.join("L")}L${u.reverse().join("L")}Z`:""}function np(n,t,e){let i=new Float32Array(t.length),s=0;for(let r=0;r<t.length;r++){for(;n[s]<n[r]-e;)s++;let o=-1/0;for(let a=s;a<t.length&&n[a]<=n[r]+e;a++)o=Math.max(o,t[a]);i[r]=o}return i}function z_(n,t,e){let[i,s]=[0,0];return Uint32Array.from(t,(r,o)=>{for(;n[i]<n[o]-e;)i++;for(;s<t.length&&n[s]<=n[o]+e;)s++;let a=i;for(let l=i;l<s;l++)t[l]>=t[a]&&(a=l);return a})}var nE=cn.sync("time"),V_=216,iE=196;function ip(n,t,e){let i=W("div",{class:"histories"}),s=[],r=!1;function o(M){let v=M.history,T=t.map(g=>({...g,columns:g.columns.filter(([b])=>v[b])})).filter(g=>g.columns.length).filter(g=>g.columns.some(([b])=>v[b].some(P=>P!==0))).map(g=>({...g,times:v.time_s,values:g.columns.map(([b])=>v[b])})),w=e?l(M):null;return w?[...T,w]:T}let a=n.node_channels[0].column;function l(M){let{frames:v,contact:T}=M;if(v?.channels[a]){let w=v.md_m.length,g=Tl(v.md_m,Dt.depth),{title:b,dimension:P,min_span:I}=n.node_channels.find(({column:U})=>U===a),C=Float32Array.from(v.time_s,(U,O)=>v.channels[a][O*w+g]);return{title:`${b} at ${Te(v.md_m[g],"length",5)}`,dimension:P,min_span:I,columns:[[a,"node"]],times:v.time_s,values:[C],chooses:n.node_channels.filter(({column:U})=>v.channels[U])}}if(T){let w=T.md_m.length,g=Tl(T.md_m,Dt.depth),[{column:b,title:P,dimension:I,min_span:C}]=n.contact_plots,U=Float32Array.from(T.time_s,(O,L)=>T.values[b][L*w+g]);return{title:`${P} around ${Te(T.md_m[g],"length",5)}`,dimension:I,min_span:C,columns:[[b,P.toLowerCase()]],times:T.time_s,values:[U]}}return null}function c(){s.forEach(T=>T.destroy()),s=[];let M=Je(n),v=M?o(M).map(T=>u(T,M)):[];i.replaceChildren(...v.map(T=>T.element));for(let{plot:T,body:w,it:g}of v)s.push(g.made=d(T,w,M))}function u(M,v){let T=W("div",{class:"plot"}),w=re(M.dimension),g=W("h3",{},M.points&&M.columns.length===1?M.columns[0][1].replace(/^./,I=>I.toUpperCase()):M.title,w&&W("span",{class:"unit"},` ${w}`));M.chooses&&g.append(W("select",{class:"noprint","aria-label":"Quantity of the chosen node",onchange:I=>{a=I.target.value,c()}},M.chooses.map(({column:I,title:C})=>W("option",{value:I,selected:I===a},C))));let b={plot:M,body:T,made:null},P=()=>`${Hn(v.operation)}: ${M.title}`;return g.append(Mn(P,{svg:()=>la(b.made,`${P()}${w?`, ${w}`:""}`,"Time, s"),csv:()=>Wn(...ca(b.made,"time, s",w))})),{...b,it:b,element:W("figure",{class:"card history"},g,T)}}function d(M,v,T){let w=h(M),g=[Array.from(M.times),...M.values.map(C=>$l(C,M.dimension))],b=M.columns.map(([,C],U)=>{let O=C==="set";return{label:C,stroke:vs(O?6:[0,2,3][U]??U),width:O?1.2:1.4,dash:O?Mr(4):Mr([0,2,3][U]??U)??void 0,spanGaps:!!M.points,points:{show:!1},value:Vs}});w!==null&&(g.push(g[0].map(()=>w.value)),b.push({label:w.name,stroke:vs(1),width:1.4,dash:[7,4],points:{show:!1},value:Vs}));let P=Dt.times??[0,Math.max(T.history.time_s.at(-1),.001)],I=new cn({width:zs(v),height:fn()?iE:V_,cursor:{sync:{key:nE.key,scales:["x",null]},drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:oa,scales:{x:{time:!1,min:P[0],max:P[1]},y:{dir:M.points?-1:1,range:(C,U,O)=>wl(U,O,M.dimension,M.min_span)}},axes:ra("Time, s"),series:[{label:"time, s",value:(C,U)=>U===null?"–":U.toFixed(2)},...b],hooks:{setScale:[(C,U)=>U==="x"&&f(C)],drawClear:[C=>_(C,T)],draw:[C=>y(C,T)]}},g,v);return m(I),Eu(I,`${T.operation} ${M.title.replace(/ (at|around) .*/,"")}`),I}function h(M){let v=Gl(n);if(!M.at_surface||!v)return null;let T=v.profile[M.at_surface]?.[0];return Number.isFinite(T)?{name:Ms(n,v),value:qt(T,M.dimension)}:null}function f(M){if(r||M.scales.x.min==null||s.length===0)return;r=!0;let{min:v,max:T}=M.scales.x,g=Je(n).history.time_s.at(-1);for(let b of s)b!==M&&b.setScale("x",{min:v,max:T});ze({times:v<=1e-6&&T>=g-1e-6?null:[v,T]}),r=!1}function _(M,v){let{ctx:T,bbox:w}=M,g=M.valToPos(v.window_s,"x",!0),b=Math.min(Math.max(g,w.left),w.left+w.width);T.save(),T.fillStyle=Ee("settling"),T.fillRect(w.left,w.top,b-w.left,w.height),T.restore()}function y(M,v){let{ctx:T,bbox:w}=M,g=devicePixelRatio,b=-1/0;T.save(),T.font=`${10*g}px system-ui, sans-serif`,T.textAlign="left",T.fillStyle=Ee("muted"),T.strokeStyle=Ee("muted"),T.setLineDash([2*g,3*g]);let P=Dt.moment===null?[]:[[Dt.moment,""]];for(let[I,C]of[...v.notes,...P]){let U=M.valToPos(I,"x",!0);if(U<w.left||U>w.left+w.width)continue;T.beginPath(),T.moveTo(U,w.top),T.lineTo(U,w.top+w.height),T.stroke();let O=T.measureText(C).width;C&&U>b&&U+O<w.left+w.width&&(T.fillText(C,U+3*g,w.top+11*g),b=U+O+8*g)}T.restore()}function m(M){let{over:v}=M,T=()=>Je(n).history.time_s.at(-1),w=(g,b)=>{let P=Math.max(g,0),I=Math.min(b,T());I-P>.001&&M.setScale("x",{min:P,max:I})};v.addEventListener("wheel",g=>{if(!g.ctrlKey&&!g.metaKey)return;g.preventDefault();let b=M.posToVal(g.clientX-v.getBoundingClientRect().left,"x"),P=Math.exp(g.deltaY*.002);w(b+(M.scales.x.min-b)*P,b+(M.scales.x.max-b)*P)},{passive:!1}),v.addEventListener("mousedown",g=>{if(!g.shiftKey)return;g.stopImmediatePropagation();let b=g.clientX,{min:P,max:I}=M.scales.x,C=U=>{let O=(b-U.clientX)/v.clientWidth*(I-P),L=Math.min(Math.max(O,-P),T()-I);w(P+L,I+L)};addEventListener("mousemove",C),addEventListener("mouseup",()=>removeEventListener("mousemove",C),{once:!0})},{capture:!0}),v.addEventListener("dblclick",()=>M.setScale("x",{min:0,max:T()}))}we(e?"units operation depth":"units operation",c),we("times",()=>{if(r)return;let M=Je(n);if(!M)return;let[v,T]=Dt.times??[0,M.history.time_s.at(-1)];r=!0;for(let w of s)w.setScale("x",{min:v,max:T});r=!1}),we("moment",()=>s.forEach(M=>M.redraw(!1,!1)));let p=0;new ResizeObserver(()=>{if(!(fn()||i.clientWidth===p)){p=i.clientWidth;for(let M of s)M.setSize({width:zs(M.root.parentElement),height:V_})}}).observe(i);let x=W("p",{class:"hint noprint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics");return{element:W("div",{},x,i),redraw:c}}function Tl(n,t){let e=Math.min(Math.max(Ws(n,t??0),1),n.length-1);return Math.abs(n[e]-t)<Math.abs(n[e-1]-t)?e:e-1}var Ru=58,G_=96,Cu=10,H_=34,El=430,sE=700;function rE(n,t){let e=n.filter(Number.isFinite).map(Math.abs).sort((i,s)=>i-s);return e[Math.floor(t*(e.length-1))]||1}function W_(n){let t=n.contact_plots,e=t[0],i=W("canvas",{class:"map",role:"img","aria-label":"Contact over depth and time"}),s=W("p",{class:"readout-line"}," "),r=W("div",{class:"map-holder"},i),o=W("div",{class:"tools noprint"},vr("What the map shows",t.map(({column:p,title:x,sides:M})=>[p,M?`${x}, by side`:x]),e.column,p=>{e=t.find(({column:x})=>x===p),l()}),Mn("Contact over depth and time",{svg:()=>u(),csv:()=>Wn(...d())}),W("span",{class:"hint"},"follows the depths and times in view above; click to choose a depth and a time")),a=p=>({depths:Dt.depths??[0,p.contact.md_m.at(-1)],times:Dt.times??[p.contact.from_s,p.contact.time_s.at(-1)]});function l(){let p=Je(n);if(!p?.contact)return;let x=Math.max(devicePixelRatio,2),M=fn()?sE:r.clientWidth||1200;i.width=M*x,i.height=El*x,i.style.aspectRatio=`${M} / ${El}`;let v=i.getContext("2d");v.scale(x,x),v.font="11px system-ui, sans-serif",c(v,p,M,(...T)=>h(v,...T))}function c(p,x,M,v){let{depths:T,times:w}=a(x),g={left:Ru,top:Cu,width:M-Ru-G_,height:El-Cu-H_},b=rE(Array.from(x.contact.values[e.column]),.985),P=e.sides,I=so(P),C=U=>I(P?.5+.5*U/b:U/b);v(x,g,T,w,C),f(p,g,T,w,x),_(p,g,b,C)}function u(){let p=Je(n),x=1e3,M=new Yo(x,El);return M.fillStyle=Ee("paper"),M.fillRect(0,0,x,El),c(M,p,x,(v,T,...w)=>{let g=W("canvas",{width:T.width*2,height:T.height*2}),b=g.getContext("2d");b.scale(2,2),b.translate(-T.left,-T.top),h(b,v,T,...w),M.image(g.toDataURL(),T.left,T.top,T.width,T.height)}),M.file()}function d(){let{contact:p}=Je(n),{depths:x,times:M}=a(Je(n)),v=[];p.time_s.forEach((w,g)=>{w<M[0]||w>M[1]||p.md_m.forEach((b,P)=>{if(b<x[0]||b>x[1])return;let I=g*p.md_m.length+P,C=t.map(({column:U,dimension:O})=>qt(p.values[U][I],O));v.push([w,qt(b,"length"),...C])})});let T=t.map(({title:w,dimension:g})=>`${w.toLowerCase()}, ${re(g)}`);return[["time, s",`md, ${re("length")}`,...T],v]}function h(p,x,M,[v,T],[w,g],b){let{contact:P}=x,I=P.md_m.length,C=new ImageData(P.time_s.length,Math.round(M.height));for(let B=0;B<C.height;B++){let $=Tl(P.md_m,v+(B+.5)/C.height*(T-v));for(let V=0;V<C.width;V++){let[J,G,Y]=b(P.values[e.column][V*I+$]||0);C.data.set([J,G,Y,255],4*(B*C.width+V))}}let U=new OffscreenCanvas(C.width,C.height);U.getContext("2d").putImageData(C,0,0),p.save(),p.beginPath(),p.rect(M.left,M.top,M.width,M.height),p.clip(),p.imageSmoothingEnabled=!1;let O=B=>M.left+(B-w)/(g-w)*M.width,L=P.from_s;P.time_s.forEach((B,$)=>{p.drawImage(U,$,0,1,C.height,O(L),M.top,O(B)-O(L)+.5,M.height),L=B}),p.restore()}function f(p,x,[M,v],[T,w],g){let b=O=>x.top+(O-M)/(v-M)*x.height,P=O=>x.left+(O-T)/(w-T)*x.width;p.fillStyle=p.strokeStyle=Ee("muted"),p.textBaseline="middle",p.textAlign="right";let I=Rn(qt(M,"length"),qt(v,"length"),9);for(let O of I.values)p.fillText(mn(O,I.step),x.left-8,b(zn(O,"length")));p.textAlign="center",p.textBaseline="top";let C=Rn(T,w,12);for(let O of C.values)p.fillText(mn(O,C.step),P(O),x.top+x.height+6);p.fillText("time, s",x.left+x.width/2,x.top+x.height+20),p.save(),p.translate(9,x.top+x.height/2),p.rotate(-Math.PI/2),p.fillText(`MD, ${re("length")}`,0,-4),p.restore(),p.strokeStyle=Ee("frame"),p.strokeRect(x.left,x.top,x.width,x.height);let U=(O,L,B,$)=>{p.beginPath(),p.moveTo(O,L),p.lineTo(B,$),p.stroke()};p.strokeStyle=Ee("text"),p.setLineDash([4,4]),g.window_s>T&&g.window_s<w&&(U(P(g.window_s),x.top,P(g.window_s),x.top+x.height),p.textAlign="left",p.fillStyle=Ee("text"),p.fillText("window ▸",P(g.window_s)+4,x.top+4)),p.setLineDash([1,3]);for(let{kind:O,to_m:L}of n.hole)O==="casing"&&L>M&&L<v&&(U(x.left,b(L),x.left+x.width,b(L)),p.textAlign="left",p.fillStyle=Ee("text"),p.fillText("shoe",x.left+4,b(L)-13));p.setLineDash([]),Dt.depth!==null&&Dt.depth>M&&Dt.depth<v&&U(x.left,b(Dt.depth),x.left+x.width,b(Dt.depth)),Dt.moment!==null&&Dt.moment>T&&Dt.moment<w&&U(P(Dt.moment),x.top,P(Dt.moment),x.top+x.height)}function _(p,x,M,v){let T=x.left+x.width+14,w=e.sides?-M:0,g=120;for(let P=0;P<g;P++){let[I,C,U]=v(w+(P+.5)/g*(M-w));p.fillStyle=`rgb(${I} ${C} ${U})`,p.fillRect(T,x.top+x.height*(1-(P+1)/g),12,x.height/g+.6)}p.strokeStyle=Ee("frame"),p.strokeRect(T,x.top,12,x.height);let b=Rn(qt(w,e.dimension),qt(M,e.dimension),6);p.fillStyle=Ee("muted"),p.textAlign="left",p.textBaseline="middle";for(let P of b.values){let I=(zn(P,e.dimension)-w)/(M-w);p.fillText(mn(P,b.step),T+17,x.top+x.height*(1-I))}p.fillText(re(e.dimension),T,x.top+x.height+12),e.sides&&(p.save(),p.textAlign="center",p.translate(T+66,x.top+x.height*.25),p.rotate(-Math.PI/2),p.fillText("high side",0,0),p.restore(),p.save(),p.textAlign="center",p.translate(T+66,x.top+x.height*.75),p.rotate(-Math.PI/2),p.fillText("low side",0,0),p.restore())}function y(p){let x=Je(n);if(!x?.contact)return null;let M=i.getBoundingClientRect(),{depths:v,times:T}=a(x),w=(p.clientX-M.left-Ru)/(M.width-Ru-G_),g=(p.clientY-M.top-Cu)/(M.height-Cu-H_);return w<0||w>1||g<0||g>1?null:{depth:v[0]+g*(v[1]-v[0]),moment:T[0]+w*(T[1]-T[0])}}i.addEventListener("pointermove",p=>{let x=y(p);if(ze({pointer:x?.depth??null}),!x)return void(s.textContent=" ");let{contact:M}=Je(n),v=Math.min(Math.max(Array.from(M.time_s).findIndex(g=>g>=x.moment),0),M.time_s.length-1),T=M.values[e.column][v*M.md_m.length+Tl(M.md_m,x.depth)],w=!e.sides||Math.abs(T)===0?"":T>0?", high side":", low side";s.textContent=`MD ${Te(x.depth,"length",5)}, ${Tn(x.moment,4)} s: ${Te(Math.abs(T),e.dimension,3)}${w}`}),i.addEventListener("pointerleave",()=>{ze({pointer:null}),s.textContent=" "}),i.addEventListener("click",p=>{let x=y(p);x&&ze(x)}),we("units operation depths times depth moment",l);let m=0;return new ResizeObserver(()=>{r.clientWidth!==m&&(m=r.clientWidth,l())}).observe(r),{element:W("div",{},o,r,s),redraw:l}}var X_=260;function $_(n){let t=W("div",{class:"histories"}),[e,...i]=n.drill_off_plots,s=()=>`${e.title}, ${re(e.dimension)}`,r=[];function o(){r.forEach(y=>y.destroy()),r=[];let u=Je(n)?.drill_off;if(!u)return t.replaceChildren();let d=u[e.column],h=Array.from(d,(y,m)=>m).filter(y=>Number.isFinite(d[y])).sort((y,m)=>d[y]-d[m]),f=({column:y,dimension:m})=>$l(Array.from(h,p=>u[y][p]),m),_=i.map(y=>{let{heading:m,dimension:p}=y,x=W("div",{class:"plot"}),M=W("h3",{},m,W("span",{class:"unit"},` ${re(p)}`)),v=null;M.append(Mn(m,{svg:()=>la(v,`${m}, ${re(p)}`,s()),csv:()=>Wn(...ca(v,s(),re(p)))}));let T=()=>r.push(v=a(x,y,f(e),f(y)));return{element:W("figure",{class:"card history"},M,x),make:T}});t.replaceChildren(..._.map(y=>y.element));for(let y of _)y.make()}function a(u,{title:d,dimension:h,min_span:f},_,y){let m=vs(0);return new cn({width:zs(u),height:X_,cursor:{drag:{x:!0,y:!0,uni:8},points:{size:6}},legend:oa,scales:{x:{time:!1,range:(p,x,M)=>wl(x,M,e.dimension,e.min_span)},y:{range:(p,x,M)=>wl(x,M,h,f)}},axes:ra(s()),series:[{label:`weight, ${re(e.dimension)}`,value:Vs},{label:d.replace(/^./,p=>p.toLowerCase()),stroke:m,paths:()=>null,points:{show:!0,size:3.5,width:0,fill:`color-mix(in srgb, ${m} 55%, transparent)`},value:Vs}]},[_,y],u)}we("units operation",o);let l=0;new ResizeObserver(()=>{if(!(fn()||t.clientWidth===l)){l=t.clientWidth;for(let u of r)u.setSize({width:zs(u.root.parentElement),height:X_})}}).observe(t);let c=W("p",{class:"note"},"Each point is a sample of the window of the statistics.");return{element:W("div",{class:"drill-off"},t,c),redraw:o}}var Pu=class{constructor(t){this.well=t}at(t,e){let{md_m:i,north_m:s,east_m:r,tvd_m:o,high:a}=this.well,l=Math.min(Math.max(Ws(i,t),1),i.length-1),c=(t-i[l-1])/(i[l]-i[l-1]||1),u=f=>f[l-1]+c*(f[l]-f[l-1]);e.place=[u(r),-u(o),-u(s)],e.high=sp([u(a[1]),-u(a[2]),-u(a[0])]);let d=[r,o,s].map(f=>f[l]-f[l-1]),h=sp([d[0],-d[1],-d[2]]);return e.right=sp(oE(h,e.high)),e}},sp=n=>{let t=Math.hypot(...n)||1;return n.map(e=>e/t)},oE=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Al=class extends Bn{constructor(t,e){super(),this.rings=t,this.sides=e;let i=t*e;this.setAttribute("position",new ii(new Float32Array(3*i),3)),this.setAttribute("normal",new ii(new Float32Array(3*i),3)),this.setAttribute("color",new ii(new Float32Array(3*i).fill(1),3));let s=[];for(let r=0;r+1<t;r++)for(let o=0;o<e;o++){let[a,l]=[r*e+o,r*e+(o+1)%e];s.push(a,l,a+e,l,l+e,a+e)}this.setIndex(s),this.turns=Array.from({length:e},(r,o)=>[Math.cos(2*Math.PI*o/e),Math.sin(2*Math.PI*o/e)])}ring(t,e,i,s,r){let{position:o,normal:a}=this.attributes;for(let l=0;l<this.sides;l++){let[c,u]=this.turns[l],d=3*(t*this.sides+l);for(let h=0;h<3;h++){let f=c*i[h]+u*s[h];a.array[d+h]=f,o.array[d+h]=e[h]+r*f}}}paint(t,e,i,s){let{color:r}=this.attributes;for(let o=0;o<this.sides;o++)r.array.set([e,i,s],3*(t*this.sides+o))}changed(){for(let t of Object.values(this.attributes))t.needsUpdate=!0;this.computeBoundingSphere()}};function aE(n,t){let{profile:e}=t,i=e.md_m,s=e.lateral_offset_m??lE(n,e),r=cE(e);return{depths:i,high:s.map((o,a)=>-o*Math.cos(r[a])),right:s.map((o,a)=>o*Math.sin(r[a])),values:o=>e[o],has:o=>!!e[o]&&o!=="contact_force_N"}}function lE(n,t){return t.md_m.map(e=>{let i=o=>e>=o.from_m&&e<=o.to_m,s=n.hole.find(i),r=n.string.find(i);return s&&r?(s.diameter_m-r.contact_od_m)/2:0})}function cE(n){let t=[];for(let s=0;s<n.md_m.length;s++){let r=n.climb_rad?.[s];Number.isFinite(r)?t.push([n.md_m[s],Math.cos(r),Math.sin(r)]):!n.climb_rad&&n.side_force_N_per_m[s]!==0&&t.push([n.md_m[s],n.side_force_N_per_m[s]>0?-1:1,0])}if(t.length===0)return n.md_m.map(()=>0);let e=[0,1,2].map(s=>Float32Array.from(t,r=>r[s])),i=(s,r)=>{let o=$r(e[0],r,Math.min(Math.max(s,e[0][0]),e[0].at(-1)));return Number.isFinite(o)?o:0};return n.md_m.map(s=>Math.atan2(i(s,e[2]),i(s,e[1])))}function hE(n,t){let e=n.md_m.length,i=s=>n.channels[s].subarray(t*e,(t+1)*e);return{depths:n.md_m.map(s=>s+n.moved_m[t]),high:i("offset_high_m"),right:i("offset_right_m"),values:i,has:s=>!!n.channels[s]}}function rp(n,t,e){return t?.frames&&e!==null?hE(t.frames,e):aE(n,Qs(n)[0])}var op=(n,t)=>n.string_colours.filter(({column:e})=>t.has(e));function q_(n,t,e,i,s){let r=t?.frames&&e!==null?t.frames.channels[i]:n.values(i),o=Array.from(r).filter(Number.isFinite).sort((u,d)=>u-d);if(o.length===0)return[0,1];let a=u=>o[Math.round(u*(o.length-1))];if(s){let u=Math.max(Math.abs(a(.01)),Math.abs(a(.99)))||1;return[-u,u]}let[l,c]=[a(.002),a(.998)];return l<c?[l,c]:[l-.5*Math.abs(l||1),c+.5*Math.abs(c||1)]}function Y_(n,t){let e=Math.min(Math.max(Ws(n.time_s,t),1),n.time_s.length-1);return e<1?0:t-n.time_s[e-1]<n.time_s[e]-t?e-1:e}var uE=600,dE=10;function Z_(n){let t=au("The well in space, the string in it",uE);if(!t)return{element:ru(),redraw:()=>{}};let e=new Pu(n.well),i=n.well.md_m.at(-1),s=Math.max(...n.hole.map(J=>J.diameter_m),.1),r=fE(.03*i/s),o=null,a=null,l=null,c=W("div",{class:"colour-key"}),u=W("output",{}),d=W("input",{type:"range",min:0,step:1,"aria-label":"Moment",oninput:()=>{let J=Je(n);ze({moment:J.frames.time_s[Number(d.value)]})}}),h=W("button",{type:"button",onclick:()=>l?w():T()},"Play"),f=W("button",{type:"button",onclick:()=>{w(),ze({moment:null})}},"Mean"),_=W("div",{class:"moments"},h,f,d,u),y=W("output",{}),m=W("input",{type:"range",min:0,max:3.7,step:.01,value:Math.log10(r),"aria-label":"Exaggeration across the hole",oninput:()=>{r=10**Number(m.value),P()}}),p=W("span",{}),x=[["From the side",()=>B(.02)],["From above",()=>[.001,1,.001]]].map(([J,G])=>W("button",{type:"button",onclick:()=>$(G())},J)),M=()=>{ze({depths:null}),$(B(.3))};x.unshift(W("button",{type:"button",onclick:M},"Whole well"));let v=W("div",{class:"tools noprint"},p,W("label",{},"Across × ",m,y),x,Mn("The well in space",{png:()=>t.canvas,csv:()=>Wn(...O())}),W("span",{class:"hint"},`${ou}; shows the depths in view above`));function T(){h.textContent="Stop",l=setInterval(()=>{let{frames:J}=Je(n),G=(Number(d.value)+1)%J.time_s.length;ze({moment:J.time_s[G]})},80)}function w(){clearInterval(l),l=null,h.textContent="Play"}let g=()=>Dt.depths??[n.well.md_m[0],i];function b([J,G]){let Y=Array.from(n.well.md_m).filter(rt=>rt>J&&rt<G),et=(G-J)/300;return[...Array.from({length:301},(rt,K)=>J+K*et),...Y].sort((rt,K)=>rt-K)}function P(){t.remove();let[J,G]=g(),Y={};for(let et of n.hole){let lt=[Math.max(et.from_m,J),Math.min(et.to_m,G)];if(lt[1]<=lt[0])continue;let rt=b(lt),K=new Al(rt.length,28);rt.forEach((yt,_t)=>{e.at(yt,Y),K.ring(_t,Y.place,Y.high,Y.right,et.diameter_m/2*r)}),K.changed();let ut=et.kind==="casing",pt=new Ns({color:Ee(ut?"casing":"rock"),transparent:!0,opacity:ut?.16:.26,side:li,depthWrite:!1});t.add(new qn(K,pt)).renderOrder=2}t0(e,[J,G],s/2*r,B(.3)).forEach(t.add),U(),y.textContent=` ${Tn(r,2)}`,t.render()}let I=null,C=null;function U(){let J=Je(n);a=J?.frames&&Dt.moment!==null?Y_(J.frames,Dt.moment):null;let G=rp(n,J,a),Y=op(n,G);Y.some(({column:he})=>he===o)||(o=Y[0].column);let{title:et,dimension:lt,signed:rt}=Y.find(({column:he})=>he===o);p.replaceChildren(Fl("Colour: ",Y.map(({column:he,title:Ce})=>[he,Ce]),o,he=>{o=he,U(),t.render()}));let[K,ut]=g(),pt=Array.from(G.depths,(he,Ce)=>[he,Ce]).filter(([he])=>he>=K-1&&he<=ut+1);(!I||C.geometry!==I||I.rings!==pt.length)&&(C&&t.remove([C]),I=new Al(Math.max(pt.length,2),dE),C=t.add(new qn(I,new Ns({vertexColors:!0})))),t.has(C)||t.add(C);let yt=G.values(o),_t=q_(G,J,a,o,rt),Wt=so(rt),oe=he=>Wt((he-_t[0])/(_t[1]-_t[0])).map(Ce=>Ce/255),Ot={},ce=new fe,ue=n.string;pt.forEach(([he,Ce],Pe)=>{e.at(Math.min(he,i),Ot);let[gn,ve]=[G.high[Ce]*r||0,G.right[Ce]*r||0],hn=Ot.place.map((Yt,ie)=>Yt+gn*Ot.high[ie]+ve*Ot.right[ie]),Qe=ue.find(Yt=>he<=Yt.to_m)??ue.at(-1);I.ring(Pe,hn,Ot.high,Ot.right,(Qe?.od_m??.12)/2*r);let[sn,k,Rt]=Number.isFinite(yt[Ce])?oe(yt[Ce]):[.5,.5,.5];ce.setRGB(sn,k,Rt,"srgb"),I.paint(Pe,ce.r,ce.g,ce.b)}),I.changed();let ne=re(lt)?`, ${re(lt)}`:"",We=rt?" (low side −, high side +)":"";c.replaceChildren(...tu(`${et}${ne}${We}, ${Hn(Dt.operation)}`,lt,_t,Wt)),_.hidden=!J?.frames,J?.frames&&(d.max=J.frames.time_s.length-1,a!==null&&(d.value=a),f.disabled=a===null,u.textContent=a===null?"mean of the window":`${J.frames.time_s[a].toFixed(2)} s`)}function O(){let J=rp(n,Je(n),a),{title:G,dimension:Y}=op(n,J).find(({column:K})=>K===o),et=J.values(o),lt=[`md, ${re("length")}`,`to the high side, ${re("diameter")}`,`to the right, ${re("diameter")}`,`${G}, ${re(Y)}`],rt=Array.from(J.depths,(K,ut)=>[qt(K,"length"),qt(J.high[ut],"diameter"),qt(J.right[ut],"diameter"),qt(et[ut],Y)]);return[lt,rt]}function L(){let[J,G]=g();return Array.from({length:41},(Y,et)=>e.at(J+(G-J)*et/40,{}).place)}function B(J){let[G,Y]=g().map(ut=>e.at(ut,{}).place),[et,lt]=[Y[0]-G[0],Y[2]-G[2]],rt=Math.hypot(et,lt);if(rt<.001)return[.6,J,.8];let K=et-lt<0?-1:1;return[-lt/rt*K,J,et/rt*K]}function $(J){let{low:G,high:Y}=xf(e,g()),et=G.clone().add(Y).multiplyScalar(.5),rt=[...yf({low:G,high:Y},B(.3)).flatMap(([K,ut])=>[G.y,Y.y].map(pt=>[K,pt,ut])),...L()];t.lookAt(rt,J,et,[84,16]),t.holder.dataset.spans=t.spans(rt).map(K=>K.toFixed(2)).join(" ")}function V(){t.size(),P(),$(B(.3))}return we("units operation",()=>{w(),P()}),we("depths",()=>{P(),$(t.from().toArray())}),we("moment",()=>{U(),t.render()}),{element:W("div",{},v,t.holder,_,c),redraw:V}}function fE(n){let t=10**Math.floor(Math.log10(Math.max(n,1)));return[5,2,1].map(e=>e*t).find(e=>e<=Math.max(n,1))??1}var J_=260;function pE(n){let t=re(n);return t===""?"1/Hz":/^\p{L}+$/u.test(t)?`${t}²/Hz`:`(${t})²/Hz`}function K_(n){let t=W("div",{class:"histories"}),e=[];function i(){let c=new Map;for(let u of Je(n)?.spectra??[]){let d=`${u.signal} ${u.md_m!==null}`;c.has(d)||c.set(d,[]),c.get(d).push(u)}return[...c.values()]}function s(){e.forEach(u=>u.destroy()),e=[];let c=i().map(r);t.replaceChildren(...c.map(u=>u.element));for(let u of c)e.push(u.make())}function r(c){let[{signal:u,dimension:d,md_m:h}]=c,f=c.length===1&&h!==null?` at ${Te(h,"length",5)}`:"",_=`Density of ${Hn(u)}${f}`,y=pE(d),m=W("div",{class:"plot"}),p=null,x=W("h3",{},_,W("span",{class:"unit"},` ${y}`),Mn(_,{svg:()=>la(p,`${_}, ${y}`,"Frequency, Hz"),csv:()=>Wn(...ca(p,"frequency, Hz",y))})),M=()=>p=o(m,c,d,`${Je(n).operation} ${u}`);return{element:W("figure",{class:"card history"},x,m),make:M}}function o(c,u,d,h){let f=Array.from(u[0].frequency_Hz).slice(1),_=d?qt(1,d)**2:1,y=u.map(C=>Array.from(C.density).slice(1).map(U=>U>0?U*_:null)),m=u.length===1&&u[0].md_m===null,p=y.flat().filter(C=>C!==null),x=Math.max(...p),M=Math.max(Math.min(...p),x*1e-9),[v,T]=ra("Frequency, Hz"),w=Math.max(Math.ceil(Math.log10(x/M)/6),1),g=C=>Math.abs(Math.log10(C)-Math.round(Math.log10(C)))<1e-6,b=(C,U)=>U.map(O=>g(O)&&Math.round(Math.log10(O))%w===0?O:null),P=(C,U)=>b(C,U).map(O=>O===null?"":`1e${Math.round(Math.log10(O))}`),I=new cn({width:zs(c),height:J_,cursor:{drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:oa,scales:{x:{time:!1,distr:3,range:(C,U,O)=>[U,O]},y:{distr:3,range:()=>[M/1.5,x*1.5]}},axes:[{...v,grid:{...v.grid,filter:b},values:(C,U)=>U.map(O=>O===null?"":String(Number(O.toPrecision(3))))},{...T,grid:{...T.grid,filter:b},values:P}],series:[{label:"frequency, Hz",value:Vs},...u.map((C,U)=>({label:m?Hn(C.signal):`at ${Te(C.md_m,"length",5)}`,stroke:vs(U),dash:Mr(U)??void 0,width:1.4,points:{show:!1},value:Vs}))]},[f,...y],c);return Eu(I,`spectrum ${h}`),I}we("units operation",s);let a=0;new ResizeObserver(()=>{if(!(fn()||t.clientWidth===a)){a=t.clientWidth;for(let c of e)c.setSize({width:zs(c.root.parentElement),height:J_})}}).observe(t);let l=W("p",{class:"hint noprint"},"of the window of the statistics; drag to zoom, double-click for all");return{element:W("div",{},l,t),redraw:s}}var j_=4;function Q_({cover:n,band:t,picture:e,head:i,height:s,total:r,full:o,view:a,zoom:l}){let c=f=>{let[_,y]=a();return i+(f-_)/(y-_)*s},u=f=>{let _=e.getBoundingClientRect(),[y,m]=a(),p=(f.clientY-_.top)/_.height*r;return y+(p-i)/s*(m-y)},d=null;function h(f){let[_,y]=a(),m=r/e.getBoundingClientRect().height*(y-_)/s,p=x=>{let M=(f.clientY-x.clientY)*m,v=Math.min(Math.max(M,o[0]-_),o[1]-y);l([_+v,y+v])};addEventListener("pointermove",p),addEventListener("pointerup",()=>removeEventListener("pointermove",p),{once:!0})}n.addEventListener("pointerdown",f=>{if(f.button===0){if(f.shiftKey)return h(f);d={depth:u(f),y:f.clientY},n.setPointerCapture(f.pointerId)}}),n.addEventListener("pointermove",f=>{let _=u(f);if(d&&Math.abs(f.clientY-d.y)>j_){let y=[c(d.depth),c(_)].sort((m,p)=>m-p);t.setAttribute("y",y[0]),t.setAttribute("height",y[1]-y[0]),t.setAttribute("visibility","visible")}ze({pointer:_})}),n.addEventListener("pointerup",f=>{if(!d)return;let{depth:_,y}=d;d=null,t.setAttribute("visibility","hidden"),Math.abs(f.clientY-y)>j_?l([_,u(f)]):ze({depth:Math.min(Math.max(_,o[0]),o[1])})}),n.addEventListener("pointerleave",()=>ze({pointer:null})),n.addEventListener("dblclick",()=>l(o)),n.addEventListener("wheel",f=>{if(!f.ctrlKey&&!f.metaKey)return;f.preventDefault();let _=u(f),y=Math.exp(f.deltaY*.002);l(a().map(m=>_+(m-_)*y))},{passive:!1})}var mE=5,tx=n=>n.kind==="casing"?"casing":"open hole";function ex(n,t){let e=r=>t>=r.from_m&&t<=r.to_m,i=n.hole.find(e),s=n.string.find(e);return[i&&`${tx(i)} ${Te(i.diameter_m,"diameter")}`,s&&`${s.name} ${Te(s.od_m,"diameter")}`].filter(Boolean)}function nx(n,{left:t,width:e,top:i,height:s},[r,o],a){let l=t+e/2,c=Math.max(...n.hole.map(y=>y.diameter_m),...n.string.map(y=>y.contact_od_m)),u=y=>(e-22)/2*(y/c),d=Pt("g",{"clip-path":"inset(0)"}),h=y=>Math.min(Math.max(a(y),i-12),i+s+12);for(let y of n.hole){if(y.to_m<r||y.from_m>o)continue;let[m,p,x]=[h(y.from_m),h(y.to_m),u(y.diameter_m)],M=Pt("title",{},`${tx(y)} ${Te(y.diameter_m,"diameter")}, ${Te(y.from_m,"length",5)} to ${Te(y.to_m,"length",5)}, friction ${y.friction}`);d.append(Pt("rect",{x:l-x,y:m,width:2*x,height:Math.max(p-m,0),class:y.kind==="casing"?"bore":"rock"},M));for(let v of[-1,1]){let T=l+v*x;d.append(Pt("line",{x1:T,x2:T,y1:m,y2:p,class:y.kind==="casing"?"casing":"wall"})),y.kind==="casing"&&y.to_m<o&&d.append(Pt("path",{d:`M${T} ${p}h${v*8}L${T} ${p-9}Z`,class:"shoe"}))}}let f=n.string.at(-1),_=f&&f.to_m-f.from_m<mE?f:null;for(let y of n.string){if(y.to_m<r||y.from_m>o)continue;let[m,p,x]=[h(y.from_m),h(y.to_m),Math.max(u(y.od_m),1.5)],M=Pt("title",{},`${y.name}, OD ${Te(y.od_m,"diameter")}, ${Te(y.from_m,"length",5)} to ${Te(y.to_m,"length",5)}`),v=/pipe/i.test(y.name)&&!/heavy/i.test(y.name)?"pipe":"tool",T=y===_?Pt("path",{d:`M${l-x} ${Math.min(m,p-5)}h${2*x}v${Math.max(p-m,5)*.5}L${l} ${p+3}L${l-x} ${p-Math.max(p-m,5)*.5}Z`,class:"bit"}):Pt("rect",{x:l-x,y:m,width:2*x,height:Math.max(p-m,.7),class:v});T.append(M),d.append(T)}return d}var ix=n=>n.map(t=>-t);function gE({depths:n,values:t,low:e,high:i},{joint_reach_m:s,min_difference:r}){let o=z_(n,t,s),a=h=>h&&Float32Array.from(o,f=>h[f]),l={values:a(t),low:a(e),high:a(i)},c=ix(np(n,ix(t),s)),u=l.values.reduce((h,f)=>Math.max(h,Math.abs(f)),0);return c.some((h,f)=>Math.abs(h-l.values[f])>r*u)?{...l,between:c}:l}function _E(n,t){if(t.from==="well"){let e=n.well[t.column];return e.length?[{depths:n.well.md_m,values:e,well:!0}]:[]}return n.solved.flatMap(e=>{let i=t.from==="wear"?e.wear:e.profile,s=i[t.column];if(!s)return[];let r=i.md_m,[o,a]=(t.band??[]).map(c=>i[c]),l={solved:e,depths:r,values:s,low:o,high:a};return t.touches&&(l.values=np(r,s,n.rules.joint_reach_m)),t.swings&&(l.far=gE(l,n.rules)),[l]})}var sx=n=>n.tracks.map(t=>({...t,curves:_E(n,t)})).filter(t=>t.curves.length),ap=(n,t)=>Math.abs(t)<1e-4*n.min_span?0:t,Rl=n=>n.well||!Dt.hidden.has(zl(n.solved));function rx(n,t,[e,i]){let s=i-e>n.rules.far_m;return t.curves.filter(Rl).map(r=>s&&r.far?{...r,...r.far}:r)}function ox(n,t){let e=n.solved.map(a=>{let{colour:l,dash:c,shape:u,hollow:d}=js(n,a),h=zl(a),f=Dt.hidden.has(h),_=Vl(n,a);return W("button",{type:"button",class:"key","aria-pressed":String(!f),title:f?`Show ${_}`:`Hide ${_}`,onclick:()=>{let y=new Set(Dt.hidden);y.delete(h)||y.add(h),ze({hidden:y}),document.querySelector(`.legend [data-curve="${h}"]`)?.focus()},"data-curve":h},Pt("svg",{width:30,height:12},Pt("line",{x1:1,x2:29,y1:6,y2:6,stroke:l,class:"curve","stroke-dasharray":c?.join(" ")}),u&&Pt("path",{d:u,transform:"translate(15 6)",fill:d?"var(--paper)":l,stroke:d?l:"var(--paper)",class:"marker"})),_)}),i=[...new Set(ro(n).map(a=>a.level))].reverse().map(a=>W("span",{class:"key"},Pt("svg",{width:20,height:12},Pt("rect",{width:20,height:12,class:`found level-${a}`}),Pt("rect",{x:15,width:5,height:12,class:`found-bar level-${a}`})),`${Bi[a][0].toLowerCase()} here, ${Hn(Dt.operation)}`)),s=n.runs.length?[W("span",{class:"key"},Pt("svg",{width:26,height:10},Pt("rect",{width:26,height:10,fill:"var(--muted)",class:"band"})),"5–95 % of the time")]:[],r=t?[W("span",{class:"key"},Pt("svg",{width:30,height:12},Pt("line",{x1:1,x2:29,y1:6,y2:6,stroke:"var(--muted)",class:"curve between"})),"between the joints")]:[],o=["high","low"].map(a=>W("span",{class:"key"},Pt("svg",{width:14,height:10},Pt("rect",{width:14,height:10,class:`${a}-side`})),`on the ${a} side`));return[...e,...r,...s,...o,...i]}function cx(n,t,{tail:e,times_as_long:i,fewest:s}){let r=Float64Array.from(n.filter(Number.isFinite)).sort(),o=r.length-1;if(o<0)return[1/0,-1/0];let a=[r[0],r[o]];if(r.length<s)return a;let l=Math.ceil(e*r.length),[c,u]=[r[l],r[o-l]];t&&([c,u]=[Math.min(c,0),Math.max(u,0)]);let d=(i-1)*(u-c);return d===0?a:[r.find(h=>c-h<=d),r.findLast(h=>h-u<=d)]}var ax=7,lx=4;function hx(n,t,e,i,s,r){return[-1,1].flatMap(o=>{let a=d=>o>0?d>e[1]:d<e[0],l=o>0?i.left+i.width:i.left,c=[],u=null;for(let{depths:d,columns:h,colour:f}of n){let[_,y]=Xr(d,s);for(let m of h){let p=null;for(let x=_;x<=y;x++){let M=x<y&&a(m[x])&&d[x]>=s[0]&&d[x]<=s[1];if(M&&(p===null||o*m[x]>o*m[p])&&(p=x),M||p===null)continue;let v=r(d[p]),T=l-o*ax,w=`M${l} ${v}L${T} ${v-lx}V${v+lx}Z`;c.push(Pt("path",{d:w,fill:f,class:"beyond"})),(!u||o*m[p]>o*u.value)&&(u={value:m[p],at:v}),p=null}}}if(u){let d=Math.min(Math.max(u.at,i.top+8),i.top+i.height-8),h={x:l-o*(ax+3),y:d+4,class:`beyond-value${o>0?" end":""}`};c.push(Pt("text",h,Tn(qt(u.value,t))))}return c})}var ux=5,dx=n=>n.from==="profile"&&!n.range;function xE(n,t,e,i){let s=e.flatMap(o=>[o.values,o.low,o.high,o.between].filter(Boolean).map(a=>[o.depths,a])),r=dx(t)?cx(s.flatMap(([o,a])=>Array.from(a.slice(...Xr(o,i)))),t.zero,n.rules.outliers):s.map(([o,a])=>k_(o,a,i)).reduce(([o,a],l)=>[Math.min(o,l[0]),Math.max(a,l[1])],[1/0,-1/0]);return jg(...r,t.zero||t.sides,zn(1,t.dimension),t.min_span)}function fx(n,t,e,i,[s,r],o){let a=[s,r],l=rx(n,e,a),c=e.range??xE(n,e,l,a),u=y=>i.left+(y-c[0])/(c[1]-c[0])*i.width,d=Pt("svg",{x:i.left,y:i.top,width:i.width,height:i.height,viewBox:`${i.left} ${i.top} ${i.width} ${i.height}`}),h=Kg(qt(c[0],e.dimension),qt(c[1],e.dimension),i.width);for(let y of h.values){let m=u(zn(y,e.dimension)),p=gf(m-i.left,i.width);t.append(Pt("line",{x1:m,x2:m,y1:i.top,y2:i.top+i.height,class:y===0?"zero":"grid"}),Pt("text",{x:m,y:i.top-7,class:`tick ${p}`},mn(y,h.step)))}for(let y of n.hole.filter(m=>m.kind==="casing"&&m.to_m>s&&m.to_m<r))d.append(Pt("line",{x1:i.left,x2:i.left+i.width,y1:o(y.to_m),y2:o(y.to_m),class:"shoe-depth"}));vE(n,d,i,a,o),e.sides&&ME(n,d,e,a,u,o);for(let y of l){let{colour:m,dash:p,shape:x,place:M,hollow:v}=y.well?{colour:"var(--text)"}:js(n,y.solved),T=!y.well&&Sr(n).length>1&&y.solved.operation!==Dt.operation;y.low&&y.high&&d.append(Pt("path",{d:Au(y.depths,y.low,y.high,a,u,o),fill:m,class:T?"band faint":"band"})),d.append(Pt("path",{d:ep(y.depths,y.values,a,u,o),stroke:m,class:`curve${T?" faint":""}`,"stroke-dasharray":p?.join(" ")})),y.between&&d.append(Pt("path",{d:ep(y.depths,y.between,a,u,o),stroke:m,class:`curve between${T?" faint":""}`})),x&&d.append(...yE(n,y,{colour:m,shape:x,place:M,hollow:v,faint:T},a,u,o))}e.touches&&SE(n,d,e,i,a,o);let f=i.left+i.width/2;if(t.append(d,Pt("rect",{x:i.left,y:i.top,width:i.width,height:i.height,class:"frame"}),Pt("text",{x:f,y:16,class:"title middle"},e.title),Pt("text",{x:f,y:31,class:"unit middle"},re(e.dimension))),e.sides&&t.append(Pt("text",{x:i.left,y:i.top+i.height+14,class:"side low"},"◂ low side"),Pt("text",{x:i.left+i.width,y:i.top+i.height+14,class:"side high end"},"high side ▸")),l.some(y=>y.between)&&t.append(Pt("text",{x:i.left,y:i.top+i.height+14,class:"side"},"··· between joints")),dx(e)){let y=x=>[x.values,x.between].filter(Boolean),m=x=>x.well?"var(--text)":js(n,x.solved).colour,p=l.map(x=>({depths:x.depths,columns:y(x),colour:m(x)}));t.append(...hx(p,e.dimension,c,i,a,o))}e.touches&&t.append(Pt("text",{x:i.left,y:i.top+i.height+14,class:"side"},"▌ always ",Pt("tspan",{class:"sometimes"},"▌")," at times"));let _=Pt("text",{x:f,y:48,class:"readout middle"});return t.append(_),{text:_,curves:l}}function yE(n,t,{colour:e,shape:i,place:s,hollow:r,faint:o},[a,l],c,u){let d=h=>(h+(s+(r?1.5:1))/(Sr(n).length+1.5))/ux;return Array.from({length:ux},(h,f)=>a+d(f)*(l-a)).map(h=>[h,$r(t.depths,t.values,h)]).filter(([h,f])=>Number.isFinite(f)&&h<=t.depths.at(-1)).map(([h,f])=>Pt("path",{d:i,transform:`translate(${c(f).toFixed(1)} ${u(h).toFixed(1)})`,fill:r?"var(--paper)":e,stroke:r?e:"var(--paper)",class:`marker${o?" faint":""}`}))}function vE(n,t,e,[i,s],r){for(let{level:o,md_m:a,to_md_m:l}of ro(n)){if(a>s||(l??a)<i)continue;let[c,u]=[r(a),r(l??a)],d=Math.max(u-c,2),h={y:c,height:d},f=l!==null;if(f&&t.append(Pt("rect",{x:e.left,width:e.width,...h,class:`found level-${o}`})),t.append(Pt("rect",{x:e.left+e.width-5,width:5,...h,class:`found-bar level-${o}`})),o!=="error"&&f)for(let _=c+6;_<u;_+=o==="warning"?10:6)t.append(Pt("rect",{x:e.left+e.width-5,width:5,y:_,height:3,fill:"var(--paper)"}))}}function ME(n,t,e,i,s,r){let o=Qs(n)[0],a=e.curves.find(u=>u.solved===o);if(!a||!Rl(a))return;let l=new Float32Array(a.values.length),c=u=>a.values.map(d=>u(d)?d:0);t.append(Pt("path",{d:Au(a.depths,l,c(u=>u>0),i,s,r),class:"high-side"}),Pt("path",{d:Au(a.depths,c(u=>u<0),l,i,s,r),class:"low-side"}))}function SE(n,t,e,i,s,r){let o=Np(n),a=e.curves.find(h=>h.solved===o);if(!a)return;let l=h=>h<.01?0:h<=.99?1:2,c=0,{depths:u,values:d}=a;for(let h=1;h<=d.length;h++){if(h<d.length&&l(d[h])===l(d[c]))continue;let f=l(d[c]),[_,y]=[r(u[c]),r(u[Math.min(h,d.length-1)])];f>0&&y>i.top&&_<i.top+i.height&&t.append(Pt("rect",{x:i.left,y:_,width:6,height:Math.max(y-_,.7),class:f===2?"always":"sometimes"})),c=h}}var bE=700,wE=126,TE=120,Ni=54,Cl=88,Pl=14,Xs=82,EE=20;function px(n){let t=sx(n),e=Math.max(n.well.md_m.at(-1)??0,...n.solved.map(w=>w.profile.md_m?.at(-1)??0)),i=[0,e],s=()=>Dt.depths??i,r=W("div",{class:"tracks"}),o=[],a=["from","to"].map((w,g)=>W("input",{type:"number","aria-label":`Depths in view, ${w}`,step:"any",onchange:b=>{let P=[...s()];P[g]=zn(Number(b.target.value),"length"),f(P)}})),l=W("span",{}),c=W("button",{type:"button",onclick:()=>f(i)},"All depths"),u=W("div",{class:"tools noprint"},W("label",{},"Depths from ",a[0]),W("label",{},"to ",a[1]),l,c,Mn("Along the hole",{svg:()=>oo(o.map(w=>w.picture)),csv:()=>Wn(...d())}),W("span",{class:"hint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all"));function d(){let[w,g]=s(),b=t.flatMap(P=>P.curves.filter(Rl).flatMap(I=>{let{solved:C,depths:U,values:O,low:L,high:B}=I,$=(J,G)=>J?qt(J[G],P.dimension):null,V=C?[C.operation,C.model]:["",""];return Array.from(U,(J,G)=>[J,G]).filter(([J])=>J>=w&&J<=g).map(([J,G])=>[P.title,re(P.dimension),...V,qt(J,"length"),$(O,G),$(L,G),$(B,G)])}));return[["quantity","unit","operation","model",`md, ${re("length")}`,"value","p05","p95"],b]}function h({md_m:w,to_md_m:g}){let b=Math.max((g??w)-w,.02*e);f([w-.1*b,(g??w)+.1*b]),r.scrollIntoView({block:"nearest"})}function f([w,g]){let[b,P]=[Math.max(Math.min(w,g),i[0]),Math.min(Math.max(w,g),i[1])];P-b>=2&&ze({depths:b<=i[0]&&P>=i[1]?null:[b,P]})}function _(){let w=fn()?bE:r.clientWidth||1360,g=fn()?TE:wE,b=Math.max(Math.floor((w-Ni-Cl-Pl)/(g+Pl)),1),P=Math.ceil(t.length/Math.min(b,t.length)),I=Math.ceil(t.length/P),C=P===1?640:fn()?370:500;o=Array.from({length:P},(L,B)=>y(t.slice(B*I,(B+1)*I),w,I,C)),r.replaceChildren(...o.map(L=>L.picture));let[U,O]=s();a[0].value=qt(U,"length").toFixed(1),a[1].value=qt(O,"length").toFixed(1),l.textContent=re("length"),c.disabled=Dt.depths===null,x()}function y(w,g,b,P){let[I,C]=s(),U=pt=>Xs+(pt-I)/(C-I)*P,O=Xs+P+EE,L=Pt("svg",{viewBox:`0 0 ${g} ${O}`,width:g,height:O,role:"img","aria-label":w.map(pt=>pt.title).join(", ")}),B=Ni+Cl+Pl,$=(g-B-Pl*(b-1)-2)/b;m(L,[I,C],U,g,B);let V={left:Ni,width:Cl,top:Xs,height:P},J=Pt("svg",{x:0,y:Xs-10,width:g,height:P+18,viewBox:`0 ${Xs-10} ${g} ${P+18}`});J.append(nx(n,V,[I,C],U)),L.append(J,Pt("text",{x:Ni+Cl/2,y:16,class:"title middle"},"Hole, string"));let G=w.map((pt,yt)=>{let _t={left:B+yt*($+Pl),width:$,top:Xs,height:P};return{track:pt,box:_t,...fx(n,L,pt,_t,[I,C],U)}}),Y=Pt("line",{x1:Ni,x2:g,class:"cursor",visibility:"hidden"}),et=Pt("line",{x1:Ni,x2:g,class:"chosen",visibility:"hidden"}),lt=Pt("text",{x:2,class:"flag",visibility:"hidden"}),rt=Pt("g",{class:"readout"}),K=Pt("rect",{x:Ni,width:g-Ni,class:"drag",visibility:"hidden"}),ut=Pt("rect",{x:Ni,y:Xs,width:g-Ni,height:P,class:"cover"});return L.append(K,et,Y,lt,rt,ut),ut.addEventListener("pointermove",pt=>p(pt,L,G,[I,C],P)),ut.addEventListener("pointerleave",Ma),Q_({cover:ut,band:K,picture:L,head:Xs,height:P,total:O,full:i,view:s,zoom:f}),{picture:L,y:U,readouts:G,cursor:Y,chosenLine:et,flag:lt,what:rt}}function m(w,[g,b],P,I,C){let{values:U,step:O}=Rn(qt(g,"length"),qt(b,"length"),12);for(let L of U){let B=P(zn(L,"length"));w.append(Pt("line",{x1:C,x2:I,y1:B,y2:B,class:"grid"}),Pt("text",{x:Ni-8,y:B+4,class:"tick end"},mn(L,O)))}w.append(Pt("text",{x:0,y:16,class:"title"},"MD"),Pt("text",{x:0,y:31,class:"unit"},re("length")))}function p(w,g,b,[P,I],C){let U=g.getBoundingClientRect(),O=g.viewBox.baseVal.width/U.width,L=(w.clientX-U.left)*O,B=P+((w.clientY-U.top)*O-Xs)/C*(I-P),$=b.find(({box:G})=>L>=G.left&&L<=G.left+G.width),V=($?.curves??[]).flatMap(G=>{let Y=G.well?"well":Vl(n,G.solved),et=(lt,rt)=>{let K=ap($.track,$r(G.depths,lt,B));return{colour:G.well?"var(--text)":js(n,G.solved).colour,text:`${Y}${rt}: ${Number.isFinite(K)?Te(K,$.track.dimension):"–"}`,class:!G.well&&G.solved.operation===Dt.operation?"mine":null}};return G.between?[et(G.values,", at the joints"),et(G.between,", between the joints")]:[et(G.values,"")]}),J=.006*(I-P);for(let G of ro(n).reverse()){let{level:Y,kind:et,md_m:lt,to_md_m:rt}=G;if(B<lt-J||B>(rt??lt)+J)continue;let[K,ut]=Bi[Y];V.push({colour:`var(--${ut})`,text:`${K}: ${Vp(et)}`})}if(V.length===0)return Ma();Zl(w,[$?.track.title,`MD ${Te(B,"length",5)}`].filter(Boolean).join(", "),V)}function x(){let[w,g]=s();for(let{y:b,readouts:P,cursor:I,chosenLine:C,flag:U,what:O}of o){let L=($,V)=>{let J=V!==null&&V>=w&&V<=g;if($.setAttribute("visibility",J?"visible":"hidden"),J)for(let G of["y1","y2"])$.setAttribute(G,b(V));return J};L(C,Dt.depth);let B=L(I,Dt.pointer);U.setAttribute("visibility",B?"visible":"hidden"),U.setAttribute("y",B?b(Dt.pointer)+4:0),U.textContent=B?Tn(qt(Dt.pointer,"length"),5):"",O.replaceChildren(...(B?ex(n,Dt.pointer):[]).map(($,V)=>Pt("text",{x:Ni+Cl/2,y:34+13*V,class:"readout middle small"},$.length>24?`${$.slice(0,23)}…`:$)));for(let{track:$,curves:V,text:J}of P)J.replaceChildren(...B?M($,V):[])}}function M(w,g){return g.filter(P=>P.well||P.solved.operation===Dt.operation).map((P,I)=>{let C=ap(w,$r(P.depths,P.values,Dt.pointer)),U=P.well?"var(--text)":js(n,P.solved).colour;return Pt("tspan",{fill:U,dx:I?6:0},Number.isFinite(C)?Tn(qt(C,w.dimension)):"–")})}let v=W("div",{class:"legend"}),T=()=>{_();let w=o.some(g=>g.readouts.some(({curves:b})=>b.some(P=>P.between)));v.replaceChildren(...ox(n,w))};return we("units depths operation hidden",T),we("pointer depth",x),new ResizeObserver(()=>!fn()&&r.clientWidth!==Number(o[0]?.picture.getAttribute("width"))&&_()).observe(r),{element:W("div",{},v,u,r),redraw:T,full:i,zoomTo:h}}function AE(n){let t=ql(n);if(!t.length||t[0].level==="note")return null;let e=t.filter(s=>s.level===t[0].level).map(s=>s.solved.operation),i=s=>e.filter(r=>r===s).length;return e.reduce((s,r)=>i(r)>i(s)?r:s)}function RE(n,t){let e=va(n,t).filter(s=>s.level!=="note"),i=e.length?`${Hn(t)}: ${Ol(e)}`:null;return[t,[Hn(t),...Pp(e)],i]}function mx(n){let t=Sr(n),e=n.runs.at(-1);Object.assign(Dt,{operation:AE(n)??e?.operation??t.at(-1),depth:(n.well.md_m.at(-1)??0)/2});let i={keyResults:Kp(n),tracks:px(n)};i.findings=Gp(n,i.tracks.zoomTo),n.runs.length&&(i.history=ip(n,n.time_plots,!0),i.contact=W_(n)),n.runs.some(f=>f.drill_off)&&(i.bit=ip(n,n.bit_plots,!1),i.drillOff=$_(n)),n.runs.some(f=>f.spectra.length)&&(i.spectra=K_(n)),n.runs.some(f=>f.bottom)&&(i.bottom=cu(()=>Je(n)?.bottom,!0)),n.well.md_m.length>1&&(i.scene=Z_(n));let s=(f,_,...y)=>W("section",{id:f},W("h2",{},_),y),r=f=>n.page_tables.filter(_=>_.place===f).map(rs);function o(f){let _=f.history.time_s.length,y=_<f.samples?`${f.samples} samples are drawn as ${_}, the smallest and the largest of each few: peaks keep their height`:`all ${f.samples} samples are drawn`,{frames:m}=f,p=m&&(m.time_s.length<m.kept?`; ${m.time_s.length} of ${m.kept} frames`:`; all ${m.kept} frames`),x=m&&m.md_m.length<m.nodes?`, ${m.md_m.length} of ${m.nodes} nodes`:"";return`${Hn(f.operation)}: ${y}${p??""}${x}.`}let a=document.getElementById("page"),l=t.length>1?vr("Operation",t.map(f=>RE(n,f)),Dt.operation,f=>ze({operation:f,times:null,moment:null})):null;a.append(uo(n.title,lo(n),()=>Object.values(i).forEach(f=>f.redraw())),s("answer","Answer",i.findings.element,l&&W("div",{class:"operations"},l),i.keyResults.element),s("tracks","Along the hole",i.tracks.element));let c=[],u=(f,..._)=>c.push([s(..._),f]);if(i.history&&u(f=>f,"history","In time",i.history.element),i.spectra&&u(f=>f?.spectra.length,"spectra","Spectra",i.spectra.element),i.bit&&u(f=>f?.drill_off,"bit","Bit",i.bit.element,i.drillOff.element),i.bottom){let f=W("p",{class:"note"},"As the operation left it.");u(_=>_?.bottom,"bottom","Bottom of the hole",i.bottom.element,f)}i.contact&&u(f=>f,"contact","Contact over depth and time",i.contact.element),a.append(...c.map(([f])=>f)),i.scene&&a.append(s("scene","In space",i.scene.element)),a.append(s("results","All numbers",r("results")),...n.runs.length?[s("numerics","Numerics",r("numerics"))]:[],s("inputs","Inputs, defaults included",r("inputs")),W("footer",{},W("p",{},`Made by ${n.program}. The tables beside this file hold every digit; this page holds what can be seen. `,n.runs.map(o).join(" ")),ho()));let d=co([...a.querySelectorAll("section")]);a.querySelector("header").after(d.element);let h=()=>{c.forEach(([f,_])=>f.toggleAttribute("hidden",!_(Je(n)))),d.redraw();for(let f of a.querySelectorAll(".operations button"))f.setAttribute("aria-pressed",String(f.dataset.value===Dt.operation))};we("operation",h),h(),Object.values(i).forEach(f=>f.redraw())}var Il=h0();Bp(Il.dimensions,Il.units);var CE=Il.sweeps?tm:Il.bottoms?l0:mx;CE(Il);document.documentElement.dataset.ready="";})();

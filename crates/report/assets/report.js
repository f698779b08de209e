(()=>{var ry="http://www.w3.org/2000/svg";function Bp(n,t){if(!(t==null||t===!1))if(typeof t=="string"||typeof t=="number")n.append(String(t));else if(t instanceof Node)n.append(t);else for(let e of t)Bp(n,e)}function kp(n,t,e){for(let[i,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?n.addEventListener(i.slice(2),s):i==="style"?n.style.cssText=String(s):n.setAttribute(i,s===!0?"":String(s)));return Bp(n,e),n}function z(n,t={},...e){return kp(document.createElement(n),t,e)}function wt(n,t={},...e){return kp(document.createElementNS(ry,n),t,e)}function Tr(n,t,e,i){let s=t.map(([r,o,a])=>{let l=z("button",{type:"button","aria-pressed":String(r===e),"data-value":r,"aria-label":a,title:a},o);return l.addEventListener("click",()=>{for(let c of s)c.setAttribute("aria-pressed",String(c===l));i(r)}),l});return z("div",{class:"choice",role:"group","aria-label":n},s)}function Wl(n,t,e,i){let s=z("select",{},t.map(([r,o])=>z("option",{value:r,selected:r===e},o)));return s.addEventListener("change",()=>i(s.value)),z("label",{class:"select"},n,s)}var Xl=["si","metric","field"],zp={},$l=()=>"si";function Vp(n,t){zp=n,$l=t}var Er=n=>n[Xl.indexOf($l())];function ql(n){return zp[n]?.[Xl.indexOf($l())]??{symbol:"",factor:1}}var ie=n=>ql(n).symbol,Xt=(n,t)=>n/ql(t).factor,kn=(n,t)=>n*ql(t).factor;function Yl(n,t){let e=ql(t).factor;return Array.from(n,i=>i!==null&&Number.isFinite(i)?i/e:null)}function dn(n,t=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.abs(n);if(e>=1e9||e<1e-4){let[o,a]=n.toExponential(t-1).split("e");return`${Gp(String(Number(o)))}·10${oy(Number(a))}`}let i=Math.floor(Math.log10(e))+1,s=Math.min(Math.max(t-i,0),6);if(i<=t)return os(n.toFixed(s));let r=10**(i-t);return os(String(Math.round(n/r)*r))}function oy(n){let t="⁰¹²³⁴⁵⁶⁷⁸⁹";return[...String(n)].map(e=>e==="-"?"⁻":t[Number(e)]).join("")}var Gp=n=>n.replace("-","−");function os(n){let[t="",e]=n.split("."),[i,s]=$l()==="field"?[4,","]:[5," "],r=t.replace("-","").length>=i?t.replace(/\B(?=(\d{3})+$)/g,s):t;return Gp(e===void 0?r:`${r}.${e}`)}function as(n,t=6){let e=dn(n,t);return/\.\d*0$/.test(e)?e.replace(/\.?0+$/,""):e}var wa=n=>`${os(String(Math.round(Xt(n,"length"))))} ${ie("length")}`;function Te(n,t,e=4,i=dn){let s=ie(t),r=i(Xt(n,t),e);return s===""?r:`${r} ${s}`}var ci={error:["Error","M5 1h6l4 4v6l-4 4h-6l-4-4v-6z"],warning:["Warning","M8 1.5L15.5 14.5H.5z"],note:["Note","M8 1.5a6.5 6.5 0 1 0 .01 0z"],ok:["OK","M8 1.5a6.5 6.5 0 1 0 .01 0z"]},Ju=n=>`var(--severity-${n})`,Ta=Object.keys(ci),ay={error:"M5.5 5.5l5 5m0-5l-5 5",warning:"M8 6v4.2m0 1.6v.6",note:"M8 7v4.5m0-7v.6",ok:"M4.8 8.3l2.2 2.3 4.3-4.8"},ju=(n,t)=>Ta.indexOf(n.severity)-Ta.indexOf(t.severity),Hp=n=>Ta.find(t=>n.some(e=>e.severity===t))??null;function nr(n){let[t,e]=ci[n];return wt("svg",{class:"level-mark",viewBox:"0 0 16 16",width:15,height:15,role:"img","aria-label":t},wt("path",{d:e,fill:Ju(n)}),wt("path",{d:ay[n],stroke:"var(--paper)","stroke-width":1.8,fill:"none"}))}function Zl(n){return Ta.flatMap(t=>{let e=n.filter(i=>i.severity===t).length;return e?[`${e} ${ci[t][0].toLowerCase()}${e>1?"s":""}`]:[]}).join(", ")}var Wp=n=>Ta.flatMap(t=>{let e=n.filter(i=>i.severity===t).length;return e?[z("span",{class:`count level-${t}`},nr(t),String(e))]:[]});var Xp=[null,[6,4],[1.5,3],[13,4],[3.5,2.5],[6,7],[1.5,6]],Qu=["M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z","M-3.2 -3.2h6.4v6.4h-6.4z","M0 -4.2L4 3.2H-4z","M0 -4.6L4.2 0L0 4.6L-4.2 0z","M0 4.2L4 -3.2H-4z","M-4 -1.2h2.8v-2.8h2.4v2.8h2.8v2.4h-2.8v2.8h-2.4v-2.8h-2.8z","M-4 -2.4L-2.4 -4L0 -1.6L2.4 -4L4 -2.4L1.6 0L4 2.4L2.4 4L0 1.6L-2.4 4L-4 2.4L-1.6 0z"],Ar=n=>Xp[n%Xp.length]??null,$p=n=>Qu[n%Qu.length]??Qu[0];var Se=n=>getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim(),Rs=n=>Se(`line-${n%7}`);function ly(n){let t=parseInt(n.slice(1),16);return[t>>16,t>>8&255,t&255]}var cy=Array.from({length:10},(n,t)=>`amount-${t}`),hy=["low-side-strong","low-side","middle","high-side","high-side-strong"];function uy(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i,[r,o]=[n[i],n[i+1]],a=l=>r[l]+s*(o[l]-r[l]);return[a(0),a(1),a(2)]}var td=512;function lo(n){let t=(n?hy:cy).map(i=>ly(Se(i))),e=Array.from({length:td+1},(i,s)=>uy(t,s/td));return i=>e[Math.round(Math.min(Math.max(i,0),1)*td)]}var Kl=new Map,Lt={units:"si",theme:"auto",operation:null,depths:null,times:null,depth:null,moment:null,pointer:null,hidden:new Set};function me(n,t){for(let e of n.split(" "))Kl.has(e)||Kl.set(e,[]),Kl.get(e).push(t)}function We(n){let t=new Set;for(let[e,i]of Object.entries(n))if(!Object.is(Lt[e],i)){Lt[e]=i;for(let s of Kl.get(e)??[])t.add(s)}t.forEach(ed)}function ed(n){try{n()}catch(t){reportError(t)}}var En=n=>n.replaceAll("_"," "),Jl=(n,t)=>n.models.find(({name:e})=>e===t.model),zi=(n,t)=>Jl(n,t).long_name,ir=n=>[...new Set(n.solved.map(t=>t.operation))];function sr(n,t){let e=ir(n),i=n.models.indexOf(Jl(n,t)),s=n.models.length>1,r=e.length===1&&s?i:e.indexOf(t.operation);return{colour:e.length===1&&s?Rs(i):Se(`operation-${t.operation}`),dash:Ar(s?i:r),hollow:!n.models[i].in_time,shape:e.length>1?$p(r):null,place:r}}var jl=n=>`${n.model} ${n.operation}`;function Ql(n,t){if(ir(n).length===1)return zi(n,t);let e=En(t.operation);return n.models.length===1?e:`${e}, ${zi(n,t)}`}var ls=n=>n.models.flatMap(({name:t})=>n.solved.filter(e=>e.operation===Lt.operation&&e.model===t)),Ea=n=>n.key_results.length>0,qp=n=>!!n.profile.md_m?.length,nd=n=>n.find(Ea)??n[0],Yp=n=>nd(ls(n)),Zp=n=>nd(ls(n).filter(t=>Jl(n,t).in_time)),tc=n=>nd(ls(n).filter(t=>!Jl(n,t).in_time)),Kp=n=>ir(n).filter(t=>n.solved.some(e=>e.operation===t&&Ea(e))),Ke=n=>n.runs.find(t=>t.operation===Lt.operation);var dy=8,ec=n=>n.solved.flatMap(t=>t.checks.filter(({severity:e})=>e!=="ok").map(e=>({...e,solved:t}))).sort(ju),Aa=(n,t)=>ec(n).filter(e=>e.solved.operation===t),co=n=>Aa(n,Lt.operation).filter(t=>t.md_m!==null).reverse();function Qp({md_m:n,to_md_m:t}){if(n===null)return null;let e=wa(n),i=t===null?e:wa(t);return i===e?`at ${e}`:`${e} to ${i}`}var Jp=n=>typeof n=="number"?as(n,4):Te(n.value,n.dimension,4,as);function tm(n,t){let e=z("div",{class:"check-list"}),i=new Set(n.solved.map(a=>a.operation)).size>1,s=new Set(n.solved.map(a=>a.model)).size>1;function r(a){let{severity:l,solved:c,sentences:u}=a,[d]=ci[l],h=Qp(a),p=i&&c.operation!==Lt.operation,g=[i&&En(c.operation),s&&zi(n,c)].filter(Boolean).join(", ");return z("li",{class:`check level-${l}`},z("span",{class:"level"},nr(l),` ${d}`),z("span",{class:"message"},g&&(p?z("button",{type:"button",class:"link",title:"Show this operation",onclick:()=>We({operation:c.operation,times:null,moment:null})},g):z("strong",{},g)),g&&": ",Er(u),z("span",{class:"note"},h&&" ",h&&z("button",{type:"button",class:"link",title:"Show these depths along the hole",onclick:()=>{We({operation:c.operation,times:null,moment:null}),t(a)}},h))))}function o(){let a=ec(n),l=d=>d.severity==="error"||d.severity==="warning"&&d.solved.operation===Lt.operation,c=a.length>dy?a.filter(d=>!l(d)):[],u=e.querySelector("details")?.open??!1;e.replaceChildren(...a.length?[z("ul",{class:"checks"},a.filter(d=>!c.includes(d)).map(r)),c.length>0&&z("details",{class:"prints",open:u},z("summary",{},`${c.length} more: ${Zl(c)}`),z("ul",{class:"checks"},c.map(r)))].filter(Boolean):[])}return me("units operation",o),{element:e,redraw:o}}var jp=n=>n===null?"–":n>=100?"over 100":n.toFixed(2);function em(n){let t=z("div",{class:"check-table"});function e({severity:r,verdict:o,label:a,component:l,value:c,limit:u,factor:d,required:h,...p}){let g=[l,Qp(p)].filter(Boolean).join(", "),y=o===r?ci[r][0]:o;return z("tr",{},z("td",{class:`verdict severity-${r}`},nr(r),` ${y}`),z("th",{scope:"row"},a),z("td",{},g),z("td",{class:"number","data-head":"load"},c===null?"–":Jp(c)),z("td",{class:"number","data-head":"capacity"},u===null?"–":Jp(u)),z("td",{class:"number","data-head":"factor"},jp(d)),z("td",{class:"number","data-head":"required"},jp(h)))}function i(r,o){let a=["Verdict","Check","Where","Load","Capacity","Factor","Required"],l=o?`${En(r.operation)}, ${zi(n,r)}`:En(r.operation);return z("div",{class:"scrolls",tabindex:"0",role:"region","aria-label":`Checks: ${l}`},z("table",{},z("caption",{},`Checks: ${l}`),z("thead",{},z("tr",{},...a.map(c=>z("th",{scope:"col"},c)))),z("tbody",{},[...r.checks].sort(ju).map(e))),r.unchecked.length>0&&z("p",{class:"note"},`Not checked for want of data: ${r.unchecked.join("; ")}.`))}function s(){let r=n.solved.filter(o=>o.operation===Lt.operation&&o.checks.length>0);t.replaceChildren(...r.map(o=>i(o,r.length>1)))}return me("units operation",s),s(),{element:t,redraw:s}}function id(n,t,e){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e}));z("a",{href:i,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(i),6e4)}var fy=n=>n.toLowerCase().replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-|-$/g,"")||"figure";function py(n){if(n==null||Number.isNaN(n))return"";if(typeof n=="number")return String(Number(n.toPrecision(9)));let t=/^[=+@\t\r]|^-(?![\d.])/.test(n)?`'${n}`:n;return/[",\n\r]/.test(t)?`"${t.replaceAll('"','""')}"`:t}var $n=(n,t)=>[n,...t].map(e=>Array.from(e,py).join(",")).join(`\r
`)+`\r
`,my=["fill","fill-opacity","stroke","stroke-width","stroke-dasharray","stroke-linejoin","opacity","font-family","font-size","font-weight","text-anchor","paint-order"];function ho(n){let t=n.map(a=>a.viewBox.baseVal),e=Math.max(...t.map(a=>a.width)),i=t.reduce((a,l)=>a+l.height,0),s=0,r=getComputedStyle(document.documentElement).getPropertyValue("--paper"),o=n.map((a,l)=>{let c=a.cloneNode(!0),u=[a,...a.querySelectorAll("*")];[c,...c.querySelectorAll("*")].forEach((p,g)=>{let y=getComputedStyle(u[g]);if(y.visibility==="hidden"||y.display==="none")return p.setAttribute("display","none");p.removeAttribute("style");for(let m of my){let f=y.getPropertyValue(m);f&&p.setAttribute(m,f)}});let{width:d,height:h}=t[l];for(let[p,g]of Object.entries({x:0,y:s,width:d,height:h}))c.setAttribute(p,g);return s+=h,new XMLSerializer().serializeToString(c)});return`<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="${e}" height="${i}" viewBox="0 0 ${e} ${i}">
<rect width="100%" height="100%" fill="${r}"/>
${o.join(`
`)}
</svg>
`}function vn(n,{svg:t,csv:e,png:i}){let s=()=>fy(typeof n=="function"?n():n),r=(o,a)=>z("button",{type:"button",class:"download",title:`Download as ${o}`,"data-download":o.toLowerCase(),onclick:a},o);return z("span",{class:"downloads noprint"},t&&r("SVG",()=>id(`${s()}.svg`,t(),"image/svg+xml")),i&&r("PNG",()=>i().toBlob(o=>id(`${s()}.png`,o))),e&&r("CSV",()=>id(`${s()}.csv`,e(),"text/csv")))}var im=n=>Number.isInteger(n)&&Math.abs(n)<1e12?os(String(n)):as(n);function cs(n,t,e=t?dn:as){return n===null||n===""?"–":typeof n=="string"?n:n.href?n.text:typeof n=="number"?im(n):n.values?gy(n):Te(n.value,n.dimension,t??6,e)}function gy({values:n,dimension:t}){return`${n.map(i=>as(Xt(i,t))).join(", ")} ${ie(t)}`.trim()}function sm(n){return n?.value===void 0?cs(n):as(Xt(n.value,n.dimension))}function rm(n,t,e){if(n===null||typeof n!="object")return cs(n);let i=o=>Math.abs(o)<1e-6*t?0:o,s=i(Xt(n.value,n.dimension)),r=n.dimension==="ratio"&&Number.isInteger(s)?im(s):dn(s,e);return n.std===void 0?r:`${r} ± ${dn(i(Xt(n.std,n.dimension)),2)}`}function Ra(n){let t=new Set(n.filter(e=>e!==null&&typeof e=="object").map(e=>e.dimension));return t.size===1?[...t][0]:null}var om=n=>n&&ie(n)!==""?z("span",{class:"unit"},` ${ie(n)}`):null,am=n=>typeof n=="string"||!!n?.href,lm=n=>Math.max(0,...n.map(t=>t?.dimension?Math.abs(Xt(t.value,t.dimension)):0));function _y(n){return n.rows.map(([t,...e])=>z("tr",{},z("th",{scope:"row"},t,om(Ra(e))),e.map(i=>z("td",{class:"number"},rm(i,lm(e),5)))))}var xy=n=>n?.dimension==="length"?os(Xt(n.value,"length").toFixed(2)):cs(n);function yy(n,t=!1){if(t&&Ra(n)==="length")return xy;let e=({value:r,dimension:o,std:a})=>{let l=Xt(r,o);return a===void 0&&Math.abs(l-Math.round(l))<=1e-9*Math.abs(l)},i=n.filter(r=>r?.dimension),s=lm(i);return i.every(e)?sm:r=>rm(r,s,4)}function nm(n,t){let e=(n.rows[0]??[]).map((i,s)=>t(n.rows.map(r=>r[s])));return n.rows.map(i=>z("tr",{},i.map((s,r)=>z("td",{class:am(s)?null:"number"},s?.href?z("a",{href:s.href},s.text):e[r](s)))))}function vy(n){return n.rows.map(([t,e])=>z("tr",{},z("th",{scope:"row"},t),z("td",{},cs(e))))}function by(n,t){let e=a=>a===null||typeof a!="object"?a:a.values||a.href?cs(a):Xt(a.value,a.dimension),i=(a,l)=>l&&ie(l)?`${a}, ${ie(l)}`:a,s=a=>a.some(l=>l?.std!==void 0),r=a=>a?.std===void 0?null:Xt(a.std,a.dimension);if(t){let a=n.heads.map((u,d)=>d>0&&s(n.rows.map(h=>h[d]))),l=n.heads.flatMap((u,d)=>a[d]?[u,`${u}, deviation`]:[u]),c=n.rows.map(([u,...d])=>[i(u,Ra(d)),...d.flatMap((h,p)=>a[p+1]?[e(h),r(h)]:[e(h)])]);return[l,c]}if(!n.heads.length){let a=l=>l?.dimension?ie(l.dimension):"";return[["key","value","unit"],n.rows.map(([l,c])=>[l,e(c),a(c)])]}let o=n.heads.map((a,l)=>{let c=n.rows.map(u=>u[l]);return{head:i(a,Ra(c)),wide:s(c)}});return[o.flatMap(({head:a,wide:l})=>l?[a,`${a}, deviation`]:[a]),n.rows.map(a=>a.flatMap((l,c)=>o[c].wide?[e(l),r(l)]:[e(l)]))]}var uo=n=>vn(n.title,{csv:()=>$n(...by(n,["results","numerics"].includes(n.place)))});function hs(n,{exact:t=!1}={}){let e=z("tbody",{}),i=z("thead",{}),s=n.place==="cases",r=n.place!=="inputs"&&!s,o=()=>r?_y(n):s?nm(n,d=>yy(d,t)):n.heads.length?nm(n,()=>sm):vy(n),a=()=>{e.replaceChildren(...o());let d=h=>r?null:om(Ra(n.rows.map(p=>p[h])));n.heads.length&&i.replaceChildren(z("tr",{},n.heads.map((h,p)=>{let g=s&&n.rows.every(y=>am(y[p]));return z("th",{scope:"col",class:g?"words":null},h,d(p))})))};me("units",a),a();let l=uo(n),c=z("div",{class:"scrolls"},z("table",{class:n.heads.length?"grid":"keys"},i,e));if(s)return z("div",{class:"page-table cases"},c);if(r)return z("div",{class:"page-table"},z("h3",{},n.title,l),c);let u=n.rows.length>24;return z("details",{class:`page-table prints${n.heads.length>4?" wide":""}${u?" long":""}`,open:!u},z("summary",{},n.title,u?` (${n.rows.length} rows)`:""),c,l)}function fo(n){let t=z("dl",{class:"facts"}),e=()=>t.replaceChildren(...n.facts.map(({label:i,value:s})=>z("div",{},z("dt",{},i),z("dd",{},cs(s,s?.dimension==="length"?5:4,as)))));return me("units",e),e(),t}var Sy={ok:"within",note:"near",warning:"near",error:"over"};function My(n,t){let e=n.filter(s=>t.includes(s.kind)&&s.factor!==null),[i]=e.sort((s,r)=>s.factor/s.required-r.factor/r.required);return i?[Sy[i.severity],`of the limit: ${i.verdict}`]:["","of the limit"]}function wy(n,t){let e=t.length===1?"see the check above":`see the ${t.length} checks above`;return z("p",{class:`flag level-${n}`},nr(n),z("strong",{},` ${ci[n][0]}`),`: ${e}`)}var cm={part:.01,of:["force","torque"]};function sd(n,t){if(!cm.of.includes(n?.dimension))return n;let e=t.time_plots.filter(i=>i.dimension===n.dimension).map(i=>i.min_span);return Math.abs(n.value)<cm.part*Math.max(...e)?{...n,value:0}:n}function Ty(n,t,e,i){let r=Aa(n,Lt.operation).filter(u=>t.check_kinds.includes(u.kind)),o=Hp(r),a=t.value?.dimension,l=[z("h3",{},t.label),z("p",{class:"number"},cs(sd(t.value,n),a==="ratio"||a==="percent"?3:4))];t.largest!==null&&a&&l.push(z("p",{class:"note"},`mean; at most ${Te(sd({value:t.largest,dimension:a},n).value,a)}`));for(let{label:u,value:d}of t.more)l.push(z("p",{class:"note"},`${cs(d,4)} ${u}`));e?.result?.value?.dimension===a&&a&&l.push(z("p",{class:"note"},`${e.name} ${cs(sd(e.result.value,n),4)}`)),o&&l.push(wy(o,r));let c=t.compared??t.largest??t.value?.value;if(t.limit!==null&&Number.isFinite(c)){let u=c/t.limit,[d,h]=My(i,t.check_kinds);l.push(z("div",{class:`limit ${d}`},z("div",{class:"bar"},z("div",{class:"used",style:`width:${Math.min(Math.max(u,0),1)*100}%`})),z("p",{class:"note"},z("strong",{},`${Math.round(u*100)} % ${h}`),z("br"),`${t.limit_label} ${a==="percent"||a==="ratio"?"":Te(t.limit,a)}`)))}else l.push(z("p",{class:"note"},t.limit_label));return z("div",{class:`card key-result${o?` has-${o}`:""}`},l)}function hm(n){let t=z("div",{}),e=()=>{let i=ls(n),s=Yp(n),r=tc(n),o=l=>r&&r!==s&&{name:zi(n,r),result:r.key_results.find(c=>c.label===l.label)},a=i.filter(l=>l.message).map(l=>z("p",{class:"warning"},`${zi(n,l)}: ${Er(l.message)}`));s&&s!==i[0]&&Ea(s)&&a.push(z("p",{class:"note"},`Numbers of the ${zi(n,s)}:`)),(!s||!Ea(s))&&a.push(z("p",{class:"note"},"No model has numbers of this operation.")),t.replaceChildren(...a,z("div",{class:"key-results"},(s?.key_results??[]).map(l=>Ty(n,l,o(l),s.checks))))};return me("units operation",e),{element:t,redraw:e}}function po(n){let t=n.map(s=>[s,z("a",{href:`#${s.id}`},s.querySelector("h2").firstChild.textContent)]),e=z("nav",{class:"contents noprint","aria-label":"Contents"},t.map(([,s])=>s)),i=()=>t.forEach(([s,r])=>r.toggleAttribute("hidden",s.hidden));return i(),{element:e,redraw:i}}var rr=z("div",{class:"tip noprint",role:"status",hidden:!0});function nc(n,t,e){rr.isConnected||document.body.append(rr),rr.replaceChildren(z("strong",{},t),...e.map(({colour:a,text:l,class:c})=>z("div",{class:c},a&&z("span",{class:"swatch",style:`background:${a}`}),l))),rr.hidden=!1;let{width:i,height:s}=rr.getBoundingClientRect(),r=n.clientX+16+i>innerWidth?n.clientX-16-i:n.clientX+16,o=Math.min(n.clientY+12,innerHeight-s-4);rr.style.left=`${Math.max(r,4)}px`,rr.style.top=`${Math.max(o,4)}px`}var Ca=()=>{rr.hidden=!0};function Ey(n){let t=n.split(" ").map(Number);return Array.from({length:Math.floor(t.length/3)},(e,i)=>{let[s,r,o]=t.slice(3*i,3*i+3);return{x:s,y:r,row:o}})}function ic(n,t,e=null){let i=z("div",{class:"figure-holder"}),s=new Set;function r(u){let d=h=>h.dataset.keys.split(" ").filter(Boolean);for(let h of u.querySelectorAll(".series"))h.toggleAttribute("hidden",d(h).some(p=>s.has(p)));for(let h of u.querySelectorAll(".legend-key")){let p=s.has(h.dataset.keys);h.setAttribute("aria-pressed",String(!p)),h.classList.toggle("off",p)}}function o(u){for(let d of u.querySelectorAll(".legend-key")){if(![...u.querySelectorAll(".series")].some(y=>y.dataset.keys.split(" ").includes(d.dataset.keys)))continue;let p=()=>{s.delete(d.dataset.keys)||s.add(d.dataset.keys),r(u)},g={tabindex:0,role:"button","aria-label":`Show or hide ${d.textContent.trim()}`};for(let[y,m]of Object.entries(g))d.setAttribute(y,m);d.addEventListener("click",p),d.addEventListener("keydown",y=>{y.key!=="Enter"&&y.key!==" "||(y.preventDefault(),p())})}if(e)for(let d of u.querySelectorAll(".spots"))d.append(...Ey(d.dataset.spots).map(a));r(u)}function a({x:u,y:d,row:h}){let p=document.createElementNS("http://www.w3.org/2000/svg","circle");for(let[f,x]of Object.entries({class:"spot",cx:u,cy:d,r:4.5}))p.setAttribute(f,x);let{title:g,href:y}=e(h);if(p.setAttribute("aria-label",g),y){p.setAttribute("role","link"),p.setAttribute("tabindex",0),p.classList.add("leads");let f=()=>location.assign(y);p.addEventListener("click",f),p.addEventListener("keydown",x=>x.key==="Enter"&&f())}let m=f=>{let{title:x,rows:b}=e(h),v=p.getBoundingClientRect();nc({clientX:f.clientX??v.right,clientY:f.clientY??v.bottom},x,b)};for(let f of["pointerenter","pointermove","focus"])p.addEventListener(f,m);for(let f of["pointerleave","blur"])p.addEventListener(f,Ca);return p}let l=matchMedia("screen and (max-width: 800px)");function c(){let h=(l.matches&&document.getElementById(`${n}-narrow-${Lt.units}`)||document.getElementById(`${n}-${Lt.units}`))?.content.cloneNode(!0);i.replaceChildren(...h?.firstElementChild?[h]:[t]);let p=i.querySelector("svg");p&&o(p)}return me("units",c),l.addEventListener("change",c),c(),{element:i,file:()=>ho([...i.querySelectorAll("svg")]),there:()=>i.querySelector("svg")!==null}}var mo=()=>z("details",{},z("summary",{},"Plots by uPlot, 3D by three.js: their licences (MIT)"),z("pre",{},document.getElementById("licences").content.textContent));var rd=!1;addEventListener("beforeprint",()=>rd=!0);addEventListener("afterprint",()=>rd=!1);var nn=()=>rd;var um="wholestring.";function sc(n,t){try{let e=localStorage.getItem(um+n);return t.includes(e)?e:null}catch{return null}}function rc(n,t){try{localStorage.setItem(um+n,t)}catch{}}var dm=matchMedia("(prefers-color-scheme: dark)"),Ay=()=>!nn()&&(Lt.theme==="dark"||Lt.theme==="auto"&&dm.matches);function fm(n){Lt.theme=sc("theme",["auto","light","dark"])??Lt.theme;let t=()=>{document.documentElement.dataset.theme=Ay()?"dark":"light"},e=()=>{t(),n()};dm.addEventListener("change",e);let i=s=>()=>{for(let r of document.querySelectorAll("details.prints"))s?(r.dataset.was=r.open?"open":"",r.open=!0):r.open=r.dataset.was==="open";e()};return addEventListener("beforeprint",i(!0)),addEventListener("afterprint",i(!1)),t(),s=>{We({theme:s}),rc("theme",s),e()}}function go(n,t,e){let i=fm(e);return z("header",{},z("div",{class:"title-line"},z("h1",{},n),z("div",{class:"controls noprint"},Tr("Units",[["si","SI"],["metric","Metric"],["field","US field"]],Lt.units,s=>We({units:s})),Tr("Colours",[["auto","Auto"],["light","Light"],["dark","Dark"]],Lt.theme,i),z("button",{type:"button",onclick:()=>print()},"Print"))),t)}var oc=(n,t,...e)=>z("section",{id:n},z("h2",{},t),e);function od(n,t,e,...i){let{element:s,file:r,there:o}=ic(e,"Nothing was solved.");return oc(n,[t,vn(t,{svg:o()?r:null})],s,i)}var Ry=n=>n.place==="cases"?[z("h3",{},n.title,uo(n)),hs(n,pm)]:hs(n),pm={exact:!0},Cy=n=>z("p",{class:"note"},n);function Py(n){let t=z("p",{class:"verdict"}),e=()=>{t.textContent=Er(n.tendency).map(i=>`${i}.`).join(" "),t.hidden=t.textContent===""};return me("units",e),e(),t}function Iy(n){let t=z("ul",{class:"checks"}),e=()=>t.replaceChildren(...n.checks.map(({severity:i,sentences:s})=>z("li",{class:`check level-${i}`},z("span",{class:"level"},nr(i),` ${ci[i][0]}`),z("span",{class:"message"},Er(s)))));return me("units",e),e(),n.checks.length>0?z("div",{class:"check-list"},t):null}var Ly={toolface:"Tool face",weight:"Weight on bit",inclination:"Inclination"};function mm(n){let t=n.page_tables.filter(o=>o.place!=="inputs"),e=n.page_tables.filter(o=>o.place==="inputs"),[i,...s]=t,r=document.getElementById("page");r.append(go(n.title,[Iy(n),Py(n),fo(n)].filter(Boolean),()=>{}),...n.message?[z("p",{class:"warning"},n.message)]:[],od("views","The assembly in its hole","views",Cy("The wall is the two lines. A side force of the bit towards the high side builds inclination, one to the right turns the hole to the right. Directions are as one looks down the hole.")),oc("contacts",["Contacts",uo(i)],hs(i,pm)),od("bending","Bending","bending"),...n.sweeps.map(([o])=>od(o,Ly[o]??o,o)),oc("results","Numbers",s.flatMap(Ry)),...e.length?[oc("inputs","Inputs, defaults included",e.map(hs))]:[],z("footer",{},z("p",{},`Made by ${n.program}. The tables beside this file hold every digit.`),mo())),r.querySelector("header").after(po([...r.querySelectorAll("section:has(h2)")]).element)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var gr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},_r={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},qm=0,Od=1,Ym=2;var hl=1,Zm=2,Xo=3,_s=0,ai=1,hi=2,Ur=0,$o=1,Fd=2,Bd=3,kd=4,Km=5;var Or=100,Jm=101,jm=102,Qm=103,tg=104,eg=200,ng=201,ig=202,sg=203,zd=204,Vd=205,rg=206,og=207,ag=208,lg=209,cg=210,hg=211,ug=212,dg=213,fg=214,Nc=0,Uc=1,Oc=2,Uo=3,Fc=4,Bc=5,kc=6,zc=7,mh=0,pg=1,mg=2,xs=0,Gd=1,Hd=2,Wd=3,Xd=4,$d=5,qd=6,Yd=7;var Zd=300,Fr=301,qo=302,gh=303,_h=304,Vc=1e3,ds=1001,Gc=1002,Vn=1003,gg=1004;var ul=1005;var ri=1006,xh=1007;var zs=1008;var ui=1009,Kd=1010,Jd=1011,Yo=1012,yh=1013,Xi=1014,$i=1015,qi=1016,vh=1017,bh=1018,Br=1020,jd=35902,Qd=35899,tf=1021,ef=1022,Yi=1023,Os=1026,Vs=1027,nf=1028,Sh=1029,xr=1030,Mh=1031;var wh=1033,dl=33776,fl=33777,pl=33778,ml=33779,Th=35840,Eh=35841,Ah=35842,Rh=35843,Ch=36196,Ph=37492,Ih=37496,Lh=37488,Dh=37489,gl=37490,Nh=37491,Uh=37808,Oh=37809,Fh=37810,Bh=37811,kh=37812,zh=37813,Vh=37814,Gh=37815,Hh=37816,Wh=37817,Xh=37818,$h=37819,qh=37820,Yh=37821,Zh=36492,Kh=36494,Jh=36495,jh=36283,Qh=36284,_l=36285,tu=36286;var Va=2300,Hc=2301,Lc=2302,Cd=2303,Pd=2400,Id=2401,Ld=2402;var _g=3200;var eu=0,xg=1,Gs="",ni="srgb",Ga="srgb-linear",Ha="linear",Le="srgb";var Dc=7680;var yg=519,vg=512,bg=513,Sg=514,sf=515,Mg=516,wg=517,rf=518,of=519,af=35044;var lf="300 es",Pi=2e3,Oo=2001;function Dy(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Ny(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Wa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Tg(){let n=Wa("canvas");return n.style.display="block",n}var gm={},Fo=null;function Xa(...n){let t="THREE."+n.shift();Fo?Fo("log",t,...n):console.log(t,...n)}function Eg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Jt(...n){n=Eg(n);let t="THREE."+n.shift();if(Fo)Fo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function se(...n){n=Eg(n);let t="THREE."+n.shift();if(Fo)Fo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Ba(...n){let t=n.join(" ");t in gm||(gm[t]=!0,Jt(...n))}function Ag(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Rg={[Nc]:Nc,[Oc]:kc,[Fc]:Fc,[Uo]:Bc,[Uc]:Uc,[kc]:Oc,[zc]:zc,[Bc]:Uo},Wi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],_m=1234567,ka=Math.PI/180,Bo=180/Math.PI;function yr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]+"-"+qn[t&255]+qn[t>>8&255]+"-"+qn[t>>16&15|64]+qn[t>>24&255]+"-"+qn[e&63|128]+qn[e>>8&255]+"-"+qn[e>>16&255]+qn[e>>24&255]+qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]).toLowerCase()}function ye(n,t,e){return Math.max(t,Math.min(e,n))}function cf(n,t){return(n%t+t)%t}function Uy(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Oy(n,t,e){return n!==t?(e-n)/(t-n):0}function za(n,t,e){return(1-e)*n+e*t}function Fy(n,t,e,i){return za(n,t,1-Math.exp(-e*i))}function By(n,t=1){return t-Math.abs(cf(n,t*2)-t)}function ky(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function zy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Vy(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Gy(n,t){return n+Math.random()*(t-n)}function Hy(n){return n*(.5-Math.random())}function Wy(n){n!==void 0&&(_m=n);let t=_m+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Xy(n){return n*ka}function $y(n){return n*Bo}function qy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Yy(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function hf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Zy(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),d=r((t-i)/2),h=o((t-i)/2),p=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*g,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*g,a*c);break;case"ZYZ":n.set(l*g,l*p,a*u,a*c);break;default:Jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function nu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function uf(n,t){if(t.constructor===Float32Array)return n;let e=nu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function df(n,t){if(t.constructor===Float32Array)return n;let e=nu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ff={DEG2RAD:ka,RAD2DEG:Bo,generateUUID:yr,clamp:ye,euclideanModulo:cf,mapLinear:Uy,inverseLerp:Oy,lerp:za,damp:Fy,pingpong:By,smoothstep:ky,smootherstep:zy,randInt:Vy,randFloat:Gy,randFloatSpread:Hy,seededRandom:Wy,degToRad:Xy,radToDeg:$y,isPowerOfTwo:qy,ceilPowerOfTwo:Yy,floorPowerOfTwo:hf,setQuaternionFromProperEuler:Zy,normalize:df,denormalize:uf},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ye(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},bi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],p=r[o+1],g=r[o+2],y=r[o+3];if(d!==y||l!==h||c!==p||u!==g){let m=l*h+c*p+u*g+d*y;m<0&&(h=-h,p=-p,g=-g,y=-y,m=-m);let f=1-a;if(m<.9995){let x=Math.acos(m),b=Math.sin(x);f=Math.sin(f*x)/b,a=Math.sin(a*x)/b,l=l*f+h*a,c=c*f+p*a,u=u*f+g*a,d=d*f+y*a}else{l=l*f+h*a,c=c*f+p*a,u=u*f+g*a,d=d*f+y*a;let x=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=x,c*=x,u*=x,d*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],p=r[o+2],g=r[o+3];return t[e]=a*g+u*d+l*p-c*h,t[e+1]=l*g+u*h+c*d-a*p,t[e+2]=c*g+u*p+a*h-l*d,t[e+3]=u*g-a*d-l*h-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*p*g,this._y=c*p*d-h*u*g,this._z=c*u*g+h*p*d,this._w=c*u*d-h*p*g;break;case"YXZ":this._x=h*u*d+c*p*g,this._y=c*p*d-h*u*g,this._z=c*u*g-h*p*d,this._w=c*u*d+h*p*g;break;case"ZXY":this._x=h*u*d-c*p*g,this._y=c*p*d+h*u*g,this._z=c*u*g+h*p*d,this._w=c*u*d-h*p*g;break;case"ZYX":this._x=h*u*d-c*p*g,this._y=c*p*d+h*u*g,this._z=c*u*g-h*p*d,this._w=c*u*d+h*p*g;break;case"YZX":this._x=h*u*d+c*p*g,this._y=c*p*d+h*u*g,this._z=c*u*g-h*p*d,this._w=c*u*d-h*p*g;break;case"XZY":this._x=h*u*d-c*p*g,this._y=c*p*d-h*u*g,this._z=c*u*g+h*p*d,this._w=c*u*d+h*p*g;break;default:Jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],d=e[10],h=i+a+d;if(h>0){let p=.5/Math.sqrt(h+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>d){let p=2*Math.sqrt(1+i-a-d);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>d){let p=2*Math.sqrt(1+a-i-d);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+d-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(xm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(xm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return ad.copy(this).projectOnVector(t),this.sub(ad)}reflect(t){return this.sub(ad.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ye(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ad=new q,xm=new bi,le=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],p=i[5],g=i[8],y=s[0],m=s[3],f=s[6],x=s[1],b=s[4],v=s[7],T=s[2],w=s[5],_=s[8];return r[0]=o*y+a*x+l*T,r[3]=o*m+a*b+l*w,r[6]=o*f+a*v+l*_,r[1]=c*y+u*x+d*T,r[4]=c*m+u*b+d*w,r[7]=c*f+u*v+d*_,r[2]=h*y+p*x+g*T,r[5]=h*m+p*b+g*w,r[8]=h*f+p*v+g*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=u*o-a*c,h=a*l-u*r,p=c*r-o*l,g=e*d+i*h+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=d*y,t[1]=(s*c-u*i)*y,t[2]=(a*i-s*o)*y,t[3]=h*y,t[4]=(u*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=p*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Ba("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ld.makeScale(t,e)),this}rotate(t){return Ba("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ld.makeRotation(-t)),this}translate(t,e){return Ba("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ld.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ld=new le,ym=new le().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),vm=new le().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ky(){let n={enabled:!0,workingColorSpace:Ga,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Le&&(s.r=Us(s.r),s.g=Us(s.g),s.b=Us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Le&&(s.r=No(s.r),s.g=No(s.g),s.b=No(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Gs?Ha:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ga]:{primaries:t,whitePoint:i,transfer:Ha,toXYZ:ym,fromXYZ:vm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ni},outputColorSpaceConfig:{drawingBufferColorSpace:ni}},[ni]:{primaries:t,whitePoint:i,transfer:Le,toXYZ:ym,fromXYZ:vm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ni}}}),n}var Me=Ky();function Us(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function No(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var _o,Wc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{_o===void 0&&(_o=Wa("canvas")),_o.width=t.width,_o.height=t.height;let s=_o.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=_o}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Wa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Us(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Us(e[i]/255)*255):e[i]=Us(e[i]);return{data:e,width:t.width,height:t.height}}else return Jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Jy=0,ko=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Jy++}),this.uuid=yr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(cd(s[o].image)):r.push(cd(s[o]))}else r=cd(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function cd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Wc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Jt("Texture: Unable to serialize Texture."),{})}var jy=0,hd=new q,oi=class n extends Wi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=ds,s=ds,r=ri,o=zs,a=Yi,l=ui,c=n.DEFAULT_ANISOTROPY,u=Gs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:jy++}),this.uuid=yr(),this.name="",this.source=new ko(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new le,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(hd).x}get height(){return this.source.getSize(hd).y}get depth(){return this.source.getSize(hd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Zd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Vc:t.x=t.x-Math.floor(t.x);break;case ds:t.x=t.x<0?0:1;break;case Gc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Vc:t.y=t.y-Math.floor(t.y);break;case ds:t.y=t.y<0?0:1;break;case Gc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=Zd;oi.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],d=l[8],h=l[1],p=l[5],g=l[9],y=l[2],m=l[6],f=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+f-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,v=(p+1)/2,T=(f+1)/2,w=(u+h)/4,_=(d+y)/4,M=(g+m)/4;return b>v&&b>T?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=w/i,r=_/i):v>T?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=w/s,r=M/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=_/r,s=M/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-g)*(m-g)+(d-y)*(d-y)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(m-g)/x,this.y=(d-y)/x,this.z=(h-u)/x,this.w=Math.acos((c+p+f-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Xc=class extends Wi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new tn(0,0,t,e),this.scissorTest=!1,this.viewport=new tn(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new oi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ko(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Si=class extends Xc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},$a=class extends oi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Vn,this.minFilter=Vn,this.wrapR=ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var $c=class extends oi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Vn,this.minFilter=Vn,this.wrapR=ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Xe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,d,h,p,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,d,h,p,g,y,m)}set(t,e,i,s,r,o,a,l,c,u,d,h,p,g,y,m){let f=this.elements;return f[0]=t,f[4]=e,f[8]=i,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=u,f[10]=d,f[14]=h,f[3]=p,f[7]=g,f[11]=y,f[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/xo.setFromMatrixColumn(t,0).length(),r=1/xo.setFromMatrixColumn(t,1).length(),o=1/xo.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let h=o*u,p=o*d,g=a*u,y=a*d;e[0]=l*u,e[4]=-l*d,e[8]=c,e[1]=p+g*c,e[5]=h-y*c,e[9]=-a*l,e[2]=y-h*c,e[6]=g+p*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,p=l*d,g=c*u,y=c*d;e[0]=h+y*a,e[4]=g*a-p,e[8]=o*c,e[1]=o*d,e[5]=o*u,e[9]=-a,e[2]=p*a-g,e[6]=y+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,p=l*d,g=c*u,y=c*d;e[0]=h-y*a,e[4]=-o*d,e[8]=g+p*a,e[1]=p+g*a,e[5]=o*u,e[9]=y-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,p=o*d,g=a*u,y=a*d;e[0]=l*u,e[4]=g*c-p,e[8]=h*c+y,e[1]=l*d,e[5]=y*c+h,e[9]=p*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,p=o*c,g=a*l,y=a*c;e[0]=l*u,e[4]=y-h*d,e[8]=g*d+p,e[1]=d,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=p*d+g,e[10]=h-y*d}else if(t.order==="XZY"){let h=o*l,p=o*c,g=a*l,y=a*c;e[0]=l*u,e[4]=-d,e[8]=c*u,e[1]=h*d+y,e[5]=o*u,e[9]=p*d-g,e[2]=g*d-p,e[6]=a*u,e[10]=y*d+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Qy,t,tv)}lookAt(t,e,i){let s=this.elements;return xi.subVectors(t,e),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),or.crossVectors(i,xi),or.lengthSq()===0&&(Math.abs(i.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),or.crossVectors(i,xi)),or.normalize(),ac.crossVectors(xi,or),s[0]=or.x,s[4]=ac.x,s[8]=xi.x,s[1]=or.y,s[5]=ac.y,s[9]=xi.y,s[2]=or.z,s[6]=ac.z,s[10]=xi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],p=i[13],g=i[2],y=i[6],m=i[10],f=i[14],x=i[3],b=i[7],v=i[11],T=i[15],w=s[0],_=s[4],M=s[8],L=s[12],P=s[1],C=s[5],U=s[9],B=s[13],I=s[2],k=s[6],H=s[10],F=s[14],j=s[3],$=s[7],Z=s[11],nt=s[15];return r[0]=o*w+a*P+l*I+c*j,r[4]=o*_+a*C+l*k+c*$,r[8]=o*M+a*U+l*H+c*Z,r[12]=o*L+a*B+l*F+c*nt,r[1]=u*w+d*P+h*I+p*j,r[5]=u*_+d*C+h*k+p*$,r[9]=u*M+d*U+h*H+p*Z,r[13]=u*L+d*B+h*F+p*nt,r[2]=g*w+y*P+m*I+f*j,r[6]=g*_+y*C+m*k+f*$,r[10]=g*M+y*U+m*H+f*Z,r[14]=g*L+y*B+m*F+f*nt,r[3]=x*w+b*P+v*I+T*j,r[7]=x*_+b*C+v*k+T*$,r[11]=x*M+b*U+v*H+T*Z,r[15]=x*L+b*B+v*F+T*nt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],d=t[6],h=t[10],p=t[14],g=t[3],y=t[7],m=t[11],f=t[15],x=l*p-c*h,b=a*p-c*d,v=a*h-l*d,T=o*p-c*u,w=o*h-l*u,_=o*d-a*u;return e*(y*x-m*b+f*v)-i*(g*x-m*T+f*w)+s*(g*b-y*T+f*_)-r*(g*v-y*w+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=t[9],h=t[10],p=t[11],g=t[12],y=t[13],m=t[14],f=t[15],x=e*a-i*o,b=e*l-s*o,v=e*c-r*o,T=i*l-s*a,w=i*c-r*a,_=s*c-r*l,M=u*y-d*g,L=u*m-h*g,P=u*f-p*g,C=d*m-h*y,U=d*f-p*y,B=h*f-p*m,I=x*B-b*U+v*C+T*P-w*L+_*M;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let k=1/I;return t[0]=(a*B-l*U+c*C)*k,t[1]=(s*U-i*B-r*C)*k,t[2]=(y*_-m*w+f*T)*k,t[3]=(h*w-d*_-p*T)*k,t[4]=(l*P-o*B-c*L)*k,t[5]=(e*B-s*P+r*L)*k,t[6]=(m*v-g*_-f*b)*k,t[7]=(u*_-h*v+p*b)*k,t[8]=(o*U-a*P+c*M)*k,t[9]=(i*P-e*U-r*M)*k,t[10]=(g*w-y*v+f*x)*k,t[11]=(d*v-u*w-p*x)*k,t[12]=(a*L-o*C-l*M)*k,t[13]=(e*C-i*L+s*M)*k,t[14]=(y*b-g*T-m*x)*k,t[15]=(u*T-d*b+h*x)*k,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,d=a+a,h=r*c,p=r*u,g=r*d,y=o*u,m=o*d,f=a*d,x=l*c,b=l*u,v=l*d,T=i.x,w=i.y,_=i.z;return s[0]=(1-(y+f))*T,s[1]=(p+v)*T,s[2]=(g-b)*T,s[3]=0,s[4]=(p-v)*w,s[5]=(1-(h+f))*w,s[6]=(m+x)*w,s[7]=0,s[8]=(g+b)*_,s[9]=(m-x)*_,s[10]=(1-(h+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=xo.set(s[0],s[1],s[2]).length(),a=xo.set(s[4],s[5],s[6]).length(),l=xo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Vi.copy(this);let c=1/o,u=1/a,d=1/l;return Vi.elements[0]*=c,Vi.elements[1]*=c,Vi.elements[2]*=c,Vi.elements[4]*=u,Vi.elements[5]*=u,Vi.elements[6]*=u,Vi.elements[8]*=d,Vi.elements[9]*=d,Vi.elements[10]*=d,e.setFromRotationMatrix(Vi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Pi,l=!1){let c=this.elements,u=2*r/(e-t),d=2*r/(i-s),h=(e+t)/(e-t),p=(i+s)/(i-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Pi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Oo)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Pi,l=!1){let c=this.elements,u=2/(e-t),d=2/(i-s),h=-(e+t)/(e-t),p=-(i+s)/(i-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Pi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Oo)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},xo=new q,Vi=new Xe,Qy=new q(0,0,0),tv=new q(1,1,1),or=new q,ac=new q,xi=new q,bm=new Xe,Sm=new bi,Fs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ye(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return bm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(bm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Sm.setFromEuler(this),this.setFromQuaternion(Sm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Fs.DEFAULT_ORDER="XYZ";var qa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},ev=0,Mm=new q,yo=new bi,Cs=new Xe,lc=new q,Pa=new q,nv=new q,iv=new bi,wm=new q(1,0,0),Tm=new q(0,1,0),Em=new q(0,0,1),Am={type:"added"},sv={type:"removed"},vo={type:"childadded",child:null},ud={type:"childremoved",child:null},Wn=class n extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ev++}),this.uuid=yr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new q,e=new Fs,i=new bi,s=new q(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xe},normalMatrix:{value:new le}}),this.matrix=new Xe,this.matrixWorld=new Xe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new qa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return yo.setFromAxisAngle(t,e),this.quaternion.multiply(yo),this}rotateOnWorldAxis(t,e){return yo.setFromAxisAngle(t,e),this.quaternion.premultiply(yo),this}rotateX(t){return this.rotateOnAxis(wm,t)}rotateY(t){return this.rotateOnAxis(Tm,t)}rotateZ(t){return this.rotateOnAxis(Em,t)}translateOnAxis(t,e){return Mm.copy(t).applyQuaternion(this.quaternion),this.position.add(Mm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(wm,t)}translateY(t){return this.translateOnAxis(Tm,t)}translateZ(t){return this.translateOnAxis(Em,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Cs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?lc.copy(t):lc.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Pa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Cs.lookAt(Pa,lc,this.up):Cs.lookAt(lc,Pa,this.up),this.quaternion.setFromRotationMatrix(Cs),s&&(Cs.extractRotation(s.matrixWorld),yo.setFromRotationMatrix(Cs),this.quaternion.premultiply(yo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(se("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Am),vo.child=t,this.dispatchEvent(vo),vo.child=null):se("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(sv),ud.child=t,this.dispatchEvent(ud),ud.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Cs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Cs.multiply(t.parent.matrixWorld)),t.applyMatrix4(Cs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Am),vo.child=t,this.dispatchEvent(vo),vo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Pa,t,nv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Pa,iv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),d=o(t.shapes),h=o(t.skeletons),p=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Wn.DEFAULT_UP=new q(0,1,0);Wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Lr=class extends Wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},rv={type:"move"},zo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Lr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Lr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Lr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),f=this._getHandJoint(c,y);m!==null&&(f.matrix.fromArray(m.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=m.radius),f.visible=m!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),p=.02,g=.005;c.inputState.pinching&&h>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(rv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Lr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Cg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ar={h:0,s:0,l:0},cc={h:0,s:0,l:0};function dd(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var de=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ni){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Me.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Me.workingColorSpace){return this.r=t,this.g=e,this.b=i,Me.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Me.workingColorSpace){if(t=cf(t,1),e=ye(e,0,1),i=ye(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=dd(o,r,t+1/3),this.g=dd(o,r,t),this.b=dd(o,r,t-1/3)}return Me.colorSpaceToWorking(this,s),this}setStyle(t,e=ni){function i(r){r!==void 0&&parseFloat(r)<1&&Jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ni){let i=Cg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Us(t.r),this.g=Us(t.g),this.b=Us(t.b),this}copyLinearToSRGB(t){return this.r=No(t.r),this.g=No(t.g),this.b=No(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ni){return Me.workingToColorSpace(Yn.copy(this),t),Math.round(ye(Yn.r*255,0,255))*65536+Math.round(ye(Yn.g*255,0,255))*256+Math.round(ye(Yn.b*255,0,255))}getHexString(t=ni){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Me.workingColorSpace){Me.workingToColorSpace(Yn.copy(this),e);let i=Yn.r,s=Yn.g,r=Yn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=Me.workingColorSpace){return Me.workingToColorSpace(Yn.copy(this),e),t.r=Yn.r,t.g=Yn.g,t.b=Yn.b,t}getStyle(t=ni){Me.workingToColorSpace(Yn.copy(this),t);let e=Yn.r,i=Yn.g,s=Yn.b;return t!==ni?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(ar),this.setHSL(ar.h+t,ar.s+e,ar.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(ar),t.getHSL(cc);let i=za(ar.h,cc.h,e),s=za(ar.s,cc.s,e),r=za(ar.l,cc.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Yn=new de;de.NAMES=Cg;var Ya=class extends Wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Fs,this.environmentIntensity=1,this.environmentRotation=new Fs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Gi=new q,Ps=new q,fd=new q,Is=new q,bo=new q,So=new q,Rm=new q,pd=new q,md=new q,gd=new q,_d=new tn,xd=new tn,yd=new tn,Ns=class n{constructor(t=new q,e=new q,i=new q){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Gi.subVectors(t,e),s.cross(Gi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Gi.subVectors(s,e),Ps.subVectors(i,e),fd.subVectors(t,e);let o=Gi.dot(Gi),a=Gi.dot(Ps),l=Gi.dot(fd),c=Ps.dot(Ps),u=Ps.dot(fd),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,p=(c*l-a*u)*h,g=(o*u-a*l)*h;return r.set(1-p-g,g,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Is)===null?!1:Is.x>=0&&Is.y>=0&&Is.x+Is.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Is)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Is.x),l.addScaledVector(o,Is.y),l.addScaledVector(a,Is.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return _d.setScalar(0),xd.setScalar(0),yd.setScalar(0),_d.fromBufferAttribute(t,e),xd.fromBufferAttribute(t,i),yd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(_d,r.x),o.addScaledVector(xd,r.y),o.addScaledVector(yd,r.z),o}static isFrontFacing(t,e,i,s){return Gi.subVectors(i,e),Ps.subVectors(t,e),Gi.cross(Ps).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Gi.subVectors(this.c,this.b),Ps.subVectors(this.a,this.b),Gi.cross(Ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;bo.subVectors(s,i),So.subVectors(r,i),pd.subVectors(t,i);let l=bo.dot(pd),c=So.dot(pd);if(l<=0&&c<=0)return e.copy(i);md.subVectors(t,s);let u=bo.dot(md),d=So.dot(md);if(u>=0&&d<=u)return e.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(bo,o);gd.subVectors(t,r);let p=bo.dot(gd),g=So.dot(gd);if(g>=0&&p<=g)return e.copy(r);let y=p*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(So,a);let m=u*g-p*d;if(m<=0&&d-u>=0&&p-g>=0)return Rm.subVectors(r,s),a=(d-u)/(d-u+(p-g)),e.copy(s).addScaledVector(Rm,a);let f=1/(m+y+h);return o=y*f,a=h*f,e.copy(i).addScaledVector(bo,o).addScaledVector(So,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ii=class{constructor(t=new q(1/0,1/0,1/0),e=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Hi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Hi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Hi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Hi):Hi.fromBufferAttribute(r,o),Hi.applyMatrix4(t.matrixWorld),this.expandByPoint(Hi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),hc.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),hc.copy(i.boundingBox)),hc.applyMatrix4(t.matrixWorld),this.union(hc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Hi),Hi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ia),uc.subVectors(this.max,Ia),Mo.subVectors(t.a,Ia),wo.subVectors(t.b,Ia),To.subVectors(t.c,Ia),lr.subVectors(wo,Mo),cr.subVectors(To,wo),Rr.subVectors(Mo,To);let e=[0,-lr.z,lr.y,0,-cr.z,cr.y,0,-Rr.z,Rr.y,lr.z,0,-lr.x,cr.z,0,-cr.x,Rr.z,0,-Rr.x,-lr.y,lr.x,0,-cr.y,cr.x,0,-Rr.y,Rr.x,0];return!vd(e,Mo,wo,To,uc)||(e=[1,0,0,0,1,0,0,0,1],!vd(e,Mo,wo,To,uc))?!1:(dc.crossVectors(lr,cr),e=[dc.x,dc.y,dc.z],vd(e,Mo,wo,To,uc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Hi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Hi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ls),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ls=[new q,new q,new q,new q,new q,new q,new q,new q],Hi=new q,hc=new Ii,Mo=new q,wo=new q,To=new q,lr=new q,cr=new q,Rr=new q,Ia=new q,uc=new q,dc=new q,Cr=new q;function vd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Cr.fromArray(n,r);let a=s.x*Math.abs(Cr.x)+s.y*Math.abs(Cr.y)+s.z*Math.abs(Cr.z),l=t.dot(Cr),c=e.dot(Cr),u=i.dot(Cr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var bn=new q,fc=new Zt,ov=0,si=class extends Wi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ov++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=af,this.updateRanges=[],this.gpuType=$i,this.version=0,this._normalizationScale=t!==void 0?nu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)fc.fromBufferAttribute(this,e),fc.applyMatrix3(t),this.setXY(e,fc.x,fc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)bn.fromBufferAttribute(this,e),bn.applyMatrix3(t),this.setXYZ(e,bn.x,bn.y,bn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)bn.fromBufferAttribute(this,e),bn.applyMatrix4(t),this.setXYZ(e,bn.x,bn.y,bn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)bn.fromBufferAttribute(this,e),bn.applyNormalMatrix(t),this.setXYZ(e,bn.x,bn.y,bn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)bn.fromBufferAttribute(this,e),bn.transformDirection(t),this.setXYZ(e,bn.x,bn.y,bn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):uf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):df(t,this.array)}};var Za=class extends si{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Ka=class extends si{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var fn=class extends si{constructor(t,e,i){super(new Float32Array(t),e,i)}},av=new Ii,La=new q,bd=new q,Dr=class{constructor(t=new q,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):av.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;La.subVectors(t,this.center);let e=La.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(La,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(bd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(La.copy(t.center).add(bd)),this.expandByPoint(La.copy(t.center).sub(bd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},lv=0,Ci=new Xe,Sd=new Wn,Eo=new q,yi=new Ii,Da=new Ii,zn=new q,Gn=class n extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:lv++}),this.uuid=yr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Dy(t)?Ka:Za)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new le().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ci.makeRotationFromQuaternion(t),this.applyMatrix4(Ci),this}rotateX(t){return Ci.makeRotationX(t),this.applyMatrix4(Ci),this}rotateY(t){return Ci.makeRotationY(t),this.applyMatrix4(Ci),this}rotateZ(t){return Ci.makeRotationZ(t),this.applyMatrix4(Ci),this}translate(t,e,i){return Ci.makeTranslation(t,e,i),this.applyMatrix4(Ci),this}scale(t,e,i){return Ci.makeScale(t,e,i),this.applyMatrix4(Ci),this}lookAt(t){return Sd.lookAt(t),Sd.updateMatrix(),this.applyMatrix4(Sd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Eo).negate(),this.translate(Eo.x,Eo.y,Eo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new fn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ii);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];yi.setFromBufferAttribute(r),this.morphTargetsRelative?(zn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(zn),zn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(zn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&se('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Dr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){se("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(t){let i=this.boundingSphere.center;if(yi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Da.setFromBufferAttribute(a),this.morphTargetsRelative?(zn.addVectors(yi.min,Da.min),yi.expandByPoint(zn),zn.addVectors(yi.max,Da.max),yi.expandByPoint(zn)):(yi.expandByPoint(Da.min),yi.expandByPoint(Da.max))}yi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)zn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(zn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)zn.fromBufferAttribute(a,c),l&&(Eo.fromBufferAttribute(t,c),zn.add(Eo)),s=Math.max(s,i.distanceToSquared(zn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&se('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){se("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new si(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new q,l[L]=new q;let u=new q,d=new q,h=new q,p=new Zt,g=new Zt,y=new Zt,m=new q,f=new q;function x(L,P,C){c[L]=c[P]=c[C]=1,u.fromBufferAttribute(i,L),d.fromBufferAttribute(i,P),h.fromBufferAttribute(i,C),p.fromBufferAttribute(r,L),g.fromBufferAttribute(r,P),y.fromBufferAttribute(r,C),d.sub(u),h.sub(u),g.sub(p),y.sub(p);let U=1/(g.x*y.y-y.x*g.y);isFinite(U)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(h,-g.y).multiplyScalar(U),f.copy(h).multiplyScalar(g.x).addScaledVector(d,-y.x).multiplyScalar(U),a[L].add(m),a[P].add(m),a[C].add(m),l[L].add(f),l[P].add(f),l[C].add(f))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let L=0,P=b.length;L<P;++L){let C=b[L],U=C.start,B=C.count;for(let I=U,k=U+B;I<k;I+=3)x(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let v=new q,T=new q,w=new q,_=new q;function M(L){w.fromBufferAttribute(s,L),_.copy(w);let P=a[L];v.copy(P),v.sub(w.multiplyScalar(w.dot(P))).normalize(),T.crossVectors(_,P);let U=T.dot(l[L])<0?-1:1;o.setXYZW(L,v.x,v.y,v.z,U)}for(let L=0,P=i.count;L<P;++L)c[L]&&M(L);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new si(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,p=i.count;h<p;h++)i.setXYZ(h,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,u=new q,d=new q;if(t)for(let h=0,p=t.count;h<p;h+=3){let g=t.getX(h+0),y=t.getX(h+1),m=t.getX(h+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,p=e.count;h<p;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)zn.fromBufferAttribute(t,e),zn.normalize(),t.setXYZ(e,zn.x,zn.y,zn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),p=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?p=l[y]*a.data.stride+a.offset:p=l[y]*u;for(let f=0;f<u;f++)h[g++]=c[p++]}return new si(h,u,d)}if(this.index===null)return Jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],p=t(h,i);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let p=c[d];u.push(p.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,p=d.length;h<p;h++)u.push(d[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},qc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=af,this.updateRanges=[],this.version=0,this.uuid=yr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Cm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Cm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Cm(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=yr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ei=new q,Ja=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?nu(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ei.fromBufferAttribute(this,e),ei.applyMatrix4(t),this.setXYZ(e,ei.x,ei.y,ei.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ei.fromBufferAttribute(this,e),ei.applyNormalMatrix(t),this.setXYZ(e,ei.x,ei.y,ei.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ei.fromBufferAttribute(this,e),ei.transformDirection(t),this.setXYZ(e,ei.x,ei.y,ei.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Xa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new si(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Xa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):uf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):df(t,this.data.array)}},Md=new q,cv=new q,hv=new le,vi=class{constructor(t=new q(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Md.subVectors(i,e).cross(cv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Md),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||hv.getNormalMatrix(t),s=this.coplanarPoint(Md).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},uv=0,fs=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:uv++}),this.uuid=yr(),this.name="",this.type="Material",this.blending=$o,this.side=_s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=zd,this.blendDst=Vd,this.blendEquation=Or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new de(0,0,0),this.blendAlpha=0,this.depthFunc=Uo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=yg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dc,this.stencilZFail=Dc,this.stencilZPass=Dc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new de().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new vi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Zt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Vo=class extends fs{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new de(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Ao,Na=new q,Ro=new q,Co=new q,Po=new Zt,Ua=new Zt,Pg=new Xe,pc=new q,Oa=new q,mc=new q,Pm=new Zt,wd=new Zt,Im=new Zt,ps=class extends Wn{constructor(t=new Vo){if(super(),this.isSprite=!0,this.type="Sprite",Ao===void 0){Ao=new Gn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new qc(e,5);Ao.setIndex([0,1,2,0,2,3]),Ao.setAttribute("position",new Ja(i,3,0,!1)),Ao.setAttribute("uv",new Ja(i,2,3,!1))}this.geometry=Ao,this.material=t,this.center=new Zt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&se('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Ro.setFromMatrixScale(this.matrixWorld),Pg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Co.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Ro.multiplyScalar(-Co.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;gc(pc.set(-.5,-.5,0),Co,o,Ro,s,r),gc(Oa.set(.5,-.5,0),Co,o,Ro,s,r),gc(mc.set(.5,.5,0),Co,o,Ro,s,r),Pm.set(0,0),wd.set(1,0),Im.set(1,1);let a=t.ray.intersectTriangle(pc,Oa,mc,!1,Na);if(a===null&&(gc(Oa.set(-.5,.5,0),Co,o,Ro,s,r),wd.set(0,1),a=t.ray.intersectTriangle(pc,mc,Oa,!1,Na),a===null))return;let l=t.ray.origin.distanceTo(Na);l<t.near||l>t.far||e.push({distance:l,point:Na.clone(),uv:Ns.getInterpolation(Na,pc,Oa,mc,Pm,wd,Im,new Zt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function gc(n,t,e,i,s,r){Po.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Ua.x=r*Po.x-s*Po.y,Ua.y=s*Po.x+r*Po.y):Ua.copy(Po),n.copy(t),n.x+=Ua.x,n.y+=Ua.y,n.applyMatrix4(Pg)}var Ds=new q,Td=new q,_c=new q,xc=new q,Nr=class{constructor(t=new q,e=new q(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ds)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ds.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ds.copy(this.origin).addScaledVector(this.direction,e),Ds.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Td.copy(t).add(e).multiplyScalar(.5),_c.copy(e).sub(t).normalize(),xc.copy(this.origin).sub(Td);let r=t.distanceTo(e)*.5,o=-this.direction.dot(_c),a=xc.dot(this.direction),l=-xc.dot(_c),c=xc.lengthSq(),u=Math.abs(1-o*o),d,h,p,g;if(u>0)if(d=o*l-a,h=o*a-l,g=r*u,d>=0)if(h>=-g)if(h<=g){let y=1/u;d*=y,h*=y,p=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),p=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),p=-d*d+h*(h+2*l)+c;else h<=-g?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),p=-d*d+h*(h+2*l)+c):h<=g?(d=0,h=Math.min(Math.max(-r,-l),r),p=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),p=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),p=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Td).addScaledVector(_c,h),p}intersectSphere(t,e){if(t.radius<0)return null;Ds.subVectors(t.center,this.origin);let i=Ds.dot(this.direction),s=Ds.dot(Ds)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-h.z)*d,l=(t.max.z-h.z)*d):(a=(t.max.z-h.z)*d,l=(t.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Ds)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=t.x-o.x,h=t.y-o.y,p=t.z-o.z,g=e.x-o.x,y=e.y-o.y,m=e.z-o.z,f=i.x-o.x,x=i.y-o.y,b=i.z-o.z,v=Math.abs(l),T=Math.abs(c),w=Math.abs(u),_,M,L,P,C,U,B,I,k,H,F,j;if(v>=T&&v>=w?(L=l,U=d,k=g,j=f,l>=0?(_=c,M=u,P=h,C=p,B=y,I=m,H=x,F=b):(_=u,M=c,P=p,C=h,B=m,I=y,H=b,F=x)):T>=w?(L=c,U=h,k=y,j=x,c>=0?(_=u,M=l,P=p,C=d,B=m,I=g,H=b,F=f):(_=l,M=u,P=d,C=p,B=g,I=m,H=f,F=b)):(L=u,U=p,k=m,j=b,u>=0?(_=l,M=c,P=d,C=h,B=g,I=y,H=f,F=x):(_=c,M=l,P=h,C=d,B=y,I=g,H=x,F=f)),L===0)return null;let $=_/L,Z=M/L,nt=1/L,ht=P-$*U,ct=C-Z*U,tt=B-$*k,mt=I-Z*k,_t=H-$*j,ft=F-Z*j,xt=_t*mt-ft*tt,Gt=ht*ft-ct*_t,ae=tt*ct-mt*ht;if(s){if(xt<0||Gt<0||ae<0)return null}else if((xt<0||Gt<0||ae<0)&&(xt>0||Gt>0||ae>0))return null;let Ht=xt+Gt+ae;if(Ht===0)return null;let qt=nt*(xt*U+Gt*k+ae*j);return(Ht>0?qt<0:qt>0)?null:this.at(qt/Ht,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Yc=class extends fs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new de(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fs,this.combine=mh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Lm=new Xe,Pr=new Nr,yc=new Dr,Dm=new q,vc=new q,bc=new q,Sc=new q,Ed=new q,Mc=new q,Nm=new q,wc=new q,An=class extends Wn{constructor(t=new Gn,e=new Yc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Mc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(Ed.fromBufferAttribute(d,t),o?Mc.addScaledVector(Ed,u):Mc.addScaledVector(Ed.sub(e),u))}e.add(Mc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),yc.copy(i.boundingSphere),yc.applyMatrix4(r),Pr.copy(t.ray).recast(t.near),!(yc.containsPoint(Pr.origin)===!1&&(Pr.intersectSphere(yc,Dm)===null||Pr.origin.distanceToSquared(Dm)>(t.far-t.near)**2))&&(Lm.copy(r).invert(),Pr.copy(t.ray).applyMatrix4(Lm),!(i.boundingBox!==null&&Pr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Pr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let m=h[g],f=o[m.materialIndex],x=Math.max(m.start,p.start),b=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let v=x,T=b;v<T;v+=3){let w=a.getX(v),_=a.getX(v+1),M=a.getX(v+2);s=Tc(this,f,t,i,c,u,d,w,_,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(a.count,p.start+p.count);for(let m=g,f=y;m<f;m+=3){let x=a.getX(m),b=a.getX(m+1),v=a.getX(m+2);s=Tc(this,o,t,i,c,u,d,x,b,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=h.length;g<y;g++){let m=h[g],f=o[m.materialIndex],x=Math.max(m.start,p.start),b=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let v=x,T=b;v<T;v+=3){let w=v,_=v+1,M=v+2;s=Tc(this,f,t,i,c,u,d,w,_,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),y=Math.min(l.count,p.start+p.count);for(let m=g,f=y;m<f;m+=3){let x=m,b=m+1,v=m+2;s=Tc(this,o,t,i,c,u,d,x,b,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function dv(n,t,e,i,s,r,o,a){let l;if(t.side===ai?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===_s,a),l===null)return null;wc.copy(a),wc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(wc);return c<e.near||c>e.far?null:{distance:c,point:wc.clone(),object:n}}function Tc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,vc),n.getVertexPosition(l,bc),n.getVertexPosition(c,Sc);let u=dv(n,t,e,i,vc,bc,Sc,Nm);if(u){let d=new q;Ns.getBarycoord(Nm,vc,bc,Sc,d),s&&(u.uv=Ns.getInterpolatedAttribute(s,a,l,c,d,new Zt)),r&&(u.uv1=Ns.getInterpolatedAttribute(r,a,l,c,d,new Zt)),o&&(u.normal=Ns.getInterpolatedAttribute(o,a,l,c,d,new q),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new q,materialIndex:0};Ns.getNormal(vc,bc,Sc,h.normal),u.face=h,u.barycoord=d}return u}var Zc=class extends oi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Vn,u=Vn,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ir=new Dr,fv=new Zt(.5,.5),Ec=new q,ur=class{constructor(t=new vi,e=new vi,i=new vi,s=new vi,r=new vi,o=new vi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Pi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],p=r[7],g=r[8],y=r[9],m=r[10],f=r[11],x=r[12],b=r[13],v=r[14],T=r[15];if(s[0].setComponents(c-o,p-u,f-g,T-x).normalize(),s[1].setComponents(c+o,p+u,f+g,T+x).normalize(),s[2].setComponents(c+a,p+d,f+y,T+b).normalize(),s[3].setComponents(c-a,p-d,f-y,T-b).normalize(),i)s[4].setComponents(l,h,m,v).normalize(),s[5].setComponents(c-l,p-h,f-m,T-v).normalize();else if(s[4].setComponents(c-l,p-h,f-m,T-v).normalize(),e===Pi)s[5].setComponents(c+l,p+h,f+m,T+v).normalize();else if(e===Oo)s[5].setComponents(l,h,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ir.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ir.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ir)}intersectsSprite(t){Ir.center.set(0,0,0);let e=fv.distanceTo(t.center);return Ir.radius=.7071067811865476+e,Ir.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ir)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ec.x=s.normal.x>0?t.max.x:t.min.x,Ec.y=s.normal.y>0?t.max.y:t.min.y,Ec.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ec)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Um=new Xe,Kc=class n{constructor(){this.coordinateSystem=Pi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Um.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new ur),i[s].setFromProjectionMatrix(Um,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new ur),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var dr=class extends fs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new de(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Jc=new q,jc=new q,Om=new Xe,Fa=new Nr,Ac=new Dr,Ad=new q,Fm=new q,Qc=class extends Wn{constructor(t=new Gn,e=new dr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Jc.fromBufferAttribute(e,s-1),jc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Jc.distanceTo(jc);t.setAttribute("lineDistance",new fn(i,1))}else Jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ac.copy(i.boundingSphere),Ac.applyMatrix4(s),Ac.radius+=r,t.ray.intersectsSphere(Ac)===!1)return;Om.copy(s).invert(),Fa.copy(t.ray).applyMatrix4(Om);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=p,m=g-1;y<m;y+=c){let f=u.getX(y),x=u.getX(y+1),b=Rc(this,t,Fa,l,f,x,y);b&&e.push(b)}if(this.isLineLoop){let y=u.getX(g-1),m=u.getX(p),f=Rc(this,t,Fa,l,y,m,g-1);f&&e.push(f)}}else{let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=p,m=g-1;y<m;y+=c){let f=Rc(this,t,Fa,l,y,y+1,y);f&&e.push(f)}if(this.isLineLoop){let y=Rc(this,t,Fa,l,g-1,p,g-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Rc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Jc.fromBufferAttribute(a,s),jc.fromBufferAttribute(a,r),e.distanceSqToSegment(Jc,jc,Ad,Fm)>i)return;Ad.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ad);if(!(c<t.near||c>t.far))return{distance:c,point:Fm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Bm=new q,km=new q,Bs=class extends Qc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Bm.fromBufferAttribute(e,s),km.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Bm.distanceTo(km);t.setAttribute("lineDistance",new fn(i,1))}else Jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ja=class extends oi{constructor(t=[],e=Fr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Qa=class extends oi{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var ks=class extends oi{constructor(t,e,i=Xi,s,r,o,a=Vn,l=Vn,c,u=Os,d=1){if(u!==Os&&u!==Vs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ko(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},tl=class extends ks{constructor(t,e=Xi,i=Fr,s,r,o=Vn,a=Vn,l,c=Os){let u={width:t,height:t,depth:1},d=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},el=class extends oi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Go=class n extends Gn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,p=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new fn(c,3)),this.setAttribute("normal",new fn(u,3)),this.setAttribute("uv",new fn(d,2));function g(y,m,f,x,b,v,T,w,_,M,L){let P=v/_,C=T/M,U=v/2,B=T/2,I=w/2,k=_+1,H=M+1,F=0,j=0,$=new q;for(let Z=0;Z<H;Z++){let nt=Z*C-B;for(let ht=0;ht<k;ht++){let ct=ht*P-U;$[y]=ct*x,$[m]=nt*b,$[f]=I,c.push($.x,$.y,$.z),$[y]=0,$[m]=0,$[f]=w>0?1:-1,u.push($.x,$.y,$.z),d.push(ht/_),d.push(1-Z/M),F+=1}}for(let Z=0;Z<M;Z++)for(let nt=0;nt<_;nt++){let ht=h+nt+k*Z,ct=h+nt+k*(Z+1),tt=h+(nt+1)+k*(Z+1),mt=h+(nt+1)+k*Z;l.push(ht,ct,mt),l.push(ct,tt,mt),j+=6}a.addGroup(p,j,L),p+=j,h+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var nl=class n extends Gn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=t/a,h=e/l,p=[],g=[],y=[],m=[];for(let f=0;f<u;f++){let x=f*h-o;for(let b=0;b<c;b++){let v=b*d-r;g.push(v,-x,0),y.push(0,0,1),m.push(b/a),m.push(1-f/l)}}for(let f=0;f<l;f++)for(let x=0;x<a;x++){let b=x+c*f,v=x+c*(f+1),T=x+1+c*(f+1),w=x+1+c*f;p.push(b,v,w),p.push(v,T,w)}this.setIndex(p),this.setAttribute("position",new fn(g,3)),this.setAttribute("normal",new fn(y,3)),this.setAttribute("uv",new fn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function kr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(zm(s))s.isRenderTargetTexture?(Jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(zm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Zn(n){let t={};for(let e=0;e<n.length;e++){let i=kr(n[e]);for(let s in i)t[s]=i[s]}return t}function zm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function pv(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function pf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Me.workingColorSpace}var Ig={clone:kr,merge:Zn},mv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,gv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ms=class extends fs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=mv,this.fragmentShader=gv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=kr(t.uniforms),this.uniformsGroups=pv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new de().setHex(s.value);break;case"v2":this.uniforms[i].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new q().fromArray(s.value);break;case"v4":this.uniforms[i].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new le().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Xe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},th=class extends ms{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var gs=class extends fs{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new de(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new de(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=eu,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fs,this.combine=mh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},eh=class extends fs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=_g,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},nh=class extends fs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Io(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Cc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var fr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ih=class extends fr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Pd,endingEnd:Pd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Id:r=t,a=2*e-i;break;case Ld:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Id:o=t,l=2*i-e;break;case Ld:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,p=this._weightNext,g=(i-e)/(s-e),y=g*g,m=y*g,f=-h*m+2*h*y-h*g,x=(1+h)*m+(-1.5-2*h)*y+(-.5+h)*g+1,b=(-1-p)*m+(1.5+p)*y+.5*g,v=p*m-p*y;for(let T=0;T!==a;++T)r[T]=f*o[u+T]+x*o[c+T]+b*o[l+T]+v*o[d+T];return r}},sh=class extends fr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},rh=class extends fr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},oh=class extends fr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let g=(i-e)/(s-e),y=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*g;return r}let h=a*2,p=t-1;for(let g=0;g!==a;++g){let y=o[c+g],m=o[l+g],f=p*h+g*2,x=d[f],b=d[f+1],v=t*h+g*2,T=u[v],w=u[v+1],_=xv(i,e,x,T,s);r[g]=Lg(_,y,b,w,m)}return r}};function Lg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function _v(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function xv(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Lg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=_v(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Mi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Io(e,this.TimeBufferType),this.values=Io(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Io(t.times,Array),values:Io(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Cc(t.settings)&&(i.settings={inTangents:Io(t.settings.inTangents,Array),outTangents:Io(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new rh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new sh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ih(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new oh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Va:e=this.InterpolantFactoryMethodDiscrete;break;case Hc:e=this.InterpolantFactoryMethodLinear;break;case Lc:e=this.InterpolantFactoryMethodSmooth;break;case Cd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Jt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Va;case this.InterpolantFactoryMethodLinear:return Hc;case this.InterpolantFactoryMethodSmooth:return Lc;case this.InterpolantFactoryMethodBezier:return Cd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Cc(this.settings)&&(Vm(this.settings.inTangents,t),Vm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Cc(this.settings)&&(Gm(this.settings.inTangents,t),Gm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(se("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(se("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){se("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){se("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Ny(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){se("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Lc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,h=d-i,p=d+i;for(let g=0;g!==i;++g){let y=e[d+g];if(y!==e[h+g]||y!==e[p+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,h=o*i;for(let p=0;p!==i;++p)e[h+p]=e[d+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Cc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Vm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Gm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Mi.prototype.ValueTypeName="";Mi.prototype.TimeBufferType=Float32Array;Mi.prototype.ValueBufferType=Float32Array;Mi.prototype.DefaultInterpolation=Hc;var pr=class extends Mi{constructor(t,e,i){super(t,e,i)}};pr.prototype.ValueTypeName="bool";pr.prototype.ValueBufferType=Array;pr.prototype.DefaultInterpolation=Va;pr.prototype.InterpolantFactoryMethodLinear=void 0;pr.prototype.InterpolantFactoryMethodSmooth=void 0;var ah=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};ah.prototype.ValueTypeName="color";var lh=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};lh.prototype.ValueTypeName="number";var ch=class extends fr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)bi.slerpFlat(r,0,o,c-a,o,c,l);return r}},il=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ch(this.times,this.values,this.getValueSize(),t)}};il.prototype.ValueTypeName="quaternion";il.prototype.InterpolantFactoryMethodSmooth=void 0;var mr=class extends Mi{constructor(t,e,i){super(t,e,i)}};mr.prototype.ValueTypeName="string";mr.prototype.ValueBufferType=Array;mr.prototype.DefaultInterpolation=Va;mr.prototype.InterpolantFactoryMethodLinear=void 0;mr.prototype.InterpolantFactoryMethodSmooth=void 0;var hh=class extends Mi{constructor(t,e,i,s){super(t,e,i,s)}};hh.prototype.ValueTypeName="vector";var uh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let p=c[d],g=c[d+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Dg=new uh,dh=class{constructor(t){this.manager=t!==void 0?t:Dg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};dh.DEFAULT_MATERIAL_NAME="__DEFAULT";var sl=class extends Wn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new de(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Rd=new Xe,Hm=new q,Wm=new q,fh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new Xe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ur,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Hm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Hm),Wm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Wm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Rd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Rd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Oo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Rd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Pc=new q,Ic=new bi,us=new q,rl=class extends Wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xe,this.projectionMatrix=new Xe,this.projectionMatrixInverse=new Xe,this.coordinateSystem=Pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Pc,Ic,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pc,Ic,us.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Pc,Ic,us),us.x===1&&us.y===1&&us.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pc,Ic,us.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hr=new q,Xm=new Zt,$m=new Zt,ii=class extends rl{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Bo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ka*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Bo*2*Math.atan(Math.tan(ka*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){hr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(hr.x,hr.y).multiplyScalar(-t/hr.z),hr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(hr.x,hr.y).multiplyScalar(-t/hr.z)}getViewSize(t,e){return this.getViewBounds(t,Xm,$m),e.subVectors($m,Xm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ka*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ol=class extends rl{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Dd=class extends fh{constructor(){super(new ol(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},al=class extends sl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.target=new Wn,this.shadow=new Dd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},ll=class extends sl{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Lo=-90,Do=1,Ho=class extends Wn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ii(Lo,Do,t,e);s.layers=this.layers,this.add(s);let r=new ii(Lo,Do,t,e);r.layers=this.layers,this.add(r);let o=new ii(Lo,Do,t,e);o.layers=this.layers,this.add(o);let a=new ii(Lo,Do,t,e);a.layers=this.layers,this.add(a);let l=new ii(Lo,Do,t,e);l.layers=this.layers,this.add(l);let c=new ii(Lo,Do,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Pi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Oo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=t.getRenderTarget(),h=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(d,h,p),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},ph=class extends ii{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var mf="\\[\\]\\.:\\/",yv=new RegExp("["+mf+"]","g"),gf="[^"+mf+"]",vv="[^"+mf.replace("\\.","")+"]",bv=/((?:WC+[\/:])*)/.source.replace("WC",gf),Sv=/(WCOD+)?/.source.replace("WCOD",vv),Mv=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gf),wv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gf),Tv=new RegExp("^"+bv+Sv+Mv+wv+"$"),Ev=["material","materials","bones","map"],Nd=class{constructor(t,e,i){let s=i||Je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Je=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(yv,"")}static parseTrackName(t){let e=Tv.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Ev.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){se("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){se("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){se("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){se("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){se("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){se("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;se("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){se("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Je.Composite=Nd;Je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Je.prototype.GetterByBindingType=[Je.prototype._getValue_direct,Je.prototype._getValue_array,Je.prototype._getValue_arrayElement,Je.prototype._getValue_toArray];Je.prototype.SetterByBindingTypeAndVersioning=[[Je.prototype._setValue_direct,Je.prototype._setValue_direct_setNeedsUpdate,Je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_array,Je.prototype._setValue_array_setNeedsUpdate,Je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_arrayElement,Je.prototype._setValue_arrayElement_setNeedsUpdate,Je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_fromArray,Je.prototype._setValue_fromArray_setNeedsUpdate,Je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var RR=new Float32Array(1);var Wo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ye(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ud=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var cl=class extends Wi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function _f(n,t,e,i){let s=Av(i);switch(e){case tf:return n*t;case nf:return n*t/s.components*s.byteLength;case Sh:return n*t/s.components*s.byteLength;case xr:return n*t*2/s.components*s.byteLength;case Mh:return n*t*2/s.components*s.byteLength;case ef:return n*t*3/s.components*s.byteLength;case Yi:return n*t*4/s.components*s.byteLength;case wh:return n*t*4/s.components*s.byteLength;case dl:case fl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case pl:case ml:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Eh:case Rh:return Math.max(n,16)*Math.max(t,8)/4;case Th:case Ah:return Math.max(n,8)*Math.max(t,8)/2;case Ch:case Ph:case Lh:case Dh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ih:case gl:case Nh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Uh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Oh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Fh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Bh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case kh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case zh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Vh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Gh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Hh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Wh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Xh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case $h:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case qh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Yh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Zh:case Kh:case Jh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case jh:case Qh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case _l:case tu:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Av(n){switch(n){case ui:case Kd:return{byteLength:1,components:1};case Yo:case Jd:case qi:return{byteLength:2,components:1};case vh:case bh:return{byteLength:2,components:4};case Xi:case yh:case $i:return{byteLength:4,components:1};case jd:case Qd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function e0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Cv(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((p,g)=>p.start-g.start);let h=0;for(let p=1;p<d.length;p++){let g=d[h],y=d[p];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++h,d[h]=y)}d.length=h+1;for(let p=0,g=d.length;p<g;p++){let y=d[p];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Pv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Iv=`#ifdef USE_ALPHAHASH
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
#endif`,Lv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Dv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Nv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Uv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ov=`#ifdef USE_AOMAP
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
#endif`,Fv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Bv=`#ifdef USE_BATCHING
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
#endif`,kv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,zv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Vv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Gv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Hv=`#ifdef USE_IRIDESCENCE
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
#endif`,Wv=`#ifdef USE_BUMPMAP
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
#endif`,Xv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,$v=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,qv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Yv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Zv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Kv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Jv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,jv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Qv=`#define PI 3.141592653589793
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
} // validated`,tb=`vec3 transformedNormal = objectNormal;
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
#endif`,eb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,nb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ib=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,sb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,rb="gl_FragColor = linearToOutputTexel( gl_FragColor );",ob=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ab=`#ifdef USE_ENVMAP
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
#endif`,lb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,cb=`#ifdef USE_ENVMAP
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
#endif`,hb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ub=`#ifdef USE_ENVMAP
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
#endif`,db=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,fb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,pb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,mb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gb=`#ifdef USE_GRADIENTMAP
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
}`,_b=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,xb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,yb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,vb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,bb=`#ifdef USE_ENVMAP
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
#endif`,Sb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Mb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,wb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Tb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Eb=`PhysicalMaterial material;
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
#endif`,Ab=`uniform sampler2D dfgLUT;
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
}`,Rb=`
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
#endif`,Cb=`#if defined( RE_IndirectDiffuse )
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
#endif`,Pb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ib=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Lb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Db=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Nb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ub=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ob=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Fb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Bb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,kb=`#if defined( USE_POINTS_UV )
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
#endif`,zb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Vb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Gb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Hb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Wb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Xb=`#ifdef USE_MORPHTARGETS
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
#endif`,$b=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Yb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Zb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Kb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Jb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,jb=`#ifdef USE_NORMALMAP
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
#endif`,Qb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,tS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,eS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,nS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,iS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,sS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,rS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,oS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,aS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,lS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,cS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,hS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,uS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,dS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,pS=`float getShadowMask() {
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
}`,mS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,gS=`#ifdef USE_SKINNING
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
#endif`,_S=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,xS=`#ifdef USE_SKINNING
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
#endif`,yS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,vS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,bS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,SS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,MS=`#ifdef USE_TRANSMISSION
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
#endif`,wS=`#ifdef USE_TRANSMISSION
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
#endif`,TS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ES=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,AS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,RS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,CS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,PS=`uniform sampler2D t2D;
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
}`,IS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,LS=`uniform float backgroundBlurriness;
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
}`,DS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,US=`#include <common>
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
}`,OS=`#if DEPTH_PACKING == 3200
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
}`,FS=`#define DISTANCE
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
}`,BS=`#define DISTANCE
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
}`,kS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,zS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VS=`uniform float scale;
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
}`,GS=`uniform vec3 diffuse;
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
}`,HS=`#include <common>
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
}`,WS=`uniform vec3 diffuse;
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
}`,XS=`#define LAMBERT
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
}`,$S=`#define LAMBERT
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
}`,qS=`#define MATCAP
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
}`,YS=`#define MATCAP
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
}`,ZS=`#define NORMAL
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
}`,KS=`#define NORMAL
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
}`,JS=`#define PHONG
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
}`,jS=`#define PHONG
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
}`,QS=`#define STANDARD
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
}`,tM=`#define STANDARD
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
}`,eM=`#define TOON
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
}`,nM=`#define TOON
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
}`,iM=`uniform float size;
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
}`,sM=`uniform vec3 diffuse;
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
}`,rM=`#include <common>
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
}`,oM=`uniform vec3 color;
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
}`,aM=`uniform float rotation;
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
}`,lM=`uniform vec3 diffuse;
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
}`,pe={alphahash_fragment:Pv,alphahash_pars_fragment:Iv,alphamap_fragment:Lv,alphamap_pars_fragment:Dv,alphatest_fragment:Nv,alphatest_pars_fragment:Uv,aomap_fragment:Ov,aomap_pars_fragment:Fv,batching_pars_vertex:Bv,batching_vertex:kv,begin_vertex:zv,beginnormal_vertex:Vv,bsdfs:Gv,iridescence_fragment:Hv,bumpmap_pars_fragment:Wv,clipping_planes_fragment:Xv,clipping_planes_pars_fragment:$v,clipping_planes_pars_vertex:qv,clipping_planes_vertex:Yv,color_fragment:Zv,color_pars_fragment:Kv,color_pars_vertex:Jv,color_vertex:jv,common:Qv,defaultnormal_vertex:tb,displacementmap_pars_vertex:eb,displacementmap_vertex:nb,emissivemap_fragment:ib,emissivemap_pars_fragment:sb,colorspace_fragment:rb,colorspace_pars_fragment:ob,envmap_fragment:ab,envmap_common_pars_fragment:lb,envmap_pars_fragment:cb,envmap_pars_vertex:hb,envmap_physical_pars_fragment:bb,envmap_vertex:ub,fog_vertex:db,fog_pars_vertex:fb,fog_fragment:pb,fog_pars_fragment:mb,gradientmap_pars_fragment:gb,lightmap_pars_fragment:_b,lights_lambert_fragment:xb,lights_lambert_pars_fragment:yb,lights_pars_begin:vb,lights_toon_fragment:Sb,lights_toon_pars_fragment:Mb,lights_phong_fragment:wb,lights_phong_pars_fragment:Tb,lights_physical_fragment:Eb,lights_physical_pars_fragment:Ab,lights_fragment_begin:Rb,lights_fragment_maps:Cb,lights_fragment_end:Pb,lightprobes_pars_fragment:Ib,logdepthbuf_fragment:Lb,logdepthbuf_pars_fragment:Db,logdepthbuf_pars_vertex:Nb,logdepthbuf_vertex:Ub,map_fragment:Ob,map_pars_fragment:Fb,map_particle_fragment:Bb,map_particle_pars_fragment:kb,metalnessmap_fragment:zb,metalnessmap_pars_fragment:Vb,morphinstance_vertex:Gb,morphcolor_vertex:Hb,morphnormal_vertex:Wb,morphtarget_pars_vertex:Xb,morphtarget_vertex:$b,normal_fragment_begin:qb,normal_fragment_maps:Yb,normal_pars_fragment:Zb,normal_pars_vertex:Kb,normal_vertex:Jb,normalmap_pars_fragment:jb,clearcoat_normal_fragment_begin:Qb,clearcoat_normal_fragment_maps:tS,clearcoat_pars_fragment:eS,iridescence_pars_fragment:nS,opaque_fragment:iS,packing:sS,premultiplied_alpha_fragment:rS,project_vertex:oS,dithering_fragment:aS,dithering_pars_fragment:lS,roughnessmap_fragment:cS,roughnessmap_pars_fragment:hS,shadowmap_pars_fragment:uS,shadowmap_pars_vertex:dS,shadowmap_vertex:fS,shadowmask_pars_fragment:pS,skinbase_vertex:mS,skinning_pars_vertex:gS,skinning_vertex:_S,skinnormal_vertex:xS,specularmap_fragment:yS,specularmap_pars_fragment:vS,tonemapping_fragment:bS,tonemapping_pars_fragment:SS,transmission_fragment:MS,transmission_pars_fragment:wS,uv_pars_fragment:TS,uv_pars_vertex:ES,uv_vertex:AS,worldpos_vertex:RS,background_vert:CS,background_frag:PS,backgroundCube_vert:IS,backgroundCube_frag:LS,cube_vert:DS,cube_frag:NS,depth_vert:US,depth_frag:OS,distance_vert:FS,distance_frag:BS,equirect_vert:kS,equirect_frag:zS,linedashed_vert:VS,linedashed_frag:GS,meshbasic_vert:HS,meshbasic_frag:WS,meshlambert_vert:XS,meshlambert_frag:$S,meshmatcap_vert:qS,meshmatcap_frag:YS,meshnormal_vert:ZS,meshnormal_frag:KS,meshphong_vert:JS,meshphong_frag:jS,meshphysical_vert:QS,meshphysical_frag:tM,meshtoon_vert:eM,meshtoon_frag:nM,points_vert:iM,points_frag:sM,shadow_vert:rM,shadow_frag:oM,sprite_vert:aM,sprite_frag:lM},Nt={common:{diffuse:{value:new de(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new le}},envmap:{envMap:{value:null},envMapRotation:{value:new le},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new le}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new le}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new le},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new le},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new le},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new le}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new le}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new le}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new de(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new de(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0},uvTransform:{value:new le}},sprite:{diffuse:{value:new de(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new le},alphaMap:{value:null},alphaMapTransform:{value:new le},alphaTest:{value:0}}},vs={basic:{uniforms:Zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new de(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new de(0)},specular:{value:new de(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Zn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new de(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Zn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new de(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Zn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Zn([Nt.points,Nt.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Zn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Zn([Nt.common,Nt.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Zn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Zn([Nt.sprite,Nt.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new le},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new le}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Zn([Nt.common,Nt.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Zn([Nt.lights,Nt.fog,{color:{value:new de(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};vs.physical={uniforms:Zn([vs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new le},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new le},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new le},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new le},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new le},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new le},sheen:{value:0},sheenColor:{value:new de(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new le},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new le},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new le},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new le},attenuationDistance:{value:0},attenuationColor:{value:new de(0)},specularColor:{value:new de(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new le},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new le},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new le}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var iu={r:0,b:0,g:0},cM=new Xe,n0=new le;n0.set(-1,0,0,0,1,0,0,0,1);function hM(n,t,e,i,s,r){let o=new de(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function p(x){let b=x.isScene===!0?x.background:null;if(b&&b.isTexture){let v=x.backgroundBlurriness>0;b=t.get(b,v)}return b}function g(x){let b=!1,v=p(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),b=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(x,b){let v=p(b);v&&v.isCubeTexture?(c===void 0&&(c=new An(new Go(1,1,1),new ms({name:"BackgroundCubeMaterial",uniforms:kr(vs.backgroundCube.uniforms),vertexShader:vs.backgroundCube.vertexShader,fragmentShader:vs.backgroundCube.fragmentShader,side:ai,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(T,w,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(cM.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(n0),c.material.toneMapped=Me.getTransfer(v.colorSpace)!==Le,(u!==v||d!==v.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,d=v.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new An(new nl(2,2),new ms({name:"BackgroundMaterial",uniforms:kr(vs.background.uniforms),vertexShader:vs.background.vertexShader,fragmentShader:vs.background.fragmentShader,side:_s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=Me.getTransfer(v.colorSpace)!==Le,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||d!==v.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,d=v.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,b){x.getRGB(iu,pf(n)),e.buffers.color.setClear(iu.r,iu.g,iu.b,b,r)}function f(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,b=1){o.set(x),a=b,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:g,addToRenderList:y,dispose:f}}function uM(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(C,U,B,I,k){let H=!1,F=d(C,I,B,U);r!==F&&(r=F,c(r.object)),H=p(C,I,B,k),H&&g(C,I,B,k),k!==null&&t.update(k,n.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,v(C,U,B,I),k!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(k).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function u(C){return n.deleteVertexArray(C)}function d(C,U,B,I){let k=I.wireframe===!0,H=i[U.id];H===void 0&&(H={},i[U.id]=H);let F=C.isInstancedMesh===!0?C.id:0,j=H[F];j===void 0&&(j={},H[F]=j);let $=j[B.id];$===void 0&&($={},j[B.id]=$);let Z=$[k];return Z===void 0&&(Z=h(l()),$[k]=Z),Z}function h(C){let U=[],B=[],I=[];for(let k=0;k<e;k++)U[k]=0,B[k]=0,I[k]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:B,attributeDivisors:I,object:C,attributes:{},index:null}}function p(C,U,B,I){let k=r.attributes,H=U.attributes,F=0,j=B.getAttributes();for(let $ in j)if(j[$].location>=0){let nt=k[$],ht=H[$];if(ht===void 0&&($==="instanceMatrix"&&C.instanceMatrix&&(ht=C.instanceMatrix),$==="instanceColor"&&C.instanceColor&&(ht=C.instanceColor)),nt===void 0||nt.attribute!==ht||ht&&nt.data!==ht.data)return!0;F++}return r.attributesNum!==F||r.index!==I}function g(C,U,B,I){let k={},H=U.attributes,F=0,j=B.getAttributes();for(let $ in j)if(j[$].location>=0){let nt=H[$];nt===void 0&&($==="instanceMatrix"&&C.instanceMatrix&&(nt=C.instanceMatrix),$==="instanceColor"&&C.instanceColor&&(nt=C.instanceColor));let ht={};ht.attribute=nt,nt&&nt.data&&(ht.data=nt.data),k[$]=ht,F++}r.attributes=k,r.attributesNum=F,r.index=I}function y(){let C=r.newAttributes;for(let U=0,B=C.length;U<B;U++)C[U]=0}function m(C){f(C,0)}function f(C,U){let B=r.newAttributes,I=r.enabledAttributes,k=r.attributeDivisors;B[C]=1,I[C]===0&&(n.enableVertexAttribArray(C),I[C]=1),k[C]!==U&&(n.vertexAttribDivisor(C,U),k[C]=U)}function x(){let C=r.newAttributes,U=r.enabledAttributes;for(let B=0,I=U.length;B<I;B++)U[B]!==C[B]&&(n.disableVertexAttribArray(B),U[B]=0)}function b(C,U,B,I,k,H,F){F===!0?n.vertexAttribIPointer(C,U,B,k,H):n.vertexAttribPointer(C,U,B,I,k,H)}function v(C,U,B,I){y();let k=I.attributes,H=B.getAttributes(),F=U.defaultAttributeValues;for(let j in H){let $=H[j];if($.location>=0){let Z=k[j];if(Z===void 0&&(j==="instanceMatrix"&&C.instanceMatrix&&(Z=C.instanceMatrix),j==="instanceColor"&&C.instanceColor&&(Z=C.instanceColor)),Z!==void 0){let nt=Z.normalized,ht=Z.itemSize,ct=t.get(Z);if(ct===void 0)continue;let tt=ct.buffer,mt=ct.type,_t=ct.bytesPerElement,ft=mt===n.INT||mt===n.UNSIGNED_INT||Z.gpuType===yh;if(Z.isInterleavedBufferAttribute){let xt=Z.data,Gt=xt.isInterleavedBuffer===!0?xt.stride:xt.itemSize,ae=Z.offset;if(xt.isInstancedInterleavedBuffer||xt.isInstancedBufferAttribute){for(let Ht=0;Ht<$.locationSize;Ht++)f($.location+Ht,xt.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=xt.meshPerAttribute*xt.count)}else for(let Ht=0;Ht<$.locationSize;Ht++)m($.location+Ht);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Ht=0;Ht<$.locationSize;Ht++)b($.location+Ht,ht/$.locationSize,mt,nt,Gt*_t,(ae+ht/$.locationSize*Ht)*_t,ft)}else{if(Z.isInstancedBufferAttribute){for(let xt=0;xt<$.locationSize;xt++)f($.location+xt,Z.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let xt=0;xt<$.locationSize;xt++)m($.location+xt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let xt=0;xt<$.locationSize;xt++)b($.location+xt,ht/$.locationSize,mt,nt,ht*_t,ht/$.locationSize*xt*_t,ft)}}else if(F!==void 0){let nt=F[j];if(nt!==void 0)switch(nt.length){case 2:n.vertexAttrib2fv($.location,nt);break;case 3:n.vertexAttrib3fv($.location,nt);break;case 4:n.vertexAttrib4fv($.location,nt);break;default:n.vertexAttrib1fv($.location,nt)}}}}x()}function T(){L();for(let C in i){let U=i[C];for(let B in U){let I=U[B];for(let k in I){let H=I[k];for(let F in H)u(H[F].object),delete H[F];delete I[k]}}delete i[C]}}function w(C){if(i[C.id]===void 0)return;let U=i[C.id];for(let B in U){let I=U[B];for(let k in I){let H=I[k];for(let F in H)u(H[F].object),delete H[F];delete I[k]}}delete i[C.id]}function _(C){for(let U in i){let B=i[U];for(let I in B){let k=B[I];if(k[C.id]===void 0)continue;let H=k[C.id];for(let F in H)u(H[F].object),delete H[F];delete k[C.id]}}}function M(C){for(let U in i){let B=i[U],I=C.isInstancedMesh===!0?C.id:0,k=B[I];if(k!==void 0){for(let H in k){let F=k[H];for(let j in F)u(F[j].object),delete F[j];delete k[H]}delete B[I],Object.keys(B).length===0&&delete i[U]}}}function L(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:P,dispose:T,releaseStatesOfGeometry:w,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:m,disableUnusedAttributes:x}}function dM(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let p=0;p<u;p++)h+=c[p];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function fM(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Yi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===qi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ui&&_!==$i&&!M&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Jt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),f=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:f,maxVertexUniforms:x,maxVaryings:b,maxFragmentUniforms:v,maxSamples:T,samples:w}}function pM(n){let t=this,e=null,i=0,s=!1,r=!1,o=new vi,a=new le,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let p=d.length!==0||h||i!==0||s;return s=h,i=d.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){e=u(d,h,0)},this.setState=function(d,h,p){let g=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,f=n.get(d);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,b=x*4,v=f.clippingState||null;l.value=v,v=u(g,h,b,p);for(let T=0;T!==b;++T)v[T]=e[T];f.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(d,h,p,g){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let f=p+y*4,x=h.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<f)&&(m=new Float32Array(f));for(let b=0,v=p;b!==y;++b,v+=4)o.copy(d[b]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var vl=class extends Si{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ja(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Go(5,5,5),r=new ms({name:"CubemapFromEquirect",uniforms:kr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ai,blending:Ur});r.uniforms.tEquirect.value=e;let o=new An(s,r),a=e.minFilter;return e.minFilter===zs&&(e.minFilter=ri),new Ho(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Ng=256,mM=3,gM=20,i0=256,s0=16,_M=3,xM=new q,yM=new de,ru=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ho(1,10,null),this._boxMesh=new An(new Go(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=xM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(yM));let m=new Ho(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=p,l.autoClearStencil=g,t.background=y,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Fg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Og(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Ng,hf(t))}_fromTexture(t,e){t.mapping===Fr||t.mapping===qo?this._setSize(t.image.length===0?Ng:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Ug(t,!1,!1),i=Math.log2(t)-mM;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ug(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Fr||t.mapping===qo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Fg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Og()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=vM(),this._integrationMaterial=bM());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/s0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-_M)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(i0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=SM());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Ug(n,t,e){return new vl(n,{minFilter:zs,generateMipmaps:t,type:qi,colorSpace:Ga,depthBuffer:e})}function bl(n,t,e){return new ms({name:n,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:ai,blending:Ur,depthTest:!1,depthWrite:!1})}function vM(){return bl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${i0}u

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
	`)}function bM(){return bl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:s0}},`

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
	`)}function SM(){return bl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${gM}
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
	`)}function Og(){return bl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Fg(){return bl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function MM(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,p=!1){return h==null?null:p?o(h):r(h)}function r(h){if(h&&h.isTexture){let p=h.mapping;if(p===gh||p===_h)if(t.has(h)){let g=t.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let y=new vl(g.height);return y.fromEquirectangularTexture(n,h),t.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let p=h.mapping,g=p===gh||p===_h,y=p===Fr||p===qo;if(g||y){let m=e.get(h),f=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==f)return i===null&&(i=new ru(n)),m=g?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),m.texture;if(m!==void 0)return m.texture;{let x=h.image;return g&&x&&x.height>0||y&&x&&l(x)?(i===null&&(i=new ru(n)),m=g?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,p){return p===gh?h.mapping=Fr:p===_h&&(h.mapping=qo),h}function l(h){let p=0,g=6;for(let y=0;y<g;y++)h[y]!==void 0&&p++;return p===g}function c(h){let p=h.target;p.removeEventListener("dispose",c);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function u(h){let p=h.target;p.removeEventListener("dispose",u);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function wM(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Ba("WebGLRenderer: "+i+" extension not supported."),s}}}function TM(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function u(g){let y=g.attributes;for(let m in y)t.update(y[m],n.ARRAY_BUFFER)}function d(g){let y=g.index,m=g.attributes.position,f=0;if(m===void 0)return;let x=y!==null?y.array.length:m.array.length/3-1,b=m.count>=65535?Ka:Za,v=new b(Math.ceil(x/3)*6,1),T=v.array;if(y!==null){let _=y.array;f=y.version;for(let M=0,L=0;M<x;M+=3){let P=_[M+0],C=_[M+1],U=_[M+2];T[L++]=P,T[L++]=C,T[L++]=C,T[L++]=U,T[L++]=U,T[L++]=P}}else{f=m.version;for(let _=0,M=0;_<x;_+=3){let L=_+0,P=_+1,C=_+2;T[M++]=L,T[M++]=P,T[M++]=P,T[M++]=C,T[M++]=C,T[M++]=L}}v.version=f;let w=r.get(g);w&&t.remove(w),r.set(g,v)}function h(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&d(g)}else d(g);return r.get(g)}function p(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:p}}function EM(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),e.update(h,i,1)}function c(d,h,p){p!==0&&(n.drawElementsInstanced(i,h,r,d*o,p),e.update(h,i,p))}function u(d,h,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,p);let y=0;for(let m=0;m<p;m++)y+=h[m];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function AM(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:se("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function RM(n,t,e){let i=new WeakMap,s=new tn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let L=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",L)};h!==void 0&&h.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],f=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],b=0;p===!0&&(b=1),g===!0&&(b=2),y===!0&&(b=3);let v=a.attributes.position.count*b,T=1;v>t.maxTextureSize&&(T=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let w=new Float32Array(v*T*4*d),_=new $a(w,v,T,d);_.type=$i,_.needsUpdate=!0;let M=b*4;for(let P=0;P<d;P++){let C=m[P],U=f[P],B=x[P],I=v*T*4*P;for(let k=0;k<C.count;k++){let H=k*M;p===!0&&(s.fromBufferAttribute(C,k),w[I+H+0]=s.x,w[I+H+1]=s.y,w[I+H+2]=s.z,w[I+H+3]=0),g===!0&&(s.fromBufferAttribute(U,k),w[I+H+4]=s.x,w[I+H+5]=s.y,w[I+H+6]=s.z,w[I+H+7]=0),y===!0&&(s.fromBufferAttribute(B,k),w[I+H+8]=s.x,w[I+H+9]=s.y,w[I+H+10]=s.z,w[I+H+11]=B.itemSize===4?s.w:1)}}h={count:d,texture:_,size:new Zt(v,T)},i.set(a,h),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let y=0;y<c.length;y++)p+=c[y];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function CM(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=t.get(c,d);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==u&&(p.update(),r.set(p,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var PM={[Gd]:"LINEAR_TONE_MAPPING",[Hd]:"REINHARD_TONE_MAPPING",[Wd]:"CINEON_TONE_MAPPING",[Xd]:"ACES_FILMIC_TONE_MAPPING",[qd]:"AGX_TONE_MAPPING",[Yd]:"NEUTRAL_TONE_MAPPING",[$d]:"CUSTOM_TONE_MAPPING"};function IM(n,t,e,i,s,r){let o=new Si(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Gn;u.setAttribute("position",new fn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new fn([0,2,0,0,2,0],2));let d=new th({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new An(u,d),p=new ol(-1,1,1,-1,0,1),g=null,y=null,m=!1,f,x=null,b=[],v=!1;this.setSize=function(T,w){o.setSize(T,w),a!==null&&a.setSize(T,w),l!==null&&l.setSize(T,w);for(let _=0;_<b.length;_++){let M=b[_];M.setSize&&M.setSize(T,w)}},this.setEffects=function(T){b=T,v=b.length>0&&b[0].isRenderPass===!0;let w=o.width,_=o.height;b.length>0&&a===null&&(a=new Si(w,_,{type:qi,depthBuffer:!1,stencilBuffer:!1}),l=new Si(w,_,{type:qi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&b.some(L=>L.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new ks(w,_),r===!0&&(c.format=Vs,c.type=Br)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let L=0;L<b.length;L++){let P=b[L];P.setSize&&P.setSize(w,_),M&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(T,w){if(m||T.toneMapping===xs&&b.length===0)return!1;if(x=w,w!==null){let _=w.width,M=w.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return v===!1&&T.setRenderTarget(o),f=T.toneMapping,T.toneMapping=xs,!0},this.hasRenderPass=function(){return v},this.end=function(T,w){T.toneMapping=f,m=!0;let _=o,M=a;for(let L=0;L<b.length;L++){let P=b[L];P.enabled!==!1&&(P.render(T,M,_,w),P.needsSwap!==!1&&(_=M,M=M===a?l:a))}if(g!==T.outputColorSpace||y!==T.toneMapping){g=T.outputColorSpace,y=T.toneMapping,d.defines={},Me.getTransfer(g)===Le&&(d.defines.SRGB_TRANSFER="");let L=PM[y];L&&(d.defines[L]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,T.setRenderTarget(x),T.render(h,p),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var r0=new oi,o0=new ks(1,1),a0=new tl(1),l0=new $a,c0=new $c,h0=new ja,Bg=[],kg=[],zg=new Float32Array(16),Vg=new Float32Array(9),Gg=new Float32Array(4);function Ko(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Bg[s];if(r===void 0&&(r=new Float32Array(s),Bg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Rn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Cn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function au(n,t){let e=kg[t];e===void 0&&(e=new Int32Array(t),kg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function LM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function DM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Rn(e,t))return;n.uniform2fv(this.addr,t),Cn(e,t)}}function NM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Rn(e,t))return;n.uniform3fv(this.addr,t),Cn(e,t)}}function UM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Rn(e,t))return;n.uniform4fv(this.addr,t),Cn(e,t)}}function OM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Rn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Cn(e,t)}else{if(Rn(e,i))return;Gg.set(i),n.uniformMatrix2fv(this.addr,!1,Gg),Cn(e,i)}}function FM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Rn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Cn(e,t)}else{if(Rn(e,i))return;Vg.set(i),n.uniformMatrix3fv(this.addr,!1,Vg),Cn(e,i)}}function BM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Rn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Cn(e,t)}else{if(Rn(e,i))return;zg.set(i),n.uniformMatrix4fv(this.addr,!1,zg),Cn(e,i)}}function kM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function zM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Rn(e,t))return;n.uniform2iv(this.addr,t),Cn(e,t)}}function VM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Rn(e,t))return;n.uniform3iv(this.addr,t),Cn(e,t)}}function GM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Rn(e,t))return;n.uniform4iv(this.addr,t),Cn(e,t)}}function HM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function WM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Rn(e,t))return;n.uniform2uiv(this.addr,t),Cn(e,t)}}function XM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Rn(e,t))return;n.uniform3uiv(this.addr,t),Cn(e,t)}}function $M(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Rn(e,t))return;n.uniform4uiv(this.addr,t),Cn(e,t)}}function lu(n){return n.version===0&&(n.compareFunction=of,n.needsUpdate=!0),n}function qM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=lu(o0):r=r0,e.setTexture2D(t||r,s)}function YM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||c0,s)}function ZM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=lu(a0):r=h0,e.setTextureCube(t||r,s)}function KM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||l0,s)}function JM(n){switch(n){case 5126:return LM;case 35664:return DM;case 35665:return NM;case 35666:return UM;case 35674:return OM;case 35675:return FM;case 35676:return BM;case 5124:case 35670:return kM;case 35667:case 35671:return zM;case 35668:case 35672:return VM;case 35669:case 35673:return GM;case 5125:return HM;case 36294:return WM;case 36295:return XM;case 36296:return $M;case 35678:case 36198:case 36298:case 36306:case 35682:return qM;case 35679:case 36299:case 36307:return YM;case 35680:case 36300:case 36308:case 36293:return ZM;case 36289:case 36303:case 36311:case 36292:return KM}}function jM(n,t){n.uniform1fv(this.addr,t)}function QM(n,t){let e=Ko(t,this.size,2);n.uniform2fv(this.addr,e)}function tw(n,t){let e=Ko(t,this.size,3);n.uniform3fv(this.addr,e)}function ew(n,t){let e=Ko(t,this.size,4);n.uniform4fv(this.addr,e)}function nw(n,t){let e=Ko(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function iw(n,t){let e=Ko(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function sw(n,t){let e=Ko(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function rw(n,t){n.uniform1iv(this.addr,t)}function ow(n,t){n.uniform2iv(this.addr,t)}function aw(n,t){n.uniform3iv(this.addr,t)}function lw(n,t){n.uniform4iv(this.addr,t)}function cw(n,t){n.uniform1uiv(this.addr,t)}function hw(n,t){n.uniform2uiv(this.addr,t)}function uw(n,t){n.uniform3uiv(this.addr,t)}function dw(n,t){n.uniform4uiv(this.addr,t)}function fw(n,t,e){let i=this.cache,s=t.length,r=au(e,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=lu(o0):o=r0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function pw(n,t,e){let i=this.cache,s=t.length,r=au(e,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||c0,r[o])}function mw(n,t,e){let i=this.cache,s=t.length,r=au(e,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=lu(a0):o=h0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function gw(n,t,e){let i=this.cache,s=t.length,r=au(e,s);Rn(i,r)||(n.uniform1iv(this.addr,r),Cn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||l0,r[o])}function _w(n){switch(n){case 5126:return jM;case 35664:return QM;case 35665:return tw;case 35666:return ew;case 35674:return nw;case 35675:return iw;case 35676:return sw;case 5124:case 35670:return rw;case 35667:case 35671:return ow;case 35668:case 35672:return aw;case 35669:case 35673:return lw;case 5125:return cw;case 36294:return hw;case 36295:return uw;case 36296:return dw;case 35678:case 36198:case 36298:case 36306:case 35682:return fw;case 35679:case 36299:case 36307:return pw;case 35680:case 36300:case 36308:case 36293:return mw;case 36289:case 36303:case 36311:case 36292:return gw}}var vf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=JM(e.type)}},bf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=_w(e.type)}},Sf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},xf=/(\w+)(\])?(\[|\.)?/g;function Hg(n,t){n.seq.push(t),n.map[t.id]=t}function xw(n,t,e){let i=n.name,s=i.length;for(xf.lastIndex=0;;){let r=xf.exec(i),o=xf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Hg(e,c===void 0?new vf(a,n,t):new bf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new Sf(a),Hg(e,d)),e=d}}}var Zo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);xw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Wg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var yw=37297,vw=0;function bw(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Xg=new le;function Sw(n){Me._getMatrix(Xg,Me.workingColorSpace,n);let t=`mat3( ${Xg.elements.map(e=>e.toFixed(4))} )`;switch(Me.getTransfer(n)){case Ha:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return Jt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function $g(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+bw(n.getShaderSource(t),a)}else return r}function Mw(n,t){let e=Sw(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ww={[Gd]:"Linear",[Hd]:"Reinhard",[Wd]:"Cineon",[Xd]:"ACESFilmic",[qd]:"AgX",[Yd]:"Neutral",[$d]:"Custom"};function Tw(n,t){let e=ww[t];return e===void 0?(Jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var su=new q;function Ew(){Me.getLuminanceCoefficients(su);let n=su.x.toFixed(4),t=su.y.toFixed(4),e=su.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Aw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(yl).join(`
`)}function Rw(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Cw(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function yl(n){return n!==""}function qg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Yg(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Pw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mf(n){return n.replace(Pw,Iw)}function Iw(n,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Mf(e)}var Lw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Zg(n){return n.replace(Lw,Dw)}function Dw(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Kg(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var Nw={[hl]:"SHADOWMAP_TYPE_PCF",[Xo]:"SHADOWMAP_TYPE_VSM"};function Uw(n){return Nw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Ow={[qo]:"ENVMAP_MODE_REFRACTION"};function Fw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Ow[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Bw={[mh]:"ENVMAP_BLENDING_MULTIPLY",[pg]:"ENVMAP_BLENDING_MIX",[mg]:"ENVMAP_BLENDING_ADD"};function kw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Bw[n.combine]||"ENVMAP_BLENDING_NONE"}function zw(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Uw(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Fw(e),d=kw(e),h=Aw(e),p=Rw(r),g=s.createProgram(),y,m,f=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(yl).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(yl).join(`
`),m.length>0&&(m+=`
`)):(y=[Kg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(yl).join(`
`),m=[Kg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==xs?"#define TONE_MAPPING":"",e.toneMapping!==xs?pe.tonemapping_pars_fragment:"",e.toneMapping!==xs?Tw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,Mw("linearToOutputTexel",e.outputColorSpace),Ew(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(yl).join(`
`)),o=Mf(o),o=qg(o,e),o=Yg(o,e),a=Mf(a),a=qg(a,e),a=Yg(a,e),o=Zg(o),a=Zg(a),e.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===lf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===lf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=f+y+o,b=f+m+a,v=Wg(s,s.VERTEX_SHADER,x),T=Wg(s,s.FRAGMENT_SHADER,b);s.attachShader(g,v),s.attachShader(g,T),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function w(P){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(g)||"",U=s.getShaderInfoLog(v)||"",B=s.getShaderInfoLog(T)||"",I=C.trim(),k=U.trim(),H=B.trim(),F=!0,j=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(F=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,v,T);else{let $=$g(s,v,"vertex"),Z=$g(s,T,"fragment");se("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+I+`
`+$+`
`+Z)}else I!==""?Jt("WebGLProgram: Program Info Log:",I):(k===""||H==="")&&(j=!1);j&&(P.diagnostics={runnable:F,programLog:I,vertexShader:{log:k,prefix:y},fragmentShader:{log:H,prefix:m}})}s.deleteShader(v),s.deleteShader(T),_=new Zo(s,g),M=Cw(s,g)}let _;this.getUniforms=function(){return _===void 0&&w(this),_};let M;this.getAttributes=function(){return M===void 0&&w(this),M};let L=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,yw)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=vw++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=v,this.fragmentShader=T,this}var Vw=0,wf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Tf(t),e.set(t,i)),i}},Tf=class{constructor(t){this.id=Vw++,this.code=t,this.usedTimes=0}};function Gw(n){return n===xr||n===gl||n===_l}function Hw(n,t,e,i,s,r){let o=new qa,a=new wf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,M,L,P,C,U){let B=P.fog,I=C.geometry,k=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,F=t.get(_.envMap||k,H),j=h[_.type],$=i.precision;_.precision!==null&&($=i.getMaxPrecision(_.precision),$!==_.precision&&Jt("WebGLProgram.getParameters:",_.precision,"not supported, using",$,"instead."));let Z=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,nt=Z!==void 0?Z.length:0,ht=0;I.morphAttributes.position!==void 0&&(ht=1),I.morphAttributes.normal!==void 0&&(ht=2),I.morphAttributes.color!==void 0&&(ht=3);let ct,tt,mt,_t;if(j){let Ct=vs[j];ct=Ct.vertexShader,tt=Ct.fragmentShader}else{ct=_.vertexShader,tt=_.fragmentShader;let Ct=a.getVertexShaderStage(_),ue=a.getFragmentShaderStage(_);a.update(_,Ct,ue),mt=Ct.id,_t=ue.id}let ft=n.getRenderTarget(),xt=n.state.buffers.depth.getReversed(),Gt=C.isInstancedMesh===!0,ae=C.isBatchedMesh===!0,Ht=!!_.map,qt=!!_.matcap,te=!!F,re=te&&F.isPMREMTexture===!0,Ge=!!_.aoMap,He=!!_.lightMap,pn=!!_.bumpMap&&_.wireframe===!1,Fe=!!_.normalMap,Nn=!!_.displacementMap,Ee=!!_.emissiveMap,wn=!!_.metalnessMap,sn=!!_.roughnessMap,mn=_.anisotropy>0,G=_.clearcoat>0,Pt=_.diffuseRoughness>0,jt=_.dispersion>0,he=_.retroreflectivity>0,Tt=_.iridescence>0,ke=_.sheen>0,Wt=_.transmission>0,Kt=mn&&!!_.anisotropyMap,D=G&&!!_.clearcoatMap,E=G&&!!_.clearcoatNormalMap,Y=G&&!!_.clearcoatRoughnessMap,dt=Pt&&!!_.diffuseRoughnessMap,at=Tt&&!!_.iridescenceMap,vt=Tt&&!!_.iridescenceThicknessMap,bt=ke&&!!_.sheenColorMap,it=ke&&!!_.sheenRoughnessMap,rt=!!_.specularMap,gt=!!_.specularColorMap,V=!!_.specularIntensityMap,ot=Wt&&!!_.transmissionMap,st=Wt&&!!_.thicknessMap,Et=!!_.gradientMap,yt=!!_.alphaMap,Mt=_.alphaTest>0,$t=!!_.alphaHash,ee=!!_.extensions,ut=xs;_.toneMapped&&(ft===null||ft.isXRRenderTarget===!0)&&(ut=n.toneMapping);let kt=re?F.isCompressedCubeTexture?F.image[0].mipmaps:F.mipmaps:null,ne={shaderID:j,shaderType:_.type,shaderName:_.name,vertexShader:ct,fragmentShader:tt,defines:_.defines,customVertexShaderID:mt,customFragmentShaderID:_t,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:$,batching:ae,batchingColor:ae&&C._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&C.instanceColor!==null,instancingMorph:Gt&&C.morphTexture!==null,outputColorSpace:ft===null?n.outputColorSpace:ft.isXRRenderTarget===!0?ft.texture.colorSpace:Me.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ht,matcap:qt,envMap:te,envMapMode:te&&F.mapping,envMapPMREM:re,envMapMaxLod:re?kt.length-1:null,envMapSize:re?kt[0].width:null,aoMap:Ge,lightMap:He,bumpMap:pn,normalMap:Fe,displacementMap:Nn,emissiveMap:Ee,normalMapObjectSpace:Fe&&_.normalMapType===xg,normalMapTangentSpace:Fe&&_.normalMapType===eu,packedNormalMap:Fe&&_.normalMapType===eu&&Gw(_.normalMap.format),metalnessMap:wn,roughnessMap:sn,anisotropy:mn,anisotropyMap:Kt,clearcoat:G,clearcoatMap:D,clearcoatNormalMap:E,clearcoatRoughnessMap:Y,diffuseRoughness:Pt,diffuseRoughnessMap:dt,dispersion:jt,retroreflection:he,iridescence:Tt,iridescenceMap:at,iridescenceThicknessMap:vt,sheen:ke,sheenColorMap:bt,sheenRoughnessMap:it,specularMap:rt,specularColorMap:gt,specularIntensityMap:V,transmission:Wt,transmissionMap:ot,thicknessMap:st,gradientMap:Et,opaque:_.transparent===!1&&_.blending===$o&&_.alphaToCoverage===!1,alphaMap:yt,alphaTest:Mt,alphaHash:$t,combine:_.combine,mapUv:Ht&&p(_.map.channel),aoMapUv:Ge&&p(_.aoMap.channel),lightMapUv:He&&p(_.lightMap.channel),bumpMapUv:pn&&p(_.bumpMap.channel),normalMapUv:Fe&&p(_.normalMap.channel),displacementMapUv:Nn&&p(_.displacementMap.channel),emissiveMapUv:Ee&&p(_.emissiveMap.channel),metalnessMapUv:wn&&p(_.metalnessMap.channel),roughnessMapUv:sn&&p(_.roughnessMap.channel),anisotropyMapUv:Kt&&p(_.anisotropyMap.channel),clearcoatMapUv:D&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:E&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:bt&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&p(_.sheenRoughnessMap.channel),specularMapUv:rt&&p(_.specularMap.channel),specularColorMapUv:gt&&p(_.specularColorMap.channel),specularIntensityMapUv:V&&p(_.specularIntensityMap.channel),transmissionMapUv:ot&&p(_.transmissionMap.channel),thicknessMapUv:st&&p(_.thicknessMap.channel),alphaMapUv:yt&&p(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Fe||mn),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!I.attributes.uv&&(Ht||yt),fog:!!B,useFog:_.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Fe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:xt,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:nt,morphTextureStride:ht,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:U.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:ut,decodeVideoTexture:Ht&&_.map.isVideoTexture===!0&&Me.getTransfer(_.map.colorSpace)===Le,decodeVideoTextureEmissive:Ee&&_.emissiveMap.isVideoTexture===!0&&Me.getTransfer(_.emissiveMap.colorSpace)===Le,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===hi,flipSided:_.side===ai,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ee&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ee&&_.extensions.multiDraw===!0||ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ne.vertexUv1s=l.has(1),ne.vertexUv2s=l.has(2),ne.vertexUv3s=l.has(3),l.clear(),ne}function y(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let L in _.defines)M.push(L),M.push(_.defines[L]);return _.isRawShaderMaterial===!1&&(m(M,_),f(M,_),M.push(n.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function m(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function f(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let M=h[_.type],L;if(M){let P=vs[M];L=Ig.clone(P.uniforms)}else L=_.uniforms;return L}function b(_,M){let L=u.get(M);return L!==void 0?++L.usedTimes:(L=new zw(n,M,_,s),c.push(L),u.set(M,L)),L}function v(_){if(--_.usedTimes===0){let M=c.indexOf(_);c[M]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function T(_){a.remove(_)}function w(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:b,releaseProgram:v,releaseShaderCache:T,programs:c,dispose:w}}function Ww(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Xw(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Jg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function jg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let p=0;return h.isInstancedMesh&&(p+=2),h.isSkinnedMesh&&(p+=1),p}function a(h,p,g,y,m,f){let x=n[t];return x===void 0?(x={id:h.id,object:h,geometry:p,material:g,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:m,group:f},n[t]=x):(x.id=h.id,x.object=h,x.geometry=p,x.material=g,x.materialVariant=o(h),x.groupOrder=y,x.renderOrder=h.renderOrder,x.z=m,x.group=f),t++,x}function l(h,p,g,y,m,f,x){x.reversedDepth===!0&&(m=-m);let b=a(h,p,g,y,m,f);g.transmission>0?i.push(b):g.transparent===!0?s.push(b):e.push(b)}function c(h,p,g,y,m,f){let x=a(h,p,g,y,m,f);g.transmission>0?i.unshift(x):g.transparent===!0?s.unshift(x):e.unshift(x)}function u(h,p){e.length>1&&e.sort(h||Xw),i.length>1&&i.sort(p||Jg),s.length>1&&s.sort(p||Jg)}function d(){for(let h=t,p=n.length;h<p;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function $w(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new jg,n.set(i,[o])):s>=r.length?(o=new jg,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function qw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new q,color:new de};break;case"SpotLight":e={position:new q,direction:new q,color:new de,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new q,color:new de,distance:0,decay:0};break;case"HemisphereLight":e={direction:new q,skyColor:new de,groundColor:new de};break;case"RectAreaLight":e={color:new de,position:new q,halfWidth:new q,halfHeight:new q};break}return n[t.id]=e,e}}}function Yw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var Zw=0;function Kw(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Jw(n){let t=new qw,e=Yw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new q);let s=new q,r=new Xe,o=new Xe;function a(c){let u=0,d=0,h=0;for(let U=0;U<9;U++)i.probe[U].set(0,0,0);let p=0,g=0,y=0,m=0,f=0,x=0,b=0,v=0,T=0,w=0,_=0,M=0,L=0,P=0;c.sort(Kw);for(let U=0,B=c.length;U<B;U++){let I=c[U],k=I.color,H=I.intensity,F=I.distance,j=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===xr?j=I.shadow.map.texture:j=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=k.r*H,d+=k.g*H,h+=k.b*H;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],H);P++}else if(I.isSunLight){let $=t.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Z=I.shadow,nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[g]=nt,i.sunShadowMap[g]=j;let ht=Z.getViewportCount();for(let ct=0;ct<ht;ct++)i.sunShadowMatrix[y+ct]=Z.getMatrix(ct),i.sunShadowCascade[y+ct]=Z._cascadeData[ct];y+=ht,g++}i.sun[p]=$,p++}else if(I.isDirectionalLight){let $=t.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Z=I.shadow,nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.directionalShadow[m]=nt,i.directionalShadowMap[m]=j,i.directionalShadowMatrix[m]=I.shadow.matrix,T++}i.directional[m]=$,m++}else if(I.isSpotLight){let $=t.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(k).multiplyScalar(H),$.distance=F,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[x]=$;let Z=I.shadow;if(I.map&&(i.spotLightMap[M]=I.map,M++,Z.updateMatrices(I),I.castShadow&&L++),i.spotLightMatrix[x]=Z.matrix,I.castShadow){let nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,i.spotShadow[x]=nt,i.spotShadowMap[x]=j,_++}x++}else if(I.isRectAreaLight){let $=t.get(I);$.color.copy(k).multiplyScalar(H),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[b]=$,b++}else if(I.isPointLight){let $=t.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let Z=I.shadow,nt=e.get(I);nt.shadowIntensity=Z.intensity,nt.shadowBias=Z.bias,nt.shadowNormalBias=Z.normalBias,nt.shadowRadius=Z.radius,nt.shadowMapSize=Z.mapSize,nt.shadowCameraNear=Z.camera.near,nt.shadowCameraFar=Z.camera.far,i.pointShadow[f]=nt,i.pointShadowMap[f]=j,i.pointShadowMatrix[f]=I.shadow.matrix,w++}i.point[f]=$,f++}else if(I.isHemisphereLight){let $=t.get(I);$.skyColor.copy(I.color).multiplyScalar(H),$.groundColor.copy(I.groundColor).multiplyScalar(H),i.hemi[v]=$,v++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Nt.LTC_FLOAT_1,i.rectAreaLTC2=Nt.LTC_FLOAT_2):(i.rectAreaLTC1=Nt.LTC_HALF_1,i.rectAreaLTC2=Nt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let C=i.hash;(C.sunLength!==p||C.directionalLength!==m||C.pointLength!==f||C.spotLength!==x||C.rectAreaLength!==b||C.hemiLength!==v||C.numSunShadows!==g||C.numDirectionalShadows!==T||C.numPointShadows!==w||C.numSpotShadows!==_||C.numSpotMaps!==M||C.numLightProbes!==P)&&(i.sun.length=p,i.directional.length=m,i.spot.length=x,i.rectArea.length=b,i.point.length=f,i.hemi.length=v,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+M-L,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=P,C.sunLength=p,C.directionalLength=m,C.pointLength=f,C.spotLength=x,C.rectAreaLength=b,C.hemiLength=v,C.numSunShadows=g,C.numDirectionalShadows=T,C.numPointShadows=w,C.numSpotShadows=_,C.numSpotMaps=M,C.numLightProbes=P,i.version=Zw++)}function l(c,u){let d=0,h=0,p=0,g=0,y=0,m=0,f=u.matrixWorldInverse;for(let x=0,b=c.length;x<b;x++){let v=c[x];if(v.isSunLight){let T=i.sun[d];T.direction.setFromMatrixPosition(v.matrixWorld),T.direction.transformDirection(f),d++}else if(v.isDirectionalLight){let T=i.directional[h];T.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(f),h++}else if(v.isSpotLight){let T=i.spot[g];T.position.setFromMatrixPosition(v.matrixWorld),T.position.applyMatrix4(f),T.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(f),g++}else if(v.isRectAreaLight){let T=i.rectArea[y];T.position.setFromMatrixPosition(v.matrixWorld),T.position.applyMatrix4(f),o.identity(),r.copy(v.matrixWorld),r.premultiply(f),o.extractRotation(r),T.halfWidth.set(v.width*.5,0,0),T.halfHeight.set(0,v.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let T=i.point[p];T.position.setFromMatrixPosition(v.matrixWorld),T.position.applyMatrix4(f),p++}else if(v.isHemisphereLight){let T=i.hemi[m];T.direction.setFromMatrixPosition(v.matrixWorld),T.direction.transformDirection(f),m++}}}return{setup:a,setupView:l,state:i}}function Qg(n){let t=new Jw(n),e=[],i=[],s=[];function r(d){u.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){t.setupView(e,d)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function jw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Qg(n),t.set(s,[a])):r>=o.length?(a=new Qg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var Qw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,t1=`uniform sampler2D shadow_pass;
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
}`,e1=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],n1=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],t0=new Xe,xl=new q,yf=new q;function i1(n,t,e){let i=new ur,s=new Zt,r=new Zt,o=new tn,a=new eh,l=new nh,c={},u=e.maxTextureSize,d={[_s]:ai,[ai]:_s,[hi]:hi},h=new ms({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:Qw,fragmentShader:t1}),p=h.clone();p.defines.HORIZONTAL_PASS=1;let g=new Gn;g.setAttribute("position",new si(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new An(g,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=hl;let f=this.type;this.render=function(w,_,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===Zm&&(Jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=hl);let L=n.getRenderTarget(),P=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),U=n.state;U.setBlending(Ur),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let B=f!==this.type;B&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(k=>k.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,k=w.length;I<k;I++){let H=w[I],F=H.shadow;if(F===void 0){Jt("WebGLShadowMap:",H,"has no shadow.");continue}if(F.autoUpdate===!1&&F.needsUpdate===!1)continue;s.copy(F.mapSize);let j=F.getFrameExtents();s.multiply(j),r.copy(F.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/j.x),s.x=r.x*j.x,F.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/j.y),s.y=r.y*j.y,F.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(F.camera._reversedDepth=$,F.map===null||B===!0){if(F.map!==null&&(F.map.depthTexture!==null&&(F.map.depthTexture.dispose(),F.map.depthTexture=null),F.map.dispose()),this.type===Xo){if(H.isPointLight){Jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}F.map=new Si(s.x,s.y,{format:xr,type:qi,minFilter:ri,magFilter:ri,generateMipmaps:!1}),F.map.texture.name=H.name+".shadowMap",F.map.depthTexture=new ks(s.x,s.y,$i),F.map.depthTexture.name=H.name+".shadowMapDepth",F.map.depthTexture.format=Os,F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=Vn,F.map.depthTexture.magFilter=Vn}else H.isPointLight?(F.map=new vl(s.x),F.map.depthTexture=new tl(s.x,Xi)):(F.map=new Si(s.x,s.y),F.map.depthTexture=new ks(s.x,s.y,Xi)),F.map.depthTexture.name=H.name+".shadowMap",F.map.depthTexture.format=Os,this.type===hl?(F.map.depthTexture.compareFunction=$?rf:sf,F.map.depthTexture.minFilter=ri,F.map.depthTexture.magFilter=ri):(F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=Vn,F.map.depthTexture.magFilter=Vn);F.camera.updateProjectionMatrix()}F.map.isWebGLCubeRenderTarget!==!0&&(F.map.width!==s.x||F.map.height!==s.y)&&F.map.setSize(s.x,s.y);let Z=F.map.isWebGLCubeRenderTarget?6:F.getViewportCount();H.isPointLight!==!0&&F.updateMatrices(H,M);let nt=(F.camera.layers.mask&4294967294)!==0?F.camera.layers:M.layers;for(let ht=0;ht<Z;ht++){let ct=F.getCamera(ht);if(H.isPointLight){let tt=F.camera,mt=F.matrix,_t=H.distance||tt.far;_t!==tt.far&&(tt.far=_t,tt.updateProjectionMatrix()),xl.setFromMatrixPosition(H.matrixWorld),tt.position.copy(xl),yf.copy(tt.position),yf.add(e1[ht]),tt.up.copy(n1[ht]),tt.lookAt(yf),tt.updateMatrixWorld(),mt.makeTranslation(-xl.x,-xl.y,-xl.z),t0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),F._frustum.setFromProjectionMatrix(t0,tt.coordinateSystem,tt.reversedDepth)}if(F.map.isWebGLCubeRenderTarget)n.setRenderTarget(F.map,ht),n.clear();else{ht===0&&(n.setRenderTarget(F.map),n.clear());let tt=F.getViewport(ht);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),U.viewport(o)}i=F.getFrustum(ht),v(_,M,ct,H,nt,this.type)}F.isPointLightShadow!==!0&&this.type===Xo&&x(F,M),F.needsUpdate=!1}f=this.type,m.needsUpdate=!1,n.setRenderTarget(L,P,C)};function x(w,_){let M=t.update(y);h.defines.VSM_SAMPLES!==w.blurSamples&&(h.defines.VSM_SAMPLES=w.blurSamples,p.defines.VSM_SAMPLES=w.blurSamples,h.needsUpdate=!0,p.needsUpdate=!0),w.mapPass===null?w.mapPass=new Si(s.x,s.y,{format:xr,type:qi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),h.uniforms.shadow_pass.value=w.map.depthTexture,h.uniforms.resolution.value.set(w.map.width,w.map.height),h.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(_,null,M,h,y,null),p.uniforms.shadow_pass.value=w.mapPass.texture,p.uniforms.resolution.value.set(w.map.width,w.map.height),p.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(_,null,M,p,y,null)}function b(w,_,M,L){let P=null,C=M.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(C!==void 0)P=C;else if(P=M.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let U=P.uuid,B=_.uuid,I=c[U];I===void 0&&(I={},c[U]=I);let k=I[B];k===void 0&&(k=P.clone(),I[B]=k,_.addEventListener("dispose",T)),P=k}if(P.visible=_.visible,P.wireframe=_.wireframe,L===Xo?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:d[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,M.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let U=n.properties.get(P);U.light=M}return P}function v(w,_,M,L,P,C){if(w.visible===!1)return;if(w.layers.test(P)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&C===Xo)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,w.matrixWorld);let I=t.update(w),k=w.material;if(Array.isArray(k)){let H=I.groups;for(let F=0,j=H.length;F<j;F++){let $=H[F],Z=k[$.materialIndex];if(Z&&Z.visible){let nt=b(w,Z,L,C);w.onBeforeShadow(n,w,_,M,I,nt,$),n.renderBufferDirect(M,null,I,nt,w,$),w.onAfterShadow(n,w,_,M,I,nt,$)}}}else if(k.visible){let H=b(w,k,L,C);w.onBeforeShadow(n,w,_,M,I,H,null),n.renderBufferDirect(M,null,I,H,w,null),w.onAfterShadow(n,w,_,M,I,H,null)}}let B=w.children;for(let I=0,k=B.length;I<k;I++)v(B[I],_,M,L,P,C)}function T(w){w.target.removeEventListener("dispose",T);for(let M in c){let L=c[M],P=w.target.uuid;P in L&&(L[P].dispose(),delete L[P])}}}function s1(n,t){function e(){let V=!1,ot=new tn,st=null,Et=new tn(0,0,0,0);return{setMask:function(yt){st!==yt&&!V&&(n.colorMask(yt,yt,yt,yt),st=yt)},setLocked:function(yt){V=yt},setClear:function(yt,Mt,$t,ee,ut){ut===!0&&(yt*=ee,Mt*=ee,$t*=ee),ot.set(yt,Mt,$t,ee),Et.equals(ot)===!1&&(n.clearColor(yt,Mt,$t,ee),Et.copy(ot))},reset:function(){V=!1,st=null,Et.set(-1,0,0,0)}}}function i(){let V=!1,ot=!1,st=null,Et=null,yt=null;return{setReversed:function(Mt){if(ot!==Mt){let $t=t.get("EXT_clip_control");Mt?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),ot=Mt;let ee=yt;yt=null,this.setClear(ee)}},getReversed:function(){return ot},setTest:function(Mt){Mt?xt(n.DEPTH_TEST):Gt(n.DEPTH_TEST)},setMask:function(Mt){st!==Mt&&!V&&(n.depthMask(Mt),st=Mt)},setFunc:function(Mt){if(ot&&(Mt=Rg[Mt]),Et!==Mt){switch(Mt){case Nc:n.depthFunc(n.NEVER);break;case Uc:n.depthFunc(n.ALWAYS);break;case Oc:n.depthFunc(n.LESS);break;case Uo:n.depthFunc(n.LEQUAL);break;case Fc:n.depthFunc(n.EQUAL);break;case Bc:n.depthFunc(n.GEQUAL);break;case kc:n.depthFunc(n.GREATER);break;case zc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=Mt}},setLocked:function(Mt){V=Mt},setClear:function(Mt){yt!==Mt&&(yt=Mt,ot&&(Mt=1-Mt),n.clearDepth(Mt))},reset:function(){V=!1,st=null,Et=null,yt=null,ot=!1}}}function s(){let V=!1,ot=null,st=null,Et=null,yt=null,Mt=null,$t=null,ee=null,ut=null;return{setTest:function(kt){V||(kt?xt(n.STENCIL_TEST):Gt(n.STENCIL_TEST))},setMask:function(kt){ot!==kt&&!V&&(n.stencilMask(kt),ot=kt)},setFunc:function(kt,ne,Ct){(st!==kt||Et!==ne||yt!==Ct)&&(n.stencilFunc(kt,ne,Ct),st=kt,Et=ne,yt=Ct)},setOp:function(kt,ne,Ct){(Mt!==kt||$t!==ne||ee!==Ct)&&(n.stencilOp(kt,ne,Ct),Mt=kt,$t=ne,ee=Ct)},setLocked:function(kt){V=kt},setClear:function(kt){ut!==kt&&(n.clearStencil(kt),ut=kt)},reset:function(){V=!1,ot=null,st=null,Et=null,yt=null,Mt=null,$t=null,ee=null,ut=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},p=new WeakMap,g=[],y=null,m=!1,f=null,x=null,b=null,v=null,T=null,w=null,_=null,M=new de(0,0,0),L=0,P=!1,C=null,U=null,B=null,I=null,k=null,H=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),F=!1,j=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec($)[1]),F=j>=1):$.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),F=j>=2);let Z=null,nt={},ht=n.getParameter(n.SCISSOR_BOX),ct=n.getParameter(n.VIEWPORT),tt=new tn().fromArray(ht),mt=new tn().fromArray(ct);function _t(V,ot,st,Et){let yt=new Uint8Array(4),Mt=n.createTexture();n.bindTexture(V,Mt),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $t=0;$t<st;$t++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(ot,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,yt):n.texImage2D(ot+$t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,yt);return Mt}let ft={};ft[n.TEXTURE_2D]=_t(n.TEXTURE_2D,n.TEXTURE_2D,1),ft[n.TEXTURE_CUBE_MAP]=_t(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ft[n.TEXTURE_2D_ARRAY]=_t(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ft[n.TEXTURE_3D]=_t(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xt(n.DEPTH_TEST),o.setFunc(Uo),pn(!1),Fe(Od),xt(n.CULL_FACE),Ge(Ur);function xt(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Gt(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function ae(V,ot){return h[V]!==ot?(n.bindFramebuffer(V,ot),h[V]=ot,V===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ot),V===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ot),!0):!1}function Ht(V,ot){let st=g,Et=!1;if(V){st=p.get(ot),st===void 0&&(st=[],p.set(ot,st));let yt=V.textures;if(st.length!==yt.length||st[0]!==n.COLOR_ATTACHMENT0){for(let Mt=0,$t=yt.length;Mt<$t;Mt++)st[Mt]=n.COLOR_ATTACHMENT0+Mt;st.length=yt.length,Et=!0}}else st[0]!==n.BACK&&(st[0]=n.BACK,Et=!0);Et&&n.drawBuffers(st)}function qt(V){return y!==V?(n.useProgram(V),y=V,!0):!1}let te={[Or]:n.FUNC_ADD,[Jm]:n.FUNC_SUBTRACT,[jm]:n.FUNC_REVERSE_SUBTRACT};te[Qm]=n.MIN,te[tg]=n.MAX;let re={[eg]:n.ZERO,[ng]:n.ONE,[ig]:n.SRC_COLOR,[zd]:n.SRC_ALPHA,[cg]:n.SRC_ALPHA_SATURATE,[ag]:n.DST_COLOR,[rg]:n.DST_ALPHA,[sg]:n.ONE_MINUS_SRC_COLOR,[Vd]:n.ONE_MINUS_SRC_ALPHA,[lg]:n.ONE_MINUS_DST_COLOR,[og]:n.ONE_MINUS_DST_ALPHA,[hg]:n.CONSTANT_COLOR,[ug]:n.ONE_MINUS_CONSTANT_COLOR,[dg]:n.CONSTANT_ALPHA,[fg]:n.ONE_MINUS_CONSTANT_ALPHA};function Ge(V,ot,st,Et,yt,Mt,$t,ee,ut,kt){if(V===Ur){m===!0&&(Gt(n.BLEND),m=!1);return}if(m===!1&&(xt(n.BLEND),m=!0),V!==Km){if(V!==f||kt!==P){if((x!==Or||T!==Or)&&(n.blendEquation(n.FUNC_ADD),x=Or,T=Or),kt)switch(V){case $o:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Fd:n.blendFunc(n.ONE,n.ONE);break;case Bd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case kd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:se("WebGLState: Invalid blending: ",V);break}else switch(V){case $o:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Fd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Bd:se("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case kd:se("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:se("WebGLState: Invalid blending: ",V);break}b=null,v=null,w=null,_=null,M.set(0,0,0),L=0,f=V,P=kt}return}yt=yt||ot,Mt=Mt||st,$t=$t||Et,(ot!==x||yt!==T)&&(n.blendEquationSeparate(te[ot],te[yt]),x=ot,T=yt),(st!==b||Et!==v||Mt!==w||$t!==_)&&(n.blendFuncSeparate(re[st],re[Et],re[Mt],re[$t]),b=st,v=Et,w=Mt,_=$t),(ee.equals(M)===!1||ut!==L)&&(n.blendColor(ee.r,ee.g,ee.b,ut),M.copy(ee),L=ut),f=V,P=!1}function He(V,ot){V.side===hi?Gt(n.CULL_FACE):xt(n.CULL_FACE);let st=V.side===ai;ot&&(st=!st),pn(st),V.blending===$o&&V.transparent===!1?Ge(Ur):Ge(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Et=V.stencilWrite;a.setTest(Et),Et&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),Ee(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?xt(n.SAMPLE_ALPHA_TO_COVERAGE):Gt(n.SAMPLE_ALPHA_TO_COVERAGE)}function pn(V){C!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),C=V)}function Fe(V){V!==qm?(xt(n.CULL_FACE),V!==U&&(V===Od?n.cullFace(n.BACK):V===Ym?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Gt(n.CULL_FACE),U=V}function Nn(V){V!==B&&(F&&n.lineWidth(V),B=V)}function Ee(V,ot,st){V?(xt(n.POLYGON_OFFSET_FILL),(I!==ot||k!==st)&&(I=ot,k=st,o.getReversed()&&(ot=-ot,st=-st),n.polygonOffset(ot,st))):Gt(n.POLYGON_OFFSET_FILL)}function wn(V){V?xt(n.SCISSOR_TEST):Gt(n.SCISSOR_TEST)}function sn(V){V===void 0&&(V=n.TEXTURE0+H-1),Z!==V&&(n.activeTexture(V),Z=V)}function mn(V,ot,st){st===void 0&&(Z===null?st=n.TEXTURE0+H-1:st=Z);let Et=nt[st];Et===void 0&&(Et={type:void 0,texture:void 0},nt[st]=Et),(Et.type!==V||Et.texture!==ot)&&(Z!==st&&(n.activeTexture(st),Z=st),n.bindTexture(V,ot||ft[V]),Et.type=V,Et.texture=ot)}function G(){let V=nt[Z];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function jt(){try{n.compressedTexImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function he(){try{n.texSubImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function Tt(){try{n.texSubImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function ke(){try{n.compressedTexSubImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function Wt(){try{n.compressedTexSubImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function Kt(){try{n.texStorage2D(...arguments)}catch(V){se("WebGLState:",V)}}function D(){try{n.texStorage3D(...arguments)}catch(V){se("WebGLState:",V)}}function E(){try{n.texImage2D(...arguments)}catch(V){se("WebGLState:",V)}}function Y(){try{n.texImage3D(...arguments)}catch(V){se("WebGLState:",V)}}function dt(V){return d[V]!==void 0?d[V]:n.getParameter(V)}function at(V,ot){d[V]!==ot&&(n.pixelStorei(V,ot),d[V]=ot)}function vt(V){tt.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),tt.copy(V))}function bt(V){mt.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),mt.copy(V))}function it(V,ot){let st=c.get(ot);st===void 0&&(st=new WeakMap,c.set(ot,st));let Et=st.get(V);Et===void 0&&(Et=n.getUniformBlockIndex(ot,V.name),n.uniformBlockBinding(ot,Et,Et),st.set(V,Et))}function rt(V,ot,st){let yt=c.get(ot).get(V);l[yt]!==st&&(n.bindBufferBase(n.UNIFORM_BUFFER,yt,st),l[yt]=st)}function gt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},Z=null,nt={},h={},l={},p=new WeakMap,g=[],y=null,m=!1,f=null,x=null,b=null,v=null,T=null,w=null,_=null,M=new de(0,0,0),L=0,P=!1,C=null,U=null,B=null,I=null,k=null,tt.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xt,disable:Gt,bindFramebuffer:ae,drawBuffers:Ht,useProgram:qt,setBlending:Ge,setMaterial:He,setFlipSided:pn,setCullFace:Fe,setLineWidth:Nn,setPolygonOffset:Ee,setScissorTest:wn,activeTexture:sn,bindTexture:mn,unbindTexture:G,compressedTexImage2D:Pt,compressedTexImage3D:jt,texImage2D:E,texImage3D:Y,pixelStorei:at,getParameter:dt,updateUBOMapping:it,uniformBlockBinding:rt,texStorage2D:Kt,texStorage3D:D,texSubImage2D:he,texSubImage3D:Tt,compressedTexSubImage2D:ke,compressedTexSubImage3D:Wt,scissor:vt,viewport:bt,reset:gt}}function r1(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,u=new WeakMap,d=new Set,h,p=new WeakMap,g=new Set,y=new FinalizationRegistry(D=>g.delete(D)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(D,E){return m?new OffscreenCanvas(D,E):Wa("canvas")}function x(D,E,Y){let dt=1,at=Kt(D);if((at.width>Y||at.height>Y)&&(dt=Y/Math.max(at.width,at.height)),dt<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){let vt=Math.floor(dt*at.width),bt=Math.floor(dt*at.height);h===void 0&&(h=f(vt,bt));let it=E?f(vt,bt):h;return it.width=vt,it.height=bt,it.getContext("2d").drawImage(D,0,0,vt,bt),Jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+vt+"x"+bt+")."),it}else return"data"in D&&Jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),D;return D}function b(D){return D.generateMipmaps}function v(D){n.generateMipmap(D)}function T(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(D,E,Y,dt,at,vt=!1){if(D!==null){if(n[D]!==void 0)return n[D];Jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let bt;dt&&(bt=t.get("EXT_texture_norm16"),bt||Jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=E;if(E===n.RED&&(Y===n.FLOAT&&(it=n.R32F),Y===n.HALF_FLOAT&&(it=n.R16F),Y===n.UNSIGNED_BYTE&&(it=n.R8),Y===n.UNSIGNED_SHORT&&bt&&(it=bt.R16_EXT),Y===n.SHORT&&bt&&(it=bt.R16_SNORM_EXT)),E===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.R8UI),Y===n.UNSIGNED_SHORT&&(it=n.R16UI),Y===n.UNSIGNED_INT&&(it=n.R32UI),Y===n.BYTE&&(it=n.R8I),Y===n.SHORT&&(it=n.R16I),Y===n.INT&&(it=n.R32I)),E===n.RG&&(Y===n.FLOAT&&(it=n.RG32F),Y===n.HALF_FLOAT&&(it=n.RG16F),Y===n.UNSIGNED_BYTE&&(it=n.RG8),Y===n.UNSIGNED_SHORT&&bt&&(it=bt.RG16_EXT),Y===n.SHORT&&bt&&(it=bt.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.RG8UI),Y===n.UNSIGNED_SHORT&&(it=n.RG16UI),Y===n.UNSIGNED_INT&&(it=n.RG32UI),Y===n.BYTE&&(it=n.RG8I),Y===n.SHORT&&(it=n.RG16I),Y===n.INT&&(it=n.RG32I)),E===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(it=n.RGB16UI),Y===n.UNSIGNED_INT&&(it=n.RGB32UI),Y===n.BYTE&&(it=n.RGB8I),Y===n.SHORT&&(it=n.RGB16I),Y===n.INT&&(it=n.RGB32I)),E===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),Y===n.UNSIGNED_INT&&(it=n.RGBA32UI),Y===n.BYTE&&(it=n.RGBA8I),Y===n.SHORT&&(it=n.RGBA16I),Y===n.INT&&(it=n.RGBA32I)),E===n.RGB&&(Y===n.UNSIGNED_SHORT&&bt&&(it=bt.RGB16_EXT),Y===n.SHORT&&bt&&(it=bt.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),E===n.RGBA){let rt=vt?Ha:Me.getTransfer(at);Y===n.FLOAT&&(it=n.RGBA32F),Y===n.HALF_FLOAT&&(it=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(it=rt===Le?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&bt&&(it=bt.RGBA16_EXT),Y===n.SHORT&&bt&&(it=bt.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(D,E){let Y;return D?E===null||E===Xi||E===Br?Y=n.DEPTH24_STENCIL8:E===$i?Y=n.DEPTH32F_STENCIL8:E===Yo&&(Y=n.DEPTH24_STENCIL8,Jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===Xi||E===Br?Y=n.DEPTH_COMPONENT24:E===$i?Y=n.DEPTH_COMPONENT32F:E===Yo&&(Y=n.DEPTH_COMPONENT16),Y}function M(D,E){return b(D)===!0||D.isFramebufferTexture&&D.minFilter!==Vn&&D.minFilter!==ri?Math.log2(Math.max(E.width,E.height))+1:D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?E.mipmaps.length:1}function L(D){let E=new WeakRef(D);i.get(D).__ref=E,g.add(E),y.register(D,E,E)}function P(D){let E=i.get(D).__ref;E!==void 0&&(g.delete(E),y.unregister(E))}function C(D){B(D.target)}function U(D){I(D.target)}function B(D){D.removeEventListener("dispose",C),P(D),H(D),D.isVideoTexture&&u.delete(D),D.isHTMLTexture&&d.delete(D)}function I(D){D.removeEventListener("dispose",U),P(D),j(D)}function k(){for(let D of g){let E=D.deref();E!==void 0&&(E.isRenderTarget===!0?I(E):B(E))}g.clear(),d.clear()}function H(D){let E=i.get(D);if(E.__webglInit===void 0)return;let Y=D.source,dt=p.get(Y);if(dt){let at=dt[E.__cacheKey];at.usedTimes--,at.usedTimes===0&&F(D),Object.keys(dt).length===0&&p.delete(Y)}i.remove(D)}function F(D){let E=i.get(D);n.deleteTexture(E.__webglTexture);let Y=D.source,dt=p.get(Y);delete dt[E.__cacheKey],o.memory.textures--}function j(D){let E=i.get(D);E.__depthDisposeCallback&&E.__depthDisposeCallback();let Y=D.depthTexture;if(Y&&Y.renderTarget===D&&B(Y),D.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(E.__webglFramebuffer[at]))for(let vt=0;vt<E.__webglFramebuffer[at].length;vt++)n.deleteFramebuffer(E.__webglFramebuffer[at][vt]);else n.deleteFramebuffer(E.__webglFramebuffer[at]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[at])}else{if(Array.isArray(E.__webglFramebuffer))for(let at=0;at<E.__webglFramebuffer.length;at++)n.deleteFramebuffer(E.__webglFramebuffer[at]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let at=0;at<E.__webglColorRenderbuffer.length;at++)E.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[at]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let dt=D.textures;for(let at=0,vt=dt.length;at<vt;at++){let bt=i.get(dt[at]);bt.__webglTexture&&(n.deleteTexture(bt.__webglTexture),o.memory.textures--),i.remove(dt[at])}i.remove(D)}let $=0;function Z(){$=0}function nt(){return $}function ht(D){$=D}function ct(){let D=$;return D>=s.maxTextures&&Jt("WebGLTextures: Trying to use "+(D+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,D}function tt(D){let E=[];return E.push(D.wrapS),E.push(D.wrapT),E.push(D.wrapR||0),E.push(D.magFilter),E.push(D.minFilter),E.push(D.anisotropy),E.push(D.internalFormat),E.push(D.format),E.push(D.type),E.push(D.generateMipmaps),E.push(D.mipmapsAutoUpdate),E.push(D.premultiplyAlpha),E.push(D.flipY),E.push(D.unpackAlignment),E.push(D.colorSpace),E.join()}function mt(D,E){let Y=i.get(D);if(D.isVideoTexture&&ke(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&Y.__version!==D.version){let dt=D.image;if(dt===null)Jt("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)Jt("WebGLRenderer: Texture marked for update but image is incomplete");else{He(Y,D,E);return}}else D.isExternalTexture&&(Y.__webglTexture=D.sourceTexture?D.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+E)}function _t(D,E){let Y=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&Y.__version!==D.version){He(Y,D,E);return}else D.isExternalTexture&&(Y.__webglTexture=D.sourceTexture?D.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+E)}function ft(D,E){let Y=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&Y.__version!==D.version){He(Y,D,E);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+E)}function xt(D,E){let Y=i.get(D);if(D.version>0&&Y.__version!==D.version){pn(Y,D,E);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+E)}let Gt={[Vc]:n.REPEAT,[ds]:n.CLAMP_TO_EDGE,[Gc]:n.MIRRORED_REPEAT},ae={[Vn]:n.NEAREST,[gg]:n.NEAREST_MIPMAP_NEAREST,[ul]:n.NEAREST_MIPMAP_LINEAR,[ri]:n.LINEAR,[xh]:n.LINEAR_MIPMAP_NEAREST,[zs]:n.LINEAR_MIPMAP_LINEAR},Ht={[vg]:n.NEVER,[of]:n.ALWAYS,[bg]:n.LESS,[sf]:n.LEQUAL,[Sg]:n.EQUAL,[rf]:n.GEQUAL,[Mg]:n.GREATER,[wg]:n.NOTEQUAL};function qt(D,E){if(E.type===$i&&t.has("OES_texture_float_linear")===!1&&(E.magFilter===ri||E.magFilter===xh||E.magFilter===ul||E.magFilter===zs||E.minFilter===ri||E.minFilter===xh||E.minFilter===ul||E.minFilter===zs)&&Jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,Gt[E.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,Gt[E.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,Gt[E.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,ae[E.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,ae[E.minFilter]),E.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,Ht[E.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Vn||E.minFilter!==ul&&E.minFilter!==zs||E.type===$i&&t.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(D,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,s.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function te(D,E){let Y=!1;D.__webglInit===void 0&&(D.__webglInit=!0,E.addEventListener("dispose",C),L(E));let dt=E.source,at=p.get(dt);at===void 0&&(at={},p.set(dt,at));let vt=tt(E);if(vt!==D.__cacheKey){at[vt]===void 0&&(at[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[vt].usedTimes++;let bt=at[D.__cacheKey];bt!==void 0&&(at[D.__cacheKey].usedTimes--,bt.usedTimes===0&&F(E)),D.__cacheKey=vt,D.__webglTexture=at[vt].texture}return Y}function re(D,E,Y){return Math.floor(Math.floor(D/Y)/E)}function Ge(D,E,Y,dt){let vt=D.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,Y,dt,E.data);else{vt.sort((V,ot)=>V.start-ot.start);let bt=0;for(let V=1;V<vt.length;V++){let ot=vt[bt],st=vt[V],Et=ot.start+ot.count,yt=re(st.start,E.width,4),Mt=re(ot.start,E.width,4);st.start<=Et+1&&yt===Mt&&re(st.start+st.count-1,E.width,4)===yt?ot.count=Math.max(ot.count,st.start+st.count-ot.start):(++bt,vt[bt]=st)}vt.length=bt+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),gt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let V=0,ot=vt.length;V<ot;V++){let st=vt[V],Et=Math.floor(st.start/4),yt=Math.ceil(st.count/4),Mt=Et%E.width,$t=Math.floor(Et/E.width),ee=yt,ut=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(n.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(n.TEXTURE_2D,0,Mt,$t,ee,ut,Y,dt,E.data)}D.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,gt)}}function He(D,E,Y){let dt=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(dt=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(dt=n.TEXTURE_3D);let at=te(D,E),vt=E.source;e.bindTexture(dt,D.__webglTexture,n.TEXTURE0+Y);let bt=i.get(vt);if(vt.version!==bt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let ut=Me.getPrimaries(Me.workingColorSpace),kt=E.colorSpace===Gs?null:Me.getPrimaries(E.colorSpace),ne=E.colorSpace===Gs||ut===kt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne)}e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let rt=x(E.image,!1,s.maxTextureSize);rt=Wt(E,rt);let gt=r.convert(E.format,E.colorSpace),V=r.convert(E.type),ot=w(E.internalFormat,gt,V,E.normalized,E.colorSpace,E.isVideoTexture);qt(dt,E);let st,Et=E.mipmaps,yt=E.isVideoTexture!==!0,Mt=bt.__version===void 0||at===!0,$t=vt.dataReady,ee=M(E,rt);if(E.isDepthTexture)ot=_(E.format===Vs,E.type),Mt&&(yt?e.texStorage2D(n.TEXTURE_2D,1,ot,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,gt,V,null));else if(E.isDataTexture)if(Et.length>0){yt&&Mt&&e.texStorage2D(n.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)st=Et[ut],yt?$t&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,st.width,st.height,gt,V,st.data):e.texImage2D(n.TEXTURE_2D,ut,ot,st.width,st.height,0,gt,V,st.data);E.generateMipmaps=!1}else yt?(Mt&&e.texStorage2D(n.TEXTURE_2D,ee,ot,rt.width,rt.height),$t&&Ge(E,rt,gt,V)):e.texImage2D(n.TEXTURE_2D,0,ot,rt.width,rt.height,0,gt,V,rt.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){yt&&Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ee,ot,Et[0].width,Et[0].height,rt.depth);for(let ut=0,kt=Et.length;ut<kt;ut++)if(st=Et[ut],E.format!==Yi)if(gt!==null)if(yt){if($t)if(E.layerUpdates.size>0){let ne=_f(st.width,st.height,E.format,E.type);for(let Ct of E.layerUpdates){let ue=st.data.subarray(Ct*ne/st.data.BYTES_PER_ELEMENT,(Ct+1)*ne/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,Ct,st.width,st.height,1,gt,ue)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,st.width,st.height,rt.depth,gt,st.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ut,ot,st.width,st.height,rt.depth,0,st.data,0,0);else Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else yt?$t&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,st.width,st.height,rt.depth,gt,V,st.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ut,ot,st.width,st.height,rt.depth,0,gt,V,st.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{yt&&Mt&&e.texStorage2D(n.TEXTURE_2D,ee,ot,Et[0].width,Et[0].height);for(let ut=0,kt=Et.length;ut<kt;ut++)st=Et[ut],E.format!==Yi?gt!==null?yt?$t&&e.compressedTexSubImage2D(n.TEXTURE_2D,ut,0,0,st.width,st.height,gt,st.data):e.compressedTexImage2D(n.TEXTURE_2D,ut,ot,st.width,st.height,0,st.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):yt?$t&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,st.width,st.height,gt,V,st.data):e.texImage2D(n.TEXTURE_2D,ut,ot,st.width,st.height,0,gt,V,st.data)}else if(E.isDataArrayTexture)if(yt){if(Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,ee,ot,rt.width,rt.height,rt.depth),$t)if(E.layerUpdates.size>0){let ut=_f(rt.width,rt.height,E.format,E.type);for(let kt of E.layerUpdates){let ne=rt.data.subarray(kt*ut/rt.data.BYTES_PER_ELEMENT,(kt+1)*ut/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,kt,rt.width,rt.height,1,gt,V,ne)}E.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,gt,V,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,ot,rt.width,rt.height,rt.depth,0,gt,V,rt.data);else if(E.isData3DTexture)yt?(Mt&&e.texStorage3D(n.TEXTURE_3D,ee,ot,rt.width,rt.height,rt.depth),$t&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,gt,V,rt.data)):e.texImage3D(n.TEXTURE_3D,0,ot,rt.width,rt.height,rt.depth,0,gt,V,rt.data);else if(E.isFramebufferTexture){if(Mt)if(yt)e.texStorage2D(n.TEXTURE_2D,ee,ot,rt.width,rt.height);else{let ut=rt.width,kt=rt.height;for(let ne=0;ne<ee;ne++)e.texImage2D(n.TEXTURE_2D,ne,ot,ut,kt,0,gt,V,null),ut>>=1,kt>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){let ut=n.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),rt.parentNode!==ut){ut.appendChild(rt),d.add(E),ut.onpaint=kt=>{let ne=kt.changedElements;for(let Ct of d)ne.includes(Ct.image)&&(Ct.needsUpdate=!0)},ut.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let ne=n.RGBA,Ct=n.RGBA,ue=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ne,Ct,ue,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(yt&&Mt){let ut=Kt(Et[0]);e.texStorage2D(n.TEXTURE_2D,ee,ot,ut.width,ut.height)}for(let ut=0,kt=Et.length;ut<kt;ut++)st=Et[ut],yt?$t&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,gt,V,st):e.texImage2D(n.TEXTURE_2D,ut,ot,gt,V,st);E.generateMipmaps=!1}else if(yt){if(Mt){let ut=Kt(rt);e.texStorage2D(n.TEXTURE_2D,ee,ot,ut.width,ut.height)}$t&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,gt,V,rt)}else e.texImage2D(n.TEXTURE_2D,0,ot,gt,V,rt);b(E)&&E.mipmapsAutoUpdate===!0&&v(dt),bt.__version=vt.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function pn(D,E,Y){if(E.image.length!==6)return;let dt=te(D,E),at=E.source;e.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+Y);let vt=i.get(at);if(at.version!==vt.__version||dt===!0){e.activeTexture(n.TEXTURE0+Y);let bt=Me.getPrimaries(Me.workingColorSpace),it=E.colorSpace===Gs?null:Me.getPrimaries(E.colorSpace),rt=E.colorSpace===Gs||bt===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let gt=E.isCompressedTexture||E.image[0].isCompressedTexture,V=E.image[0]&&E.image[0].isDataTexture,ot=[];for(let Ct=0;Ct<6;Ct++)!gt&&!V?ot[Ct]=x(E.image[Ct],!0,s.maxCubemapSize):ot[Ct]=V?E.image[Ct].image:E.image[Ct],ot[Ct]=Wt(E,ot[Ct]);let st=ot[0],Et=r.convert(E.format,E.colorSpace),yt=r.convert(E.type),Mt=w(E.internalFormat,Et,yt,E.normalized,E.colorSpace),$t=E.isVideoTexture!==!0,ee=vt.__version===void 0||dt===!0,ut=at.dataReady,kt=M(E,st);qt(n.TEXTURE_CUBE_MAP,E);let ne;if(E.isDepthTexture){if(Mt=_(E.format===Vs,E.type),ee)if($t)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Mt,st.width,st.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Mt,st.width,st.height,0,Et,yt,null)}else if(gt){$t&&ee&&e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,Mt,st.width,st.height);for(let Ct=0;Ct<6;Ct++){ne=ot[Ct].mipmaps;for(let ue=0;ue<ne.length;ue++){let $e=ne[ue];E.format!==Yi?Et!==null?$t?ut&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,0,0,$e.width,$e.height,Et,$e.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,Mt,$e.width,$e.height,0,$e.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,0,0,$e.width,$e.height,Et,yt,$e.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue,Mt,$e.width,$e.height,0,Et,yt,$e.data)}}}else{if(ne=E.mipmaps,$t&&ee){ne.length>0&&kt++;let Ct=Kt(ot[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,Mt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(V){$t?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,ot[Ct].width,ot[Ct].height,Et,yt,ot[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Mt,ot[Ct].width,ot[Ct].height,0,Et,yt,ot[Ct].data);for(let ue=0;ue<ne.length;ue++){let Kn=ne[ue].image[Ct].image;$t?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,0,0,Kn.width,Kn.height,Et,yt,Kn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,Mt,Kn.width,Kn.height,0,Et,yt,Kn.data)}}else{$t?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,yt,ot[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,Mt,Et,yt,ot[Ct]);for(let ue=0;ue<ne.length;ue++){let $e=ne[ue];$t?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,0,0,Et,yt,$e.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,ue+1,Mt,Et,yt,$e.image[Ct])}}}b(E)&&E.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),vt.__version=at.version,E.onUpdate&&E.onUpdate(E)}D.__version=E.version}function Fe(D,E,Y,dt,at,vt){let bt=r.convert(Y.format,Y.colorSpace),it=r.convert(Y.type),rt=w(Y.internalFormat,bt,it,Y.normalized,Y.colorSpace),gt=i.get(E),V=i.get(Y);if(V.__renderTarget=E,!gt.__hasExternalTextures){let ot=Math.max(1,E.width>>vt),st=Math.max(1,E.height>>vt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,vt,rt,ot,st,E.depth,0,bt,it,null):e.texImage2D(at,vt,rt,ot,st,0,bt,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,D),Tt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,dt,at,V.__webglTexture,0,he(E)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,dt,at,V.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Nn(D,E,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,D),E.depthBuffer){let dt=E.depthTexture,at=dt&&dt.isDepthTexture?dt.type:null,vt=_(E.stencilBuffer,at),bt=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Tt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,he(E),vt,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,he(E),vt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,vt,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,bt,n.RENDERBUFFER,D)}else{let dt=E.textures;for(let at=0;at<dt.length;at++){let vt=dt[at],bt=r.convert(vt.format,vt.colorSpace),it=r.convert(vt.type),rt=w(vt.internalFormat,bt,it,vt.normalized,vt.colorSpace);Tt(E)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,he(E),rt,E.width,E.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,he(E),rt,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,rt,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ee(D,E,Y){let dt=E.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,D),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(E.depthTexture);at.__renderTarget=E;let vt=dt?E.depthTexture.image[0]:E.depthTexture.image;(!at.__webglTexture||vt.width!==E.width||vt.height!==E.height)&&(vt.width=E.width,vt.height=E.height,E.depthTexture.needsUpdate=!0),dt?xt(E.depthTexture,0):mt(E.depthTexture,0);let bt=at.__webglTexture,it=he(E),rt=dt?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,gt=E.depthTexture.format===Vs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===Os)Tt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,rt,bt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,gt,rt,bt,0);else if(E.depthTexture.format===Vs)Tt(E)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,rt,bt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,gt,rt,bt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function wn(D){let E=i.get(D),Y=D.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==D.depthTexture){let dt=D.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),dt){let at=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,dt.removeEventListener("dispose",at)};dt.addEventListener("dispose",at),E.__depthDisposeCallback=at}E.__boundDepthTexture=dt}if(D.depthTexture&&!E.__autoAllocateDepthBuffer)if(Y)for(let dt=0;dt<6;dt++)Ee(E.__webglFramebuffer[dt],D,dt);else D.texture.mipmaps.length>0?Ee(E.__webglFramebuffer[0],D,0):Ee(E.__webglFramebuffer,D,0);else if(Y){E.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[dt]),E.__webglDepthbuffer[dt]===void 0)E.__webglDepthbuffer[dt]=n.createRenderbuffer(),Nn(E.__webglDepthbuffer[dt],D,!1);else{let at=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=E.__webglDepthbuffer[dt];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,vt)}}else if(D.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),Nn(E.__webglDepthbuffer,D,!1);else{let at=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function sn(D,E,Y){let dt=i.get(D);E!==void 0&&Fe(dt.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&wn(D)}function mn(D){let E=D.texture,Y=i.get(D),dt=i.get(E);D.addEventListener("dispose",U),L(D);let at=D.textures,vt=D.isWebGLCubeRenderTarget===!0,bt=at.length>1;if(bt||(dt.__webglTexture===void 0&&(dt.__webglTexture=n.createTexture()),dt.__version=E.version,o.memory.textures++),vt){Y.__webglFramebuffer=[];for(let it=0;it<6;it++)if(E.mipmaps.length>0){Y.__webglFramebuffer[it]=[];for(let rt=0;rt<E.mipmaps.length;rt++)Y.__webglFramebuffer[it][rt]=n.createFramebuffer()}else Y.__webglFramebuffer[it]=n.createFramebuffer()}else{if(E.mipmaps.length>0){Y.__webglFramebuffer=[];for(let it=0;it<E.mipmaps.length;it++)Y.__webglFramebuffer[it]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(bt)for(let it=0,rt=at.length;it<rt;it++){let gt=i.get(at[it]);gt.__webglTexture===void 0&&(gt.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&Tt(D)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let it=0;it<at.length;it++){let rt=at[it];Y.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[it]);let gt=r.convert(rt.format,rt.colorSpace),V=r.convert(rt.type),ot=w(rt.internalFormat,gt,V,rt.normalized,rt.colorSpace,D.isXRRenderTarget===!0),st=he(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,st,ot,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,Y.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),Nn(Y.__webglDepthRenderbuffer,D,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,dt.__webglTexture),qt(n.TEXTURE_CUBE_MAP,E);for(let it=0;it<6;it++)if(E.mipmaps.length>0)for(let rt=0;rt<E.mipmaps.length;rt++)Fe(Y.__webglFramebuffer[it][rt],D,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,rt);else Fe(Y.__webglFramebuffer[it],D,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);b(E)?v(n.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}else if(bt){for(let it=0,rt=at.length;it<rt;it++){let gt=at[it],V=i.get(gt),ot=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ot=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ot,V.__webglTexture),qt(ot,gt),Fe(Y.__webglFramebuffer,D,gt,n.COLOR_ATTACHMENT0+it,ot,0),b(gt)&&v(ot)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(it=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,dt.__webglTexture),qt(it,E),E.mipmaps.length>0)for(let rt=0;rt<E.mipmaps.length;rt++)Fe(Y.__webglFramebuffer[rt],D,E,n.COLOR_ATTACHMENT0,it,rt);else Fe(Y.__webglFramebuffer,D,E,n.COLOR_ATTACHMENT0,it,0);b(E)?v(it):E.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),e.unbindTexture()}D.depthBuffer&&wn(D)}function G(D){let E=D.textures;for(let Y=0,dt=E.length;Y<dt;Y++){let at=E[Y];if(b(at)&&at.mipmapsAutoUpdate===!0){let vt=T(D),bt=i.get(at).__webglTexture;e.bindTexture(vt,bt),v(vt),e.unbindTexture()}}}let Pt=[];function jt(D){if(D.samples>0){if(Tt(D)===!1){let E=D.textures,Y=D.width,dt=D.height,at=n.COLOR_BUFFER_BIT,vt=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,bt=i.get(D),it=E.length>1;if(it)for(let gt=0;gt<E.length;gt++)e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,bt.__webglMultisampledFramebuffer),D.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglFramebuffer);for(let gt=0;gt<E.length;gt++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,bt.__webglColorRenderbuffer[gt]);let V=i.get(E[gt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,Y,dt,0,0,Y,dt,at,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+gt),D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&Pt.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let gt=0;gt<E.length;gt++){e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,bt.__webglColorRenderbuffer[gt]);let V=i.get(E[gt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,bt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,V,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,bt.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&l){let E=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function he(D){return Math.min(s.maxSamples,D.samples)}function Tt(D){let E=i.get(D);return D.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function ke(D){let E=o.render.frame;u.get(D)!==E&&(u.set(D,E),D.update())}function Wt(D,E){let Y=D.colorSpace,dt=D.format,at=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||Y!==Ga&&Y!==Gs&&(Me.getTransfer(Y)===Le?(dt!==Yi||at!==ui)&&Jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):se("WebGLTextures: Unsupported texture color space:",Y)),E}function Kt(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=ct,this.resetTextureUnits=Z,this.getTextureUnits=nt,this.setTextureUnits=ht,this.setTexture2D=mt,this.setTexture2DArray=_t,this.setTexture3D=ft,this.setTextureCube=xt,this.rebindTextures=sn,this.setupRenderTarget=mn,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=wn,this.setupFrameBufferTexture=Fe,this.useMultisampledRTT=Tt,this.dispose=k}function o1(n,t){function e(i,s=Gs){let r,o=Me.getTransfer(s);if(i===ui)return n.UNSIGNED_BYTE;if(i===vh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===bh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===jd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Qd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Kd)return n.BYTE;if(i===Jd)return n.SHORT;if(i===Yo)return n.UNSIGNED_SHORT;if(i===yh)return n.INT;if(i===Xi)return n.UNSIGNED_INT;if(i===$i)return n.FLOAT;if(i===qi)return n.HALF_FLOAT;if(i===tf)return n.ALPHA;if(i===ef)return n.RGB;if(i===Yi)return n.RGBA;if(i===Os)return n.DEPTH_COMPONENT;if(i===Vs)return n.DEPTH_STENCIL;if(i===nf)return n.RED;if(i===Sh)return n.RED_INTEGER;if(i===xr)return n.RG;if(i===Mh)return n.RG_INTEGER;if(i===wh)return n.RGBA_INTEGER;if(i===dl||i===fl||i===pl||i===ml)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===dl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===dl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===pl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ml)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Th||i===Eh||i===Ah||i===Rh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Th)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Eh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ah)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Rh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ch||i===Ph||i===Ih||i===Lh||i===Dh||i===gl||i===Nh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ch||i===Ph)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ih)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Lh)return r.COMPRESSED_R11_EAC;if(i===Dh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===gl)return r.COMPRESSED_RG11_EAC;if(i===Nh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Uh||i===Oh||i===Fh||i===Bh||i===kh||i===zh||i===Vh||i===Gh||i===Hh||i===Wh||i===Xh||i===$h||i===qh||i===Yh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Uh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Oh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Fh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Bh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===kh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===zh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Vh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Gh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Hh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Wh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Xh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===$h)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===qh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Yh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Zh||i===Kh||i===Jh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Zh)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Kh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Jh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===jh||i===Qh||i===_l||i===tu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===jh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Qh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===_l)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Br?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var a1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,l1=`
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

}`,Ef=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new el(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new ms({vertexShader:a1,fragmentShader:l1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new An(new nl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Af=class extends Wi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,p=null,g=null,y=typeof XRWebGLBinding<"u",m=new Ef,f={},x=e.getContextAttributes(),b=null,v=null,T=[],w=[],_=new Zt,M=null,L=null,P=new ii;P.viewport=new tn;let C=new ii;C.viewport=new tn;let U=[P,C],B=new ph,I=null,k=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=T[tt];return mt===void 0&&(mt=new zo,T[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=T[tt];return mt===void 0&&(mt=new zo,T[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=T[tt];return mt===void 0&&(mt=new zo,T[tt]=mt),mt.getHandSpace()};function H(tt){let mt=w.indexOf(tt.inputSource);if(mt===-1)return;let _t=T[mt];_t!==void 0&&(_t.update(tt.inputSource,tt.frame,c||o),_t.dispatchEvent({type:tt.type,data:tt.inputSource}))}function F(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",F),s.removeEventListener("inputsourceschange",j);for(let tt=0;tt<T.length;tt++){let mt=w[tt];mt!==null&&(w[tt]=null,T[tt].disconnect(mt))}I=null,k=null,m.reset();for(let tt in f)delete f[tt];if(t.setRenderTarget(b),p=null,h=null,d=null,s=null,v=null,ct.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(_.width,_.height,!1),L!==null){let tt=L.camera;tt.fov=L.fov,tt.zoom=L.zoom,tt.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return h!==null?h:p},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",F),s.addEventListener("inputsourceschange",j),x.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let _t=null,ft=null,xt=null;x.depth&&(xt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,_t=x.stencil?Vs:Os,ft=x.stencil?Br:Xi);let Gt={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Gt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),v=new Si(h.textureWidth,h.textureHeight,{format:Yi,type:ui,depthTexture:new ks(h.textureWidth,h.textureHeight,ft,void 0,void 0,void 0,void 0,void 0,void 0,_t),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let _t={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,_t),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),v=new Si(p.framebufferWidth,p.framebufferHeight,{format:Yi,type:ui,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ct.setContext(s),ct.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(tt){for(let mt=0;mt<tt.removed.length;mt++){let _t=tt.removed[mt],ft=w.indexOf(_t);ft>=0&&(w[ft]=null,T[ft].disconnect(_t))}for(let mt=0;mt<tt.added.length;mt++){let _t=tt.added[mt],ft=w.indexOf(_t);if(ft===-1){for(let Gt=0;Gt<T.length;Gt++)if(Gt>=w.length){w.push(_t),ft=Gt;break}else if(w[Gt]===null){w[Gt]=_t,ft=Gt;break}if(ft===-1)break}let xt=T[ft];xt&&xt.connect(_t)}}function $(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,_t=tt.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(_t=m.depthFar)),B.near=C.near=P.near=mt,B.far=C.far=P.far=_t,(I!==B.near||k!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),I=B.near,k=B.far),B.layers.mask=tt.layers.mask|6,P.layers.mask=B.layers.mask&-5,C.layers.mask=B.layers.mask&-3;let ft=tt.parent,xt=B.cameras;$(B,ft);for(let Gt=0;Gt<xt.length;Gt++)$(xt[Gt],ft);B.projectionMatrix.copy(P.projectionMatrix),B.projectionMatrixInverse.copy(P.projectionMatrixInverse),L===null&&tt.isPerspectiveCamera&&(L={camera:tt,fov:tt.fov,zoom:tt.zoom}),Z(tt,B,ft)};function Z(tt,mt,_t){_t===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(_t.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Bo*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(h===null&&p===null))return l},this.setFoveation=function(tt){l=tt,h!==null&&(h.fixedFoveation=tt),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(tt){return f[tt]};let nt=null;function ht(tt,mt){if(u=mt.getViewerPose(c||o),g=mt,u!==null){let _t=u.views;p!==null&&(t.setRenderTargetFramebuffer(v,p.framebuffer),t.setRenderTarget(v));let ft=!1;_t.length!==B.cameras.length&&(B.cameras.length=0,ft=!0);for(let Ht=0;Ht<_t.length;Ht++){let qt=_t[Ht],te=null;if(p!==null)te=p.getViewport(qt);else{let Ge=d.getViewSubImage(h,qt);te=Ge.viewport,Ht===0&&(t.setRenderTargetTextures(v,Ge.colorTexture,Ge.depthStencilTexture),t.setRenderTarget(v))}let re=U[Ht];re===void 0&&(re=new ii,re.layers.enable(Ht),re.viewport=new tn,U[Ht]=re),re.matrix.fromArray(qt.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(qt.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(te.x,te.y,te.width,te.height),Ht===0&&(B.matrix.copy(re.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),ft===!0&&B.cameras.push(re)}let xt=s.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=i.getBinding();let Ht=d.getDepthInformation(_t[0]);Ht&&Ht.isValid&&Ht.texture&&m.init(Ht,s.renderState)}if(xt&&xt.includes("camera-access")&&y){t.state.unbindTexture(),d=i.getBinding();for(let Ht=0;Ht<_t.length;Ht++){let qt=_t[Ht].camera;if(qt){let te=f[qt];te||(te=new el,f[qt]=te);let re=d.getCameraImage(qt);te.sourceTexture=re}}}}for(let _t=0;_t<T.length;_t++){let ft=w[_t],xt=T[_t];ft!==null&&xt!==void 0&&xt.update(ft,mt,c||o)}nt&&nt(tt,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),g=null}let ct=new e0;ct.setAnimationLoop(ht),this.setAnimationLoop=function(tt){nt=tt},this.dispose=function(){}}},c1=new Xe,u0=new le;u0.set(-1,0,0,0,1,0,0,0,1);function h1(n,t){function e(m,f){m.matrixAutoUpdate===!0&&m.updateMatrix(),f.value.copy(m.matrix)}function i(m,f){f.color.getRGB(m.fogColor.value,pf(n)),f.isFog?(m.fogNear.value=f.near,m.fogFar.value=f.far):f.isFogExp2&&(m.fogDensity.value=f.density)}function s(m,f,x,b,v){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(m,f):f.isMeshLambertMaterial?(r(m,f),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(m,f),d(m,f)):f.isMeshPhongMaterial?(r(m,f),u(m,f),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(m,f),h(m,f),f.isMeshPhysicalMaterial&&p(m,f,v)):f.isMeshMatcapMaterial?(r(m,f),g(m,f)):f.isMeshDepthMaterial?r(m,f):f.isMeshDistanceMaterial?(r(m,f),y(m,f)):f.isMeshNormalMaterial?r(m,f):f.isLineBasicMaterial?(o(m,f),f.isLineDashedMaterial&&a(m,f)):f.isPointsMaterial?l(m,f,x,b):f.isSpriteMaterial?c(m,f):f.isShadowMaterial?(m.color.value.copy(f.color),m.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(m,f){m.opacity.value=f.opacity,f.color&&m.diffuse.value.copy(f.color),f.emissive&&m.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.bumpMap&&(m.bumpMap.value=f.bumpMap,e(f.bumpMap,m.bumpMapTransform),m.bumpScale.value=f.bumpScale,f.side===ai&&(m.bumpScale.value*=-1)),f.normalMap&&(m.normalMap.value=f.normalMap,e(f.normalMap,m.normalMapTransform),m.normalScale.value.copy(f.normalScale),f.side===ai&&m.normalScale.value.negate()),f.displacementMap&&(m.displacementMap.value=f.displacementMap,e(f.displacementMap,m.displacementMapTransform),m.displacementScale.value=f.displacementScale,m.displacementBias.value=f.displacementBias),f.emissiveMap&&(m.emissiveMap.value=f.emissiveMap,e(f.emissiveMap,m.emissiveMapTransform)),f.specularMap&&(m.specularMap.value=f.specularMap,e(f.specularMap,m.specularMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest);let x=t.get(f),b=x.envMap,v=x.envMapRotation;b&&(m.envMap.value=b,m.envMapRotation.value.setFromMatrix4(c1.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(u0),m.reflectivity.value=f.reflectivity,m.ior.value=f.ior,m.refractionRatio.value=f.refractionRatio),f.lightMap&&(m.lightMap.value=f.lightMap,m.lightMapIntensity.value=f.lightMapIntensity,e(f.lightMap,m.lightMapTransform)),f.aoMap&&(m.aoMap.value=f.aoMap,m.aoMapIntensity.value=f.aoMapIntensity,e(f.aoMap,m.aoMapTransform))}function o(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform))}function a(m,f){m.dashSize.value=f.dashSize,m.totalSize.value=f.dashSize+f.gapSize,m.scale.value=f.scale}function l(m,f,x,b){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.size.value=f.size*x,m.scale.value=b*.5,f.map&&(m.map.value=f.map,e(f.map,m.uvTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function c(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.rotation.value=f.rotation,f.map&&(m.map.value=f.map,e(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,e(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function u(m,f){m.specular.value.copy(f.specular),m.shininess.value=Math.max(f.shininess,1e-4)}function d(m,f){f.gradientMap&&(m.gradientMap.value=f.gradientMap)}function h(m,f){m.metalness.value=f.metalness,f.metalnessMap&&(m.metalnessMap.value=f.metalnessMap,e(f.metalnessMap,m.metalnessMapTransform)),m.roughness.value=f.roughness,f.roughnessMap&&(m.roughnessMap.value=f.roughnessMap,e(f.roughnessMap,m.roughnessMapTransform)),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)}function p(m,f,x){m.ior.value=f.ior,f.diffuseRoughness>0&&(m.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=f.diffuseRoughnessMap,e(f.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),f.sheen>0&&(m.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),m.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(m.sheenColorMap.value=f.sheenColorMap,e(f.sheenColorMap,m.sheenColorMapTransform)),f.sheenRoughnessMap&&(m.sheenRoughnessMap.value=f.sheenRoughnessMap,e(f.sheenRoughnessMap,m.sheenRoughnessMapTransform))),f.clearcoat>0&&(m.clearcoat.value=f.clearcoat,m.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(m.clearcoatMap.value=f.clearcoatMap,e(f.clearcoatMap,m.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,e(f.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(m.clearcoatNormalMap.value=f.clearcoatNormalMap,e(f.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===ai&&m.clearcoatNormalScale.value.negate())),f.dispersion>0&&(m.dispersion.value=f.dispersion),f.retroreflectivity>0&&(m.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(m.iridescence.value=f.iridescence,m.iridescenceIOR.value=f.iridescenceIOR,m.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(m.iridescenceMap.value=f.iridescenceMap,e(f.iridescenceMap,m.iridescenceMapTransform)),f.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=f.iridescenceThicknessMap,e(f.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),f.transmission>0&&(m.transmission.value=f.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),f.transmissionMap&&(m.transmissionMap.value=f.transmissionMap,e(f.transmissionMap,m.transmissionMapTransform)),m.thickness.value=f.thickness,f.thicknessMap&&(m.thicknessMap.value=f.thicknessMap,e(f.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=f.attenuationDistance,m.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(m.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(m.anisotropyMap.value=f.anisotropyMap,e(f.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=f.specularIntensity,m.specularColor.value.copy(f.specularColor),f.specularColorMap&&(m.specularColorMap.value=f.specularColorMap,e(f.specularColorMap,m.specularColorMapTransform)),f.specularIntensityMap&&(m.specularIntensityMap.value=f.specularIntensityMap,e(f.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,f){f.matcap&&(m.matcap.value=f.matcap)}function y(m,f){let x=t.get(f).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function u1(n,t,e,i){let s={},r={};function o(x,b){let v=b.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,b){let v=s[x.id];v===void 0&&(g(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",m));let T=b.program;i.updateUBOMapping(x,T);let w=t.render.frame;r[x.id]!==w&&(c(x),r[x.id]=w)}function l(x){let b=n.createBuffer(),v=x.__size,T=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,v,T),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function c(x){let b=s[x.id],v=x.uniforms,T=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let w=0,_=v.length;w<_;w++){let M=v[w];if(Array.isArray(M))for(let L=0,P=M.length;L<P;L++)u(M[L],w,L,T);else u(M,w,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,b,v,T){if(h(x,b,v,T)===!0){let w=x.__offset,_=x.value;if(Array.isArray(_)){let M=0;for(let L=0;L<_.length;L++){let P=_[L],C=y(P,!0);d(P,x.__data,M),M+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,x.__data)}}function d(x,b,v){typeof x=="number"||typeof x=="boolean"?b[v]=x:x.isMatrix3?(b[v]=x.elements[0],b[v+1]=x.elements[1],b[v+2]=x.elements[2],b[v+3]=0,b[v+4]=x.elements[3],b[v+5]=x.elements[4],b[v+6]=x.elements[5],b[v+7]=0,b[v+8]=x.elements[6],b[v+9]=x.elements[7],b[v+10]=x.elements[8],b[v+11]=0):ArrayBuffer.isView(x)?b.set(x.subarray(0,b.length-v),v):x.toArray(b,v)}function h(x,b,v,T){let w=x.value,_=b+"_"+v;if(Array.isArray(w)){T[_]===void 0&&(T[_]=[]);let M=T[_],L=!1;for(let P=0;P<w.length;P++)p(w[P],M,P)===!0&&(L=!0);return L}return p(w,T,_)}function p(x,b,v){if(b[v]===void 0)return typeof x=="number"||typeof x=="boolean"?b[v]=x:ArrayBuffer.isView(x)?b[v]=x.slice():b[v]=x.clone(),!0;{let T=b[v];if(typeof x=="number"||typeof x=="boolean"){if(T!==x)return b[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(T.equals(x)===!1)return T.copy(x),!0}}return!1}function g(x){let b=x.uniforms,v=0,T=16;for(let _=0,M=b.length;_<M;_++){let L=Array.isArray(b[_])?b[_]:[b[_]];for(let P=0,C=L.length;P<C;P++){let U=L[P],B=Array.isArray(U.value)?U.value:[U.value],I=Array.isArray(b[_])||Array.isArray(U.value),k=v;for(let F=0,j=B.length;F<j;F++){let $=B[F],Z=y($,I),nt=v%T,ht=nt%Z.boundary,ct=nt+ht;v+=ht,ct!==0&&T-ct<Z.storage&&(v+=T-ct),F===0&&(k=v),v+=Z.storage}let H=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new H((v-k)/Float32Array.BYTES_PER_ELEMENT),U.__offset=k}}let w=v%T;return w>0&&(v+=T-w),x.__size=v,x.__cache={},this}function y(x,b){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?Jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):Jt("WebGLRenderer: Unsupported uniform value type.",x),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let b=x.target;b.removeEventListener("dispose",m),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function f(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:f}}var d1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ys=null;function f1(){return ys===null&&(ys=new Zc(d1,16,16,xr,qi),ys.name="DFG_LUT",ys.minFilter=ri,ys.magFilter=ri,ys.wrapS=ds,ys.wrapT=ds,ys.generateMipmaps=!1,ys.needsUpdate=!0),ys}var ou=class{constructor(t={}){let{canvas:e=Tg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:p=ui}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=p,m=new Set([wh,Mh,Sh]),f=new Set([ui,Xi,Yo,Br,vh,bh]),x=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},T=null,w=null,_=[],M=[],L=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,C=!1,U=null,B=null,I=null,k=null;this._outputColorSpace=ni;let H=0,F=0,j=null,$=-1,Z=null,nt=new tn,ht=new tn,ct=null,tt=new de(0),mt=0,_t=e.width,ft=e.height,xt=1,Gt=null,ae=null,Ht=new tn(0,0,_t,ft),qt=new tn(0,0,_t,ft),te=!1,re=new ur,Ge=new Kc,He=!1,pn=!1,Fe=new Xe,Nn=new q,Ee=new tn,wn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function mn(){return j===null?xt:1}let G=i;function Pt(R,W){return e.getContext(R,W)}let jt,he,Tt,ke,Wt,Kt,D,E,Y,dt,at,vt,bt,it,rt,gt,V,ot,st,Et,yt,Mt,$t;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ne,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),G===null){let W="webgl2";if(G=Pt(W,R),G===null)throw Pt(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ee()}catch(R){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),se("WebGLRenderer: "+R.message),R}function ee(){jt=new wM(G),jt.init(),yt=new o1(G,jt),he=new fM(G,jt,t,yt),Tt=new s1(G,jt),he.reversedDepthBuffer&&h&&Tt.buffers.depth.setReversed(!0),B=G.createFramebuffer(),I=G.createFramebuffer(),k=G.createFramebuffer(),ke=new AM(G),Wt=new Ww,Kt=new r1(G,jt,Tt,Wt,he,yt,ke),D=new MM(P),E=new Cv(G),Mt=new uM(G,E),Y=new TM(G,E,ke,Mt),dt=new CM(G,Y,E,Mt,ke),ot=new RM(G,he,Kt),rt=new pM(Wt),at=new Hw(P,D,jt,he,Mt,rt),vt=new h1(P,Wt),bt=new $w,it=new jw(jt),V=new hM(P,D,Tt,dt,g,l),gt=new i1(P,dt,he),$t=new u1(G,ke,he,Tt),st=new dM(G,jt,ke),Et=new EM(G,jt,ke),ke.programs=at.programs,P.capabilities=he,P.extensions=jt,P.properties=Wt,P.renderLists=bt,P.shadowMap=gt,P.state=Tt,P.info=ke}y!==ui&&(L=new IM(y,e.width,e.height,a,s,r));let ut=new Af(P,G);this.xr=ut,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let R=jt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=jt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return xt},this.setPixelRatio=function(R){R!==void 0&&(xt=R,this.setSize(_t,ft,!1))},this.getSize=function(R){return R.set(_t,ft)},this.setSize=function(R,W,et=!0){if(ut.isPresenting){Jt("WebGLRenderer: Can't change size while VR device is presenting.");return}_t=R,ft=W,e.width=Math.floor(R*xt),e.height=Math.floor(W*xt),et===!0&&(e.style.width=R+"px",e.style.height=W+"px"),L!==null&&L.setSize(e.width,e.height),this.setViewport(0,0,R,W)},this.getDrawingBufferSize=function(R){return R.set(_t*xt,ft*xt).floor()},this.setDrawingBufferSize=function(R,W,et){_t=R,ft=W,xt=et,e.width=Math.floor(R*et),e.height=Math.floor(W*et),this.setViewport(0,0,R,W)},this.setEffects=function(R){if(y===ui){se("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let W=0;W<R.length;W++)if(R[W].isOutputPass===!0){Jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(nt)},this.getViewport=function(R){return R.copy(Ht)},this.setViewport=function(R,W,et,K){R.isVector4?Ht.set(R.x,R.y,R.z,R.w):Ht.set(R,W,et,K),Tt.viewport(nt.copy(Ht).multiplyScalar(mn()).round())},this.getScissor=function(R){return R.copy(qt)},this.setScissor=function(R,W,et,K){R.isVector4?qt.set(R.x,R.y,R.z,R.w):qt.set(R,W,et,K),Tt.scissor(ht.copy(qt).multiplyScalar(mn()).round())},this.getScissorTest=function(){return te},this.setScissorTest=function(R){Tt.setScissorTest(te=R)},this.setOpaqueSort=function(R){Gt=R},this.setTransparentSort=function(R){ae=R},this.getClearColor=function(R){return R.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(R=!0,W=!0,et=!0){let K=0;if(R){let J=!1;if(j!==null){let At=j.texture.format;J=m.has(At)}if(J){let At=j.texture.type,It=f.has(At),Rt=V.getClearColor(),Dt=V.getClearAlpha(),Vt=Rt.r,oe=Rt.g,_e=Rt.b;It?(x[0]=Vt,x[1]=oe,x[2]=_e,x[3]=Dt,G.clearBufferuiv(G.COLOR,0,x)):(b[0]=Vt,b[1]=oe,b[2]=_e,b[3]=Dt,G.clearBufferiv(G.COLOR,0,b))}else K|=G.COLOR_BUFFER_BIT}W&&(K|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(K|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),K!==0&&G.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),U=R},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ne,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),V.dispose(),bt.dispose(),it.dispose(),Kt.dispose(),Wt.dispose(),D.dispose(),dt.dispose(),Y.dispose(),Mt.dispose(),$t.dispose(),at.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",zl),ut.removeEventListener("sessionend",Qi),Ms.stop()};function kt(R){R.preventDefault(),Xa("WebGLRenderer: Context Lost."),C=!0}function ne(){Xa("WebGLRenderer: Context Restored."),C=!1;let R=ke.autoReset,W=gt.enabled,et=gt.autoUpdate,K=gt.needsUpdate,J=gt.type;ee(),ke.autoReset=R,gt.enabled=W,gt.autoUpdate=et,gt.needsUpdate=K,gt.type=J}function Ct(R){se("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ue(R){let W=R.target;W.removeEventListener("dispose",ue),$e(W)}function $e(R){Kn(R),Wt.remove(R)}function Kn(R){let W=Wt.get(R).programs;W!==void 0&&(W.forEach(function(et){at.releaseProgram(et)}),R.isShaderMaterial&&at.releaseShaderCache(R))}this.renderBufferDirect=function(R,W,et,K,J,At){W===null&&(W=wn);let It=J.isMesh&&J.matrixWorld.determinantAffine()<0,Rt=ya(R,W,et,K,J);Tt.setMaterial(K,It);let Dt=et.index,Vt=1;if(K.wireframe===!0){if(Dt=Y.getWireframeAttribute(et),Dt===void 0)return;Vt=2}let oe=et.drawRange,_e=et.attributes.position,zt=oe.start*Vt,xe=(oe.start+oe.count)*Vt;At!==null&&(zt=Math.max(zt,At.start*Vt),xe=Math.min(xe,(At.start+At.count)*Vt)),Dt!==null?(zt=Math.max(zt,0),xe=Math.min(xe,Dt.count)):_e!=null&&(zt=Math.max(zt,0),xe=Math.min(xe,_e.count));let en=xe-zt;if(en<0||en===1/0)return;Mt.setup(J,K,Rt,et,Dt);let Ne,Ue=st;if(Dt!==null&&(Ne=E.get(Dt),Ue=Et,Ue.setIndex(Ne)),J.isMesh)K.wireframe===!0?(Tt.setLineWidth(K.wireframeLinewidth*mn()),Ue.setMode(G.LINES)):Ue.setMode(G.TRIANGLES);else if(J.isLine){let Tn=K.linewidth;Tn===void 0&&(Tn=1),Tt.setLineWidth(Tn*mn()),J.isLineSegments?Ue.setMode(G.LINES):J.isLineLoop?Ue.setMode(G.LINE_LOOP):Ue.setMode(G.LINE_STRIP)}else J.isPoints?Ue.setMode(G.POINTS):J.isSprite&&Ue.setMode(G.TRIANGLES);if(J.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))Ue.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Tn=J._multiDrawStarts,Ft=J._multiDrawCounts,gn=J._multiDrawCount,be=Dt?E.get(Dt).bytesPerElement:1,Ts=Wt.get(K).currentProgram.getUniforms();for(let _n=0;_n<gn;_n++)Ts.setValue(G,"_gl_DrawID",_n),Ue.render(Tn[_n]/be,Ft[_n])}else if(J.isInstancedMesh)Ue.renderInstances(zt,en,J.count);else if(et.isInstancedBufferGeometry){let Tn=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Ft=Math.min(et.instanceCount,Tn);Ue.renderInstances(zt,en,Ft)}else Ue.render(zt,en)};function ga(R,W,et,K){U!==null&&R.isNodeMaterial&&U.setObject(K,R),He===!0&&rt.setState(R,et,!1),R.transparent===!0&&R.side===hi&&R.forceSinglePass===!1?(R.side=ai,R.needsUpdate=!0,ts(R,W,K),R.side=_s,R.needsUpdate=!0,ts(R,W,K),R.side=hi):ts(R,W,K)}this.compile=function(R,W,et=null){et===null&&(et=R),U!==null&&U.renderStart(R,W,et),w=it.get(et),w.init(W),M.push(w),et.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(w.pushLight(J),J.castShadow&&w.pushShadow(J))}),R!==et&&R.traverseVisible(function(J){J.isLight&&J.layers.test(W.layers)&&(w.pushLight(J),J.castShadow&&w.pushShadow(J))}),w.setupLights(),U!==null&&U.updateLights(w.state.lightsArray),pn=this.localClippingEnabled,He=rt.init(this.clippingPlanes,pn),He===!0&&rt.setGlobalState(this.clippingPlanes,W),U!==null&&gt.render(w.state.shadowsArray,et,W);let K=new Set;return R.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let At=J.material;if(At)if(Array.isArray(At))for(let It=0;It<At.length;It++){let Rt=At[It];ga(Rt,et,W,J),K.add(Rt)}else ga(At,et,W,J),K.add(At)}),w=M.pop(),U!==null&&U.renderEnd(),K},this.compileAsync=function(R,W,et=null){let K=this.compile(R,W,et);return new Promise(J=>{function At(){if(K.forEach(function(It){let Dt=Wt.get(It).currentProgram;(Dt===void 0||Dt.isReady())&&K.delete(It)}),K.size===0){J(R);return}setTimeout(At,10)}jt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let Jr=null;function Vu(R){Jr&&Jr(R)}function zl(){Ms.stop()}function Qi(){Ms.start()}let Ms=new e0;Ms.setAnimationLoop(Vu),typeof self<"u"&&Ms.setContext(self),this.setAnimationLoop=function(R){Jr=R,ut.setAnimationLoop(R),R===null?Ms.stop():Ms.start()},ut.addEventListener("sessionstart",zl),ut.addEventListener("sessionend",Qi),this.render=function(R,W){if(W!==void 0&&W.isCamera!==!0){se("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;U!==null&&U.renderStart(R,W);let et=ut.enabled===!0&&ut.isPresenting===!0,K=L!==null&&(j===null||et)&&L.begin(P,j);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(W),W=ut.getCamera()),R.isScene===!0&&R.onBeforeRender(P,R,W,j),w=it.get(R,M.length),w.init(W),w.state.textureUnits=Kt.getTextureUnits(),M.push(w),Fe.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?Ge.setFromArrayCamera(W):re.setFromProjectionMatrix(Fe,Pi,W.reversedDepth),pn=this.localClippingEnabled,He=rt.init(this.clippingPlanes,pn),T=bt.get(R,_.length),T.init(),_.push(T),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let It=P.xr.getDepthSensingMesh();It!==null&&ws(It,W,-1/0,P.sortObjects)}ws(R,W,0,P.sortObjects),T.finish(),U!==null&&U.updateLights(w.state.lightsArray),P.sortObjects===!0&&T.sort(Gt,ae),sn=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,sn&&V.addToRenderList(T,R),this.info.autoReset===!0&&this.info.reset(),He===!0&&rt.beginShadows();let J=w.state.shadowsArray;if(gt.render(J,R,W),He===!0&&rt.endShadows(),(K&&L.hasRenderPass())===!1){let It=T.opaque,Rt=T.transmissive;if(w.setupLights(),W.isArrayCamera){let Dt=W.cameras;if(Rt.length>0)for(let Vt=0,oe=Dt.length;Vt<oe;Vt++){let _e=Dt[Vt];Fi(It,Rt,R,_e)}sn&&V.render(R);for(let Vt=0,oe=Dt.length;Vt<oe;Vt++){let _e=Dt[Vt];_a(T,R,_e,_e.viewport)}}else Rt.length>0&&Fi(It,Rt,R,W),sn&&V.render(R),_a(T,R,W)}j!==null&&F===0&&(Kt.updateMultisampleRenderTarget(j),Kt.updateRenderTargetMipmap(j)),K&&L.end(P),R.isScene===!0&&R.onAfterRender(P,R,W),Mt.resetDefaultState(),$=-1,Z=null,M.pop(),M.length>0?(w=M[M.length-1],Kt.setTextureUnits(w.state.textureUnits),He===!0&&rt.setGlobalState(P.clippingPlanes,w.state.camera)):w=null,_.pop(),_.length>0?T=_[_.length-1]:T=null,U!==null&&U.renderEnd()};function ws(R,W,et,K){if(R.visible===!1)return;if(R.layers.test(W.layers)){if(R.isGroup)et=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(W);else if(R.isLight)w.pushLight(R),R.castShadow&&w.pushShadow(R);else if(R.isSprite){let It=W.isArrayCamera?Ge:re;if(!R.frustumCulled||R.intersectsFrustum(It)){K&&Ee.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Fe);let Rt=dt.update(R),Dt=R.material;Dt.visible&&T.push(R,Rt,Dt,et,Ee.z,null,W)}}else if(R.isMesh||R.isLine||R.isPoints){let It=W.isArrayCamera?Ge:re;if(!R.frustumCulled||R.intersectsFrustum(It)){let Rt=dt.update(R),Dt=R.material;if(K&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Ee.copy(R.boundingSphere.center)):(Rt.boundingSphere===null&&Rt.computeBoundingSphere(),Ee.copy(Rt.boundingSphere.center)),Ee.applyMatrix4(R.matrixWorld).applyMatrix4(Fe)),Array.isArray(Dt)){let Vt=Rt.groups;for(let oe=0,_e=Vt.length;oe<_e;oe++){let zt=Vt[oe],xe=Dt[zt.materialIndex];xe&&xe.visible&&T.push(R,Rt,xe,et,Ee.z,zt,W)}}else Dt.visible&&T.push(R,Rt,Dt,et,Ee.z,null,W)}}}let At=R.children;for(let It=0,Rt=At.length;It<Rt;It++)ws(At[It],W,et,K)}function _a(R,W,et,K){let{opaque:J,transmissive:At,transparent:It}=R;w.setupLightsView(et),He===!0&&rt.setGlobalState(P.clippingPlanes,et),K&&Tt.viewport(nt.copy(K)),J.length>0&&rn(J,W,et),At.length>0&&rn(At,W,et),It.length>0&&rn(It,W,et),Tt.buffers.depth.setTest(!0),Tt.buffers.depth.setMask(!0),Tt.buffers.color.setMask(!0),Tt.setPolygonOffset(!1)}function Fi(R,W,et,K){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[K.id]===void 0){let zt=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[K.id]=new Si(1,1,{generateMipmaps:!0,type:zt?qi:ui,minFilter:zs,samples:Math.max(4,he.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Me.workingColorSpace})}let At=w.state.transmissionRenderTarget[K.id],It=K.viewport||nt;At.setSize(It.z*P.transmissionResolutionScale,It.w*P.transmissionResolutionScale);let Rt=P.getRenderTarget(),Dt=P.getActiveCubeFace(),Vt=P.getActiveMipmapLevel();P.setRenderTarget(At),P.getClearColor(tt),mt=P.getClearAlpha(),mt<1&&P.setClearColor(16777215,.5),P.clear(),sn&&V.render(et);let oe=P.toneMapping;P.toneMapping=xs;let _e=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),w.setupLightsView(K),He===!0&&rt.setGlobalState(P.clippingPlanes,K),rn(R,et,K),Kt.updateMultisampleRenderTarget(At),Kt.updateRenderTargetMipmap(At),jt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let xe=0,en=W.length;xe<en;xe++){let Ne=W[xe],{object:Ue,geometry:Tn,material:Ft,group:gn}=Ne;if(Ft.side===hi&&Ue.layers.test(K.layers)){let be=Ft.side;Ft.side=ai,Ft.needsUpdate=!0,hn(Ue,et,K,Tn,Ft,gn),Ft.side=be,Ft.needsUpdate=!0,zt=!0}}zt===!0&&(Kt.updateMultisampleRenderTarget(At),Kt.updateRenderTargetMipmap(At))}P.setRenderTarget(Rt,Dt,Vt),P.setClearColor(tt,mt),_e!==void 0&&(K.viewport=_e),P.toneMapping=oe}function rn(R,W,et){let K=W.isScene===!0?W.overrideMaterial:null;for(let J=0,At=R.length;J<At;J++){let It=R[J],{object:Rt,geometry:Dt,group:Vt}=It,oe=It.material;oe.allowOverride===!0&&K!==null&&(oe=K),Rt.layers.test(et.layers)&&hn(Rt,W,et,Dt,oe,Vt)}}function hn(R,W,et,K,J,At){U!==null&&J.isNodeMaterial&&U.setObject(R,J),R.onBeforeRender(P,W,et,K,J,At),R.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),J.onBeforeRender(P,W,et,K,R,At),J.transparent===!0&&J.side===hi&&J.forceSinglePass===!1?(J.side=ai,J.needsUpdate=!0,P.renderBufferDirect(et,W,K,J,R,At),J.side=_s,J.needsUpdate=!0,P.renderBufferDirect(et,W,K,J,R,At),J.side=hi):P.renderBufferDirect(et,W,K,J,R,At),R.onAfterRender(P,W,et,K,J,At)}function un(R){let W=0;for(let et of R)et.texture!==null&&W++;return W}function ts(R,W,et){W.isScene!==!0&&(W=wn);let K=Wt.get(R),J=w.state.lights,At=w.state.shadowsArray,It=J.state.version,Rt=at.getParameters(R,J.state,At,W,et,w.state.lightProbeGridArray),Dt=at.getProgramCacheKey(Rt),Vt=K.programs;K.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?W.environment:null,K.fog=W.fog;let oe=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;K.envMap=D.get(R.envMap||K.environment,oe),K.envMapRotation=K.environment!==null&&R.envMap===null?W.environmentRotation:R.envMapRotation,Vt===void 0&&(R.addEventListener("dispose",ue),Vt=new Map,K.programs=Vt,K.programVariants=new Map);let _e=Vt.get(Dt);if(_e!==void 0){if(K.currentProgram===_e&&K.lightsStateVersion===It)return xa(R,Rt),_e}else Rt.uniforms=at.getUniforms(R),U!==null&&R.isNodeMaterial&&U.build(R,et,Rt),R.onBeforeCompile(Rt,P),_e=at.acquireProgram(Rt,Dt),Vt.set(Dt,_e),K.uniforms=Rt.uniforms;let zt=K.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(zt.clippingPlanes=rt.uniform),xa(R,Rt),K.needsLights=Js(R),K.lightsStateVersion=It,K.needsLights&&(zt.ambientLightColor.value=J.state.ambient,zt.lightProbe.value=J.state.probe,zt.sunLights.value=J.state.sun,zt.sunLightShadows.value=J.state.sunShadow,zt.directionalLights.value=J.state.directional,zt.directionalLightShadows.value=J.state.directionalShadow,zt.spotLights.value=J.state.spot,zt.spotLightShadows.value=J.state.spotShadow,zt.rectAreaLights.value=J.state.rectArea,zt.ltc_1.value=J.state.rectAreaLTC1,zt.ltc_2.value=J.state.rectAreaLTC2,zt.pointLights.value=J.state.point,zt.pointLightShadows.value=J.state.pointShadow,zt.hemisphereLights.value=J.state.hemi,zt.sunShadowMatrix.value=J.state.sunShadowMatrix,zt.sunShadowCascade.value=J.state.sunShadowCascade,zt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,zt.spotLightMatrix.value=J.state.spotLightMatrix,zt.spotLightMap.value=J.state.spotLightMap,zt.pointShadowMatrix.value=J.state.pointShadowMatrix),K.numLightProbeGrids=un(w.state.lightProbeGridArray),K.currentProgram=_e,K.uniformsList=null,_e}function pi(R,W,et,K,J){let At=Wt.get(R),It=At.currentProgram.id+","+K+","+J,Rt=At.programVariants.get(It);return Rt===void 0?(Rt=ts(R,W,et),At.programVariants.set(It,Rt)):(At.currentProgram=Rt,At.uniformsList=null,At.outputColorSpace=K,At.toneMapping=J),Rt}function Ks(R){if(R.uniformsList===null){let W=R.currentProgram.getUniforms();R.uniformsList=Zo.seqWithValue(W.seq,R.uniforms)}return R.uniformsList}function xa(R,W){let et=Wt.get(R);et.outputColorSpace=W.outputColorSpace,et.batching=W.batching,et.batchingColor=W.batchingColor,et.instancing=W.instancing,et.instancingColor=W.instancingColor,et.instancingMorph=W.instancingMorph,et.skinning=W.skinning,et.morphTargets=W.morphTargets,et.morphNormals=W.morphNormals,et.morphColors=W.morphColors,et.morphTargetsCount=W.morphTargetsCount,et.numClippingPlanes=W.numClippingPlanes,et.numIntersection=W.numClipIntersection,et.vertexAlphas=W.vertexAlphas,et.vertexTangents=W.vertexTangents,et.toneMapping=W.toneMapping}function ya(R,W,et,K,J){W.isScene!==!0&&(W=wn),Kt.resetTextureUnits();let At=W.fog,It=K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial?W.environment:null,Rt=j===null?P.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:Me.workingColorSpace,Dt=K.isMeshStandardMaterial||K.isMeshLambertMaterial&&!K.envMap||K.isMeshPhongMaterial&&!K.envMap,Vt=D.get(K.envMap||It,Dt),oe=K.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,_e=!!et.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),zt=!!et.morphAttributes.position,xe=!!et.morphAttributes.normal,en=!!et.morphAttributes.color,Ne=xs;K.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(Ne=P.toneMapping);let Ue=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,Tn=Ue!==void 0?Ue.length:0,Ft=Wt.get(K),gn=w.state.lights;if(He===!0&&(pn===!0||R!==Z)){let Oe=R===Z&&K.id===$;rt.setState(K,R,Oe)}let be=!1,Ts=!1;K.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==gn.state.version||J.isBatchedMesh&&Ft.batching===!1||!J.isBatchedMesh&&Ft.batching===!0||J.isBatchedMesh&&Ft.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ft.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ft.instancing===!1||!J.isInstancedMesh&&Ft.instancing===!0||J.isSkinnedMesh&&Ft.skinning===!1||!J.isSkinnedMesh&&Ft.skinning===!0||J.isInstancedMesh&&Ft.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ft.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ft.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ft.instancingMorph===!1&&J.morphTexture!==null||Ft.envMap!==Vt||K.fog===!0&&Ft.fog!==At||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==rt.numPlanes||Ft.numIntersection!==rt.numIntersection)||Ft.vertexAlphas!==oe||Ft.vertexTangents!==_e||Ft.morphTargets!==zt||Ft.morphNormals!==xe||Ft.morphColors!==en||Ft.morphTargetsCount!==Tn||Ft.numLightProbeGrids!==un(w.state.lightProbeGridArray)?be=!0:(Ft.outputColorSpace!==Rt||Ft.toneMapping!==Ne)&&(Ts=!0):(be=!0,Ft.__version=K.version);let _n=Ft.currentProgram;(be===!0||Ts===!0)&&(_n=Ts===!0?pi(K,W,J,Rt,Ne):ts(K,W,J),U&&K.isNodeMaterial&&U.onUpdateProgram(K,_n,Ft));let to=!1,es=!1,Es=!1,fe=_n.getUniforms(),on=Ft.uniforms;if(Tt.useProgram(_n.program)&&(to=!0,es=!0,Es=!0),K.id!==$&&($=K.id,es=!0),to||Z!==R){Tt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),fe.setValue(G,"projectionMatrix",R.projectionMatrix),fe.setValue(G,"viewMatrix",R.matrixWorldInverse);let xn=fe.map.cameraPosition;xn!==void 0&&xn.setValue(G,Nn.setFromMatrixPosition(R.matrixWorld)),he.logarithmicDepthBuffer&&fe.setValue(G,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&fe.setValue(G,"isOrthographic",R.isOrthographicCamera===!0),Z!==R&&(Z=R,es=!0,Es=!0)}if(Ft.needsLights&&(gn.state.sunShadowMap.length>0&&fe.setValue(G,"sunShadowMap",gn.state.sunShadowMap,Kt),gn.state.directionalShadowMap.length>0&&fe.setValue(G,"directionalShadowMap",gn.state.directionalShadowMap,Kt),gn.state.spotShadowMap.length>0&&fe.setValue(G,"spotShadowMap",gn.state.spotShadowMap,Kt),gn.state.pointShadowMap.length>0&&fe.setValue(G,"pointShadowMap",gn.state.pointShadowMap,Kt)),J.isSkinnedMesh){fe.setOptional(G,J,"bindMatrix"),fe.setOptional(G,J,"bindMatrixInverse");let Oe=J.skeleton;Oe&&(Oe.boneTexture===null&&Oe.computeBoneTexture(),fe.setValue(G,"boneTexture",Oe.boneTexture,Kt))}J.isBatchedMesh&&(fe.setOptional(G,J,"batchingTexture"),fe.setValue(G,"batchingTexture",J._matricesTexture,Kt),fe.setOptional(G,J,"batchingIdTexture"),fe.setValue(G,"batchingIdTexture",J._indirectTexture,Kt),fe.setOptional(G,J,"batchingColorTexture"),J._colorsTexture!==null&&fe.setValue(G,"batchingColorTexture",J._colorsTexture,Kt));let Jn=et.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&ot.update(J,et,_n),(es||Ft.receiveShadow!==J.receiveShadow)&&(Ft.receiveShadow=J.receiveShadow,fe.setValue(G,"receiveShadow",J.receiveShadow)),(K.isMeshStandardMaterial||K.isMeshLambertMaterial||K.isMeshPhongMaterial)&&K.envMap===null&&W.environment!==null&&(on.envMapIntensity.value=W.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=f1()),es){if(fe.setValue(G,"toneMappingExposure",P.toneMappingExposure),Ft.needsLights&&jr(on,Es),At&&K.fog===!0&&vt.refreshFogUniforms(on,At),vt.refreshMaterialUniforms(on,K,xt,ft,w.state.transmissionRenderTarget[R.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Oe=v,xn=0;for(let Xn of w.state.lightProbeGridArray)Xn.texture!==null&&(Oe.textures[xn]=Xn.texture,Oe.min[xn]=Xn.boundingBox.min,Oe.max[xn]=Xn.boundingBox.max,Oe.resolution[xn]=Xn.resolution,xn++);for(let Xn in Oe)Oe[Xn].length=xn;on.probesSH.value=Oe.textures,on.probesMin.value=Oe.min,on.probesMax.value=Oe.max,on.probesResolution.value=Oe.resolution}Zo.upload(G,Ks(Ft),on,Kt)}if(K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Zo.upload(G,Ks(Ft),on,Kt),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&fe.setValue(G,"center",J.center),fe.setValue(G,"modelViewMatrix",J.modelViewMatrix),fe.setValue(G,"normalMatrix",J.normalMatrix),fe.setValue(G,"modelMatrix",J.matrixWorld),K.uniformsGroups!==void 0){let Oe=K.uniformsGroups;for(let xn=0,Xn=Oe.length;xn<Xn;xn++){let Vl=Oe[xn];$t.update(Vl,_n),$t.bind(Vl,_n)}}return _n}function jr(R,W){R.ambientLightColor.needsUpdate=W,R.lightProbe.needsUpdate=W,R.sunLights.needsUpdate=W,R.sunLightShadows.needsUpdate=W,R.directionalLights.needsUpdate=W,R.directionalLightShadows.needsUpdate=W,R.pointLights.needsUpdate=W,R.pointLightShadows.needsUpdate=W,R.spotLights.needsUpdate=W,R.spotLightShadows.needsUpdate=W,R.rectAreaLights.needsUpdate=W,R.hemisphereLights.needsUpdate=W}function Js(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return F},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(R,W,et){let K=Wt.get(R);K.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Wt.get(R.texture).__webglTexture=W,Wt.get(R.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:et,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,W){let et=Wt.get(R);et.__webglFramebuffer=W,et.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(R,W=0,et=0){j=R,H=W,F=et;let K=null,J=!1,At=!1;if(R){let Rt=Wt.get(R);if(Rt.__useDefaultFramebuffer!==void 0){Tt.bindFramebuffer(G.FRAMEBUFFER,Rt.__webglFramebuffer),nt.copy(R.viewport),ht.copy(R.scissor),ct=R.scissorTest,Tt.viewport(nt),Tt.scissor(ht),Tt.setScissorTest(ct),$=-1;return}else if(Rt.__webglFramebuffer===void 0)Kt.setupRenderTarget(R);else if(Rt.__hasExternalTextures)Kt.rebindTextures(R,Wt.get(R.texture).__webglTexture,Wt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let oe=R.depthTexture;if(Rt.__boundDepthTexture!==oe){if(oe!==null&&Wt.has(oe)&&(R.width!==oe.image.width||R.height!==oe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(R)}}let Dt=R.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(At=!0);let Vt=Wt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Vt[W])?K=Vt[W][et]:K=Vt[W],J=!0):R.samples>0&&Kt.useMultisampledRTT(R)===!1?K=Wt.get(R).__webglMultisampledFramebuffer:Array.isArray(Vt)?K=Vt[et]:K=Vt,nt.copy(R.viewport),ht.copy(R.scissor),ct=R.scissorTest}else nt.copy(Ht).multiplyScalar(xt).floor(),ht.copy(qt).multiplyScalar(xt).floor(),ct=te;if(et!==0&&(K=B),Tt.bindFramebuffer(G.FRAMEBUFFER,K)&&Tt.drawBuffers(R,K),Tt.viewport(nt),Tt.scissor(ht),Tt.setScissorTest(ct),J){let Rt=Wt.get(R.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+W,Rt.__webglTexture,et)}else if(At){let Rt=W;for(let Dt=0;Dt<R.textures.length;Dt++){let Vt=Wt.get(R.textures[Dt]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+Dt,Vt.__webglTexture,et,Rt)}}else if(R!==null&&et!==0){let Rt=Wt.get(R.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,Rt.__webglTexture,et)}$=-1};function Qr(R){let W=Wt.get(R);return(W.__readFormat!==R.format||W.__readType!==R.type)&&(W.__readFormat=R.format,W.__readType=R.type,W.__formatReadable=he.textureFormatReadable(R.format),W.__typeReadable=he.textureTypeReadable(R.type)),W}this.readRenderTargetPixels=function(R,W,et,K,J,At,It,Rt=0){if(!(R&&R.isWebGLRenderTarget)){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Wt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Dt=Dt[It],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){Tt.bindFramebuffer(G.FRAMEBUFFER,Dt);try{let Vt=R.textures[Rt],oe=Vt.format,_e=Vt.type;R.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Rt);let zt=Qr(Vt);if(zt.__formatReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){se("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=R.width-K&&et>=0&&et<=R.height-J&&G.readPixels(W,et,K,J,yt.convert(oe),yt.convert(_e),At)}finally{let Vt=j!==null?Wt.get(j).__webglFramebuffer:null;Tt.bindFramebuffer(G.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(R,W,et,K,J,At,It,Rt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Wt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&It!==void 0&&(Dt=Dt[It],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(W>=0&&W<=R.width-K&&et>=0&&et<=R.height-J){Tt.bindFramebuffer(G.FRAMEBUFFER,Dt);let Vt=R.textures[Rt],oe=Vt.format,_e=Vt.type;R.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Rt);let zt=Qr(Vt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,xe),G.bufferData(G.PIXEL_PACK_BUFFER,At.byteLength,G.STREAM_READ),G.readPixels(W,et,K,J,yt.convert(oe),yt.convert(_e),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let en=j!==null?Wt.get(j).__webglFramebuffer:null;Tt.bindFramebuffer(G.FRAMEBUFFER,en);let Ne=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await Ag(G,Ne,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,xe),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,At),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(xe),G.deleteSync(Ne),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,W=null,et=0){let K=Math.pow(2,-et),J=Math.floor(R.image.width*K),At=Math.floor(R.image.height*K),It=W!==null?W.x:0,Rt=W!==null?W.y:0;Kt.setTexture2D(R,0),G.copyTexSubImage2D(G.TEXTURE_2D,et,0,0,It,Rt,J,At),Tt.unbindTexture()},this.copyTextureToTexture=function(R,W,et=null,K=null,J=0,At=0){let It,Rt,Dt,Vt,oe,_e,zt,xe,en,Ne=R.isCompressedTexture?R.mipmaps[At]:R.image;if(et!==null)It=et.max.x-et.min.x,Rt=et.max.y-et.min.y,Dt=et.isBox3?et.max.z-et.min.z:1,Vt=et.min.x,oe=et.min.y,_e=et.isBox3?et.min.z:0;else{let fe=Math.pow(2,-J);It=Math.floor(Ne.width*fe),Rt=Math.floor(Ne.height*fe),R.isDataArrayTexture?Dt=Ne.depth:R.isData3DTexture?Dt=Math.floor(Ne.depth*fe):Dt=1,Vt=0,oe=0,_e=0}K!==null?(zt=K.x,xe=K.y,en=K.z):(zt=0,xe=0,en=0);let Ue=yt.convert(W.format),Tn=yt.convert(W.type),Ft;W.isData3DTexture?(Kt.setTexture3D(W,0),Ft=G.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Kt.setTexture2DArray(W,0),Ft=G.TEXTURE_2D_ARRAY):(Kt.setTexture2D(W,0),Ft=G.TEXTURE_2D),Tt.activeTexture(G.TEXTURE0),Tt.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,W.flipY),Tt.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Tt.pixelStorei(G.UNPACK_ALIGNMENT,W.unpackAlignment);let gn=Tt.getParameter(G.UNPACK_ROW_LENGTH),be=Tt.getParameter(G.UNPACK_IMAGE_HEIGHT),Ts=Tt.getParameter(G.UNPACK_SKIP_PIXELS),_n=Tt.getParameter(G.UNPACK_SKIP_ROWS),to=Tt.getParameter(G.UNPACK_SKIP_IMAGES);Tt.pixelStorei(G.UNPACK_ROW_LENGTH,Ne.width),Tt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Ne.height),Tt.pixelStorei(G.UNPACK_SKIP_PIXELS,Vt),Tt.pixelStorei(G.UNPACK_SKIP_ROWS,oe),Tt.pixelStorei(G.UNPACK_SKIP_IMAGES,_e);let es=R.isDataArrayTexture||R.isData3DTexture,Es=W.isDataArrayTexture||W.isData3DTexture;if(R.isDepthTexture){let fe=Wt.get(R),on=Wt.get(W),Jn=Wt.get(fe.__renderTarget),Oe=Wt.get(on.__renderTarget);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,Jn.__webglFramebuffer),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let xn=0;xn<Dt;xn++)es&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Wt.get(R).__webglTexture,J,_e+xn),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Wt.get(W).__webglTexture,At,en+xn)),G.blitFramebuffer(Vt,oe,Vt+It,oe+Rt,zt,xe,zt+It,xe+Rt,G.DEPTH_BUFFER_BIT,G.NEAREST);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(J!==0||R.isRenderTargetTexture||Wt.has(R)){let fe=Wt.get(R),on=Wt.get(W);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,I),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,k);for(let Jn=0;Jn<Dt;Jn++)es?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,fe.__webglTexture,J,_e+Jn):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,fe.__webglTexture,J),Es?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,on.__webglTexture,At,en+Jn):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,on.__webglTexture,At),J!==0?G.blitFramebuffer(Vt,oe,Vt+It,oe+Rt,zt,xe,zt+It,xe+Rt,G.COLOR_BUFFER_BIT,G.NEAREST):Es?G.copyTexSubImage3D(Ft,At,zt,xe,en+Jn,Vt,oe,It,Rt):G.copyTexSubImage2D(Ft,At,zt,xe,Vt,oe,It,Rt);Tt.bindFramebuffer(G.READ_FRAMEBUFFER,null),Tt.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Es?R.isDataTexture||R.isData3DTexture?G.texSubImage3D(Ft,At,zt,xe,en,It,Rt,Dt,Ue,Tn,Ne.data):W.isCompressedArrayTexture?G.compressedTexSubImage3D(Ft,At,zt,xe,en,It,Rt,Dt,Ue,Ne.data):G.texSubImage3D(Ft,At,zt,xe,en,It,Rt,Dt,Ue,Tn,Ne):R.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,At,zt,xe,It,Rt,Ue,Tn,Ne.data):R.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,At,zt,xe,Ne.width,Ne.height,Ue,Ne.data):G.texSubImage2D(G.TEXTURE_2D,At,zt,xe,It,Rt,Ue,Tn,Ne);Tt.pixelStorei(G.UNPACK_ROW_LENGTH,gn),Tt.pixelStorei(G.UNPACK_IMAGE_HEIGHT,be),Tt.pixelStorei(G.UNPACK_SKIP_PIXELS,Ts),Tt.pixelStorei(G.UNPACK_SKIP_ROWS,_n),Tt.pixelStorei(G.UNPACK_SKIP_IMAGES,to),At===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&G.generateMipmap(Ft),Tt.unbindTexture()},this.initRenderTarget=function(R){Wt.get(R).__webglFramebuffer===void 0&&Kt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Kt.setTextureCube(R,0):R.isData3DTexture?Kt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Kt.setTexture2DArray(R,0):Kt.setTexture2D(R,0),Tt.unbindTexture()},this.resetState=function(){H=0,F=0,j=null,Tt.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Me._getDrawingBufferColorSpace(t),e.unpackColorSpace=Me._getUnpackColorSpace()}};function Pn(n,t,e){let i=t-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],step:1};let s=i/Math.max(e,1),r=10**Math.floor(Math.log10(s)),o=[1,2,2.5,5,10].map(l=>l*r).find(l=>l>=s*.999)??10*r,a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=t+o*1e-9;l++)a.push(l*o);return{values:a,step:o}}var p1={start:0,middle:.5,end:1},Rf=(n,t)=>n<8?"start":n>t-8?"end":"middle";function d0(n,t,e){for(let r=Math.floor(e/24);r>1;r--){let o=Pn(n,t,r),a=-1/0;if(o.values.every(c=>{let u=(c-n)/(t-n)*e,d=6.2*Sn(c,o.step).length,h=u-p1[Rf(u,e)]*d,p=a<=h;return a=h+d+5,p}))return o}return Pn(n,t,1)}function Sn(n,t){let e=Math.abs(n)<t*1e-6?0:n,i=0;for(;i<8&&Math.abs(t*10**i-Math.round(t*10**i))>1e-6;)i++;return os(e.toFixed(i))}function f0(n,t,e,i,s){if(!(n<=t)||n===0&&t===0)return[0,i];(e||n>0&&n<.35*t)&&(n=Math.min(n,0)),(e||t<0&&t>.35*n)&&(t=Math.max(t,0));let r=s-(t-n);if(r>0){let l=.001*s;return n>=-l&&n<r/2?[0,Math.max(t,s)]:t<=l&&-t<r/2?[Math.min(n,-s),0]:[n-r/2,t+r/2]}let a=.05*(t-n||Math.abs(t)*.2||1);return[n===0?0:n-a,t===0?0:t+a]}function cu(n,t,e,i){let s=Array.from({length:21},(c,u)=>`rgb(${i(u/20).join(" ")}) ${u*5}%`),[r,o]=[Xt(e[0],t),Xt(e[1],t)],{values:a,step:l}=Pn(r,o,4);return[z("span",{},n),z("div",{class:"ramp",style:`background:linear-gradient(to right, ${s.join(",")})`}),z("div",{class:"ramp-ticks"},a.map(c=>z("span",{style:`left:${(c-r)/(o-r)*100}%`},Sn(c,l))))]}var hu=17;function zr(n,t,e,i="text",s=.5){let r=z("canvas",{}),o=r.getContext("2d");if(!o)throw new Error("this browser does not support canvas drawing");let a="600 44px system-ui, sans-serif";o.font=a,r.width=Math.ceil(o.measureText(n).width)+8,r.height=56,o.font=a,o.textBaseline="middle",o.fillStyle=Se(i),o.fillText(n,4,30);let l=new Qa(r);l.colorSpace=ni;let c=new ps(new Vo({map:l,depthTest:!1,transparent:!0}));return c.position.set(...t),c.center.set(s,.5),c.userData.pixels=[e*r.width/r.height,e],c.renderOrder=3,c}function Cf(n,[t,e]){let i=new q(1/0,1/0,1/0),s=i.clone().negate();for(let o=0;o<=100;o++){let a=new q(...n.at(t+(e-t)*o/100).place);i.min(a),s.max(a)}let r=.22*s.clone().sub(i).length();for(let o of["x","y","z"]){let l=Math.max(r-(s[o]-i[o]),0)/2+(o==="y"?0:.03*r);i[o]-=l,s[o]+=l}return{low:i,high:s}}function Pf({low:n,high:t},[e,,i]){let[s,r]=e>=0?[n.x,t.x]:[t.x,n.x],[o,a]=i>=0?[n.z,t.z]:[t.z,n.z];return[[s,o],[r,o],[s,a]]}function m1(n,[t,e],i,s,r){let a=1/0;for(let l=0;l<=100;l++){let[c,u,d]=n.at(t+(e-t)*l/100).place;Math.abs(u-i)<=(e-t)/100&&(a=Math.min(a,Math.abs(s([c,d])-s(r))))}return a}function p0(n,t,e,i){let s=Cf(n,t),{low:r,high:o}=s,[a,l,c]=Pf(s,i),u=([M,L])=>M*i[2]-L*i[0],[d,h]=u(l)<=u(c)?[l,c]:[c,l],p=o.clone().sub(r).length(),g=ie("length"),y=Pn(Xt(t[0],"length"),Xt(t[1],"length"),8),m=y.values.map(M=>{let{place:L,high:P}=n.at(kn(M,"length")),C=e+.012*p;return zr(`${Sn(M,y.step)} ${g}`,[L[0]+C*P[0],L[1]+C*P[1],L[2]+C*P[2]],hu,"text",0)}),f=[],x=(M,L)=>{f.push(...M,...L)},b=Pn(Xt(-o.y,"length"),Xt(-r.y,"length"),5),v=M=>Math.min(...b.values.map(L=>m1(n,t,-kn(L,"length"),u,M))),T=v(h)>v(d)+.1*p?h:d,w=b.values.map(M=>{let L=-kn(M,"length"),P=([C,U])=>[C,L,U];return x(P(a),P(h)),x(P(a),P(d)),zr(`TVD ${Sn(M,b.step)} ${g}`,P(T),hu,"muted",T===d?1.06:-.06)});for(let[M,L]of[a,h,d])x([M,r.y,L],[M,o.y,L]);let _=new Gn;return _.setAttribute("position",new fn(f,3)),[new Bs(_,new dr({color:Se("frame"),transparent:!0,opacity:.35})),zr("N",[(r.x+o.x)/2,o.y,r.z-.04*p],hu+2),zr("E",[o.x+.04*p,o.y,(r.z+o.z)/2],hu+2),...w,...m]}var m0={type:"change"},Lf={type:"start"},_0={type:"end"},uu=new Nr,g0=new vi,g1=Math.cos(70*ff.DEG2RAD),In=new q,di=2*Math.PI,Pe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},If=1e-6,du=class extends cl{constructor(t,e=null){super(t,e),this.state=Pe.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:gr.ROTATE,MIDDLE:gr.DOLLY,RIGHT:gr.PAN},this.touches={ONE:_r.ROTATE,TWO:_r.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new bi,this._lastTargetPosition=new q,this._quat=new bi().setFromUnitVectors(t.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Wo,this._sphericalDelta=new Wo,this._scale=1,this._panOffset=new q,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new q,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=x1.bind(this),this._onPointerDown=_1.bind(this),this._onPointerUp=y1.bind(this),this._onContextMenu=E1.bind(this),this._onMouseWheel=S1.bind(this),this._onKeyDown=M1.bind(this),this._onTouchStart=w1.bind(this),this._onTouchMove=T1.bind(this),this._onMouseDown=v1.bind(this),this._onMouseMove=b1.bind(this),this._interceptControlDown=A1.bind(this),this._interceptControlUp=R1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(m0),this.update(),this.state=Pe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;In.copy(e).sub(this.target),In.applyQuaternion(this._quat),this._spherical.setFromVector3(In),this.autoRotate&&this.state===Pe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=di:i>Math.PI&&(i-=di),s<-Math.PI?s+=di:s>Math.PI&&(s-=di),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(In.setFromSpherical(this._spherical),In.applyQuaternion(this._quatInverse),e.copy(this.target).add(In),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=In.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=In.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(uu.origin.copy(this.object.position),uu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(uu.direction))<g1?this.object.lookAt(this.target):(g0.setFromNormalAndCoplanarPoint(this.object.up,this.target),uu.intersectPlane(g0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>If||8*(1-this._lastQuaternion.dot(this.object.quaternion))>If||this._lastTargetPosition.distanceToSquared(this.target)>If?(this.dispatchEvent(m0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?di/60*this.autoRotateSpeed*t:di/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){In.setFromMatrixColumn(e,0),In.multiplyScalar(-t),this._panOffset.add(In)}_panUp(t,e){this.screenSpacePanning===!0?In.setFromMatrixColumn(e,1):(In.setFromMatrixColumn(e,0),In.crossVectors(this.object.up,In)),In.multiplyScalar(t),this._panOffset.add(In)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;In.copy(s).sub(this.target);let r=In.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(di*this._rotateDelta.x/e.clientHeight),this._rotateUp(di*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-di*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(di*this._rotateDelta.x/e.clientHeight),this._rotateUp(di*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function _1(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function x1(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function y1(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(_0),this.state=Pe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function v1(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case gr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pe.DOLLY;break;case gr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pe.ROTATE}break;case gr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pe.PAN}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Lf)}function b1(n){switch(this.state){case Pe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function S1(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pe.NONE||(n.preventDefault(),this.dispatchEvent(Lf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(_0))}function M1(n){this.enabled!==!1&&this._handleKeyDown(n)}function w1(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case _r.ROTATE:if(this.enableRotate===!1){this.state=Pe.NONE;break}this._handleTouchStartRotate(n),this.state=Pe.TOUCH_ROTATE;break;case _r.PAN:if(this.enablePan===!1){this.state=Pe.NONE;break}this._handleTouchStartPan(n),this.state=Pe.TOUCH_PAN;break;default:this.state=Pe.NONE}break;case 2:switch(this.touches.TWO){case _r.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pe.TOUCH_DOLLY_PAN;break;case _r.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pe.TOUCH_DOLLY_ROTATE;break;default:this.state=Pe.NONE}break;default:this.state=Pe.NONE}this.state!==Pe.NONE&&this.dispatchEvent(Lf)}function T1(n){switch(this._trackPointer(n),this.state){case Pe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pe.NONE}}function E1(n){this.enabled!==!1&&n.preventDefault()}function A1(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function R1(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var fu=()=>z("p",{class:"warning"},"This view requires WebGL, which this browser does not provide."),C1=n=>new Ii().setFromArray(n.flat()).getCenter(new q),pu="drag to rotate, right-drag to move, Ctrl + wheel to zoom";function P1(n){if(!(n instanceof An||n instanceof Bs||n instanceof ps))return;n instanceof ps||n.geometry.dispose();let t=n.material;n instanceof ps&&n.material.map?.dispose(),t.dispose()}function mu(n,t,e=0){let i=z("canvas",{class:"space",style:`height:${t}px`,role:"img","aria-label":n}),s;try{s=new ou({canvas:i,antialias:!0,alpha:!0,preserveDrawingBuffer:!0})}catch{return null}let r=new Ya,o=new ii(38,1,1,1e5),a=new du(o,i);a.enableDamping=!1,a.enableZoom=!1;let l=new al(16777215,2.2);r.add(new ll(16777215,1.6),l);let c=z("canvas",{class:"space-paper"}),u=z("div",{class:"space-holder"},i,c),d=[];i.addEventListener("wheel",v=>{if(!v.ctrlKey&&!v.metaKey)return;v.preventDefault();let T=o.position.clone().sub(a.target).multiplyScalar(Math.exp(v.deltaY*.002));o.position.copy(a.target).add(T),g()},{passive:!1}),a.addEventListener("change",g);function h(v){return d.push(v),r.add(v),v}function p(v=d){for(let T of v)r.remove(T),P1(T);d=d.filter(T=>!v.includes(T))}function g(){let v=e*o.position.distanceTo(a.target);l.position.copy(o.position).add(new q(-v,v,0).applyQuaternion(o.quaternion)),l.target.position.copy(a.target),l.target.updateMatrixWorld(),u.dataset.labels=JSON.stringify(m()),s.render(r,o),nn()&&([c.width,c.height]=[i.width,i.height],c.getContext("2d")?.drawImage(i,0,0))}function y(v,T,w=C1(v),_=[.07*(i.clientWidth||1200),.04*t]){let M=i.clientWidth||1200,L=new q(...T).normalize(),P=v.map(H=>new q(...H)),C=Math.tan(o.fov*Math.PI/360),U=Math.max(1-2*_[0]/M,.3),B=Math.max(1-2*_[1]/t,.3),I=w.clone(),k=2*Math.max(...P.map(H=>H.distanceTo(w)),.001);for(let H=0;H<12;H++){o.position.copy(I).addScaledVector(L,k),o.near=k/1e3,o.far=k*1e3,o.updateProjectionMatrix(),o.lookAt(I),o.updateMatrixWorld();let F=new Ii().setFromPoints(P.map(ht=>ht.clone().project(o))),[j,$]=[(F.min.x+F.max.x)/2,(F.min.y+F.max.y)/2],Z=new q().setFromMatrixColumn(o.matrixWorld,0),nt=new q().setFromMatrixColumn(o.matrixWorld,1);I.addScaledVector(Z,j*k*C*(M/t)).addScaledVector(nt,$*k*C),k*=Math.max((F.max.x-F.min.x)/2/U,(F.max.y-F.min.y)/2/B)||1}a.target.copy(I),o.position.copy(I).addScaledVector(L,k),o.near=k/200,o.far=k*20,o.updateProjectionMatrix(),a.update(),g()}function m(){o.updateMatrixWorld();let[v,T]=[i.clientWidth||1200,Math.tan(o.fov*Math.PI/360)],w=[];for(let _ of d){if(!(_ instanceof ps))continue;let[M,L]=_.userData.pixels,P=-_.position.clone().applyMatrix4(o.matrixWorldInverse).z,C=2*T*P/t;_.scale.set(M*C,L*C,1);let U=_.position.clone().project(o),B=(U.x+1)/2*v-_.center.x*M,I=(1-U.y)/2*t-L/2,k={left:B,top:I,right:B+M,bottom:I+L},H=F=>k.left<F.right+4&&F.left<k.right+4&&k.top<F.bottom&&F.top<k.bottom;_.visible=P>0&&k.left>=0&&k.right<=v&&!w.some(H),_.visible&&w.push(k)}return w}function f(){let v=u.clientWidth||1200;s.setPixelRatio(Math.min(devicePixelRatio*(devicePixelRatio<1.5?1.5:1),2.5)),s.setSize(v,t,!1),o.aspect=v/t,o.updateProjectionMatrix()}let x=0,b=new ResizeObserver(()=>{u.clientWidth!==x&&(x=u.clientWidth,f(),g())});return b.observe(u),{holder:u,canvas:i,spans:v=>{let T=new Ii().setFromPoints(v.map(w=>new q(...w).project(o)));return[(T.max.x-T.min.x)/2,(T.max.y-T.min.y)/2]},add:h,has:v=>d.includes(v),remove:p,render:g,lookAt:y,size:f,from:()=>o.position.clone().sub(a.target),end:()=>{b.disconnect(),p(),a.dispose(),s.dispose(),s.forceContextLoss()}}}var Sl=()=>{let n=lo(!1);return t=>n(1-t)};function Zi({radius_m:n}){let[t,e]=[n[0],n.at(-1)],i=n.length>1?(e-t)/(n.length-1)/2:t;return[Math.max(t-i,0),e+i]}var Jo=({depth_m:n})=>n.reduce((t,e)=>e>t?e:t,0);function Df(n,t,e){let[i,s]=Zi(n),r=n.radius_m.length,o=n.angle_rad.length,a=Math.floor((Math.hypot(t,e)-i)/(s-i)*r);if(a<0||a>=r)return NaN;let l=Math.atan2(e,t)/(2*Math.PI),c=Math.min(Math.floor((l-Math.floor(l))*o),o-1);return n.depth_m[a*o+c]}var I1={top:"hanging",middle:"central",bottom:"text-after-edge"},jo=class{fillStyle="#000";strokeStyle="#000";textAlign="left";textBaseline="alphabetic";font="";#i=[];#e="";#t=[];#n=[];constructor(t,e){this.picture=wt("svg",{viewBox:`0 0 ${t} ${e}`,xmlns:"http://www.w3.org/2000/svg","font-family":"system-ui, sans-serif","font-size":11})}#s(t,e,...i){let s=this.#t.join(" ")||null;this.picture.append(wt(t,{...e,transform:s},...i))}save(){this.#n.push([...this.#t])}restore(){this.#t=this.#n.pop()??[]}translate(t,e){this.#t.push(`translate(${t} ${e})`)}rotate(t){this.#t.push(`rotate(${t*180/Math.PI})`)}setLineDash(t){this.#i=t}beginPath(){this.#e=""}moveTo(t,e){this.#e+=`M${t} ${e}`}lineTo(t,e){this.#e+=`L${t} ${e}`}stroke(){this.#s("path",{d:this.#e,fill:"none",stroke:this.strokeStyle,"stroke-dasharray":this.#i.join(" ")||null})}fillRect(t,e,i,s){this.#s("rect",{x:t,y:e,width:i,height:s,fill:this.fillStyle})}strokeRect(t,e,i,s){this.#s("rect",{x:t,y:e,width:i,height:s,fill:"none",stroke:this.strokeStyle})}fillText(t,e,i){let s={center:"middle",right:"end"}[this.textAlign]??"start";this.#s("text",{x:e,y:i,fill:this.fillStyle,"text-anchor":s,"dominant-baseline":I1[this.textBaseline]??"auto"},t)}image(t,e,i,s,r){this.#s("image",{x:e,y:i,width:s,height:r,href:t,preserveAspectRatio:"none"})}file(){let{width:t,height:e}=this.picture.viewBox.baseVal;return this.picture.setAttribute("width",t),this.picture.setAttribute("height",e),`<?xml version="1.0" encoding="UTF-8"?>
${new XMLSerializer().serializeToString(this.picture)}
`}};var fi=44,Nf=34,Li=18,Ml=8,gu=400,L1=270;function x0(n,t){let e=z("canvas",{class:"plan",role:"img","aria-label":"The bottom of the hole from above"}),i=z("p",{class:"readout-line"}," "),s=vn("Bottom of the hole",{svg:()=>l(),csv:()=>$n(...c())}),r=z("div",{class:"plan-holder"},e,i,s),o=gu;function a(){let h=n();if(!h)return;o=nn()?L1:Math.min(Math.max((r.clientWidth||gu)-fi-Ml,150),gu);let p=Math.max(devicePixelRatio,2),[g,y]=[fi+o+Ml,Li+o+Nf];[e.width,e.height]=[g*p,y*p],e.style.width=`${g}px`,e.style.height=`${y}px`;let m=e.getContext("2d");m.scale(p,p),m.font="11px system-ui, sans-serif";let f=1.04*Zi(h)[1];u(m,h,f,Math.round(o*p)),d(m,f)}function l(){let h=n(),p=new jo(fi+o+Ml,Li+o+Nf);p.fillStyle=Se("paper"),p.fillRect(0,0,fi+o+Ml,Li+o+Nf);let g=z("canvas",{width:2*o,height:2*o}),y=g.getContext("2d");y.scale(2,2),y.translate(-fi,-Li);let m=1.04*Zi(h)[1];return u(y,h,m,2*o),p.image(g.toDataURL(),fi,Li,o,o),d(p,m),p.file()}function c(){let{radius_m:h,angle_rad:p,depth_m:g}=n(),y=Array.from(h).flatMap((f,x)=>Array.from(p,(b,v)=>[Xt(f,"diameter"),Xt(b,"angle"),Xt(g[x*p.length+v],"diameter")])),m=ie("diameter");return[[`radius, ${m}`,`angle, ${ie("angle")}`,`depth, ${m}`],y]}function u(h,p,g,y){let m=Sl(),f=Jo(p)||1,x=new ImageData(y,y),b=T=>(2*((T+.5)/y)-1)*g;for(let T=0;T<y;T++)for(let w=0;w<y;w++){let _=Df(p,-b(T),b(w));Number.isFinite(_)&&x.data.set([...m(_/f),255],4*(T*y+w))}let v=new OffscreenCanvas(y,y);v.getContext("2d").putImageData(x,0,0),h.drawImage(v,fi,Li,o,o)}function d(h,p){let g=Xt(p,"diameter"),{values:y,step:m}=Pn(-g,g,6),f=b=>.5+kn(b,"diameter")/(2*p);h.fillStyle=Se("muted"),h.textAlign="center",h.textBaseline="top";for(let b of y)h.fillText(Sn(b,m),fi+f(b)*o,Li+o+5);let x=t?"to the right":"across";h.fillText(`${x}, ${ie("diameter")}`,fi+o/2,Li+o+19),h.textAlign="right",h.textBaseline="middle";for(let b of y)h.fillText(Sn(b,m),fi-6,Li+(1-f(b))*o);t&&(h.textAlign="center",h.textBaseline="bottom",h.fillText("high side ▴",fi+o/2,Li-4)),h.strokeStyle=Se("frame"),h.strokeRect(fi,Li,o,o)}return e.addEventListener("pointermove",h=>{let p=n();if(!p)return;let g=e.getBoundingClientRect(),y=1.04*Zi(p)[1],m=T=>(2*(T/o)-1)*y,f=m(h.clientX-g.left-fi),x=-m(h.clientY-g.top-Li),b=Df(p,x,f),v=(Math.atan2(f,x)+2*Math.PI)%(2*Math.PI);i.textContent=Number.isFinite(b)?`radius ${Te(Math.hypot(x,f),"diameter",3)}, ${Te(v,"angle",3)}: ${Te(b,"diameter",3)} deep`:" "}),e.addEventListener("pointerleave",()=>i.textContent=" "),new ResizeObserver(()=>{let h=Math.min(Math.max(r.clientWidth-fi-Ml,150),gu);!nn()&&r.clientWidth&&h!==o&&a()}).observe(r),{element:r,draw:a}}var D1=460,y0=[-.35,.95,.9];function xu(n,t){let e=mu("The bottom of the hole in space",D1,.9),i=x0(n,t),s=z("div",{class:"colour-key"}),r=1,o=null,a=z("output",{}),l=z("input",{type:"range",min:0,max:1.3,step:.01,"aria-label":"Exaggeration of depth",oninput:()=>{r=10**Number(l.value),d()}}),c=[["At an angle",y0],["From above",[0,1,.001]],["From the side",[0,.12,1]]].map(([m,f])=>z("button",{type:"button",onclick:()=>h(f)},m)),u=z("div",{class:"tools noprint"},z("label",{},"Depth × ",l,a),c,z("span",{class:"hint"},pu));function d(){let m=n();if(!m)return;let[,f]=Zi(m),x=Jo(m),b=ie("diameter");s.replaceChildren(...cu(`Depth below the rim, ${b}`,"diameter",[0,x],Sl())),e&&(e.remove(),e.add(U1(m,x,r)),e.add(O1(m,r)),F1(f,t?b0(m)*r:null).forEach(e.add),a.textContent=` ${dn(r,2)}`,e.render())}function h(m){let f=n();if(!f||!e)return;let[,x]=Zi(f),b=Jo(f)*r,v=f.depth_m.reduce((M,L)=>L<M?L:M,0)*r,w=Array.from({length:24},(M,L)=>L*Math.PI/12).flatMap(M=>[v,b].map(L=>_u(x,M,L))),_=[-1,1].map(M=>[.7*M*x,0,1.25*x]);t&&_.push([0,.2*x-v,-x]),e.lookAt([...w,..._],m,new q(0,-(v+b)/2,.22*x))}function p(){let m=n();if(o=m,!m)return;let f=.3*Zi(m)[1]/(Jo(m)||1);r=[10,5,2].find(x=>x<=f)??1,l.value=Math.log10(r),d(),h(y0)}function g(){i.draw(),e&&e.size(),n()===o?d():p()}me("units",()=>{i.draw(),d()}),me("operation",()=>{i.draw(),p()});let y=e?[u,z("div",{class:"bottom"},e.holder,i.element)]:[fu(),i.element];return{element:z("div",{},y,s),redraw:g}}var _u=(n,t,e)=>[n*Math.sin(t),-e,-n*Math.cos(t)];function N1(n){let[t,e]=Zi(n),i=n.angle_rad.length,s=n.radius_m.length-1,r=u=>n.depth_m.subarray(u*i,(u+1)*i),o=Array.from(n.radius_m,(u,d)=>[u,r(d)]),a=r(0),l=a.filter(Number.isFinite),c=l.reduce((u,d)=>u+d,0)/l.length;return o.unshift(t>0?[t,a]:[0,a.map(()=>c)]),o.push([e,r(s)]),o}function U1(n,t,e){let i=N1(n),s=n.angle_rad.length,r=Sl(),o=new de,[a,l,c]=[[],[],[]];for(let[h,p]of i)p.forEach((g,y)=>{let m=Number.isFinite(g)?g:0;a.push(..._u(h,n.angle_rad[y],m*e));let[f,x,b]=r(m/(t||1)).map(v=>v/255);o.setRGB(f,x,b,"srgb"),l.push(o.r,o.g,o.b)});let u=(h,p)=>Number.isFinite(i[h][1][p]);for(let h=0;h+1<i.length;h++)for(let p=0;p<s;p++){let g=(p+1)%s;if(![u(h,p),u(h,g),u(h+1,p),u(h+1,g)].every(Boolean))continue;let[y,m]=[h*s+p,h*s+g];c.push(y,m,y+s,m,m+s,y+s)}let d=new Gn;return d.setAttribute("position",new fn(a,3)),d.setAttribute("color",new fn(l,3)),d.setIndex(c),d.computeVertexNormals(),new An(d,new gs({vertexColors:!0,side:hi}))}var v0=n=>n.depth_m.subarray((n.radius_m.length-1)*n.angle_rad.length),b0=n=>Math.min(0,...v0(n).filter(Number.isFinite));function O1(n,t){let[,e]=Zi(n),i=n.angle_rad.length,s=v0(n),r=b0(n)*t-.02*e,[o,a]=[[],[]];s.forEach((c,u)=>{let d=n.angle_rad[u];o.push(..._u(e,d,r)),o.push(..._u(e,d,(Number.isFinite(c)?c:0)*t));let[h,p]=[2*u,2*((u+1)%i)];a.push(h,h+1,p,p,h+1,p+1)});let l=new Gn;return l.setAttribute("position",new fn(o,3)),l.setIndex(a),l.computeVertexNormals(),new An(l,new gs({color:Se("rock"),side:_s}))}function F1(n,t){let{values:e,step:i}=Pn(0,Xt(1.4*n,"diameter"),3),s=kn(e.at(-1),"diameter"),r=1.12*n,[o,a]=[-s/2,s/2],l=.025*n,c=[o,0,r,a,0,r];for(let p of[o,a])c.push(p,0,r-l,p,0,r+l);let u=new Gn;u.setAttribute("position",new fn(c,3));let d=.075*n,h=`${Sn(e.at(-1),i)} ${ie("diameter")}`;return[new Bs(u,new dr({color:Se("text")})),zr(h,[0,0,r+1.1*d],18),...t===null?[]:[zr("high side",[0,1.2*d-t,-n],18)]]}var yu=(n,t,...e)=>z("section",{id:n},z("h2",{},t),e);function S0(n,t,e){let{element:i,file:s,there:r}=ic(e,"No point was finished.");return yu(n,[t,vn(t,{svg:r()?s:null})],i)}function M0(n){let{bottoms:t}=n,e=t.length-1,i=t.length?xu(()=>t[e].bottom,!1):null,s=z("div",{class:"tools noprint"}),r=z("p",{class:"note"}),o=({weight_N:h,rotary_rad_per_s:p})=>`${Te(h,"force",3)} at ${Te(p,"rotary speed",3)}`,a=()=>{let h=t.map((p,g)=>[String(g),o(p)]);s.replaceChildren(Wl("Point: ",h,String(e),p=>{e=Number(p),l(),i.redraw()})),l()},l=()=>r.textContent=`After ${o(t[e])}.`,[c,...u]=n.page_tables,d=document.getElementById("page");d.append(go(n.title,fo(n),()=>i?.redraw()),...n.message?[z("p",{class:"warning"},n.message)]:[],S0("drill-off","Drill-off","drill-off"),S0("energy","Specific energy","specific-energy")),i&&(a(),me("units",a),d.append(yu("bottom","Bottom of the hole",s,i.element,r))),d.append(yu("points",["Points",uo(c)],hs(c)),...u.length?[yu("inputs","Inputs, defaults included",u.map(hs))]:[],z("footer",{},z("p",{},`Made by ${n.program}. The tables beside this file hold every digit.`),mo())),d.querySelector("header").after(po([...d.querySelectorAll("section:has(h2)")]).element),i?.redraw()}function w0(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function B1(n){if(n.f32!==void 0)return new Float32Array(w0(n.f32));let[t,e,i]=n.i16,s=new Int16Array(w0(t)),r=new Float32Array(s.length);for(let o=0;o<s.length;o++)r[o]=s[o]===-32768?NaN:e+i*s[o];return r}function Uf(n){return Array.isArray(n)?n.map(Uf):n===null||typeof n!="object"?n:typeof n.f32=="string"||Array.isArray(n.i16)?B1(n):Object.fromEntries(Object.entries(n).map(([t,e])=>[t,Uf(e)]))}function T0(){return Uf(JSON.parse(document.getElementById("report").textContent))}var k1="uplot",z1="u-hz",V1="u-vt",G1="u-title",H1="u-wrap",W1="u-under",X1="u-over",$1="u-axis",Hr="u-off",q1="u-select",Y1="u-cursor-x",Z1="u-cursor-y",K1="u-cursor-pt",J1="u-legend",j1="u-live",Q1="u-inline",tT="u-series",eT="u-marker",E0="u-label",nT="u-value",Tl="width",El="height";var A0="bottom",Qo="left",Of="right",Qf="#000",R0=Qf+"0",Ff="mousemove",C0="mousedown",Bf="mouseup",P0="mouseenter",I0="mouseleave",L0="dblclick",iT="resize",sT="scroll",D0="change",wu="dppxchange",tp="--",oa=typeof window<"u",Hf=oa?document:null,ea=oa?window:null,rT=oa?navigator:null,Ie,vu;function Wf(){let n=devicePixelRatio;Ie!=n&&(Ie=n,vu&&$f(D0,vu,Wf),vu=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),Wr(D0,vu,Wf),ea.dispatchEvent(new CustomEvent(wu)))}function wi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Xf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function je(n,t,e){n.style[t]=e+"px"}function Ki(n,t,e,i){let s=Hf.createElement(n);return t!=null&&wi(s,t),e?.insertBefore(s,i),s}function Di(n,t){return Ki("div",n,t)}var N0=new WeakMap;function bs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=N0.get(n);r!=o&&(n.style.transform=r,N0.set(n,r),t<0||e<0||t>i||e>s?wi(n,Hr):Xf(n,Hr))}var U0=new WeakMap;function O0(n,t,e){let i=t+e,s=U0.get(n);i!=s&&(U0.set(n,i),n.style.background=t,n.style.borderColor=e)}var F0=new WeakMap;function B0(n,t,e,i){let s=t+""+e,r=F0.get(n);s!=r&&(F0.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var ep={passive:!0},oT={...ep,capture:!0};function Wr(n,t,e,i){t.addEventListener(n,e,i?oT:ep)}function $f(n,t,e,i){t.removeEventListener(n,e,ep)}oa&&Wf();function Ji(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Ti((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function d_(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var f_=n=>n!=null,p_=n=>n!=null&&n>0,Au=d_(f_),aT=d_(p_);function lT(n,t,e,i=0,s=!1){let r=s?aT:Au,o=s?p_:f_;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??ze,l??-ze]}function Ru(n,t,e,i){let s=V0(n),r=V0(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Hs:m_,a=s==1?Ti:Ni,l=r==1?Ni:Ti,c=a(o(Dn(n))),u=l(o(Dn(t))),d=na(e,c),h=na(e,u);return e==10&&(c<0&&(d=Ve(d,-c)),u<0&&(h=Ve(h,-u))),i||e==2?(n=d*s,t=h*r):(n=y_(n,d),t=Cu(t,h)),[n,t]}function np(n,t,e,i){let s=Ru(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var ip=.1,k0={mode:3,pad:ip},Rl={pad:0,soft:null,mode:0},cT={min:Rl,max:Rl};function Tu(n,t,e,i){return Pu(e)?z0(n,t,e):(Rl.pad=e,Rl.soft=i?0:null,Rl.mode=i?3:0,z0(n,t,cT))}function Re(n,t){return n??t}function hT(n,t,e){for(t=Re(t,0),e=Re(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function z0(n,t,e){let i=e.min,s=e.max,r=Re(i.pad,0),o=Re(s.pad,0),a=Re(i.hard,-ze),l=Re(s.hard,ze),c=Re(i.soft,ze),u=Re(s.soft,-ze),d=Re(i.mode,0),h=Re(s.mode,0),p=t-n,g=Hs(p),y=li(Dn(n),Dn(t)),m=Hs(y),f=Dn(m-g);(p<1e-24||f>10)&&(p=0,(n==0||t==0)&&(p=1e-24,d==2&&c!=ze&&(r=0),h==2&&u!=-ze&&(o=0)));let x=p||y||1e3,b=Hs(x),v=na(10,Ti(b)),T=x*(p==0?n==0?.1:1:r),w=Ve(y_(n-T,v/10),24),_=n>=c&&(d==1||d==3&&w<=c||d==2&&w>=c)?c:ze,M=li(a,w<_&&n>=_?_:ji(_,w)),L=x*(p==0?t==0?.1:1:o),P=Ve(Cu(t+L,v/10),24),C=t<=u&&(h==1||h==3&&P>=u||h==2&&P<=u)?u:-ze,U=ji(l,P>C&&t<=C?C:li(C,P));return M==U&&M==0&&(U=100),[M,U]}var uT=new Intl.NumberFormat(oa?rT.language:"en-US"),sp=n=>uT.format(n),Ei=Math,Mu=Ei.PI,Dn=Ei.abs,Ti=Ei.floor,Ln=Ei.round,Ni=Ei.ceil,ji=Ei.min,li=Ei.max,na=Ei.pow,V0=Ei.sign,Hs=Ei.log10,m_=Ei.log2,dT=(n,t=1)=>Ei.sinh(n)*t,kf=(n,t=1)=>Ei.asinh(n/t),ze=1/0;function G0(n){return(Hs((n^n>>31)-(n>>31))|0)+1}function qf(n,t,e){return ji(li(n,t),e)}function g_(n){return typeof n=="function"}function we(n){return g_(n)?n:()=>n}var fT=()=>{},__=n=>n,x_=(n,t)=>t,pT=n=>null,H0=n=>!0,W0=(n,t)=>n==t,mT=/\.\d*?(?=9{6,}|0{6,})/gm,Xr=n=>{if(b_(n)||br.has(n))return n;let t=`${n}`,e=t.match(mT);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Xr(s)}e${r}`}return Ve(n,i)};function Vr(n,t){return Xr(Ve(Xr(n/t))*t)}function Cu(n,t){return Xr(Ni(Xr(n/t))*t)}function y_(n,t){return Xr(Ti(Xr(n/t))*t)}function Ve(n,t=0){if(b_(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Ln(i)/e}var br=new Map;function v_(n){return((""+n).split(".")[1]||"").length}function Pl(n,t,e,i){let s=[],r=i.map(v_);for(let o=t;o<e;o++){let a=Dn(o),l=Ve(na(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ve(u,d);s.push(h),br.set(h,d)}}return s}var Cl={},rp=[],ia=[null,null],vr=Array.isArray,b_=Number.isInteger,gT=n=>n===void 0;function X0(n){return typeof n=="string"}function Pu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function _T(n){return n!=null&&typeof n=="object"}var xT=Object.getPrototypeOf(Uint8Array),S_="__proto__";function sa(n,t=Pu){let e;if(vr(n)){let i=n.find(s=>s!=null);if(vr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=sa(n[s],t)}else e=n.slice()}else if(n instanceof xT)e=n.slice();else if(t(n)){e={};for(let i in n)i!=S_&&(e[i]=sa(n[i],t))}else e=n;return e}function Mn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=S_&&(Pu(n[s])?Mn(n[s],sa(i[s])):n[s]=sa(i[s]))}return n}var yT=0,vT=1,bT=2;function ST(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function MT(n,t){if(ET(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return AT(o[0])||(o=TT(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=t?t[o][c]:vT,p=[];for(let g=0;g<u.length;g++){let y=u[g],m=r.get(l[g]);y===null?h!=yT&&(d[m]=y,h==bT&&p.push(m)):d[m]=y}ST(d,p,s),i.push(d)}}return i}var wT=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function TT(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function ET(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function AT(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=li(1,Ti((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var M_=["January","February","March","April","May","June","July","August","September","October","November","December"],w_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function T_(n){return n.slice(0,3)}var RT=w_.map(T_),CT=M_.map(T_),PT={MMMM:M_,MMM:CT,WWWW:w_,WWW:RT};function wl(n){return(n<10?"0":"")+n}function IT(n){return(n<10?"00":n<100?"0":"")+n}var LT={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>wl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>wl(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>wl(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>wl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>wl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>IT(n.getMilliseconds())};function op(n,t){t=t||PT;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?LT[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var DT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function NT(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==DT?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var E_=n=>n%1==0,Eu=[1,2,2.5,5],UT=Pl(10,-32,0,Eu),A_=Pl(10,0,32,Eu),OT=A_.filter(E_),Gr=UT.concat(A_),ap=`
`,R_="{YYYY}",$0=ap+R_,C_="{M}/{D}",Al=ap+C_,bu=Al+"/{YY}",P_="{aa}",FT="{h}:{mm}",ta=FT+P_,q0=ap+ta,Y0=":{ss}",De=null;function I_(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Pl(10,0,3,Eu).filter(E_):Pl(10,-3,0,Eu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,R_,De,De,De,De,De,De,1],[s*28,"{MMM}",$0,De,De,De,De,De,1],[s,C_,$0,De,De,De,De,De,1],[i,"{h}"+P_,bu,De,Al,De,De,De,1],[e,ta,bu,De,Al,De,De,De,1],[t,Y0,bu+" "+ta,De,Al+" "+ta,De,q0,De,1],[n,Y0+".{fff}",bu+" "+ta,De,Al+" "+ta,De,q0,De,1]];function u(d){return(h,p,g,y,m,f)=>{let x=[],b=m>=o,v=m>=r&&m<o,T=d(g),w=Ve(T*n,3),_=zf(T.getFullYear(),b?0:T.getMonth(),v||b?1:T.getDate()),M=Ve(_*n,3);if(v||b){let L=v?m/r:0,P=b?m/o:0,C=w==M?w:Ve(zf(_.getFullYear()+P,_.getMonth()+L,1)*n,3),U=new Date(Ln(C/n)),B=U.getFullYear(),I=U.getMonth();for(let k=0;C<=y;k++){let H=zf(B+P*k,I+L*k,1),F=H-d(Ve(H*n,3));C=Ve((+H+F)*n,3),C<=y&&x.push(C)}}else{let L=m>=s?s:m,P=Ti(g)-Ti(w),C=M+P+Cu(w-M,L);x.push(C);let U=d(C),B=U.getHours()+U.getMinutes()/e+U.getSeconds()/i,I=m/i,k=h.axes[p]._space,H=f/k;for(;C=Ve(C+m,n==1?0:3),!(C>y);)if(I>1){let F=Ti(Ve(B+I,6))%24,Z=d(C).getHours()-F;Z>1&&(Z=-1),C-=Z*i,B=(B+I)%24;let nt=x[x.length-1];Ve((C-nt)/m,3)*H>=.7&&x.push(C)}else x.push(C)}return x}}return[l,c,u]}var[BT,kT,zT]=I_(1),[VT,GT,HT]=I_(.001);Pl(2,-53,53,[1]);function Z0(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function K0(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,d,h,p;return i.map(g=>{let y=n(g),m=y.getFullYear(),f=y.getMonth(),x=y.getDate(),b=y.getHours(),v=y.getMinutes(),T=y.getSeconds(),w=m!=l&&a[2]||f!=c&&a[3]||x!=u&&a[4]||b!=d&&a[5]||v!=h&&a[6]||T!=p&&a[7]||a[1];return l=m,c=f,u=x,d=b,h=v,p=T,w(y)})}}function WT(n,t){let e=op(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function zf(n,t,e){return new Date(n,t,e)}function J0(n,t){return t(n)}var XT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function j0(n,t){return(e,i,s,r)=>r==null?tp:t(n(i))}function $T(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function qT(n,t){return n.series[t].fill(n,t)}var YT={show:!0,live:!0,isolate:!1,mount:fT,markers:{show:!0,width:2,stroke:$T,fill:qT,dash:"solid"},idx:null,idxs:null,values:[]};function ZT(n,t){let e=n.cursor.points,i=Di(),s=e.size(n,t);je(i,Tl,s),je(i,El,s);let r=s/-2;je(i,"marginLeft",r),je(i,"marginTop",r);let o=e.width(n,t,s);return o&&je(i,"borderWidth",o),i}function KT(n,t){let e=n.series[t].points;return e._fill||e._stroke}function JT(n,t){let e=n.series[t].points;return e._stroke||e._fill}function jT(n,t){return n.series[t].points.size}var Vf=[0,0];function QT(n,t,e){return Vf[0]=t,Vf[1]=e,Vf}function Su(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Gf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var tE={show:!0,x:!0,y:!0,lock:!1,move:QT,points:{one:!1,show:ZT,size:jT,width:0,stroke:JT,fill:KT},bind:{mousedown:Su,mouseup:Su,click:Su,dblclick:Su,mousemove:Gf,mouseleave:Gf,mouseenter:Gf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},L_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},lp=Mn({},L_,{filter:x_}),D_=Mn({},lp,{size:10}),N_=Mn({},L_,{show:!1}),cp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',U_="bold "+cp,O_=1.5,Q0={show:!0,scale:"x",stroke:Qf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:U_,side:2,grid:lp,ticks:D_,border:N_,font:cp,lineGap:O_,rotate:0},eE="Value",nE="Time",t_={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function iE(n,t,e,i,s){return t.map(r=>r==null?"":sp(r))}function sE(n,t,e,i,s,r,o){let a=[],l=br.get(s)||0;e=o?e:Ve(Cu(e,s),l);for(let c=e;c<=i;c=Ve(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Yf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Hs:m_,u=Ti(c(e));s=na(l,u),l==10&&(s=Gr[Ji(s,Gr)]);let d=e,h=s*l;l==10&&(h=Gr[Ji(h,Gr)]);do a.push(d),d=d+s,l==10&&!br.has(d)&&(d=Ve(d,br.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Gr[Ji(h,Gr)]));while(d<=i);return a}function rE(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Yf(n,t,li(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Yf(n,t,li(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var F_=/./,oE=/[12357]/,aE=/[125]/,e_=/1/,Zf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function lE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?F_:l(7,o)-u>=c?oE:l(5,o)-u>=c?aE:e_;if(d==e_){let h=Dn(l(1,o)-u);if(h<c)return Zf(t.slice().reverse(),a.distr,d,Ni(c/h)).reverse()}return Zf(t,a.distr,d,1)}function cE(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Dn(l(1,o)-l(2,o));return c<a?Zf(t.slice().reverse(),3,F_,Ni(a/c)).reverse():t}function hE(n,t,e,i){return i==null?tp:t==null?"":sp(t)}var n_={show:!0,scale:"y",stroke:Qf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:U_,side:3,grid:lp,ticks:D_,border:N_,font:cp,lineGap:O_,rotate:0};function uE(n,t){let e=3+(n||1)*2;return Ve(e*t,3)}function dE(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Dn(o-r),l=n.series[t],c=a/(l.points.space*Ie);return i[1]-i[0]<=c}var i_={scale:null,auto:!0,sorted:0,min:ze,max:-ze},B_=(n,t,e,i,s)=>s,s_={show:!0,auto:!0,sorted:0,gaps:B_,alpha:1,facets:[Mn({},i_,{scale:"x"}),Mn({},i_,{scale:"y"})]},r_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:B_,alpha:1,points:{show:dE,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function fE(n,t,e,i,s){return e/10}var k_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},pE=Mn({},k_,{time:!1,ori:1}),o_={};function z_(n,t){let e=o_[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(o_[n]=e)),e}var ra=1,Kf=2;function $r(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,p=a.top,g=a.width,y=a.height,m=n.valToPosH,f=n.valToPosV;return u.ori==0?e(s,l,c,u,d,m,f,h,p,g,y,Lu,aa,Nu,G_,W_):e(s,l,c,u,d,f,m,p,h,y,g,Du,la,dp,H_,X_)}function hp(n,t){let e=0,i=0,s=Re(n.bands,rp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function mE(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ws(n,t,e,i,s,r){return $r(n,t,(o,a,l,c,u,d,h,p,g,y,m)=>{let f=o.pxRound,x=c.dir*(c.ori==0?1:-1),b=c.ori==0?aa:la,v,T;x==1?(v=e,T=i):(v=i,T=e);let w=f(d(a[v],c,y,p)),_=f(h(l[v],u,m,g)),M=f(d(a[T],c,y,p)),L=f(h(r==1?u.max:u.min,u,m,g)),P=new Path2D(s);return b(P,M,L),b(P,w,L),b(P,w,_),P})}function Iu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Nu:dp,l=e;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let p=h[0]-l;p>0&&a(o,l,i,p,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function gE(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function up(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let p=r(n[d]),g=h==d?p:r(n[h]),y=d-s;p=o<=0&&y>=0&&y<l?r(n[y]):p;let f=h+s;g=o>=0&&f>=0&&f<l?r(n[f]):g,g>=p&&a.push([p,g])}return a}function a_(n){return n==0?__:n==1?Ln:t=>Vr(t,n)}function V_(n){let t=n==0?Lu:Du,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ji(c,a/2,l/2),u=ji(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Lu=(n,t,e)=>{n.moveTo(t,e)},Du=(n,t,e)=>{n.moveTo(e,t)},aa=(n,t,e)=>{n.lineTo(t,e)},la=(n,t,e)=>{n.lineTo(e,t)},Nu=V_(0),dp=V_(1),G_=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},H_=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},W_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},X_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function $_(n){return(t,e,i,s,r)=>$r(t,e,(o,a,l,c,u,d,h,p,g,y,m)=>{let{pxRound:f,points:x}=o,b,v;c.ori==0?(b=Lu,v=G_):(b=Du,v=H_);let T=Ve(x.width*Ie,3),w=(x.size-x.width)/2*Ie,_=Ve(w*2,3),M=new Path2D,L=new Path2D,{left:P,top:C,width:U,height:B}=t.bbox;Nu(L,P-_,C-_,U+_*2,B+_*2);let I=k=>{if(l[k]!=null){let H=f(d(a[k],c,y,p)),F=f(h(l[k],u,m,g));b(M,H+w,F),v(M,H,F,w,0,Mu*2)}};if(r)r.forEach(I);else for(let k=i;k<=s;k++)I(k);return{stroke:T>0?M:null,fill:M,clip:L,flags:ra|Kf}})}function q_(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var _E=q_(aa),xE=q_(la);function Y_(n){let t=Re(n?.alignGaps,0);return(e,i,s,r)=>$r(e,i,(o,a,l,c,u,d,h,p,g,y,m)=>{[s,r]=Au(l,s,r);let f=o.pxRound,x=B=>f(d(B,c,y,p)),b=B=>f(h(B,u,m,g)),v,T;c.ori==0?(v=aa,T=_E):(v=la,T=xE);let w=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ra},M=_.stroke,L=!1;if(r-s>=y*4){let B=ct=>e.posToVal(ct,c.key,!0),I=null,k=null,H,F,j,$=x(a[w==1?s:r]),Z=x(a[s]),nt=x(a[r]),ht=B(w==1?Z+1:nt-1);for(let ct=w==1?s:r;ct>=s&&ct<=r;ct+=w){let tt=a[ct],_t=(w==1?tt<ht:tt>ht)?$:x(tt),ft=l[ct];_t==$?ft!=null?(F=ft,I==null?(v(M,_t,b(F)),H=I=k=F):F<I?I=F:F>k&&(k=F)):ft===null&&(L=!0):(I!=null&&T(M,$,b(I),b(k),b(H),b(F)),ft!=null?(F=ft,v(M,_t,b(F)),I=k=H=F):(I=k=null,ft===null&&(L=!0)),$=_t,ht=B($+w))}I!=null&&I!=k&&j!=$&&T(M,$,b(I),b(k),b(H),b(F))}else for(let B=w==1?s:r;B>=s&&B<=r;B+=w){let I=l[B];I===null?L=!0:I!=null&&v(M,x(a[B]),b(I))}let[C,U]=hp(e,i);if(o.fill!=null||C!=0){let B=_.fill=new Path2D(M),I=o.fillTo(e,i,o.min,o.max,C),k=b(I),H=x(a[s]),F=x(a[r]);w==-1&&([F,H]=[H,F]),v(B,F,k),v(B,H,k)}if(!o.spanGaps){let B=[];L&&B.push(...up(a,l,s,r,w,x,t)),_.gaps=B=o.gaps(e,i,s,r,B),_.clip=Iu(B,c.ori,p,g,y,m)}return U!=0&&(_.band=U==2?[Ws(e,i,s,r,M,-1),Ws(e,i,s,r,M,1)]:Ws(e,i,s,r,M,U)),_})}function yE(n){let t=Re(n.align,1),e=Re(n.ascDesc,!1),i=Re(n.alignGaps,0),s=Re(n.extend,!1);return(r,o,a,l)=>$r(r,o,(c,u,d,h,p,g,y,m,f,x,b)=>{[a,l]=Au(d,a,l);let v=c.pxRound,{left:T,width:w}=r.bbox,_=Z=>v(g(Z,h,x,m)),M=Z=>v(y(Z,p,b,f)),L=h.ori==0?aa:la,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ra},C=P.stroke,U=h.dir*(h.ori==0?1:-1),B=M(d[U==1?a:l]),I=_(u[U==1?a:l]),k=I,H=I;s&&t==-1&&(H=T,L(C,H,B)),L(C,I,B);for(let Z=U==1?a:l;Z>=a&&Z<=l;Z+=U){let nt=d[Z];if(nt==null)continue;let ht=_(u[Z]),ct=M(nt);t==1?L(C,ht,B):L(C,k,ct),L(C,ht,ct),B=ct,k=ht}let F=k;s&&t==1&&(F=T+w,L(C,F,B));let[j,$]=hp(r,o);if(c.fill!=null||j!=0){let Z=P.fill=new Path2D(C),nt=c.fillTo(r,o,c.min,c.max,j),ht=M(nt);L(Z,F,ht),L(Z,H,ht)}if(!c.spanGaps){let Z=[];Z.push(...up(u,d,a,l,U,_,i));let nt=c.width*Ie/2,ht=e||t==1?nt:-nt,ct=e||t==-1?-nt:nt;Z.forEach(tt=>{tt[0]+=ht,tt[1]+=ct}),P.gaps=Z=c.gaps(r,o,a,l,Z),P.clip=Iu(Z,h.ori,m,f,x,b)}return $!=0&&(P.band=$==2?[Ws(r,o,a,l,C,-1),Ws(r,o,a,l,C,1)]:Ws(r,o,a,l,C,$)),P})}function l_(n,t,e,i,s,r,o=ze){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Dn(n[l]-n[a]);u<c&&(c=u,o=Dn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function vE(n){n=n||Cl;let t=Re(n.size,[.6,ze,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=we(s),o=1-t[0],a=Re(t[1],ze),l=Re(t[2],1),c=Re(n.disp,Cl),u=Re(n.each,p=>{}),{fill:d,stroke:h}=c;return(p,g,y,m)=>$r(p,g,(f,x,b,v,T,w,_,M,L,P,C)=>{let U=f.pxRound,B=e,I=i*Ie,k=a*Ie,H=l*Ie,F,j;v.ori==0?[F,j]=r(p,g):[j,F]=r(p,g);let $=v.dir*(v.ori==0?1:-1),Z=v.ori==0?Nu:dp,nt=v.ori==0?u:(Pt,jt,he,Tt,ke,Wt,Kt)=>{u(Pt,jt,he,ke,Tt,Kt,Wt)},ht=Re(p.bands,rp).find(Pt=>Pt.series[0]==g),ct=ht!=null?ht.dir:0,tt=f.fillTo(p,g,f.min,f.max,ct),mt=U(_(tt,T,C,L)),_t,ft,xt,Gt=P,ae=U(f.width*Ie),Ht=!1,qt=null,te=null,re=null,Ge=null;d!=null&&(ae==0||h!=null)&&(Ht=!0,qt=d.values(p,g,y,m),te=new Map,new Set(qt).forEach(Pt=>{Pt!=null&&te.set(Pt,new Path2D)}),ae>0&&(re=h.values(p,g,y,m),Ge=new Map,new Set(re).forEach(Pt=>{Pt!=null&&Ge.set(Pt,new Path2D)})));let{x0:He,size:pn}=c;if(He!=null&&pn!=null){B=1,x=He.values(p,g,y,m),He.unit==2&&(x=x.map(he=>p.posToVal(M+he*P,v.key,!0)));let Pt=pn.values(p,g,y,m);pn.unit==2?ft=Pt[0]*P:ft=w(Pt[0],v,P,M)-w(0,v,P,M),Gt=l_(x,b,w,v,P,M,Gt),xt=Gt-ft+I}else Gt=l_(x,b,w,v,P,M,Gt),xt=Gt*o+I,ft=Gt-xt;xt<1&&(xt=0),ae>=ft/2&&(ae=0),xt<5&&(U=__);let Fe=xt>0,Nn=Gt-xt-(Fe?ae:0);ft=U(qf(Nn,H,k)),_t=(B==0?ft/2:B==$?0:ft)-B*$*((B==0?I/2:0)+(Fe?ae/2:0));let Ee={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},wn=Ht?null:new Path2D,sn=null;if(ht!=null)sn=p.data[ht.series[1]];else{let{y0:Pt,y1:jt}=c;Pt!=null&&jt!=null&&(b=jt.values(p,g,y,m),sn=Pt.values(p,g,y,m))}let mn=F*ft,G=j*ft;for(let Pt=$==1?y:m;Pt>=y&&Pt<=m;Pt+=$){let jt=b[Pt];if(jt==null)continue;if(sn!=null){let Y=sn[Pt]??0;if(jt-Y==0)continue;mt=_(Y,T,C,L)}let he=v.distr!=2||c!=null?x[Pt]:Pt,Tt=w(he,v,P,M),ke=_(Re(jt,tt),T,C,L),Wt=U(Tt-_t),Kt=U(li(ke,mt)),D=U(ji(ke,mt)),E=Kt-D;if(jt!=null){let Y=jt<0?G:mn,dt=jt<0?mn:G;Ht?(ae>0&&re[Pt]!=null&&Z(Ge.get(re[Pt]),Wt,D+Ti(ae/2),ft,li(0,E-ae),Y,dt),qt[Pt]!=null&&Z(te.get(qt[Pt]),Wt,D+Ti(ae/2),ft,li(0,E-ae),Y,dt)):Z(wn,Wt,D+Ti(ae/2),ft,li(0,E-ae),Y,dt),nt(p,g,Pt,Wt-ae/2,D,ft+ae,E)}}return ae>0?Ee.stroke=Ht?Ge:wn:Ht||(Ee._fill=f.width==0?f._fill:f._stroke??f._fill,Ee.width=0),Ee.fill=Ht?te:wn,Ee})}function bE(n,t){let e=Re(t?.alignGaps,0);return(i,s,r,o)=>$r(i,s,(a,l,c,u,d,h,p,g,y,m,f)=>{[r,o]=Au(c,r,o);let x=a.pxRound,b=F=>x(h(F,u,m,g)),v=F=>x(p(F,d,f,y)),T,w,_;u.ori==0?(T=Lu,_=aa,w=W_):(T=Du,_=la,w=X_);let M=u.dir*(u.ori==0?1:-1),L=b(l[M==1?r:o]),P=L,C=[],U=[];for(let F=M==1?r:o;F>=r&&F<=o;F+=M)if(c[F]!=null){let $=l[F],Z=b($);C.push(P=Z),U.push(v(c[F]))}let B={stroke:n(C,U,T,_,w,x),fill:null,clip:null,band:null,gaps:null,flags:ra},I=B.stroke,[k,H]=hp(i,s);if(a.fill!=null||k!=0){let F=B.fill=new Path2D(I),j=a.fillTo(i,s,a.min,a.max,k),$=v(j);_(F,P,$),_(F,L,$)}if(!a.spanGaps){let F=[];F.push(...up(l,c,r,o,M,b,e)),B.gaps=F=a.gaps(i,s,r,o,F),B.clip=Iu(F,u.ori,g,y,m,f)}return H!=0&&(B.band=H==2?[Ws(i,s,r,o,I,-1),Ws(i,s,r,o,I,1)]:Ws(i,s,r,o,I,H)),B})}function SE(n){return bE(ME,n)}function ME(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,t[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,t[h+1]-l[h+1]*d[h]/3,n[h+1],t[h+1])}return a}var Jf=new Set;function c_(){for(let n of Jf)n.syncRect(!0)}oa&&(Wr(iT,ea,c_),Wr(sT,ea,c_,!0),Wr(wu,ea,()=>{cn.pxRatio=Ie}));var wE=Y_(),TE=$_();function h_(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>jf(r,o,t,e))}function EE(n,t){return n.map((e,i)=>i==0?{}:Mn({},t,e))}function jf(n,t,e,i){return Mn({},t==0?e:i,n)}function Z_(n,t,e){return t==null?ia:[t,e]}var AE=Z_;function RE(n,t,e){return t==null?ia:Tu(t,e,ip,!0)}function K_(n,t,e,i){return t==null?ia:Ru(t,e,n.scales[i].log,!1)}var CE=K_;function J_(n,t,e,i){return t==null?ia:np(t,e,n.scales[i].log,!1)}var PE=J_;function IE(n,t,e,i,s){let r=li(G0(n),G0(t)),o=t-n,a=Ji(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?br.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function u_(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Ln((e=+s)*Ie))+"px"),[n,t,e]}function LE(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ve(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function cn(n,t,e){let i={mode:Re(n.mode,1)},s=i.mode;function r(S,A,N,O){let X=A.valToPct(S);return O+N*(A.dir==-1?1-X:X)}function o(S,A,N,O){let X=A.valToPct(S);return O+N*(A.dir==-1?X:1-X)}function a(S,A,N,O){return A.ori==0?r(S,A,N,O):o(S,A,N,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Di(k1);if(n.id!=null&&(c.id=n.id),wi(c,n.class),n.title){let S=Di(G1,c);S.textContent=n.title}let u=Ki("canvas"),d=i.ctx=u.getContext("2d"),h=Di(H1,c);Wr("click",h,S=>{S.target===g&&(qe!=io||Qe!=so)&&Hn.click(i,S)},!0);let p=i.under=Di(W1,h);h.appendChild(u);let g=i.over=Di(X1,h);n=sa(n);let y=+Re(n.pxAlign,1),m=a_(y);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let f=n.ms||.001,x=i.series=s==1?h_(n.series||[],t_,r_,!1):EE(n.series||[null],s_),b=i.axes=h_(n.axes||[],Q0,n_,!0),v=i.scales={},T=i.bands=n.bands||[];T.forEach(S=>{S.fill=we(S.fill||null),S.dir=Re(S.dir,-1)});let w=s==2?x[1].facets[0].scale:x[0].scale,_={axes:Es,series:xe},M=(n.drawOrder||["axes","series"]).map(S=>_[S]);function L(S){let A=S.distr==3?N=>Hs(N>0?N:S.clamp(i,N,S.min,S.max,S.key)):S.distr==4?N=>kf(N,S.asinh):S.distr==100?N=>S.fwd(N):N=>N;return N=>{let O=A(N),{_min:X,_max:Q}=S,lt=Q-X;return(O-X)/lt}}function P(S){let A=v[S];if(A==null){let N=(n.scales||Cl)[S]||Cl;if(N.from!=null){P(N.from);let O=Mn({},v[N.from],N,{key:S});O.valToPct=L(O),v[S]=O}else{A=v[S]=Mn({},S==w?k_:pE,N),A.key=S;let O=A.time,X=A.range,Q=vr(X);if((S!=w||s==2&&!O)&&(Q&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?k0:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?k0:{mode:1,hard:X[1],soft:X[1]}},Q=!1),!Q&&Pu(X))){let lt=X;X=(pt,St,Ut)=>St==null?ia:Tu(St,Ut,lt)}A.range=we(X||(O?AE:S==w?A.distr==3?CE:A.distr==4?PE:Z_:A.distr==3?K_:A.distr==4?J_:RE)),A.auto=we(Q?!1:A.auto),A.clamp=we(A.clamp||fE),A._min=A._max=null,A.valToPct=L(A)}}}P("x"),P("y"),s==1&&x.forEach(S=>{P(S.scale)}),b.forEach(S=>{P(S.scale)});for(let S in n.scales)P(S);let C=v[w],U=C.distr,B,I;C.ori==0?(wi(c,z1),B=r,I=o):(wi(c,V1),B=o,I=r);let k={};for(let S in v){let A=v[S];(A.min!=null||A.max!=null)&&(k[S]={min:A.min,max:A.max},A.min=A.max=null)}let H=n.tzDate||(S=>new Date(Ln(S/f))),F=n.fmtDate||op,j=f==1?zT(H):HT(H),$=K0(H,Z0(f==1?kT:GT,F)),Z=j0(H,J0(XT,F)),nt=[],ht=i.legend=Mn({},YT,n.legend),ct=i.cursor=Mn({},tE,{drag:{y:s==2}},n.cursor),tt=ht.show,mt=ct.show,_t=ht.markers;ht.idxs=nt,_t.width=we(_t.width),_t.dash=we(_t.dash),_t.stroke=we(_t.stroke),_t.fill=we(_t.fill);let ft,xt,Gt,ae=[],Ht=[],qt,te=!1,re={};if(ht.live){let S=x[1]?x[1].values:null;te=S!=null,qt=te?S(i,1,0):{_:0};for(let A in qt)re[A]=tp}if(tt)if(ft=Ki("table",J1,c),Gt=Ki("tbody",null,ft),ht.mount(i,ft),te){xt=Ki("thead",null,ft,Gt);let S=Ki("tr",null,xt);Ki("th",null,S);for(var Ge in qt)Ki("th",E0,S).textContent=Ge}else wi(ft,Q1),ht.live&&wi(ft,j1);let He={show:!0},pn={show:!1};function Fe(S,A){if(A==0&&(te||!ht.live||s==2))return ia;let N=[],O=Ki("tr",tT,Gt,Gt.childNodes[A]);wi(O,S.class),S.show||wi(O,Hr);let X=Ki("th",null,O);if(_t.show){let pt=Di(eT,X);if(A>0){let St=_t.width(i,A);St&&(pt.style.border=St+"px "+_t.dash(i,A)+" "+_t.stroke(i,A)),pt.style.background=_t.fill(i,A)}}let Q=Di(E0,X);S.label instanceof HTMLElement?Q.appendChild(S.label):Q.textContent=S.label,A>0&&(_t.show||(Q.style.color=S.width>0?_t.stroke(i,A):_t.fill(i,A)),Ee("click",X,pt=>{if(ct._lock)return;ee(pt);let St=x.indexOf(S);if((pt.ctrlKey||pt.metaKey)!=ht.isolate){let Ut=x.some((Ot,Bt)=>Bt>0&&Bt!=St&&Ot.show);x.forEach((Ot,Bt)=>{Bt>0&&ns(Bt,Ut?Bt==St?He:pn:He,!0,yn.setSeries)})}else ns(St,{show:!S.show},!0,yn.setSeries)},!1),ne&&Ee(P0,X,pt=>{ct._lock||(ee(pt),ns(x.indexOf(S),oo,!0,yn.setSeries))},!1));for(var lt in qt){let pt=Ki("td",nT,O);pt.textContent="--",N.push(pt)}return[O,N]}let Nn=new Map;function Ee(S,A,N,O=!0){let X=Nn.get(A)||{},Q=ct.bind[S](i,A,N,O);Q&&(Wr(S,A,X[S]=Q),Nn.set(A,X))}function wn(S,A,N){let O=Nn.get(A)||{};for(let X in O)(S==null||X==S)&&($f(X,A,O[X]),delete O[X]);S==null&&Nn.delete(A)}let sn=0,mn=0,G=0,Pt=0,jt=0,he=0,Tt=jt,ke=he,Wt=G,Kt=Pt,D=0,E=0,Y=0,dt=0;i.bbox={};let at=!1,vt=!1,bt=!1,it=!1,rt=!1,gt=!1;function V(S,A,N){(N||S!=i.width||A!=i.height)&&ot(S,A),fe(!1),bt=!0,vt=!0,Xn()}function ot(S,A){i.width=sn=G=S,i.height=mn=Pt=A,jt=he=0,Mt(),$t();let N=i.bbox;D=N.left=Vr(jt*Ie,.5),E=N.top=Vr(he*Ie,.5),Y=N.width=Vr(G*Ie,.5),dt=N.height=Vr(Pt*Ie,.5)}let st=3;function Et(){let S=!1,A=0;for(;!S;){A++;let N=to(A),O=es(A);S=A==st||N&&O,S||(ot(i.width,i.height),vt=!0)}}function yt({width:S,height:A}){V(S,A)}i.setSize=yt;function Mt(){let S=!1,A=!1,N=!1,O=!1;b.forEach((X,Q)=>{if(X.show&&X._show){let{side:lt,_size:pt}=X,St=lt%2,Ut=X.label!=null?X.labelSize:0,Ot=pt+Ut;Ot>0&&(St?(G-=Ot,lt==3?(jt+=Ot,O=!0):N=!0):(Pt-=Ot,lt==0?(he+=Ot,S=!0):A=!0))}}),Qi[0]=S,Qi[1]=N,Qi[2]=A,Qi[3]=O,G-=Fi[1]+Fi[3],jt+=Fi[3],Pt-=Fi[2]+Fi[0],he+=Fi[0]}function $t(){let S=jt+G,A=he+Pt,N=jt,O=he;function X(Q,lt){switch(Q){case 1:return S+=lt,S-lt;case 2:return A+=lt,A-lt;case 3:return N-=lt,N+lt;case 0:return O-=lt,O+lt}}b.forEach((Q,lt)=>{if(Q.show&&Q._show){let pt=Q.side;Q._pos=X(pt,Q._size),Q.label!=null&&(Q._lpos=X(pt,Q.labelSize))}})}if(ct.dataIdx==null){let S=ct.hover,A=S.skip=new Set(S.skip??[]);A.add(void 0);let N=S.prox=we(S.prox),O=S.bias??=0;ct.dataIdx=(X,Q,lt,pt)=>{if(Q==0)return lt;let St=lt,Ut=N(X,Q,lt,pt)??ze,Ot=Ut>=0&&Ut<ze,Bt=C.ori==0?G:Pt,ce=ct.left,Ce=t[0],Ae=t[Q];if(A.has(Ae[lt])){St=null;let ve=null,Qt=null,Yt;if(O==0||O==-1)for(Yt=lt;ve==null&&Yt-- >0;)A.has(Ae[Yt])||(ve=Yt);if(O==0||O==1)for(Yt=lt;Qt==null&&Yt++<Ae.length;)A.has(Ae[Yt])||(Qt=Yt);if(ve!=null||Qt!=null)if(Ot){let Ze=ve==null?-1/0:B(Ce[ve],C,Bt,0),an=Qt==null?1/0:B(Ce[Qt],C,Bt,0),Bn=ce-Ze,Be=an-ce;Bn<=Be?Bn<=Ut&&(St=ve):Be<=Ut&&(St=Qt)}else St=Qt==null?ve:ve==null?Qt:lt-ve<=Qt-lt?ve:Qt}else Ot&&Dn(ce-B(Ce[lt],C,Bt,0))>Ut&&(St=null);return St}}let ee=S=>{ct.event=S};ct.idxs=nt,ct._lock=!1;let ut=ct.points;ut.show=we(ut.show),ut.size=we(ut.size),ut.stroke=we(ut.stroke),ut.width=we(ut.width),ut.fill=we(ut.fill);let kt=i.focus=Mn({},n.focus||{alpha:.3},ct.focus),ne=kt.prox>=0,Ct=ne&&ut.one,ue=[],$e=[],Kn=[];function ga(S,A){let N=ut.show(i,A);if(N instanceof HTMLElement)return wi(N,K1),wi(N,S.class),bs(N,-10,-10,G,Pt),g.insertBefore(N,ue[A]),N}function Jr(S,A){if(s==1||A>0){let N=s==1&&v[S.scale].time,O=S.value;S.value=N?X0(O)?j0(H,J0(O,F)):O||Z:O||hE,S.label=S.label||(N?nE:eE)}if(Ct||A>0){S.width=S.width==null?1:S.width,S.paths=S.paths||wE||pT,S.fillTo=we(S.fillTo||mE),S.pxAlign=+Re(S.pxAlign,y),S.pxRound=a_(S.pxAlign),S.stroke=we(S.stroke||null),S.fill=we(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let N=uE(li(1,S.width),1),O=S.points=Mn({},{size:N,width:li(1,N*.2),stroke:S.stroke,space:N*2,paths:TE,_stroke:null,_fill:null},S.points);O.show=we(O.show),O.filter=we(O.filter),O.fill=we(O.fill),O.stroke=we(O.stroke),O.paths=we(O.paths),O.pxAlign=S.pxAlign}if(tt){let N=Fe(S,A);ae.splice(A,0,N[0]),Ht.splice(A,0,N[1]),ht.values.push(null)}if(mt){nt.splice(A,0,null);let N=null;Ct?A==0&&(N=ga(S,A)):A>0&&(N=ga(S,A)),ue.splice(A,0,N),$e.splice(A,0,0),Kn.splice(A,0,0)}Fn("addSeries",A)}function Vu(S,A){A=A??x.length,S=s==1?jf(S,A,t_,r_):jf(S,A,{},s_),x.splice(A,0,S),Jr(x[A],A)}i.addSeries=Vu;function zl(S){if(x.splice(S,1),tt){ht.values.splice(S,1),Ht.splice(S,1);let A=ae.splice(S,1)[0];wn(null,A.firstChild),A.remove()}mt&&(nt.splice(S,1),ue.splice(S,1)[0].remove(),$e.splice(S,1),Kn.splice(S,1)),Fn("delSeries",S)}i.delSeries=zl;let Qi=[!1,!1,!1,!1];function Ms(S,A){if(S._show=S.show,S.show){let N=S.side%2,O=v[S.scale];O==null&&(S.scale=N?x[1].scale:w,O=v[S.scale]);let X=O.time;S.size=we(S.size),S.space=we(S.space),S.rotate=we(S.rotate),vr(S.incrs)&&S.incrs.forEach(lt=>{!br.has(lt)&&br.set(lt,v_(lt))}),S.incrs=we(S.incrs||(O.distr==2?OT:X?f==1?BT:VT:Gr)),S.splits=we(S.splits||(X&&O.distr==1?j:O.distr==3?Yf:O.distr==4?rE:sE)),S.stroke=we(S.stroke),S.grid.stroke=we(S.grid.stroke),S.ticks.stroke=we(S.ticks.stroke),S.border.stroke=we(S.border.stroke);let Q=S.values;S.values=vr(Q)&&!vr(Q[0])?we(Q):X?vr(Q)?K0(H,Z0(Q,F)):X0(Q)?WT(H,Q):Q||$:Q||iE,S.filter=we(S.filter||(O.distr>=3&&O.log==10?lE:O.distr==3&&O.log==2?cE:x_)),S.font=u_(S.font),S.labelFont=u_(S.labelFont),S._size=S.size(i,null,A,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Qi[A]=!0,S._el=Di($1,h))}}function ws(S,A,N,O){let[X,Q,lt,pt]=N,St=A%2,Ut=0;return St==0&&(pt||Q)&&(Ut=A==0&&!X||A==2&&!lt?Ln(Q0.size/3):0),St==1&&(X||lt)&&(Ut=A==1&&!Q||A==3&&!pt?Ln(n_.size/2):0),Ut}let _a=i.padding=(n.padding||[ws,ws,ws,ws]).map(S=>we(Re(S,ws))),Fi=i._padding=_a.map((S,A)=>S(i,A,Qi,0)),rn,hn=null,un=null,ts=s==1?x[0].idxs:null,pi=null,Ks=!1;function xa(S,A){if(t=S??[],i.data=i._data=t,s==2){rn=0;for(let N=1;N<x.length;N++)rn+=t[N][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),pi=t[0],rn=pi.length;let N=t;if(U==2){N=t.slice();let O=N[0]=Array(rn);for(let X=0;X<rn;X++)O[X]=X}i._data=t=N}if(fe(!0),Fn("setData"),U==2&&(bt=!0),A!==!1){let N=C;N.auto(i,Ks)?ya():Qs(w,N.min,N.max),it=it||ct.left>=0,gt=!0,Xn()}}i.setData=xa;function ya(){Ks=!0;let S,A;s==1&&(rn>0?(hn=ts[0]=0,un=ts[1]=rn-1,S=t[0][hn],A=t[0][un],U==2?(S=hn,A=un):S==A&&(U==3?[S,A]=Ru(S,S,C.log,!1):U==4?[S,A]=np(S,S,C.log,!1):C.time?A=S+Ln(86400/f):[S,A]=Tu(S,A,ip,!0))):(hn=ts[0]=S=null,un=ts[1]=A=null)),Qs(w,S,A)}let jr,Js,Qr,R,W,et,K,J,At,It;function Rt(S,A,N,O,X,Q){S??=R0,N??=rp,O??="butt",X??=R0,Q??="round",S!=jr&&(d.strokeStyle=jr=S),X!=Js&&(d.fillStyle=Js=X),A!=Qr&&(d.lineWidth=Qr=A),Q!=W&&(d.lineJoin=W=Q),O!=et&&(d.lineCap=et=O),N!=R&&d.setLineDash(R=N)}function Dt(S,A,N,O){A!=Js&&(d.fillStyle=Js=A),S!=K&&(d.font=K=S),N!=J&&(d.textAlign=J=N),O!=At&&(d.textBaseline=At=O)}function Vt(S,A,N,O,X=0){if(O.length>0&&S.auto(i,Ks)&&(A==null||A.min==null)){let Q=Re(hn,0),lt=Re(un,O.length-1),pt=N.min==null?lT(O,Q,lt,X,S.distr==3):[N.min,N.max];S.min=ji(S.min,N.min=pt[0]),S.max=li(S.max,N.max=pt[1])}}let oe={min:null,max:null};function _e(){for(let O in v){let X=v[O];k[O]==null&&(X.min==null||k[w]!=null&&X.auto(i,Ks))&&(k[O]=oe)}for(let O in v){let X=v[O];k[O]==null&&X.from!=null&&k[X.from]!=null&&(k[O]=oe)}k[w]!=null&&fe(!0);let S={};for(let O in k){let X=k[O];if(X!=null){let Q=S[O]=sa(v[O],_T);if(X.min!=null)Mn(Q,X);else if(O!=w||s==2)if(rn==0&&Q.from==null){let lt=Q.range(i,null,null,O);Q.min=lt[0],Q.max=lt[1]}else Q.min=ze,Q.max=-ze}}if(rn>0){x.forEach((O,X)=>{if(s==1){let Q=O.scale,lt=k[Q];if(lt==null)return;let pt=S[Q];if(X==0){let St=pt.range(i,pt.min,pt.max,Q);pt.min=St[0],pt.max=St[1],hn=Ji(pt.min,t[0]),un=Ji(pt.max,t[0]),un-hn>1&&(t[0][hn]<pt.min&&hn++,t[0][un]>pt.max&&un--),O.min=pi[hn],O.max=pi[un]}else O.show&&O.auto&&Vt(pt,lt,O,t[X],O.sorted);O.idxs[0]=hn,O.idxs[1]=un}else if(X>0&&O.show&&O.auto){let[Q,lt]=O.facets,pt=Q.scale,St=lt.scale,[Ut,Ot]=t[X],Bt=S[pt],ce=S[St];Bt!=null&&Vt(Bt,k[pt],Q,Ut,Q.sorted),ce!=null&&Vt(ce,k[St],lt,Ot,lt.sorted),O.min=lt.min,O.max=lt.max}});for(let O in S){let X=S[O],Q=k[O];if(X.from==null&&(Q==null||Q.min==null)){let lt=X.range(i,X.min==ze?null:X.min,X.max==-ze?null:X.max,O);X.min=lt[0],X.max=lt[1]}}}for(let O in S){let X=S[O];if(X.from!=null){let Q=S[X.from];if(Q.min==null)X.min=X.max=null;else{let lt=X.range(i,Q.min,Q.max,O);X.min=lt[0],X.max=lt[1]}}}let A={},N=!1;for(let O in S){let X=S[O],Q=v[O];if(Q.min!=X.min||Q.max!=X.max){Q.min=X.min,Q.max=X.max;let lt=Q.distr;Q._min=lt==3?Hs(Q.min):lt==4?kf(Q.min,Q.asinh):lt==100?Q.fwd(Q.min):Q.min,Q._max=lt==3?Hs(Q.max):lt==4?kf(Q.max,Q.asinh):lt==100?Q.fwd(Q.max):Q.max,A[O]=N=!0}}if(N){x.forEach((O,X)=>{s==2?X>0&&A.y&&(O._paths=null):A[O.scale]&&(O._paths=null)});for(let O in A)bt=!0,Fn("setScale",O);mt&&ct.left>=0&&(it=gt=!0)}for(let O in k)k[O]=null}function zt(S){let A=qf(hn-1,0,rn-1),N=qf(un+1,0,rn-1);for(;S[A]==null&&A>0;)A--;for(;S[N]==null&&N<rn-1;)N++;return[A,N]}function xe(){if(rn>0){let S=x.some(A=>A._focus)&&It!=kt.alpha;S&&(d.globalAlpha=It=kt.alpha),x.forEach((A,N)=>{if(N>0&&A.show&&(en(N,!1),en(N,!0),A._paths==null)){let O=It;It!=A.alpha&&(d.globalAlpha=It=A.alpha);let X=s==2?[0,t[N][0].length-1]:zt(t[N]);A._paths=A.paths(i,N,X[0],X[1]),It!=O&&(d.globalAlpha=It=O)}}),x.forEach((A,N)=>{if(N>0&&A.show){let O=It;It!=A.alpha&&(d.globalAlpha=It=A.alpha),A._paths!=null&&Ne(N,!1);{let X=A._paths!=null?A._paths.gaps:null,Q=A.points.show(i,N,hn,un,X),lt=A.points.filter(i,N,Q,X);(Q||lt)&&(A.points._paths=A.points.paths(i,N,hn,un,lt),Ne(N,!0))}It!=O&&(d.globalAlpha=It=O),Fn("drawSeries",N)}}),S&&(d.globalAlpha=It=1)}}function en(S,A){let N=A?x[S].points:x[S];N._stroke=N.stroke(i,S),N._fill=N.fill(i,S)}function Ne(S,A){let N=A?x[S].points:x[S],{stroke:O,fill:X,clip:Q,flags:lt,_stroke:pt=N._stroke,_fill:St=N._fill,_width:Ut=N.width}=N._paths;Ut=Ve(Ut*Ie,3);let Ot=null,Bt=Ut%2/2;A&&St==null&&(St=Ut>0?"#fff":pt);let ce=N.pxAlign==1&&Bt>0;if(ce&&d.translate(Bt,Bt),!A){let Ce=D-Ut/2,Ae=E-Ut/2,ve=Y+Ut,Qt=dt+Ut;Ot=new Path2D,Ot.rect(Ce,Ae,ve,Qt)}A?Ft(pt,Ut,N.dash,N.cap,St,O,X,lt,Q):Ue(S,pt,Ut,N.dash,N.cap,St,O,X,lt,Ot,Q),ce&&d.translate(-Bt,-Bt)}function Ue(S,A,N,O,X,Q,lt,pt,St,Ut,Ot){let Bt=!1;St!=0&&T.forEach((ce,Ce)=>{if(ce.series[0]==S){let Ae=x[ce.series[1]],ve=t[ce.series[1]],Qt=(Ae._paths||Cl).band;vr(Qt)&&(Qt=ce.dir==1?Qt[0]:Qt[1]);let Yt,Ze=null;Ae.show&&Qt&&hT(ve,hn,un)?(Ze=ce.fill(i,Ce)||Q,Yt=Ae._paths.clip):Qt=null,Ft(A,N,O,X,Ze,lt,pt,St,Ut,Ot,Yt,Qt),Bt=!0}}),Bt||Ft(A,N,O,X,Q,lt,pt,St,Ut,Ot)}let Tn=ra|Kf;function Ft(S,A,N,O,X,Q,lt,pt,St,Ut,Ot,Bt){Rt(S,A,N,O,X),(St||Ut||Bt)&&(d.save(),St&&d.clip(St),Ut&&d.clip(Ut)),Bt?(pt&Tn)==Tn?(d.clip(Bt),Ot&&d.clip(Ot),be(X,lt),gn(S,Q,A)):pt&Kf?(be(X,lt),d.clip(Bt),gn(S,Q,A)):pt&ra&&(d.save(),d.clip(Bt),Ot&&d.clip(Ot),be(X,lt),d.restore(),gn(S,Q,A)):(be(X,lt),gn(S,Q,A)),(St||Ut||Bt)&&d.restore()}function gn(S,A,N){N>0&&(A instanceof Map?A.forEach((O,X)=>{d.strokeStyle=jr=X,d.stroke(O)}):A!=null&&S&&d.stroke(A))}function be(S,A){A instanceof Map?A.forEach((N,O)=>{d.fillStyle=Js=O,d.fill(N)}):A!=null&&S&&d.fill(A)}function Ts(S,A,N,O){let X=b[S],Q;if(O<=0)Q=[0,0];else{let lt=X._space=X.space(i,S,A,N,O),pt=X._incrs=X.incrs(i,S,A,N,O,lt);Q=IE(A,N,pt,O,lt)}return X._found=Q}function _n(S,A,N,O,X,Q,lt,pt,St,Ut){let Ot=lt%2/2;y==1&&d.translate(Ot,Ot),Rt(pt,lt,St,Ut,pt),d.beginPath();let Bt,ce,Ce,Ae,ve=X+(O==0||O==3?-Q:Q);N==0?(ce=X,Ae=ve):(Bt=X,Ce=ve);for(let Qt=0;Qt<S.length;Qt++)A[Qt]!=null&&(N==0?Bt=Ce=S[Qt]:ce=Ae=S[Qt],d.moveTo(Bt,ce),d.lineTo(Ce,Ae));d.stroke(),y==1&&d.translate(-Ot,-Ot)}function to(S){let A=!0;return b.forEach((N,O)=>{if(!N.show)return;let X=v[N.scale];if(X.min==null){N._show&&(A=!1,N._show=!1,fe(!1));return}else N._show||(A=!1,N._show=!0,fe(!1));let Q=N.side,lt=Q%2,{min:pt,max:St}=X,[Ut,Ot]=Ts(O,pt,St,lt==0?G:Pt);if(Ot==0)return;let Bt=X.distr==2,ce=N._splits=N.splits(i,O,pt,St,Ut,Ot,Bt),Ce=X.distr==2?ce.map(Yt=>pi[Yt]):ce,Ae=X.distr==2?pi[ce[1]]-pi[ce[0]]:Ut,ve=N._values=N.values(i,N.filter(i,Ce,O,Ot,Ae),O,Ot,Ae);N._rotate=Q==2?N.rotate(i,ve,O,Ot):0;let Qt=N._size;N._size=Ni(N.size(i,ve,O,S)),Qt!=null&&N._size!=Qt&&(A=!1)}),A}function es(S){let A=!0;return _a.forEach((N,O)=>{let X=N(i,O,Qi,S);X!=Fi[O]&&(A=!1),Fi[O]=X}),A}function Es(){for(let S=0;S<b.length;S++){let A=b[S];if(!A.show||!A._show)continue;let N=A.side,O=N%2,X,Q,lt=A.stroke(i,S),pt=N==0||N==3?-1:1,[St,Ut]=A._found;if(A.label!=null){let Qn=A.labelGap*pt,_i=Ln((A._lpos+Qn)*Ie);Dt(A.labelFont[0],lt,"center",N==2?"top":A0),d.save(),O==1?(X=Q=0,d.translate(_i,Ln(E+dt/2)),d.rotate((N==3?-Mu:Mu)/2)):(X=Ln(D+Y/2),Q=_i);let wr=g_(A.label)?A.label(i,S,St,Ut):A.label;d.fillText(wr,X,Q),d.restore()}if(Ut==0)continue;let Ot=v[A.scale],Bt=O==0?Y:dt,ce=O==0?D:E,Ce=A._splits,Ae=Ot.distr==2?Ce.map(Qn=>pi[Qn]):Ce,ve=Ot.distr==2?pi[Ce[1]]-pi[Ce[0]]:St,Qt=A.ticks,Yt=A.border,Ze=Qt.show?Qt.size:0,an=Ln(Ze*Ie),Bn=Ln((A.alignTo==2?A._size-Ze-A.gap:A.gap)*Ie),Be=A._rotate*-Mu/180,ln=m(A._pos*Ie),mi=(an+Bn)*pt,jn=ln+mi;Q=O==0?jn:0,X=O==1?jn:0;let Ai=A.font[0],Bi=A.align==1?Qo:A.align==2?Of:Be>0?Qo:Be<0?Of:O==0?"center":N==3?Of:Qo,ss=Be||O==1?"middle":N==2?"top":A0;Dt(Ai,lt,Bi,ss);let gi=A.font[1]*A.lineGap,Ri=Ce.map(Qn=>m(a(Qn,Ot,Bt,ce))),ki=A._values;for(let Qn=0;Qn<ki.length;Qn++){let _i=ki[Qn];if(_i!=null){O==0?X=Ri[Qn]:Q=Ri[Qn],_i=""+_i;let wr=_i.indexOf(`
`)==-1?[_i]:_i.split(/\n/gm);for(let ti=0;ti<wr.length;ti++){let Fp=wr[ti];Be?(d.save(),d.translate(X,Q+ti*gi),d.rotate(Be),d.fillText(Fp,0,0),d.restore()):d.fillText(Fp,X,Q+ti*gi)}}}Qt.show&&_n(Ri,Qt.filter(i,Ae,S,Ut,ve),O,N,ln,an,Ve(Qt.width*Ie,3),Qt.stroke(i,S),Qt.dash,Qt.cap);let rs=A.grid;rs.show&&_n(Ri,rs.filter(i,Ae,S,Ut,ve),O,O==0?2:1,O==0?E:D,O==0?dt:Y,Ve(rs.width*Ie,3),rs.stroke(i,S),rs.dash,rs.cap),Yt.show&&_n([ln],[1],O==0?1:0,O==0?1:2,O==1?E:D,O==1?dt:Y,Ve(Yt.width*Ie,3),Yt.stroke(i,S),Yt.dash,Yt.cap)}Fn("drawAxes")}function fe(S){x.forEach((A,N)=>{N>0&&(A._paths=null,S&&(s==1?(A.min=null,A.max=null):A.facets.forEach(O=>{O.min=null,O.max=null})))})}let on=!1,Jn=!1,Oe=[];function xn(){Jn=!1;for(let S=0;S<Oe.length;S++)Fn(...Oe[S]);Oe.length=0}function Xn(){on||(wT(yp),on=!0)}function Vl(S,A=!1){on=!0,Jn=A,S(i),yp(),A&&Oe.length>0&&queueMicrotask(xn)}i.batch=Vl;function yp(){if(at&&(_e(),at=!1),bt&&(Et(),bt=!1),vt){if(je(p,Qo,jt),je(p,"top",he),je(p,Tl,G),je(p,El,Pt),je(g,Qo,jt),je(g,"top",he),je(g,Tl,G),je(g,El,Pt),je(h,Tl,sn),je(h,El,mn),u.width=Ln(sn*Ie),u.height=Ln(mn*Ie),b.forEach(({_el:S,_show:A,_size:N,_pos:O,side:X})=>{if(S!=null)if(A){let Q=X===3||X===0?N:0,lt=X%2==1;je(S,lt?"left":"top",O-Q),je(S,lt?"width":"height",N),je(S,lt?"top":"left",lt?he:jt),je(S,lt?"height":"width",lt?Pt:G),Xf(S,Hr)}else wi(S,Hr)}),jr=Js=Qr=W=et=K=J=At=R=null,It=1,Sa(!0),jt!=Tt||he!=ke||G!=Wt||Pt!=Kt){fe(!1);let S=G/Wt,A=Pt/Kt;if(mt&&!it&&ct.left>=0){ct.left*=S,ct.top*=A,eo&&bs(eo,Ln(ct.left),0,G,Pt),no&&bs(no,0,Ln(ct.top),G,Pt);for(let N=0;N<ue.length;N++){let O=ue[N];O!=null&&($e[N]*=S,Kn[N]*=A,bs(O,Ni($e[N]),Ni(Kn[N]),G,Pt))}}if(Ye.show&&!rt&&Ye.left>=0&&Ye.width>0){Ye.left*=S,Ye.width*=S,Ye.top*=A,Ye.height*=A;for(let N in qu)je(ro,N,Ye[N])}Tt=jt,ke=he,Wt=G,Kt=Pt}Fn("setSize"),vt=!1}sn>0&&mn>0&&(d.clearRect(0,0,u.width,u.height),Fn("drawClear"),M.forEach(S=>S()),Fn("draw")),Ye.show&&rt&&(Gl(Ye),rt=!1),mt&&it&&(Mr(null,!0,!1),it=!1),ht.show&&ht.live&&gt&&(Xu(),gt=!1),l||(l=!0,i.status=1,Fn("ready")),Ks=!1,on=!1}i.redraw=(S,A)=>{bt=A||!1,S!==!1?Qs(w,C.min,C.max):Xn()};function Gu(S,A){let N=v[S];if(N.from==null){if(rn==0){let O=N.range(i,A.min,A.max,S);A.min=O[0],A.max=O[1]}if(A.min>A.max){let O=A.min;A.min=A.max,A.max=O}if(rn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;S==w&&N.distr==2&&rn>0&&(A.min=Ji(A.min,t[0]),A.max=Ji(A.max,t[0]),A.min==A.max&&A.max++),k[S]=A,at=!0,Xn()}}i.setScale=Gu;let Hu,Wu,eo,no,vp,bp,io,so,Sp,Mp,qe,Qe,js=!1,Hn=ct.drag,Un=Hn.x,On=Hn.y;mt&&(ct.x&&(Hu=Di(Y1,g)),ct.y&&(Wu=Di(Z1,g)),C.ori==0?(eo=Hu,no=Wu):(eo=Wu,no=Hu),qe=ct.left,Qe=ct.top);let Ye=i.select=Mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ro=Ye.show?Di(q1,Ye.over?g:p):null;function Gl(S,A){if(Ye.show){for(let N in S)Ye[N]=S[N],N in qu&&je(ro,N,S[N]);A!==!1&&Fn("setSelect")}}i.setSelect=Gl;function qx(S){if(x[S].show)tt&&Xf(ae[S],Hr);else if(tt&&wi(ae[S],Hr),mt){let N=Ct?ue[0]:ue[S];N!=null&&bs(N,-10,-10,G,Pt)}}function Qs(S,A,N){Gu(S,{min:A,max:N})}function ns(S,A,N,O){A.focus!=null&&jx(S),A.show!=null&&x.forEach((X,Q)=>{Q>0&&(S==Q||S==null)&&(X.show=A.show,qx(Q),s==2?(Qs(X.facets[0].scale,null,null),Qs(X.facets[1].scale,null,null)):Qs(X.scale,null,null),Xn())}),N!==!1&&Fn("setSeries",S,A),O&&Ma("setSeries",i,S,A)}i.setSeries=ns;function Yx(S,A){Mn(T[S],A)}function Zx(S,A){S.fill=we(S.fill||null),S.dir=Re(S.dir,-1),A=A??T.length,T.splice(A,0,S)}function Kx(S){S==null?T.length=0:T.splice(S,1)}i.addBand=Zx,i.setBand=Yx,i.delBand=Kx;function Jx(S,A){x[S].alpha=A,mt&&ue[S]!=null&&(ue[S].style.opacity=A),tt&&ae[S]&&(ae[S].style.opacity=A)}let As,tr,Sr,oo={focus:!0};function jx(S){if(S!=Sr){let A=S==null,N=kt.alpha!=1;x.forEach((O,X)=>{if(s==1||X>0){let Q=A||X==0||X==S;O._focus=A?null:Q,N&&Jx(X,Q?1:kt.alpha)}}),Sr=S,N&&Xn()}}tt&&ne&&Ee(I0,ft,S=>{ct._lock||(ee(S),Sr!=null&&ns(null,oo,!0,yn.setSeries))});function is(S,A,N){let O=v[A];N&&(S=S/Ie-(O.ori==1?he:jt));let X=G;O.ori==1&&(X=Pt,S=X-S),O.dir==-1&&(S=X-S);let Q=O._min,lt=O._max,pt=S/X,St=Q+(lt-Q)*pt,Ut=O.distr;return Ut==3?na(10,St):Ut==4?dT(St,O.asinh):Ut==100?O.bwd(St):St}function Qx(S,A){let N=is(S,w,A);return Ji(N,t[0],hn,un)}i.valToIdx=S=>Ji(S,t[0]),i.posToIdx=Qx,i.posToVal=is,i.valToPos=(S,A,N)=>v[A].ori==0?r(S,v[A],N?Y:G,N?D:0):o(S,v[A],N?dt:Pt,N?E:0),i.setCursor=(S,A,N)=>{qe=S.left,Qe=S.top,Mr(null,A,N)};function wp(S,A){je(ro,Qo,Ye.left=S),je(ro,Tl,Ye.width=A)}function Tp(S,A){je(ro,"top",Ye.top=S),je(ro,El,Ye.height=A)}let va=C.ori==0?wp:Tp,ba=C.ori==1?wp:Tp;function ty(){if(tt&&ht.live)for(let S=s==2?1:0;S<x.length;S++){if(S==0&&te)continue;let A=ht.values[S],N=0;for(let O in A)Ht[S][N++].firstChild.nodeValue=A[O]}}function Xu(S,A){if(S!=null&&(S.idxs?S.idxs.forEach((N,O)=>{nt[O]=N}):gT(S.idx)||nt.fill(S.idx),ht.idx=nt[0]),tt&&ht.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!te)&&ey(N,nt[N]);ty()}gt=!1,A!==!1&&Fn("setLegend")}i.setLegend=Xu;function ey(S,A){let N=x[S],O=S==0&&U==2?pi:t[S],X;te?X=N.values(i,S,A)??re:(X=N.value(i,A==null?null:O[A],S,A),X=X==null?re:{_:X}),ht.values[S]=X}function Mr(S,A,N){Sp=qe,Mp=Qe,[qe,Qe]=ct.move(i,qe,Qe),ct.left=qe,ct.top=Qe,mt&&(eo&&bs(eo,Ln(qe),0,G,Pt),no&&bs(no,0,Ln(Qe),G,Pt));let O,X=hn>un;As=ze,tr=null;let Q=C.ori==0?G:Pt,lt=C.ori==1?G:Pt;if(qe<0||rn==0||X){O=ct.idx=null;for(let pt=0;pt<x.length;pt++){let St=ue[pt];St!=null&&bs(St,-10,-10,G,Pt)}ne&&ns(null,oo,!0,S==null&&yn.setSeries),ht.live&&(nt.fill(O),gt=!0)}else{let pt,St,Ut;s==1&&(pt=C.ori==0?qe:Qe,St=is(pt,w),O=ct.idx=Ji(St,t[0],hn,un),Ut=B(t[0][O],C,Q,0));let Ot=-10,Bt=-10,ce=0,Ce=0,Ae=!0,ve="",Qt="";for(let Yt=s==2?1:0;Yt<x.length;Yt++){let Ze=x[Yt],an=nt[Yt],Bn=an==null?null:s==1?t[Yt][an]:t[Yt][1][an],Be=ct.dataIdx(i,Yt,O,St),ln=Be==null?null:s==1?t[Yt][Be]:t[Yt][1][Be];if(gt=gt||ln!=Bn||Be!=an,nt[Yt]=Be,Yt>0&&Ze.show){let mi=Be==null?-10:Be==O?Ut:B(s==1?t[0][Be]:t[Yt][0][Be],C,Q,0),jn=ln==null?-10:I(ln,s==1?v[Ze.scale]:v[Ze.facets[1].scale],lt,0);if(ne&&ln!=null){let Ai=C.ori==1?qe:Qe,Bi=Dn(kt.dist(i,Yt,Be,jn,Ai));if(Bi<As){let ss=kt.bias;if(ss!=0){let gi=is(Ai,Ze.scale),Ri=ln>=0?1:-1,ki=gi>=0?1:-1;ki==Ri&&(ki==1?ss==1?ln>=gi:ln<=gi:ss==1?ln<=gi:ln>=gi)&&(As=Bi,tr=Yt)}else As=Bi,tr=Yt}}if(gt||Ct){let Ai,Bi;C.ori==0?(Ai=mi,Bi=jn):(Ai=jn,Bi=mi);let ss,gi,Ri,ki,rs,Qn,_i=!0,wr=ut.bbox;if(wr!=null){_i=!1;let ti=wr(i,Yt);Ri=ti.left,ki=ti.top,ss=ti.width,gi=ti.height}else Ri=Ai,ki=Bi,ss=gi=ut.size(i,Yt);if(Qn=ut.fill(i,Yt),rs=ut.stroke(i,Yt),Ct)Yt==tr&&As<=kt.prox&&(Ot=Ri,Bt=ki,ce=ss,Ce=gi,Ae=_i,ve=Qn,Qt=rs);else{let ti=ue[Yt];ti!=null&&($e[Yt]=Ri,Kn[Yt]=ki,B0(ti,ss,gi,_i),O0(ti,Qn,rs),bs(ti,Ni(Ri),Ni(ki),G,Pt))}}}}if(Ct){let Yt=kt.prox,Ze=Sr==null?As<=Yt:As>Yt||tr!=Sr;if(gt||Ze){let an=ue[0];an!=null&&($e[0]=Ot,Kn[0]=Bt,B0(an,ce,Ce,Ae),O0(an,ve,Qt),bs(an,Ni(Ot),Ni(Bt),G,Pt))}}}if(Ye.show&&js)if(S!=null){let[pt,St]=yn.scales,[Ut,Ot]=yn.match,[Bt,ce]=S.cursor.sync.scales,Ce=S.cursor.drag;if(Un=Ce._x,On=Ce._y,Un||On){let{left:Ae,top:ve,width:Qt,height:Yt}=S.select,Ze=S.scales[Bt].ori,an=S.posToVal,Bn,Be,ln,mi,jn,Ai=pt!=null&&Ut(pt,Bt),Bi=St!=null&&Ot(St,ce);Ai&&Un?(Ze==0?(Bn=Ae,Be=Qt):(Bn=ve,Be=Yt),ln=v[pt],mi=B(an(Bn,Bt),ln,Q,0),jn=B(an(Bn+Be,Bt),ln,Q,0),va(ji(mi,jn),Dn(jn-mi))):va(0,Q),Bi&&On?(Ze==1?(Bn=Ae,Be=Qt):(Bn=ve,Be=Yt),ln=v[St],mi=I(an(Bn,ce),ln,lt,0),jn=I(an(Bn+Be,ce),ln,lt,0),ba(ji(mi,jn),Dn(jn-mi))):ba(0,lt)}else Yu()}else{let pt=Dn(Sp-vp),St=Dn(Mp-bp);if(C.ori==1){let ce=pt;pt=St,St=ce}Un=Hn.x&&pt>=Hn.dist,On=Hn.y&&St>=Hn.dist;let Ut=Hn.uni;Ut!=null?Un&&On&&(Un=pt>=Ut,On=St>=Ut,!Un&&!On&&(St>pt?On=!0:Un=!0)):Hn.x&&Hn.y&&(Un||On)&&(Un=On=!0);let Ot,Bt;Un&&(C.ori==0?(Ot=io,Bt=qe):(Ot=so,Bt=Qe),va(ji(Ot,Bt),Dn(Bt-Ot)),On||ba(0,lt)),On&&(C.ori==1?(Ot=io,Bt=qe):(Ot=so,Bt=Qe),ba(ji(Ot,Bt),Dn(Bt-Ot)),Un||va(0,Q)),!Un&&!On&&(va(0,0),ba(0,0))}if(Hn._x=Un,Hn._y=On,S==null){if(N){if(Op!=null){let[pt,St]=yn.scales;yn.values[0]=pt!=null?is(C.ori==0?qe:Qe,pt):null,yn.values[1]=St!=null?is(C.ori==1?qe:Qe,St):null}Ma(Ff,i,qe,Qe,G,Pt,O)}if(ne){let pt=N&&yn.setSeries,St=kt.prox;Sr==null?As<=St&&ns(tr,oo,!0,pt):As>St?ns(null,oo,!0,pt):tr!=Sr&&ns(tr,oo,!0,pt)}}gt&&(ht.idx=O,Xu()),A!==!1&&Fn("setCursor")}let er=null;Object.defineProperty(i,"rect",{get(){return er==null&&Sa(!1),er}});function Sa(S=!1){S?er=null:(er=g.getBoundingClientRect(),Fn("syncRect",er))}function Ep(S,A,N,O,X,Q,lt){ct._lock||js&&S!=null&&S.movementX==0&&S.movementY==0||($u(S,A,N,O,X,Q,lt,!1,S!=null),S!=null?Mr(null,!0,!0):Mr(A,!0,!1))}function $u(S,A,N,O,X,Q,lt,pt,St){if(er==null&&Sa(!1),ee(S),S!=null)N=S.clientX-er.left,O=S.clientY-er.top;else{if(N<0||O<0){qe=-10,Qe=-10;return}let[Ut,Ot]=yn.scales,Bt=A.cursor.sync,[ce,Ce]=Bt.values,[Ae,ve]=Bt.scales,[Qt,Yt]=yn.match,Ze=A.axes[0].side%2==1,an=C.ori==0?G:Pt,Bn=C.ori==1?G:Pt,Be=Ze?Q:X,ln=Ze?X:Q,mi=Ze?O:N,jn=Ze?N:O;if(Ae!=null?N=Qt(Ut,Ae)?a(ce,v[Ut],an,0):-10:N=an*(mi/Be),ve!=null?O=Yt(Ot,ve)?a(Ce,v[Ot],Bn,0):-10:O=Bn*(jn/ln),C.ori==1){let Ai=N;N=O,O=Ai}}St&&(A==null||A.cursor.event.type==Ff)&&((N<=1||N>=G-1)&&(N=Vr(N,G)),(O<=1||O>=Pt-1)&&(O=Vr(O,Pt))),pt?(vp=N,bp=O,[io,so]=ct.move(i,N,O)):(qe=N,Qe=O)}let qu={width:0,height:0,left:0,top:0};function Yu(){Gl(qu,!1)}let Ap,Rp,Cp,Pp;function Ip(S,A,N,O,X,Q,lt){js=!0,Un=On=Hn._x=Hn._y=!1,$u(S,A,N,O,X,Q,lt,!0,!1),S!=null&&(Ee(Bf,Hf,Lp,!1),Ma(C0,i,io,so,G,Pt,null));let{left:pt,top:St,width:Ut,height:Ot}=Ye;Ap=pt,Rp=St,Cp=Ut,Pp=Ot}function Lp(S,A,N,O,X,Q,lt){js=Hn._x=Hn._y=!1,$u(S,A,N,O,X,Q,lt,!1,!0);let{left:pt,top:St,width:Ut,height:Ot}=Ye,Bt=Ut>0||Ot>0,ce=Ap!=pt||Rp!=St||Cp!=Ut||Pp!=Ot;if(Bt&&ce&&Gl(Ye),Hn.setScale&&Bt&&ce){let Ce=pt,Ae=Ut,ve=St,Qt=Ot;if(C.ori==1&&(Ce=St,Ae=Ot,ve=pt,Qt=Ut),Un&&Qs(w,is(Ce,w),is(Ce+Ae,w)),On)for(let Yt in v){let Ze=v[Yt];Yt!=w&&Ze.from==null&&Ze.min!=ze&&Qs(Yt,is(ve+Qt,Yt),is(ve,Yt))}Yu()}else ct.lock&&(ct._lock=!ct._lock,Mr(A,!0,S!=null));S!=null&&(wn(Bf,Hf),Ma(Bf,i,qe,Qe,G,Pt,null))}function ny(S,A,N,O,X,Q,lt){if(ct._lock)return;ee(S);let pt=js;if(js){let St=!0,Ut=!0,Ot=10,Bt,ce;C.ori==0?(Bt=Un,ce=On):(Bt=On,ce=Un),Bt&&ce&&(St=qe<=Ot||qe>=G-Ot,Ut=Qe<=Ot||Qe>=Pt-Ot),Bt&&St&&(qe=qe<io?0:G),ce&&Ut&&(Qe=Qe<so?0:Pt),Mr(null,!0,!0),js=!1}qe=-10,Qe=-10,nt.fill(null),Mr(null,!0,!0),pt&&(js=pt)}function Dp(S,A,N,O,X,Q,lt){ct._lock||(ee(S),ya(),Yu(),S!=null&&Ma(L0,i,qe,Qe,G,Pt,null))}function Np(){b.forEach(LE),V(i.width,i.height,!0)}Wr(wu,ea,Np);let ao={};ao.mousedown=Ip,ao.mousemove=Ep,ao.mouseup=Lp,ao.dblclick=Dp,ao.setSeries=(S,A,N,O)=>{let X=yn.match[2];N=X(i,A,N),N!=-1&&ns(N,O,!0,!1)},mt&&(Ee(C0,g,Ip),Ee(Ff,g,Ep),Ee(P0,g,S=>{ee(S),Sa(!1)}),Ee(I0,g,ny),Ee(L0,g,Dp),Jf.add(i),i.syncRect=Sa);let Hl=i.hooks=n.hooks||{};function Fn(S,A,N){Jn?Oe.push([S,A,N]):S in Hl&&Hl[S].forEach(O=>{O.call(null,i,A,N)})}(n.plugins||[]).forEach(S=>{for(let A in S.hooks)Hl[A]=(Hl[A]||[]).concat(S.hooks[A])});let Up=(S,A,N)=>N,yn=Mn({key:null,setSeries:!1,filters:{pub:H0,sub:H0},scales:[w,x[1]?x[1].scale:null],match:[W0,W0,Up],values:[null,null]},ct.sync);yn.match.length==2&&yn.match.push(Up),ct.sync=yn;let Op=yn.key,Zu=z_(Op);function Ma(S,A,N,O,X,Q,lt){yn.filters.pub(S,A,N,O,X,Q,lt)&&Zu.pub(S,A,N,O,X,Q,lt)}Zu.sub(i);function iy(S,A,N,O,X,Q,lt){yn.filters.sub(S,A,N,O,X,Q,lt)&&ao[S](null,A,N,O,X,Q,lt)}i.pub=iy;function sy(){Zu.unsub(i),Jf.delete(i),Nn.clear(),$f(wu,ea,Np),c.remove(),ft?.remove(),Fn("destroy")}i.destroy=sy;function Ku(){Fn("init",n,t),xa(t||n.data,!1),k[w]?Gu(w,k[w]):ya(),rt=Ye.show&&(Ye.width>0||Ye.height>0),it=gt=!0,V(n.width,n.height)}return x.forEach(Jr),b.forEach(Ms),e?e instanceof HTMLElement?(e.appendChild(c),Ku()):e(i,Ku):Ku(),i}cn.assign=Mn;cn.fmtNum=sp;cn.rangeNum=Tu;cn.rangeLog=Ru;cn.rangeAsinh=np;cn.orient=$r;cn.pxRatio=Ie;cn.join=MT;cn.fmtDate=op,cn.tzDate=NT;cn.sync=z_;{cn.addGap=gE,cn.clipGaps=Iu;let n=cn.paths={points:$_};n.linear=Y_,n.stepped=yE,n.bars=vE,n.spline=SE}var DE=n=>os(String(Number(n.toFixed(6)))),NE=364,Xs=n=>nn()?NE:Math.max(n.clientWidth,200);function ca(n){let t={stroke:Se("muted"),grid:{stroke:Se("grid"),width:1},ticks:{show:!1},font:"11px system-ui, sans-serif",values:(e,i)=>i.map(DE)};return[{...t,size:30,label:n,labelSize:18,labelFont:"11px system-ui, sans-serif"},{...t,size:62}]}var $s=(n,t)=>t==null?"–":dn(t),ha={live:!0,markers:{width:2,stroke:(n,t)=>{let e=n.series[t]?.stroke,i=typeof e=="function"?e(n,t):e;return typeof i=="string"?i:""},dash:(n,t)=>{let[e]=n.series[t]?.dash??[];return e===void 0?"solid":e<2?"dotted":"dashed"},fill:()=>"transparent"}};function Il(n,t,e,i){if(n===null||t===null)return[0,1];let s=Math.max(t-n,Xt(i,e)),r=(n+t)/2;return[r-.58*s,r+.58*s]}var j_=new Map;function Uu(n,t){let e=j_.get(t)??new Set;j_.set(t,e),n.root.querySelectorAll(".u-legend .u-series").forEach((i,s)=>{if(s===0||n.series.length<3)return;let r=i.querySelector("th"),o=n.series[s];if(!r||!o)return;let a=String(o.label),l=()=>r.setAttribute("aria-pressed",String(o.show));e.has(a)&&n.setSeries(s,{show:!1});for(let[c,u]of Object.entries({tabindex:0,role:"button",title:`Show or hide ${a}`}))r.setAttribute(c,String(u));r.addEventListener("keydown",c=>{c.key!=="Enter"&&c.key!==" "||(c.preventDefault(),r.click())}),r.addEventListener("click",()=>{o.show?e.delete(a):e.add(a),l()}),l()})}var ge=(n,t)=>n[t];function qs(n,t){let e=0,i=n.length;for(;e<i;){let s=e+i>>1;ge(n,s)<t?e=s+1:i=s}return e}function qr(n,[t,e]){return[Math.max(qs(n,t)-1,0),Math.min(qs(n,e)+1,n.length)]}function Yr(n,t,e){let i=n.length-1;if(i<0||e<ge(n,0)-1||e>ge(n,i)+1)return NaN;if(i===0)return ge(t,0);let s=Math.min(Math.max(qs(n,e),1),i),r=ge(n,s)-ge(n,s-1),o=r>0?Math.min(Math.max((e-ge(n,s-1))/r,0),1):0;return ge(t,s-1)+o*(ge(t,s)-ge(t,s-1))}function tx(n,t,e){let[i,s]=[1/0,-1/0],[r,o]=qr(n,e);for(let a=r;a<o;a++)ge(t,a)<i&&(i=ge(t,a)),ge(t,a)>s&&(s=ge(t,a));return[i,s]}var Q_=n=>Math.round(10*n)/10,fp=(n,t)=>`${Q_(n)} ${Q_(t)}`;function ex(n,t,e,i,s){let[r,o]=qr(n,e),a=o-r>2*Math.abs(s(e[1])-s(e[0])),l="",c="M",u=h=>{l+=c+fp(i(ge(t,h)),s(ge(n,h))),c="L"},d=r;for(;d<o;){if(!Number.isFinite(t[d])){c="M",d++;continue}if(!a){u(d++);continue}let h=Math.round(s(ge(n,d))),[p,g,y]=[d,d,d];for(;y+1<o&&Math.round(s(ge(n,y+1)))===h&&Number.isFinite(t[y+1]);)y++,ge(t,y)<ge(t,p)&&(p=y),ge(t,y)>ge(t,g)&&(g=y);for(let m of new Set([d,Math.min(p,g),Math.max(p,g),y]))u(m);d=y+1}return l}function Ll(n,t,e,i,s,r){let[o,a]=qr(n,i),l=Math.max(Math.floor((a-o)/(2*Math.abs(r(i[1])-r(i[0]))+1)),1),c=[],u=[];for(let d=o;d<a;d+=l){let[h,p]=[1/0,-1/0];for(let g=d;g<Math.min(d+l,a);g++)ge(t,g)<h&&(h=ge(t,g)),ge(e,g)>p&&(p=ge(e,g));h<=p&&(c.push(fp(s(p),r(ge(n,d)))),u.push(fp(s(h),r(ge(n,d)))))}return c.length>1?`M${c.join("L")}L${u.reverse().join("L")}Z`:""}function Ou(n,t,e){let i=new Float32Array(t.length),s=0;for(let r=0;r<t.length;r++){for(;ge(n,s)<ge(n,r)-e;)s++;let o=-1/0;for(let a=s;a<t.length&&ge(n,a)<=ge(n,r)+e;a++)o=Math.max(o,ge(t,a));i[r]=o}return i}function nx(n,t,e){let[i,s]=[0,0];return Uint32Array.from(t,(r,o)=>{for(;ge(n,i)<ge(n,o)-e;)i++;for(;s<t.length&&ge(n,s)<=ge(n,o)+e;)s++;let a=i;for(let l=i;l<s;l++)ge(t,l)>=ge(t,a)&&(a=l);return a})}var[Zr,Ys,Ui,ua,Zs,Kr]=[720,320,78,16,46,46],UE={"font-family":"system-ui, sans-serif","font-size":12};function OE(n,t){let e=[];for(let i=Math.ceil(Math.log10(n)-1e-9);10**i<=t*(1+1e-9);i++)e.push(10**i);return e.map(i=>[i,`1e${Math.round(Math.log10(i))}`])}function ix(n,[t,e],i){let s=n.distr===3,r=s?Math.log10:d=>d,[o,a]=[r(n.min),r(n.max)],l=d=>t+(r(d)-o)/(a-o)*(e-t),c=Pn(n.min,n.max,i),u=s?OE(n.min,n.max):c.values.map(d=>[d,Sn(d,c.step)]);return{at:l,marks:u}}function da(n,t,e){let i=n.scales.y.dir===-1,s=ix(n.scales.x,[Ui,Zr-ua],8),r=ix(n.scales.y,i?[Zs,Ys-Kr]:[Ys-Kr,Zs],5),o=wt("svg",{viewBox:`0 0 ${Zr} ${Ys}`,xmlns:"http://www.w3.org/2000/svg",...UE}),a=Se("grid"),l=(h,p)=>wt("text",{fill:Se("text"),...h},p);for(let[h,p]of s.marks)o.append(wt("line",{x1:s.at(h),x2:s.at(h),y1:Zs,y2:Ys-Kr,stroke:a})),o.append(l({x:s.at(h),y:Ys-Kr+17,"text-anchor":"middle"},p));for(let[h,p]of r.marks)o.append(wt("line",{x1:Ui,x2:Zr-ua,y1:r.at(h),y2:r.at(h),stroke:a})),o.append(l({x:Ui-7,y:r.at(h)+4,"text-anchor":"end"},p));let c=wt("svg",{x:Ui,y:Zs,width:Zr-Ui-ua,height:Ys-Zs-Kr,viewBox:`${Ui} ${Zs} ${Zr-Ui-ua} ${Ys-Zs-Kr}`}),u=Ui;n.series.forEach((h,p)=>{if(p===0||!h.show)return;let g=typeof h.stroke=="function"?h.stroke(n,p):h.stroke,y=n.data[p],m=Array.from(n.data[0],(f,x)=>[f,y[x]]).filter(([f,x])=>x!==null&&Number.isFinite(x)&&f>=n.scales.x.min&&f<=n.scales.x.max);if(h.points?.show===!0)for(let[f,x]of m)c.append(wt("circle",{cx:s.at(f).toFixed(1),cy:r.at(x).toFixed(1),r:1.8,fill:g}));else c.append(wt("path",{d:m.map(([f,x],b)=>`${b?"L":"M"}${s.at(f).toFixed(1)} ${r.at(x).toFixed(1)}`).join(""),fill:"none",stroke:g,"stroke-width":h.width??1.4,"stroke-dasharray":h.dash?.join(" ")}));if(n.series.length>2){let f=h.dash?.join(" ");o.append(wt("line",{x1:u,x2:u+22,y1:34,y2:34,stroke:g,"stroke-width":2,"stroke-dasharray":f})),o.append(l({x:u+27,y:38},h.label)),u+=42+6.4*h.label.length}}),o.append(c,wt("rect",{x:Ui,y:Zs,width:Zr-Ui-ua,height:Ys-Zs-Kr,fill:"none",stroke:Se("frame")}),l({x:Ui,y:18,"font-weight":600},t),l({x:(Ui+Zr-ua)/2,y:Ys-10,"text-anchor":"middle"},e)),o.style.position="absolute",document.body.append(o);let d=ho([o]);return o.remove(),d}function fa(n,t,e){let i=n.series.map((l,c)=>c).filter(l=>l===0||n.series[l].show),s=l=>l===0?t:`${n.series[l].label}${e?`, ${e}`:""}`,{min:r,max:o}=n.scales.x,a=Array.from(n.data[0],(l,c)=>i.map(u=>n.data[u][c]));return[i.map(s),a.filter(([l])=>l>=r&&l<=o)]}var FE=cn.sync("time"),sx=216,BE=196;function pp(n,t,e){let i=z("div",{class:"histories"}),s=[],r=!1;function o(b){let v=b.history;if(!v.time_s)return[];let T=t.map(_=>({..._,columns:_.columns.filter(([M])=>v[M])})).filter(_=>_.columns.length).filter(_=>_.columns.some(([M])=>v[M].some(L=>L!==0))).map(_=>({..._,times:v.time_s,values:_.columns.map(([M])=>v[M])})),w=e?l(b):null;return w?[...T,w]:T}let a=n.node_channels[0].column;function l(b){let{frames:v,contact:T}=b;if(v?.channels[a]){let P=v.md_m.length,C=Dl(v.md_m,Lt.depth),{title:U,dimension:B,min_span:I}=n.node_channels.find(({column:H})=>H===a),k=Float32Array.from(v.time_s,(H,F)=>v.channels[a][F*P+C]);return{title:`${U} at ${Te(v.md_m[C],"length",5)}`,dimension:B,min_span:I,columns:[[a,"node"]],times:v.time_s,values:[k],chooses:n.node_channels.filter(({column:H})=>v.channels[H])}}let[{column:w,title:_,dimension:M,min_span:L}]=n.contact_plots;if(T?.values[w]){let P=T.md_m.length,C=Dl(T.md_m,Lt.depth),U=Float32Array.from(T.time_s,(B,I)=>T.values[w][I*P+C]);return{title:`${_} around ${Te(T.md_m[C],"length",5)}`,dimension:M,min_span:L,columns:[[w,_.toLowerCase()]],times:T.time_s,values:[U]}}return null}function c(){s.forEach(T=>T.destroy()),s=[];let b=Ke(n),v=b?o(b).map(T=>u(T,b)):[];i.replaceChildren(...v.map(T=>T.element));for(let{plot:T,body:w,it:_}of v)s.push(_.made=d(T,w,b))}function u(b,v){let T=z("div",{class:"plot"}),w=ie(b.dimension),_=z("h3",{},b.points&&b.columns.length===1?b.columns[0][1].replace(/^./,P=>P.toUpperCase()):b.title,w&&z("span",{class:"unit"},` ${w}`));b.chooses&&_.append(z("select",{class:"noprint","aria-label":"Quantity of the chosen node",onchange:P=>{a=P.target.value,c()}},b.chooses.map(({column:P,title:C})=>z("option",{value:P,selected:P===a},C))));let M={plot:b,body:T,made:null},L=()=>`${En(v.operation)}: ${b.title}`;return _.append(vn(L,{svg:()=>da(M.made,`${L()}${w?`, ${w}`:""}`,"Time, s"),csv:()=>$n(...fa(M.made,"time, s",w))})),{...M,it:M,element:z("figure",{class:"card history"},_,T)}}function d(b,v,T){let w=h(b),_=[Array.from(b.times),...b.values.map(C=>Yl(C,b.dimension))],M=b.columns.map(([,C],U)=>{let B=C==="set";return{label:C,stroke:Rs(B?6:[0,2,3][U]??U),width:B?1.2:1.4,dash:B?Ar(4):Ar([0,2,3][U]??U)??void 0,spanGaps:!!b.points,points:{show:!1},value:$s}});w!==null&&(_.push(_[0].map(()=>w.value)),M.push({label:w.name,stroke:Rs(1),width:1.4,dash:[7,4],points:{show:!1},value:$s}));let L=Lt.times??[0,Math.max(Fu(T),.001)],P=new cn({width:Xs(v),height:nn()?BE:sx,cursor:{sync:{key:FE.key,scales:["x",null]},drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:ha,scales:{x:{time:!1,min:L[0],max:L[1]},y:{dir:b.points?-1:1,range:(C,U,B)=>Il(U,B,b.dimension,b.min_span)}},axes:ca("Time, s"),series:[{label:"time, s",value:(C,U)=>U===null?"–":U.toFixed(2)},...M],hooks:{setScale:[(C,U)=>U==="x"&&p(C)],drawClear:[C=>g(C,T)],draw:[C=>y(C,T)]}},_,v);return m(P),Uu(P,`${T.operation} ${b.title.replace(/ (at|around) .*/,"")}`),P}function h(b){let v=tc(n);if(!b.at_surface||!v)return null;let T=v.profile[b.at_surface]?.[0];return Number.isFinite(T)?{name:zi(n,v),value:Xt(T,b.dimension)}:null}function p(b){if(r||b.scales.x.min==null||s.length===0)return;r=!0;let{min:v,max:T}=b.scales.x,w=Ke(n),_=Fu(w);for(let M of s)M!==b&&M.setScale("x",{min:v,max:T});We({times:v<=1e-6&&T>=_-1e-6?null:[v,T]}),r=!1}function g(b,v){let{ctx:T,bbox:w}=b,_=b.valToPos(v.window_s,"x",!0),M=Math.min(Math.max(_,w.left),w.left+w.width);T.save(),T.fillStyle=Se("settling"),T.fillRect(w.left,w.top,M-w.left,w.height),T.restore()}function y(b,v){let{ctx:T,bbox:w}=b,_=devicePixelRatio,M=-1/0;T.save(),T.font=`${10*_}px system-ui, sans-serif`,T.textAlign="left",T.fillStyle=Se("muted"),T.strokeStyle=Se("muted"),T.setLineDash([2*_,3*_]);let L=Lt.moment===null?[]:[[Lt.moment,""]];for(let[P,C]of[...v.notes,...L]){let U=b.valToPos(P,"x",!0);if(U<w.left||U>w.left+w.width)continue;T.beginPath(),T.moveTo(U,w.top),T.lineTo(U,w.top+w.height),T.stroke();let B=T.measureText(C).width;C&&U>M&&U+B<w.left+w.width&&(T.fillText(C,U+3*_,w.top+11*_),M=U+B+8*_)}T.restore()}function m(b){let{over:v}=b,T=()=>Fu(Ke(n)),w=(_,M)=>{let L=Math.max(_,0),P=Math.min(M,T());P-L>.001&&b.setScale("x",{min:L,max:P})};v.addEventListener("wheel",_=>{if(!_.ctrlKey&&!_.metaKey)return;_.preventDefault();let M=b.posToVal(_.clientX-v.getBoundingClientRect().left,"x"),L=Math.exp(_.deltaY*.002);w(M+(b.scales.x.min-M)*L,M+(b.scales.x.max-M)*L)},{passive:!1}),v.addEventListener("mousedown",_=>{if(!_.shiftKey)return;_.stopImmediatePropagation();let M=_.clientX,{min:L,max:P}=b.scales.x,C=U=>{let B=(M-U.clientX)/v.clientWidth*(P-L),I=Math.min(Math.max(B,-L),T()-P);w(L+I,P+I)};addEventListener("mousemove",C),addEventListener("mouseup",()=>removeEventListener("mousemove",C),{once:!0})},{capture:!0}),v.addEventListener("dblclick",()=>b.setScale("x",{min:0,max:T()}))}me(e?"units operation depth":"units operation",c),me("times",()=>{if(r)return;let b=Ke(n);if(!b)return;let[v,T]=Lt.times??[0,Fu(b)];r=!0;for(let w of s)w.setScale("x",{min:v,max:T});r=!1}),me("moment",()=>s.forEach(b=>b.redraw(!1,!1)));let f=0;new ResizeObserver(()=>{if(!(nn()||i.clientWidth===f)){f=i.clientWidth;for(let b of s)b.setSize({width:Xs(b.root.parentElement),height:sx})}}).observe(i);let x=z("p",{class:"hint noprint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics");return{element:z("div",{},x,i),redraw:c}}var Fu=n=>n?.history.time_s?.at(-1)??0;function Dl(n,t){if(n.length<2)return 0;let e=Math.min(Math.max(qs(n,t??0),1),n.length-1);return Math.abs(n[e]-t)<Math.abs(n[e-1]-t)?e:e-1}var Bu=58,rx=96,ku=10,ox=34,Nl=430,kE=700;function zE(n,t){let e=n.filter(Number.isFinite).map(Math.abs).sort((i,s)=>i-s);return e[Math.floor(t*(e.length-1))]||1}function ax(n){let t=n.contact_plots,e=t[0],i=z("canvas",{class:"map",role:"img","aria-label":"Contact over depth and time"}),s=z("p",{class:"readout-line"}," "),r=z("div",{class:"map-holder"},i),o=z("div",{class:"tools noprint"},Tr("What the map shows",t.map(({column:f,title:x,sides:b})=>[f,b?`${x}, by side`:x]),e.column,f=>{e=t.find(({column:x})=>x===f),l()}),vn("Contact over depth and time",{svg:()=>u(),csv:()=>$n(...d())}),z("span",{class:"hint"},"follows the depths and times in view above; click to choose a depth and a time")),a=f=>({depths:Lt.depths??[0,f.contact.md_m.at(-1)],times:Lt.times??[f.contact.from_s,f.contact.time_s.at(-1)]});function l(){let f=Ke(n);if(!f?.contact?.values[e.column])return;let x=Math.max(devicePixelRatio,2),b=nn()?kE:r.clientWidth||1200;i.width=b*x,i.height=Nl*x,i.style.aspectRatio=`${b} / ${Nl}`;let v=i.getContext("2d");v.scale(x,x),v.font="11px system-ui, sans-serif",c(v,f,b,(...T)=>h(v,...T))}function c(f,x,b,v){let{depths:T,times:w}=a(x),_={left:Bu,top:ku,width:b-Bu-rx,height:Nl-ku-ox},M=zE(Array.from(x.contact.values[e.column]),.985),L=e.sides,P=lo(L),C=U=>P(L?.5+.5*U/M:U/M);v(x,_,T,w,C),p(f,_,T,w,x),g(f,_,M,C)}function u(){let f=Ke(n),x=1e3,b=new jo(x,Nl);return b.fillStyle=Se("paper"),b.fillRect(0,0,x,Nl),c(b,f,x,(v,T,...w)=>{let _=z("canvas",{width:T.width*2,height:T.height*2}),M=_.getContext("2d");M.scale(2,2),M.translate(-T.left,-T.top),h(M,v,T,...w),b.image(_.toDataURL(),T.left,T.top,T.width,T.height)}),b.file()}function d(){let{contact:f}=Ke(n),{depths:x,times:b}=a(Ke(n)),v=[];f.time_s.forEach((w,_)=>{w<b[0]||w>b[1]||f.md_m.forEach((M,L)=>{if(M<x[0]||M>x[1])return;let P=_*f.md_m.length+L,C=t.map(({column:U,dimension:B})=>Xt(f.values[U][P],B));v.push([w,Xt(M,"length"),...C])})});let T=t.map(({title:w,dimension:_})=>`${w.toLowerCase()}, ${ie(_)}`);return[["time, s",`md, ${ie("length")}`,...T],v]}function h(f,x,b,[v,T],[w,_],M){let{contact:L}=x,P=L.md_m.length,C=new ImageData(L.time_s.length,Math.round(b.height));for(let k=0;k<C.height;k++){let H=Dl(L.md_m,v+(k+.5)/C.height*(T-v));for(let F=0;F<C.width;F++){let[j,$,Z]=M(L.values[e.column][F*P+H]||0);C.data.set([j,$,Z,255],4*(k*C.width+F))}}let U=new OffscreenCanvas(C.width,C.height);U.getContext("2d").putImageData(C,0,0),f.save(),f.beginPath(),f.rect(b.left,b.top,b.width,b.height),f.clip(),f.imageSmoothingEnabled=!1;let B=k=>b.left+(k-w)/(_-w)*b.width,I=L.from_s;L.time_s.forEach((k,H)=>{f.drawImage(U,H,0,1,C.height,B(I),b.top,B(k)-B(I)+.5,b.height),I=k}),f.restore()}function p(f,x,[b,v],[T,w],_){let M=B=>x.top+(B-b)/(v-b)*x.height,L=B=>x.left+(B-T)/(w-T)*x.width;f.fillStyle=f.strokeStyle=Se("muted"),f.textBaseline="middle",f.textAlign="right";let P=Pn(Xt(b,"length"),Xt(v,"length"),9);for(let B of P.values)f.fillText(Sn(B,P.step),x.left-8,M(kn(B,"length")));f.textAlign="center",f.textBaseline="top";let C=Pn(T,w,12);for(let B of C.values)f.fillText(Sn(B,C.step),L(B),x.top+x.height+6);f.fillText("time, s",x.left+x.width/2,x.top+x.height+20),f.save(),f.translate(9,x.top+x.height/2),f.rotate(-Math.PI/2),f.fillText(`MD, ${ie("length")}`,0,-4),f.restore(),f.strokeStyle=Se("frame"),f.strokeRect(x.left,x.top,x.width,x.height);let U=(B,I,k,H)=>{f.beginPath(),f.moveTo(B,I),f.lineTo(k,H),f.stroke()};f.strokeStyle=Se("text"),f.setLineDash([4,4]),_.window_s>T&&_.window_s<w&&(U(L(_.window_s),x.top,L(_.window_s),x.top+x.height),f.textAlign="left",f.fillStyle=Se("text"),f.fillText("window ▸",L(_.window_s)+4,x.top+4)),f.setLineDash([1,3]);for(let{kind:B,to_m:I}of n.hole)B==="casing"&&I>b&&I<v&&(U(x.left,M(I),x.left+x.width,M(I)),f.textAlign="left",f.fillStyle=Se("text"),f.fillText("shoe",x.left+4,M(I)-13));f.setLineDash([]),Lt.depth!==null&&Lt.depth>b&&Lt.depth<v&&U(x.left,M(Lt.depth),x.left+x.width,M(Lt.depth)),Lt.moment!==null&&Lt.moment>T&&Lt.moment<w&&U(L(Lt.moment),x.top,L(Lt.moment),x.top+x.height)}function g(f,x,b,v){let T=x.left+x.width+14,w=e.sides?-b:0,_=120;for(let L=0;L<_;L++){let[P,C,U]=v(w+(L+.5)/_*(b-w));f.fillStyle=`rgb(${P} ${C} ${U})`,f.fillRect(T,x.top+x.height*(1-(L+1)/_),12,x.height/_+.6)}f.strokeStyle=Se("frame"),f.strokeRect(T,x.top,12,x.height);let M=Pn(Xt(w,e.dimension),Xt(b,e.dimension),6);f.fillStyle=Se("muted"),f.textAlign="left",f.textBaseline="middle";for(let L of M.values){let P=(kn(L,e.dimension)-w)/(b-w);f.fillText(Sn(L,M.step),T+17,x.top+x.height*(1-P))}f.fillText(ie(e.dimension),T,x.top+x.height+12),e.sides&&(f.save(),f.textAlign="center",f.translate(T+66,x.top+x.height*.25),f.rotate(-Math.PI/2),f.fillText("high side",0,0),f.restore(),f.save(),f.textAlign="center",f.translate(T+66,x.top+x.height*.75),f.rotate(-Math.PI/2),f.fillText("low side",0,0),f.restore())}function y(f){let x=Ke(n);if(!x?.contact)return null;let b=i.getBoundingClientRect(),{depths:v,times:T}=a(x),w=(f.clientX-b.left-Bu)/(b.width-Bu-rx),_=(f.clientY-b.top-ku)/(b.height-ku-ox);return w<0||w>1||_<0||_>1?null:{depth:v[0]+_*(v[1]-v[0]),moment:T[0]+w*(T[1]-T[0])}}i.addEventListener("pointermove",f=>{let x=y(f);if(We({pointer:x?.depth??null}),!x)return void(s.textContent=" ");let{contact:b}=Ke(n),v=Math.min(Math.max(Array.from(b.time_s).findIndex(_=>_>=x.moment),0),b.time_s.length-1),T=b.values[e.column][v*b.md_m.length+Dl(b.md_m,x.depth)],w=!e.sides||Math.abs(T)===0?"":T>0?", high side":", low side";s.textContent=`MD ${Te(x.depth,"length",5)}, ${dn(x.moment,4)} s: ${Te(Math.abs(T),e.dimension,3)}${w}`}),i.addEventListener("pointerleave",()=>{We({pointer:null}),s.textContent=" "}),i.addEventListener("click",f=>{let x=y(f);x&&We(x)}),me("units operation depths times depth moment",l);let m=0;return new ResizeObserver(()=>{r.clientWidth!==m&&(m=r.clientWidth,l())}).observe(r),{element:z("div",{},o,r,s),redraw:l}}var lx=260;function cx(n){let t=z("div",{class:"histories"}),[e,...i]=n.drill_off_plots,s=()=>`${e.title}, ${ie(e.dimension)}`,r=[];function o(){r.forEach(y=>y.destroy()),r=[];let u=Ke(n)?.drill_off;if(!u)return t.replaceChildren();let d=u[e.column],h=Array.from(d,(y,m)=>m).filter(y=>Number.isFinite(d[y])).sort((y,m)=>d[y]-d[m]),p=({column:y,dimension:m})=>Yl(Array.from(h,f=>u[y][f]),m),g=i.map(y=>{let{heading:m,dimension:f}=y,x=z("div",{class:"plot"}),b=z("h3",{},m,z("span",{class:"unit"},` ${ie(f)}`)),v=null;b.append(vn(m,{svg:()=>da(v,`${m}, ${ie(f)}`,s()),csv:()=>$n(...fa(v,s(),ie(f)))}));let T=()=>r.push(v=a(x,y,p(e),p(y)));return{element:z("figure",{class:"card history"},b,x),make:T}});t.replaceChildren(...g.map(y=>y.element));for(let y of g)y.make()}function a(u,{title:d,dimension:h,min_span:p},g,y){let m=Rs(0);return new cn({width:Xs(u),height:lx,cursor:{drag:{x:!0,y:!0,uni:8},points:{size:6}},legend:ha,scales:{x:{time:!1,range:(f,x,b)=>Il(x,b,e.dimension,e.min_span)},y:{range:(f,x,b)=>Il(x,b,h,p)}},axes:ca(s()),series:[{label:`weight, ${ie(e.dimension)}`,value:$s},{label:d.replace(/^./,f=>f.toLowerCase()),stroke:m,paths:()=>null,points:{show:!0,size:3.5,width:0,fill:`color-mix(in srgb, ${m} 55%, transparent)`},value:$s}]},[g,y],u)}me("units operation",o);let l=0;new ResizeObserver(()=>{if(!(nn()||t.clientWidth===l)){l=t.clientWidth;for(let u of r)u.setSize({width:Xs(u.root.parentElement),height:lx})}}).observe(t);let c=z("p",{class:"note"},"Each point is a sample of the window of the statistics.");return{element:z("div",{class:"drill-off"},t,c),redraw:o}}var zu=class{well;constructor(t){this.well=t}at(t){let{md_m:e,north_m:i,east_m:s,tvd_m:r,high:o}=this.well,a=Math.min(Math.max(qs(e,t),1),e.length-1),l=(g,y)=>g[y],c=(t-l(e,a-1))/(l(e,a)-l(e,a-1)||1),u=g=>l(g,a)-l(g,a-1),d=g=>l(g,a-1)+c*u(g),h=mp([d(o[1]),-d(o[2]),-d(o[0])]),p=mp([u(s),-u(r),-u(i)]);return{place:[d(s),-d(r),-d(i)],high:h,right:mp(VE(p,h))}}},mp=([n,t,e])=>{let i=Math.hypot(n,t,e)||1;return[n/i,t/i,e/i]},VE=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],pa=class extends Gn{rings;sides;#i;#e;#t;#n;constructor(t,e){super(),this.rings=t,this.sides=e;let i=3*t*e;this.#e=new Float32Array(i),this.#t=new Float32Array(i),this.#n=new Float32Array(i).fill(1),this.setAttribute("position",new si(this.#e,3)),this.setAttribute("normal",new si(this.#t,3)),this.setAttribute("color",new si(this.#n,3));let s=[];for(let r=0;r+1<t;r++)for(let o=0;o<e;o++){let[a,l]=[r*e+o,r*e+(o+1)%e];s.push(a,l,a+e,l,l+e,a+e)}this.setIndex(s),this.#i=Array.from({length:e},(r,o)=>[Math.cos(2*Math.PI*o/e),Math.sin(2*Math.PI*o/e)])}ring(t,e,i,s,r){this.#i.forEach(([o,a],l)=>{let c=3*(t*this.sides+l);for(let u of[0,1,2]){let d=o*i[u]+a*s[u];this.#t[c+u]=d,this.#e[c+u]=e[u]+r*d}})}paint(t,e,i,s){for(let r=0;r<this.sides;r++)this.#n.set([e,i,s],3*(t*this.sides+r))}changed(){for(let t of Object.values(this.attributes))t.needsUpdate=!0;this.computeBoundingSphere()}};var GE=10;function hx(n){let t=new pa(Math.max(n,2),GE);return{mesh:new An(t,new gs({vertexColors:!0})),tube:t}}function ux(n,t,e,i,s){let r=new de;e.forEach(({depth:o,high:a,right:l,radius:c,part:u},d)=>{let h=t.at(o),[p,g]=[a*i||0,l*i||0],y=h.place.map((b,v)=>b+p*(h.high[v]??0)+g*(h.right[v]??0));n.ring(d,y,h.high,h.right,c*i);let[m,f,x]=Number.isFinite(u)?s(u).map(b=>b/255):[.5,.5,.5];r.setRGB(m??.5,f??.5,x??.5,"srgb"),n.paint(d,r.r,r.g,r.b)}),n.changed()}var Ul=.3,dx=300,HE=28;function WE(n){let t=10**Math.floor(Math.log10(Math.max(n,1)));return[5,2,1].map(e=>e*t).find(e=>e<=Math.max(n,1))??1}var fx=(n,t)=>WE(.03*n/t);function XE(n,[t,e]){let i=Array.from(n.well.md_m).filter(r=>r>t&&r<e);return[...Array.from({length:dx+1},(r,o)=>t+o*(e-t)/dx),...i].sort((r,o)=>r-o)}function px(n,t,[e,i],s){return t.flatMap(r=>{let o=[Math.max(r.from_m,e),Math.min(r.to_m,i)];if(o[1]<=o[0])return[];let a=XE(n,o),l=new pa(a.length,HE);a.forEach((h,p)=>{let{place:g,high:y,right:m}=n.at(h);l.ring(p,g,y,m,r.diameter_m/2*s)}),l.changed();let c=r.kind==="casing",u=new gs({color:Se(c?"casing":"rock"),transparent:!0,opacity:c?.16:.26,side:hi,depthWrite:!1}),d=new An(l,u);return d.renderOrder=2,[d]})}function ma(n,t,e){let[i,s]=[n.at(t[0]).place,n.at(t[1]).place],[r,o]=[s[0]-i[0],s[2]-i[2]],a=Math.hypot(r,o);if(a<.001)return[.6,e,.8];let l=r-o<0?-1:1;return[-o/a*l,e,r/a*l]}function mx(n,t,e,i){let{low:s,high:r}=Cf(t,e),o=s.clone().add(r).multiplyScalar(.5),a=Pf({low:s,high:r},ma(t,e,Ul)).flatMap(([h,p])=>[[h,s.y,p],[h,r.y,p]]),[l,c]=e,u=Array.from({length:41},(h,p)=>t.at(l+(c-l)*p/40).place),d=[...a,...u];n.lookAt(d,i,o,[84,16]),n.holder.dataset.spans=n.spans(d).map(h=>h.toFixed(2)).join(" ")}function $E(n,t){let{profile:e}=t,i=e.md_m,s=e.lateral_offset_m??qE(n,e),r=YE(e);return{depths:i,high:s.map((o,a)=>-o*Math.cos(r[a])),right:s.map((o,a)=>o*Math.sin(r[a])),values:o=>e[o],has:o=>!!e[o]&&o!=="contact_force_N"}}function qE(n,t){return t.md_m.map(e=>{let i=o=>e>=o.from_m&&e<=o.to_m,s=n.hole.find(i),r=n.string.find(i);return s&&r?(s.diameter_m-r.contact_od_m)/2:0})}function YE(n){let t=[];for(let s=0;s<n.md_m.length;s++){let r=n.climb_rad?.[s];Number.isFinite(r)?t.push([n.md_m[s],Math.cos(r),Math.sin(r)]):!n.climb_rad&&Number.isFinite(n.side_force_N_per_m?.[s])&&n.side_force_N_per_m[s]!==0&&t.push([n.md_m[s],n.side_force_N_per_m[s]>0?-1:1,0])}if(t.length===0)return n.md_m.map(()=>0);let e=[0,1,2].map(s=>Float32Array.from(t,r=>r[s])),i=(s,r)=>{let o=Yr(e[0],r,Math.min(Math.max(s,e[0][0]),e[0].at(-1)));return Number.isFinite(o)?o:0};return n.md_m.map(s=>Math.atan2(i(s,e[2]),i(s,e[1])))}function ZE(n,t){let e=n.md_m.length,i=s=>n.channels[s].subarray(t*e,(t+1)*e);return{depths:n.md_m.map(s=>s+n.moved_m[t]),high:i("offset_high_m"),right:i("offset_right_m"),values:i,has:s=>!!n.channels[s]}}function gp(n,t,e){if(t?.frames&&e!==null)return ZE(t.frames,e);let i=ls(n).find(qp);return i?$E(n,i):null}var _p=(n,t)=>n.string_colours.filter(({column:e})=>t.has(e));function gx(n,t,e,i,s){let r=(t?.frames&&e!==null?t.frames.channels[i]:n.values(i))??[],o=Array.from(r).filter(Number.isFinite).sort((u,d)=>u-d);if(o.length===0)return[0,1];let a=u=>o[Math.round(u*(o.length-1))];if(s){let u=Math.max(Math.abs(a(.01)),Math.abs(a(.99)))||1;return[-u,u]}let[l,c]=[a(.002),a(.998)];return l<c?[l,c]:[l-.5*Math.abs(l||1),c+.5*Math.abs(c||1)]}function _x(n,t){let e=Math.min(Math.max(qs(n.time_s,t),1),n.time_s.length-1);return e<1?0:t-n.time_s[e-1]<n.time_s[e]-t?e-1:e}var KE=600;function xx(n){let t=mu("The well in space, the string in it",KE);if(!t)return{element:fu(),redraw:()=>{}};let e=new zu(n.well),i=n.well.md_m.at(-1),s=Math.max(...n.hole.map(H=>H.diameter_m),.1),r=fx(i,s),o=null,a=null,l=null,c=z("div",{class:"colour-key"}),u=z("output",{}),d=z("input",{type:"range",min:0,step:1,"aria-label":"Moment",oninput:()=>{let H=Ke(n);We({moment:H.frames.time_s[Number(d.value)]})}}),h=z("button",{type:"button",onclick:()=>l?w():T()},"Play"),p=z("button",{type:"button",onclick:()=>{w(),We({moment:null})}},"Mean"),g=z("div",{class:"moments"},h,p,d,u),y=z("output",{}),m=z("input",{type:"range",min:0,max:3.7,step:.01,value:Math.log10(r),"aria-label":"Exaggeration across the hole",oninput:()=>{r=10**Number(m.value),M()}}),f=z("span",{}),x=[["From the side",()=>ma(e,_(),.02)],["From above",()=>[.001,1,.001]]].map(([H,F])=>z("button",{type:"button",onclick:()=>I(F())},H)),b=()=>{We({depths:null}),I(ma(e,_(),Ul))};x.unshift(z("button",{type:"button",onclick:b},"Whole well"));let v=z("div",{class:"tools noprint"},f,z("label",{},"Across × ",m,y),x,vn("The well in space",{png:()=>t.canvas,csv:()=>$n(...B())}),z("span",{class:"hint"},`${pu}; shows the depths in view above`));function T(){h.textContent="Stop",l=setInterval(()=>{let{frames:H}=Ke(n),F=(Number(d.value)+1)%H.time_s.length;We({moment:H.time_s[F]})},80)}function w(){clearInterval(l),l=null,h.textContent="Play"}let _=()=>Lt.depths??[n.well.md_m[0],i];function M(){t.remove();let[H,F]=_();px(e,n.hole,[H,F],r).forEach(t.add),p0(e,[H,F],s/2*r,ma(e,[H,F],Ul)).forEach(t.add),C(),y.textContent=` ${dn(r,2)}`,t.render()}let L=null,P=null;function C(){let H=Ke(n);a=H?.frames&&Lt.moment!==null?_x(H.frames,Lt.moment):null;let F=gp(n,H,a),j=F?_p(n,F):[];if(!j.length)return U();j.some(({column:qt})=>qt===o)||(o=j[0].column);let{title:$,dimension:Z,signed:nt}=j.find(({column:qt})=>qt===o);f.replaceChildren(Wl("Colour: ",j.map(({column:qt,title:te})=>[qt,te]),o,qt=>{o=qt,C(),t.render()}));let[ht,ct]=_(),tt=Array.from(F.depths,(qt,te)=>[qt,te]).filter(([qt])=>qt>=ht-1&&qt<=ct+1);if(!L||P.geometry!==L||L.rings!==tt.length){P&&t.remove([P]);let qt=hx(tt.length);L=qt.tube,P=t.add(qt.mesh)}t.has(P)||t.add(P);let mt=F.values(o),_t=gx(F,H,a,o,nt),ft=lo(nt),xt=n.string,Gt=tt.map(([qt,te])=>{let re=xt.find(Ge=>qt<=Ge.to_m)??xt.at(-1);return{depth:Math.min(qt,i),high:F.high[te],right:F.right[te],radius:(re?.od_m??.12)/2,part:(mt[te]-_t[0])/(_t[1]-_t[0])}});ux(L,e,Gt,r,ft);let ae=ie(Z)?`, ${ie(Z)}`:"",Ht=nt?" (low side −, high side +)":"";c.replaceChildren(...cu(`${$}${ae}${Ht}, ${En(Lt.operation)}`,Z,_t,ft)),g.hidden=!H?.frames,H?.frames&&(d.max=H.frames.time_s.length-1,a!==null&&(d.value=a),p.disabled=a===null,u.textContent=a===null?"mean of the window":`${H.frames.time_s[a].toFixed(2)} s`)}function U(){P&&t.remove([P]),[L,P]=[null,null],f.replaceChildren(),g.hidden=!0,c.replaceChildren(`${Lt.operation?`${En(Lt.operation)}: `:""}no model has an answer; the hole without the string`)}function B(){let H=gp(n,Ke(n),a);if(!P)return[[`md, ${ie("length")}`],[]];let{title:F,dimension:j}=_p(n,H).find(({column:ht})=>ht===o),$=H.values(o),Z=[`md, ${ie("length")}`,`to the high side, ${ie("diameter")}`,`to the right, ${ie("diameter")}`,`${F}, ${ie(j)}`],nt=Array.from(H.depths,(ht,ct)=>[Xt(ht,"length"),Xt(H.high[ct],"diameter"),Xt(H.right[ct],"diameter"),Xt($[ct],j)]);return[Z,nt]}let I=H=>mx(t,e,_(),H);function k(){t.size(),M(),I(ma(e,_(),Ul))}return me("units operation",()=>{w(),M()}),me("depths",()=>{M(),I(t.from().toArray())}),me("moment",()=>{C(),t.render()}),{element:z("div",{},v,t.holder,g,c),redraw:k}}var yx=260;function JE(n){let t=ie(n);return t===""?"1/Hz":/^\p{L}+$/u.test(t)?`${t}²/Hz`:`(${t})²/Hz`}function vx(n){let t=z("div",{class:"histories"}),e=[];function i(){let c=new Map;for(let d of Ke(n)?.spectra??[]){let h=`${d.signal} ${d.md_m!==null}`;c.has(h)||c.set(h,[]),c.get(h).push(d)}let u=d=>d.density.slice(1).some(h=>h>0);return[...c.values()].filter(d=>d.some(u))}function s(){e.forEach(u=>u.destroy()),e=[];let c=i().map(r);t.replaceChildren(...c.map(u=>u.element));for(let u of c)e.push(u.make())}function r(c){let[{signal:u,dimension:d,md_m:h}]=c,p=c.length===1&&h!==null?` at ${Te(h,"length",5)}`:"",g=`Density of ${En(u)}${p}`,y=JE(d),m=z("div",{class:"plot"}),f=null,x=z("h3",{},g,z("span",{class:"unit"},` ${y}`),vn(g,{svg:()=>da(f,`${g}, ${y}`,"Frequency, Hz"),csv:()=>$n(...fa(f,"frequency, Hz",y))})),b=()=>f=o(m,c,d,`${Ke(n).operation} ${u}`);return{element:z("figure",{class:"card history"},x,m),make:b}}function o(c,u,d,h){let p=Array.from(u[0].frequency_Hz).slice(1),g=d?Xt(1,d)**2:1,y=u.map(C=>Array.from(C.density).slice(1).map(U=>U>0?U*g:null)),m=u.length===1&&u[0].md_m===null,f=y.flat().filter(C=>C!==null),x=Math.max(...f),b=Math.max(Math.min(...f),x*1e-9),[v,T]=ca("Frequency, Hz"),w=Math.max(Math.ceil(Math.log10(x/b)/6),1),_=C=>Math.abs(Math.log10(C)-Math.round(Math.log10(C)))<1e-6,M=(C,U)=>U.map(B=>_(B)&&Math.round(Math.log10(B))%w===0?B:null),L=(C,U)=>M(C,U).map(B=>B===null?"":`1e${Math.round(Math.log10(B))}`),P=new cn({width:Xs(c),height:yx,cursor:{drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:ha,scales:{x:{time:!1,distr:3,range:(C,U,B)=>[U,B]},y:{distr:3,range:()=>[b/1.5,x*1.5]}},axes:[{...v,grid:{...v.grid,filter:M},values:(C,U)=>U.map(B=>B===null?"":String(Number(B.toPrecision(3))))},{...T,grid:{...T.grid,filter:M},values:L}],series:[{label:"frequency, Hz",value:$s},...u.map((C,U)=>({label:m?En(C.signal):`at ${Te(C.md_m,"length",5)}`,stroke:Rs(U),dash:Ar(U)??void 0,width:1.4,points:{show:!1},value:$s}))]},[p,...y],c);return Uu(P,`spectrum ${h}`),P}me("units operation",s);let a=0;new ResizeObserver(()=>{if(!(nn()||t.clientWidth===a)){a=t.clientWidth;for(let c of e)c.setSize({width:Xs(c.root.parentElement),height:yx})}}).observe(t);let l=z("p",{class:"hint noprint"},"of the window of the statistics; drag to zoom, double-click for all");return{element:z("div",{},l,t),redraw:s}}function bx(n){let{cover:t,band:e,picture:i,head:s,height:r,total:o,full:a,view:l,zoom:c,point:u,choose:d}=n,h=m=>{let[f,x]=l();return s+(m-f)/(x-f)*r},p=m=>{let f=i.getBoundingClientRect(),[x,b]=l(),v=(m.clientY-f.top)/f.height*o;return x+(v-s)/r*(b-x)},g=null;function y(m){let[f,x]=l(),b=o/i.getBoundingClientRect().height*(x-f)/r,v=T=>{let w=(m.clientY-T.clientY)*b,_=Math.min(Math.max(w,a[0]-f),a[1]-x);c([f+_,x+_])};addEventListener("pointermove",v),addEventListener("pointerup",()=>removeEventListener("pointermove",v),{once:!0})}t.addEventListener("pointerdown",m=>{if(m.button===0){if(m.shiftKey)return y(m);g={depth:p(m),y:m.clientY},t.setPointerCapture(m.pointerId)}}),t.addEventListener("pointermove",m=>{let f=p(m);if(g&&Math.abs(m.clientY-g.y)>4){let x=[h(g.depth),h(f)];e.setAttribute("y",String(Math.min(...x))),e.setAttribute("height",String(Math.max(...x)-Math.min(...x))),e.setAttribute("visibility","visible")}u(f)}),t.addEventListener("pointerup",m=>{if(!g)return;let{depth:f,y:x}=g;g=null,e.setAttribute("visibility","hidden"),Math.abs(m.clientY-x)>4?c([f,p(m)]):d(Math.min(Math.max(f,a[0]),a[1]))}),t.addEventListener("pointerleave",()=>u(null)),t.addEventListener("dblclick",()=>c(a)),t.addEventListener("wheel",m=>{if(!m.ctrlKey&&!m.metaKey)return;m.preventDefault();let f=p(m),x=Math.exp(m.deltaY*.002),[b,v]=l();c([f+(b-f)*x,f+(v-f)*x])},{passive:!1})}var jE=5,Sx=n=>n.kind==="casing"?"casing":"open hole";function Mx(n,t){let e=r=>t>=r.from_m&&t<=r.to_m,i=n.hole.find(e),s=n.string.find(e);return[i&&`${Sx(i)} ${Te(i.diameter_m,"diameter")}`,s&&`${s.name} ${Te(s.od_m,"diameter")}`].filter(r=>r!==void 0)}function wx(n,{left:t,width:e,top:i,height:s},[r,o],a){let l=t+e/2,c=Math.max(...n.hole.map(y=>y.diameter_m),...n.string.map(y=>y.contact_od_m)),u=y=>(e-22)/2*(y/c),d=wt("g",{"clip-path":"inset(0)"}),h=y=>Math.min(Math.max(a(y),i-12),i+s+12);for(let y of n.hole){if(y.to_m<r||y.from_m>o)continue;let[m,f,x]=[h(y.from_m),h(y.to_m),u(y.diameter_m)],b=wt("title",{},`${Sx(y)} ${Te(y.diameter_m,"diameter")}, ${Te(y.from_m,"length",5)} to ${Te(y.to_m,"length",5)}, friction ${y.friction}`),v=y.kind==="casing"?"bore":"rock";d.append(wt("rect",{x:l-x,y:m,width:2*x,height:Math.max(f-m,0),class:v},b));for(let T of[-1,1]){let w=l+T*x;d.append(wt("line",{x1:w,x2:w,y1:m,y2:f,class:y.kind==="casing"?"casing":"wall"})),y.kind==="casing"&&y.to_m<o&&d.append(wt("path",{d:`M${w} ${f}h${T*8}L${w} ${f-9}Z`,class:"shoe"}))}}let p=n.string.at(-1),g=p&&p.to_m-p.from_m<jE?p:null;for(let y of n.string){if(y.to_m<r||y.from_m>o)continue;let[m,f,x]=[h(y.from_m),h(y.to_m),Math.max(u(y.od_m),1.5)],b=wt("title",{},`${y.name}, OD ${Te(y.od_m,"diameter")}, ${Te(y.from_m,"length",5)} to ${Te(y.to_m,"length",5)}`),v=/pipe/i.test(y.name)&&!/heavy/i.test(y.name)?"pipe":"tool",T=y===g?wt("path",{d:`M${l-x} ${Math.min(m,f-5)}h${2*x}v${Math.max(f-m,5)*.5}L${l} ${f+3}L${l-x} ${f-Math.max(f-m,5)*.5}Z`,class:"bit"}):wt("rect",{x:l-x,y:m,width:2*x,height:Math.max(f-m,.7),class:v});T.append(b),d.append(T)}return d}function Ax(n,t,e,i){let s=a=>i.left+(a-e[0])/(e[1]-e[0])*i.width,r=wt("svg",{x:i.left,y:i.top,width:i.width,height:i.height,viewBox:`${i.left} ${i.top} ${i.width} ${i.height}`}),o=d0(Xt(e[0],t),Xt(e[1],t),i.width);for(let a of o.values){let l=s(kn(a,t)),c=Rf(l-i.left,i.width);n.append(wt("line",{x1:l,x2:l,y1:i.top,y2:i.top+i.height,class:a===0?"zero":"grid"}),wt("text",{x:l,y:i.top-7,class:`tick ${c}`},Sn(a,o.step)))}return{x:s,clip:r}}function Rx(n,{clip:t},e,i,s){let r=s.left+s.width/2;n.append(t,wt("rect",{x:s.left,y:s.top,width:s.width,height:s.height,class:"frame"}),wt("text",{x:r,y:16,class:"title middle"},e),wt("text",{x:r,y:31,class:"unit middle"},ie(i)))}var Tx=new WeakMap;function Ex(n,t,e,i,s){let r=[...e,i(0),i(1e6),s(0),s(1e6)].join(" "),o=Tx.get(t);if(o?.key===r)return o.d;let a=ex(n,t,e,i,s);return Tx.set(t,{key:r,d:a}),a}function Cx({x:n,clip:t},e,i,s,r){let o=`${i.faint?" faint":""}${i.ghost?" ghost":""}`;e.low&&e.high&&t.append(wt("path",{d:Ll(e.depths,e.low,e.high,s,n,r),fill:i.colour,class:`band${o}`})),t.append(wt("path",{d:Ex(e.depths,e.values,s,n,r),stroke:i.colour,class:`curve${o}`,"stroke-dasharray":i.dash?.join(" ")})),e.between&&t.append(wt("path",{d:Ex(e.depths,e.between,s,n,r),stroke:i.colour,class:`curve between${o}`}))}function Px({clip:n},t,e,[i,s],r){for(let{kind:o,to_m:a}of t){if(o!=="casing"||a<=i||a>=s)continue;let l=r(a);n.append(wt("line",{x1:e.left,x2:e.left+e.width,y1:l,y2:l,class:"shoe-depth"}))}}function Ix(n,[t,e],i,{axis:s,left:r,right:o,count:a=12}){let{values:l,step:c}=Pn(Xt(t,"length"),Xt(e,"length"),a);for(let u of l){let d=i(kn(u,"length"));n.append(wt("line",{x1:r,x2:o,y1:d,y2:d,class:"grid"}),wt("text",{x:s-8,y:d+4,class:"tick end"},Sn(u,c)))}n.append(wt("text",{x:0,y:16,class:"title"},"MD"),wt("text",{x:0,y:31,class:"unit"},ie("length")))}var Lx=n=>Float32Array.from(n,t=>-t);function Dx({depths:n,values:t,low:e,high:i},s){let{joint_reach_m:r,min_difference:o}=s,a=nx(n,t,r),l=p=>Float32Array.from(a,g=>p[g]??NaN),c={values:l(t),low:e&&l(e),high:i&&l(i)},u=Lx(Ou(n,Lx(t),r)),d=c.values.reduce((p,g)=>Math.max(p,Math.abs(g)),0);return u.some((p,g)=>Math.abs(p-(c.values[g]??NaN))>o*d)?{...c,between:u}:c}function QE(n,t){if(t.from==="well"){let e=n.well[t.column];return e?.length?[{depths:n.well.md_m,values:e,well:!0}]:[]}return n.solved.flatMap(e=>{let i=t.from==="wear"?e.wear:e.profile,s=i[t.column],r=i.md_m;if(!s||!r)return[];let[o,a]=(t.band??[]).map(c=>i[c]),l={solved:e,depths:r,values:s,low:o,high:a};return t.touches&&(l.values=Ou(r,s,n.rules.joint_reach_m)),t.swings&&(l.far=Dx(l,n.rules)),[l]})}var Nx=n=>n.tracks.map(t=>({...t,curves:QE(n,t)})).filter(t=>t.curves.length),xp=(n,t)=>Math.abs(t)<1e-4*n.min_span?0:t,Ol=n=>n.well||!Lt.hidden.has(jl(n.solved));function Ux(n,t,[e,i]){let s=i-e>n.rules.far_m;return t.curves.filter(Ol).map(r=>s&&r.far?{...r,...r.far}:r)}function Ox(n,t){let e=n.solved.map(a=>{let{colour:l,dash:c,shape:u,hollow:d}=sr(n,a),h=jl(a),p=Lt.hidden.has(h),g=Ql(n,a);return z("button",{type:"button",class:"key","aria-pressed":String(!p),title:p?`Show ${g}`:`Hide ${g}`,onclick:()=>{let y=new Set(Lt.hidden);y.delete(h)||y.add(h),We({hidden:y}),document.querySelector(`.legend [data-curve="${h}"]`)?.focus()},"data-curve":h},wt("svg",{width:30,height:12},wt("line",{x1:1,x2:29,y1:6,y2:6,stroke:l,class:"curve","stroke-dasharray":c?.join(" ")}),u&&wt("path",{d:u,transform:"translate(15 6)",fill:d?"var(--paper)":l,stroke:d?l:"var(--paper)",class:"marker"})),g)}),i=[...new Set(co(n).map(a=>a.severity))].reverse().map(a=>z("span",{class:"key"},wt("svg",{width:20,height:12},wt("rect",{width:20,height:12,class:`found level-${a}`}),wt("rect",{x:15,width:5,height:12,class:`found-bar level-${a}`})),`${ci[a][0].toLowerCase()} here, ${En(Lt.operation)}`)),s=n.runs.length?[z("span",{class:"key"},wt("svg",{width:26,height:10},wt("rect",{width:26,height:10,fill:"var(--muted)",class:"band"})),"5–95 % of the time")]:[],r=t?[z("span",{class:"key"},wt("svg",{width:30,height:12},wt("line",{x1:1,x2:29,y1:6,y2:6,stroke:"var(--muted)",class:"curve between"})),"between the joints")]:[],o=["high","low"].map(a=>z("span",{class:"key"},wt("svg",{width:14,height:10},wt("rect",{width:14,height:10,class:`${a}-side`})),`on the ${a} side`));return[...e,...r,...s,...o,...i]}function kx(n,t,e){let{tail:i,times_as_long:s,fewest:r}=e,o=Float64Array.from(n.filter(Number.isFinite)).sort(),a=o.length-1,[l,c]=[o[0],o[a]];if(l===void 0||c===void 0)return[1/0,-1/0];if(o.length<r)return[l,c];let u=Math.ceil(i*o.length),[d,h]=[o[u],o[a-u]];t&&([d,h]=[Math.min(d,0),Math.max(h,0)]);let p=(s-1)*(h-d);return p===0?[l,c]:[o.find(g=>d-g<=p)??l,o.findLast(g=>g-h<=p)??c]}var Fx=7,Bx=4;function zx(n,t,e,i,s,r){return[-1,1].flatMap(o=>{let a=d=>o>0?d>e[1]:d<e[0],l=o>0?i.left+i.width:i.left,c=[],u=null;for(let{depths:d,columns:h,colour:p}of n){let[g,y]=qr(d,s);for(let m of h){let f=null;for(let x=g;x<=y;x++){let[b,v]=[m[x],d[x]],T=x<y&&a(b)&&v>=s[0]&&v<=s[1];if(T&&(f===null||o*b>o*f.value)&&(f={value:b,depth:v}),T||f===null)continue;let w=r(f.depth),_=l-o*Fx,M=`M${l} ${w}L${_} ${w-Bx}V${w+Bx}Z`;c.push(wt("path",{d:M,fill:p,class:"beyond"})),(!u||o*f.value>o*u.value)&&(u={value:f.value,at:w}),f=null}}}if(u){let d=Math.min(Math.max(u.at,i.top+8),i.top+i.height-8),h={x:l-o*(Fx+3),y:d+4,class:`beyond-value${o>0?" end":""}`};c.push(wt("text",h,dn(Xt(u.value,t))))}return c})}var Vx=5,Gx=n=>n.from==="profile"&&!n.range;function tA(n,t,e,i){let s=e.flatMap(o=>[o.values,o.low,o.high,o.between].filter(Boolean).map(a=>[o.depths,a])),r=Gx(t)?kx(s.flatMap(([o,a])=>Array.from(a.slice(...qr(o,i)))),t.zero,n.rules.outliers):s.map(([o,a])=>tx(o,a,i)).reduce(([o,a],l)=>[Math.min(o,l[0]),Math.max(a,l[1])],[1/0,-1/0]);return f0(...r,t.zero||t.sides,kn(1,t.dimension),t.min_span)}function Hx(n,t,e,i,[s,r],o){let a=[s,r],l=Ux(n,e,a),c=e.range??tA(n,e,l,a),u=Ax(t,e.dimension,c,i),{x:d,clip:h}=u;Px(u,n.hole,i,a,o),nA(n,h,i,a,o),e.sides&&iA(n,h,e,a,d,o);for(let g of l){let{colour:y,dash:m,shape:f,place:x,hollow:b}=g.well?{colour:"var(--text)"}:sr(n,g.solved),v=!g.well&&ir(n).length>1&&g.solved.operation!==Lt.operation;Cx(u,g,{colour:y,dash:m,faint:v},a,o),f&&h.append(...eA(n,g,{colour:y,shape:f,place:x,hollow:b,faint:v},a,d,o))}if(e.sides&&sA(n,h,i,a,o),e.touches&&rA(n,h,e,i,a,o),Rx(t,u,e.title,e.dimension,i),e.sides&&t.append(wt("text",{x:i.left,y:i.top+i.height+14,class:"side low"},"◂ low side"),wt("text",{x:i.left+i.width,y:i.top+i.height+14,class:"side high end"},"high side ▸")),l.some(g=>g.between)&&t.append(wt("text",{x:i.left,y:i.top+i.height+14,class:"side"},"··· between joints")),Gx(e)){let g=f=>[f.values,f.between].filter(Boolean),y=f=>f.well?"var(--text)":sr(n,f.solved).colour,m=l.map(f=>({depths:f.depths,columns:g(f),colour:y(f)}));t.append(...zx(m,e.dimension,c,i,a,o))}e.touches&&t.append(wt("text",{x:i.left,y:i.top+i.height+14,class:"side"},"▌ always ",wt("tspan",{class:"sometimes"},"▌")," at times"));let p=wt("text",{x:i.left+i.width/2,y:48,class:"readout middle"});return t.append(p),{text:p,curves:l}}function eA(n,t,{colour:e,shape:i,place:s,hollow:r,faint:o},[a,l],c,u){let d=h=>(h+(s+(r?1.5:1))/(ir(n).length+1.5))/Vx;return Array.from({length:Vx},(h,p)=>a+d(p)*(l-a)).map(h=>[h,Yr(t.depths,t.values,h)]).filter(([h,p])=>Number.isFinite(p)&&h<=t.depths.at(-1)).map(([h,p])=>wt("path",{d:i,transform:`translate(${c(p).toFixed(1)} ${u(h).toFixed(1)})`,fill:r?"var(--paper)":e,stroke:r?e:"var(--paper)",class:`marker${o?" faint":""}`}))}function nA(n,t,e,[i,s],r){for(let{severity:o,md_m:a,to_md_m:l}of co(n)){if(a>s||(l??a)<i)continue;let[c,u]=[r(a),r(l??a)],d=Math.max(u-c,2),h={y:c,height:d},p=l!==null;if(p&&t.append(wt("rect",{x:e.left,width:e.width,...h,class:`found level-${o}`})),t.append(wt("rect",{x:e.left+e.width-5,width:5,...h,class:`found-bar level-${o}`})),o!=="error"&&p)for(let g=c+6;g<u;g+=o==="warning"?10:6)t.append(wt("rect",{x:e.left+e.width-5,width:5,y:g,height:3,fill:"var(--paper)"}))}}function iA(n,t,e,i,s,r){let o=ls(n)[0],a=e.curves.find(u=>u.solved===o);if(!a||!Ol(a))return;let l=new Float32Array(a.values.length),c=u=>a.values.map(d=>u(d)?d:0);t.append(wt("path",{d:Ll(a.depths,l,c(u=>u>0),i,s,r),class:"high-side"}),wt("path",{d:Ll(a.depths,c(u=>u<0),l,i,s,r),class:"low-side"}))}function sA(n,t,e,[i,s],r){let o=ls(n)[0]?.cutoff_depth_m??null;if(o===null||o<i||o>s)return;let[a,l]=[e.left,e.left+e.width],c=`cut-off ${dn(Xt(o,"length"),5)}`;t.append(wt("line",{x1:a,x2:l,y1:r(o),y2:r(o),class:"cut-off"}),wt("text",{x:l-4,y:r(o)-4,class:"side end"},c))}function rA(n,t,e,i,s,r){let o=Zp(n),a=e.curves.find(h=>h.solved===o);if(!a)return;let l=h=>h<.01?0:h<=.99?1:2,c=0,{depths:u,values:d}=a;for(let h=1;h<=d.length;h++){if(h<d.length&&l(d[h])===l(d[c]))continue;let p=l(d[c]),[g,y]=[r(u[c]),r(u[Math.min(h,d.length-1)])];p>0&&y>i.top&&g<i.top+i.height&&t.append(wt("rect",{x:i.left,y:g,width:6,height:Math.max(y-g,.7),class:p===2?"always":"sometimes"})),c=h}}var oA=700,aA=126,lA=120,Oi=54,Fl=88,Bl=14,Ss=82,cA=20;function Wx(n){let t=Nx(n),e=Math.max(n.well.md_m.at(-1)??0,...n.solved.map(T=>T.profile.md_m?.at(-1)??0)),i=[0,e],s=()=>Lt.depths??i,r=z("div",{class:"tracks"}),o=[],a=["from","to"].map((T,w)=>z("input",{type:"number","aria-label":`Depths in view, ${T}`,step:"any",onchange:_=>{let M=[...s()];M[w]=kn(Number(_.target.value),"length"),p(M)}})),l=z("span",{}),c=z("button",{type:"button",onclick:()=>p(i)},"All depths"),u=z("div",{class:"tools noprint"},z("label",{},"Depths from ",a[0]),z("label",{},"to ",a[1]),l,c,vn("Along the hole",{svg:()=>ho(o.map(T=>T.picture)),csv:()=>$n(...d())}),z("span",{class:"hint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all"));function d(){let[T,w]=s(),_=t.flatMap(M=>M.curves.filter(Ol).flatMap(L=>{let{solved:P,depths:C,values:U,low:B,high:I}=L,k=(F,j)=>F?Xt(F[j],M.dimension):null,H=P?[P.operation,P.model]:["",""];return Array.from(C,(F,j)=>[F,j]).filter(([F])=>F>=T&&F<=w).map(([F,j])=>[M.title,ie(M.dimension),...H,Xt(F,"length"),k(U,j),k(B,j),k(I,j)])}));return[["quantity","unit","operation","model",`md, ${ie("length")}`,"value","p05","p95"],_]}function h({md_m:T,to_md_m:w}){let _=Math.max((w??T)-T,.02*e);p([T-.1*_,(w??T)+.1*_]),r.scrollIntoView({block:"nearest"})}function p([T,w]){let[_,M]=[Math.max(Math.min(T,w),i[0]),Math.min(Math.max(T,w),i[1])];M-_>=2&&We({depths:_<=i[0]&&M>=i[1]?null:[_,M]})}function g(){let T=nn()?oA:r.clientWidth||1360,w=nn()?lA:aA,_=Math.max(Math.floor((T-Oi-Fl-Bl)/(w+Bl)),1),M=Math.ceil(t.length/Math.min(_,t.length)),L=Math.ceil(t.length/M),P=M===1?640:nn()?370:500;o=Array.from({length:M},(B,I)=>y(t.slice(I*L,(I+1)*L),T,L,P)),r.replaceChildren(...o.map(B=>B.picture));let[C,U]=s();a[0].value=Xt(C,"length").toFixed(1),a[1].value=Xt(U,"length").toFixed(1),l.textContent=ie("length"),c.disabled=Lt.depths===null,f()}function y(T,w,_,M){let[L,P]=s(),C=ft=>Ss+(ft-L)/(P-L)*M,U=Ss+M+cA,B=wt("svg",{viewBox:`0 0 ${w} ${U}`,width:w,height:U,role:"img","aria-label":T.map(ft=>ft.title).join(", ")}),I=Oi+Fl+Bl,k=(w-I-Bl*(_-1)-2)/_;Ix(B,[L,P],C,{axis:Oi,left:I,right:w});let H={left:Oi,width:Fl,top:Ss,height:M},F=wt("svg",{x:0,y:Ss-10,width:w,height:M+18,viewBox:`0 ${Ss-10} ${w} ${M+18}`});F.append(wx(n,H,[L,P],C)),B.append(F,wt("text",{x:Oi+Fl/2,y:16,class:"title middle"},"Hole, string"));let j=T.map((ft,xt)=>{let Gt={left:I+xt*(k+Bl),width:k,top:Ss,height:M};return{track:ft,box:Gt,...Hx(n,B,ft,Gt,[L,P],C)}}),$=wt("line",{x1:Oi,x2:w,class:"cursor",visibility:"hidden"}),Z=wt("line",{x1:Oi,x2:w,class:"chosen",visibility:"hidden"}),nt=wt("text",{x:w-4,class:"side end",visibility:"hidden"}),ht=wt("text",{x:2,class:"flag",visibility:"hidden"}),ct=wt("g",{class:"readout"}),tt=wt("rect",{x:Oi,width:w-Oi,class:"drag",visibility:"hidden"}),mt=wt("rect",{x:Oi,y:Ss,width:w-Oi,height:M,class:"cover"});return B.append(tt,Z,nt,$,ht,ct,mt),mt.addEventListener("pointermove",ft=>m(ft,B,j,[L,P],M)),mt.addEventListener("pointerleave",Ca),bx({cover:mt,band:tt,picture:B,head:Ss,height:M,total:U,full:i,view:s,zoom:p,point:ft=>We({pointer:ft}),choose:ft=>We({depth:ft})}),{picture:B,y:C,readouts:j,cursor:$,chosenLine:Z,chosenName:nt,flag:ht,what:ct}}function m(T,w,_,[M,L],P){let C=w.getBoundingClientRect(),U=w.viewBox.baseVal.width/C.width,B=(T.clientX-C.left)*U,I=M+((T.clientY-C.top)*U-Ss)/P*(L-M),k=_.find(({box:j})=>B>=j.left&&B<=j.left+j.width),H=(k?.curves??[]).flatMap(j=>{let $=j.well?"well":Ql(n,j.solved),Z=(nt,ht)=>{let ct=xp(k.track,Yr(j.depths,nt,I));return{colour:j.well?"var(--text)":sr(n,j.solved).colour,text:`${$}${ht}: ${Number.isFinite(ct)?Te(ct,k.track.dimension):"–"}`,class:!j.well&&j.solved.operation===Lt.operation?"mine":null}};return j.between?[Z(j.values,", at the joints"),Z(j.between,", between the joints")]:[Z(j.values,"")]}),F=.006*(L-M);for(let j of co(n).reverse()){let{severity:$,label:Z,md_m:nt,to_md_m:ht}=j;if(I<nt-F||I>(ht??nt)+F)continue;let[ct]=ci[$];H.push({colour:Ju($),text:`${ct}: ${Z}`})}if(H.length===0)return Ca();nc(T,[k?.track.title,`MD ${Te(I,"length",5)}`].filter(Boolean).join(", "),H)}function f(){let[T,w]=s();for(let{y:_,readouts:M,cursor:L,chosenLine:P,chosenName:C,flag:U,what:B}of o){let I=(j,$)=>{let Z=$!==null&&$>=T&&$<=w;if(j.setAttribute("visibility",Z?"visible":"hidden"),Z)for(let nt of["y1","y2"])j.setAttribute(nt,_($));return Z},k=I(P,Lt.depth);C.setAttribute("visibility",k?"visible":"hidden");let H=k?_(Lt.depth):0;C.setAttribute("y",H<Ss+16?H+13:H-4),C.textContent=k?`chosen depth ${wa(Lt.depth)}`:"";let F=I(L,Lt.pointer);U.setAttribute("visibility",F?"visible":"hidden"),U.setAttribute("y",F?_(Lt.pointer)+4:0),U.textContent=F?dn(Xt(Lt.pointer,"length"),5):"",B.replaceChildren(...(F?Mx(n,Lt.pointer):[]).map((j,$)=>wt("text",{x:Oi+Fl/2,y:34+13*$,class:"readout middle small"},j.length>24?`${j.slice(0,23)}…`:j)));for(let{track:j,curves:$,text:Z}of M)Z.replaceChildren(...F?x(j,$):[])}}function x(T,w){return w.filter(M=>M.well||M.solved.operation===Lt.operation).map((M,L)=>{let P=xp(T,Yr(M.depths,M.values,Lt.pointer)),C=M.well?"var(--text)":sr(n,M.solved).colour;return wt("tspan",{fill:C,dx:L?6:0},Number.isFinite(P)?dn(Xt(P,T.dimension)):"–")})}let b=z("div",{class:"legend"}),v=()=>{g();let T=o.some(w=>w.readouts.some(({curves:_})=>_.some(M=>M.between)));b.replaceChildren(...Ox(n,T))};return me("units depths operation hidden",v),me("pointer depth",f),new ResizeObserver(()=>!nn()&&r.clientWidth!==Number(o[0]?.picture.getAttribute("width"))&&g()).observe(r),{element:z("div",{},b,u,r),redraw:v,full:i,zoomTo:h}}function hA(n,t){let e=ec(n).filter(r=>t.includes(r.solved.operation));if(!e.length||e[0].severity==="note")return null;let i=e.filter(r=>r.severity===e[0].severity).map(r=>r.solved.operation),s=r=>i.filter(o=>o===r).length;return i.reduce((r,o)=>s(o)>s(r)?o:r)}function uA(n,t){let e=Aa(n,t).filter(s=>s.severity!=="note"),i=e.length?`${En(t)}: ${Zl(e)}`:null;return[t,[En(t),...Wp(e)],i]}function Xx(n){let t=ir(n),e=Kp(n),i=e.length?e:t,s=n.runs.filter(m=>i.includes(m.operation)).at(-1);Object.assign(Lt,{operation:hA(n,i)??s?.operation??i.at(-1),depth:(n.well.md_m.at(-1)??0)/2});let r={keyResults:hm(n),tracks:Wx(n)};r.checks=tm(n,r.tracks.zoomTo),r.checkTable=em(n),n.runs.length&&(r.history=pp(n,n.time_plots,!0),r.contact=ax(n)),n.runs.some(m=>m.drill_off)&&(r.bit=pp(n,n.bit_plots,!1),r.drillOff=cx(n)),n.runs.some(m=>m.spectra.length)&&(r.spectra=vx(n)),n.runs.some(m=>m.bottom)&&(r.bottom=xu(()=>Ke(n)?.bottom,!0)),n.well.md_m.length>1&&(r.scene=xx(n));let o=()=>Object.values(r).forEach(m=>ed(m.redraw)),a=(m,f,...x)=>z("section",{id:m},z("h2",{},f),x),l=m=>n.page_tables.filter(f=>f.place===m).map(hs);function c(m){let f=m.history.time_s?.length??0,x=f<m.samples?`${m.samples} samples are drawn as ${f}, the smallest and the largest of each few: peaks keep their height`:`all ${m.samples} samples are drawn`,{frames:b}=m,v=b&&(b.time_s.length<b.kept?`; ${b.time_s.length} of ${b.kept} frames`:`; all ${b.kept} frames`),T=b&&b.md_m.length<b.nodes?`, ${b.md_m.length} of ${b.nodes} nodes`:"";return`${En(m.operation)}: ${x}${v??""}${T}.`}let u=document.getElementById("page"),d=t.length>1?Tr("Operation",t.map(m=>uA(n,m)),Lt.operation,m=>We({operation:m,times:null,moment:null})):null;u.append(go(n.title,fo(n),o),a("answer","Answer",r.checks.element,d&&z("div",{class:"operations"},d),r.keyResults.element,r.checkTable.element),a("tracks","Along the hole",r.tracks.element));let h=[],p=(m,...f)=>h.push([a(...f),m]);if(r.history&&p(m=>m,"history","In time",r.history.element),r.spectra&&p(m=>m?.spectra.length,"spectra","Spectra",r.spectra.element),r.bit&&p(m=>m?.drill_off,"bit","Bit",r.bit.element,r.drillOff.element),r.bottom){let m=z("p",{class:"note"},"As the operation left it.");p(f=>f?.bottom,"bottom","Bottom of the hole",r.bottom.element,m)}r.contact&&p(m=>m?.contact,"contact","Contact over depth and time",r.contact.element),u.append(...h.map(([m])=>m)),r.scene&&u.append(a("scene","In space",r.scene.element)),u.append(a("results","All numbers",l("results")),...n.runs.length?[a("numerics","Numerics",l("numerics"))]:[],a("inputs","Inputs, defaults included",l("inputs")),z("footer",{},z("p",{},`Made by ${n.program}. The tables beside this file hold every digit; this page holds what can be seen. `,n.runs.map(c).join(" ")),mo()));let g=po([...u.querySelectorAll("section")]);u.querySelector("header").after(g.element);let y=()=>{h.forEach(([m,f])=>m.toggleAttribute("hidden",!f(Ke(n)))),g.redraw();for(let m of u.querySelectorAll(".operations button"))m.setAttribute("aria-pressed",String(m.dataset.value===Lt.operation))};me("operation",y),y(),o()}function $x(n,t){Lt.units=sc("units",Xl)??t,Vp(n,()=>Lt.units),me("units",()=>rc("units",Lt.units))}var kl=T0();$x(kl.dimensions,kl.units);var dA=kl.sweeps?mm:kl.bottoms?M0:Xx;dA(kl);document.documentElement.dataset.ready="";})();

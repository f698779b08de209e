(()=>{var W0="http://www.w3.org/2000/svg";function md(n,t,e){for(let[i,s]of Object.entries(t??{}))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):n.setAttribute(i,s===!0?"":s));for(let i of e.flat(3))i!=null&&n.append(i);return n}function ht(n,t,...e){return md(document.createElement(n),t,e)}function ne(n,t,...e){return md(document.createElementNS(W0,n),t,e)}function nr(n,t,e,i){let s=t.map(([r,o])=>ht("button",{type:"button","aria-pressed":String(r===e),"data-value":r,onclick:a=>{for(let l of s)l.setAttribute("aria-pressed",String(l===a.currentTarget));i(r)}},o));return ht("div",{class:"choice",role:"group","aria-label":n},s)}function gd(n,t,e,i){return ht("label",{class:"select"},n,ht("select",{onchange:s=>i(s.target.value)},t.map(([s,r])=>ht("option",{value:s,selected:s===e},r))))}var qa=new Map,Qt={units:"si",theme:"auto",operation:null,depths:null,times:null,depth:null,moment:null,pointer:null};function dn(n,t){for(let e of n.split(" "))qa.has(e)||qa.set(e,[]),qa.get(e).push(t)}function rn(n){let t=new Set;for(let[e,i]of Object.entries(n))if(!Object.is(Qt[e],i)){Qt[e]=i;for(let s of qa.get(e)??[])t.add(s)}for(let e of t)e()}var X0=["si","metric","field"],_d={};function xd(n){_d=n}function Ya(n){return _d[n]?.[X0.indexOf(Qt.units)]??{symbol:"",factor:1}}var Rn=n=>Ya(n).symbol,De=(n,t)=>n/Ya(t).factor,Li=(n,t)=>n*Ya(t).factor;function yd(n,t){let e=Ya(t).factor;return Array.from(n,i=>Number.isFinite(i)?i/e:null)}function Un(n,t=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.abs(n);if(e>=1e9||e<1e-4){let[r,o]=n.toExponential(t-1).split("e");return`${vd(String(Number(r)))}·10${q0(Number(o))}`}let i=Math.floor(Math.log10(e))+1,s=Math.min(Math.max(t-i,0),6);return Ls(n.toFixed(s))}function q0(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}var vd=n=>n.replace("-","−");function Ls(n){let[t,e]=n.split("."),i=t.replace("-","").length>4?t.replace(/\B(?=(\d{3})+$)/g," "):t;return vd(e===void 0?i:`${i}.${e}`)}function $a(n,t=6){let e=Un(n,t);return/\.\d*0$/.test(e)?e.replace(/\.?0+$/,""):e}function pn(n,t,e=4,i=Un){let s=Rn(t),r=i(De(n,t),e);return s===""?r:`${r} ${s}`}var Sd=n=>Number.isInteger(n)&&Math.abs(n)<1e12?Ls(String(n)):$a(n);function ir(n,t){return n===null||n===""?"–":typeof n=="string"?n:typeof n=="number"?Sd(n):pn(n.value,n.dimension,t??6,t?Un:$a)}function Y0(n){return n===null||typeof n!="object"?ir(n):$a(De(n.value,n.dimension))}function bd(n,t=0){if(n===null||typeof n!="object")return ir(n);let e=r=>Math.abs(r)<1e-6*t?0:r,i=e(De(n.value,n.dimension)),s=n.dimension==="ratio"&&Number.isInteger(i)?Sd(i):Un(i,5);return n.std===void 0?s:`${s} ± ${Un(e(De(n.std,n.dimension)),2)}`}function wd(n){let t=new Set(n.filter(e=>e!==null&&typeof e=="object").map(e=>e.dimension));return t.size===1?[...t][0]:null}var Td=n=>n&&Rn(n)!==""?ht("span",{class:"unit"},` ${Rn(n)}`):null,Ed=n=>typeof n=="string";function $0(n){let t=e=>Math.max(...e.map(i=>i?.dimension?Math.abs(De(i.value,i.dimension)):0));return n.rows.map(([e,...i])=>ht("tr",{},ht("th",{scope:"row"},e,Td(wd(i))),i.map(s=>ht("td",{class:"number"},bd(s,t(i))))))}function Md(n,t){return n.rows.map(e=>ht("tr",{},e.map(i=>ht("td",{class:Ed(i)?null:"number"},t(i)))))}function Z0(n){return n.rows.map(([t,e])=>ht("tr",{},ht("th",{scope:"row"},t),ht("td",{},ir(e))))}function Ad(n){let t=ht("tbody",{}),e=ht("thead",{}),i=n.place==="cases",s=n.place!=="inputs"&&!i,r=()=>s?$0(n):i?Md(n,bd):n.heads.length?Md(n,Y0):Z0(n),o=()=>{t.replaceChildren(...r());let c=f=>s?null:Td(wd(n.rows.map(d=>d[f])));n.heads.length&&e.replaceChildren(ht("tr",{},n.heads.map((f,d)=>{let u=i&&n.rows.every(h=>Ed(h[d]));return ht("th",{scope:"col",class:u?"words":null},f,c(d))})))};dn("units",o),o();let a=ht("div",{class:"scrolls"},ht("table",{class:n.heads.length?"grid":"keys"},e,t));if(s||i)return ht("div",{class:i?"sheet cases":"sheet"},ht("h3",{},n.title),a);let l=n.rows.length>24;return ht("details",{class:`sheet prints${n.heads.length>4?" wide":""}`,open:!l},ht("summary",{},n.title,l?` (${n.rows.length} rows)`:""),a)}var on=n=>getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim(),Fo=n=>on(`line-${n%7}`);function Rd(n){let t=parseInt(n.slice(1),16);return[t>>16,t>>8&255,t&255]}var J0=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"].map(Rd);function K0(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,o)=>r+s*(n[i+1][o]-r))}var Fh=512;function Za(n){let t=n?["low-side-strong","low-side","middle","high-side","high-side-strong"].map(i=>Rd(on(i))):J0,e=Array.from({length:Fh+1},(i,s)=>K0(t,s/Fh));return i=>e[Math.round(Math.min(Math.max(i,0),1)*Fh)]}var sr=n=>n.replaceAll("_"," "),Ja=n=>n==="soft"?"soft string":"dynamics",Nr=n=>[...new Set(n.solved.map(t=>t.operation))];function Ka(n,t){let e=Nr(n),i=t.model==="soft",s=new Set(n.solved.map(o=>o.model)).size>1,r=e.indexOf(t.operation);return{colour:Fo(e.length===1&&s&&i?1:r),dashed:s&&i}}function Cd(n,t){return Nr(n).length===1?Ja(t.model):new Set(n.solved.map(i=>i.model)).size===1?sr(t.operation):`${sr(t.operation)}, ${Ja(t.model)}`}var Mi=(n,t)=>n.solved.find(e=>e.operation===Qt.operation&&e.model===t),Xn=n=>n.runs.find(t=>t.operation===Qt.operation);function Pd(n){let t=ht("dl",{class:"asked"}),e=()=>t.replaceChildren(...n.asked.map(({label:i,value:s})=>ht("div",{},ht("dt",{},i),ht("dd",{},ir(s)))));return dn("units",e),e(),t}function j0(n){return n>1?["over","over the limit"]:n>.8?["near","near the limit"]:["within","within the limit"]}function Q0(n,t){let e=n.value?.dimension,i=[ht("h3",{},n.label),ht("p",{class:"number"},ir(n.value,e==="ratio"||e==="percent"?3:4))];n.worst!==null&&e&&i.push(ht("p",{class:"note"},`mean; at most ${pn(n.worst,e)}`)),t?.value?.dimension===e&&e&&i.push(ht("p",{class:"note"},`soft string ${ir(t.value,4)}`));let s=n.worst??n.value?.value;if(n.limit!==null&&Number.isFinite(s)){let r=s/n.limit,[o,a]=j0(r);i.push(ht("div",{class:`limit ${o}`},ht("div",{class:"bar"},ht("div",{class:"used",style:`width:${Math.min(Math.max(r,0),1)*100}%`})),ht("p",{class:"note"},ht("strong",{},`${Math.round(r*100)} %, ${a}`),ht("br"),`${n.limit_label} ${e==="percent"||e==="ratio"?"":pn(n.limit,e)}`)))}else i.push(ht("p",{class:"note"},n.limit_label));return ht("div",{class:"card answer"},i)}function Id(n){let t=ht("div",{}),e=()=>{let i=Mi(n,"dynamic"),s=Mi(n,"soft"),r=i??s,o=l=>i&&s?.answers.find(c=>c.label===l.label),a=[i,s].filter(l=>l?.message).map(l=>ht("p",{class:"warning"},`${Ja(l.model)}: ${l.message}`));t.replaceChildren(...a,ht("div",{class:"answers"},r.answers.map(l=>Q0(l,o(l)))))};return dn("units operation",e),{element:t,redraw:e}}var t_="uplot",e_="u-hz",n_="u-vt",i_="u-title",s_="u-wrap",r_="u-under",o_="u-over",a_="u-axis",ar="u-off",l_="u-select",c_="u-cursor-x",h_="u-cursor-y",u_="u-cursor-pt",f_="u-legend",d_="u-live",p_="u-inline",m_="u-series",g_="u-marker",Ld="u-label",__="u-value",Bo="width",zo="height";var Dd="bottom",Ur="left",Oh="right",tu="#000",Nd=tu+"0",Bh="mousemove",Ud="mousedown",zh="mouseup",Fd="mouseenter",Od="mouseleave",Bd="dblclick",x_="resize",y_="scroll",zd="change",nl="dppxchange",eu="--",Gr=typeof window<"u",Wh=Gr?document:null,Or=Gr?window:null,v_=Gr?navigator:null,Pe,ja;function Xh(){let n=devicePixelRatio;Pe!=n&&(Pe=n,ja&&Yh(zd,ja,Xh),ja=matchMedia(`(min-resolution: ${Pe-.001}dppx) and (max-resolution: ${Pe+.001}dppx)`),lr(zd,ja,Xh),Or.dispatchEvent(new CustomEvent(nl)))}function oi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function qh(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ze(n,t,e){n.style[t]=e+"px"}function Di(n,t,e,i){let s=Wh.createElement(n);return t!=null&&oi(s,t),e?.insertBefore(s,i),s}function Si(n,t){return Di("div",n,t)}var kd=new WeakMap;function Ki(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=kd.get(n);r!=o&&(n.style.transform=r,kd.set(n,r),t<0||e<0||t>i||e>s?oi(n,ar):qh(n,ar))}var Vd=new WeakMap;function Gd(n,t,e){let i=t+e,s=Vd.get(n);i!=s&&(Vd.set(n,i),n.style.background=t,n.style.borderColor=e)}var Hd=new WeakMap;function Wd(n,t,e,i){let s=t+""+e,r=Hd.get(n);s!=r&&(Hd.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var nu={passive:!0},M_={...nu,capture:!0};function lr(n,t,e,i){t.addEventListener(n,e,i?M_:nu)}function Yh(n,t,e,i){t.removeEventListener(n,e,nu)}Gr&&Xh();function Ni(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ai((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function xp(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var yp=n=>n!=null,vp=n=>n!=null&&n>0,rl=xp(yp),S_=xp(vp);function b_(n,t,e,i=0,s=!1){let r=s?S_:rl,o=s?vp:yp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let f=n[c];o(f)&&(f<a?a=f:f>l&&(l=f))}return[a??Ve,l??-Ve]}function ol(n,t,e,i){let s=Yd(n),r=Yd(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?hs:Mp,a=s==1?ai:bi,l=r==1?bi:ai,c=a(o(yn(n))),f=l(o(yn(t))),d=Br(e,c),u=Br(e,f);return e==10&&(c<0&&(d=Ge(d,-c)),f<0&&(u=Ge(u,-f))),i||e==2?(n=d*s,t=u*r):(n=Tp(n,d),t=al(t,u)),[n,t]}function iu(n,t,e,i){let s=ol(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var su=.1,Xd={mode:3,pad:su},Vo={pad:0,soft:null,mode:0},w_={min:Vo,max:Vo};function il(n,t,e,i){return ll(e)?qd(n,t,e):(Vo.pad=e,Vo.soft=i?0:null,Vo.mode=i?3:0,qd(n,t,w_))}function Ee(n,t){return n??t}function T_(n,t,e){for(t=Ee(t,0),e=Ee(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function qd(n,t,e){let i=e.min,s=e.max,r=Ee(i.pad,0),o=Ee(s.pad,0),a=Ee(i.hard,-Ve),l=Ee(s.hard,Ve),c=Ee(i.soft,Ve),f=Ee(s.soft,-Ve),d=Ee(i.mode,0),u=Ee(s.mode,0),h=t-n,m=hs(h),y=qn(yn(n),yn(t)),g=hs(y),p=yn(g-m);(h<1e-24||p>10)&&(h=0,(n==0||t==0)&&(h=1e-24,d==2&&c!=Ve&&(r=0),u==2&&f!=-Ve&&(o=0)));let v=h||y||1e3,w=hs(v),M=Br(10,ai(w)),R=v*(h==0?n==0?.1:1:r),A=Ge(Tp(n-R,M/10),24),_=n>=c&&(d==1||d==3&&A<=c||d==2&&A>=c)?c:Ve,S=qn(a,A<_&&n>=_?_:Ui(_,A)),I=v*(h==0?t==0?.1:1:o),C=Ge(al(t+I,M/10),24),P=t<=f&&(u==1||u==3&&C>=f||u==2&&C<=f)?f:-Ve,O=Ui(l,C>P&&t<=P?P:qn(P,C));return S==O&&S==0&&(O=100),[S,O]}var E_=new Intl.NumberFormat(Gr?v_.language:"en-US"),ru=n=>E_.format(n),li=Math,el=li.PI,yn=li.abs,ai=li.floor,xn=li.round,bi=li.ceil,Ui=li.min,qn=li.max,Br=li.pow,Yd=li.sign,hs=li.log10,Mp=li.log2,A_=(n,t=1)=>li.sinh(n)*t,kh=(n,t=1)=>li.asinh(n/t),Ve=1/0;function $d(n){return(hs((n^n>>31)-(n>>31))|0)+1}function $h(n,t,e){return Ui(qn(n,t),e)}function Sp(n){return typeof n=="function"}function Se(n){return Sp(n)?n:()=>n}var R_=()=>{},bp=n=>n,wp=(n,t)=>t,C_=n=>null,Zd=n=>!0,Jd=(n,t)=>n==t,P_=/\.\d*?(?=9{6,}|0{6,})/gm,cr=n=>{if(Ap(n)||Ns.has(n))return n;let t=`${n}`,e=t.match(P_);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${cr(s)}e${r}`}return Ge(n,i)};function rr(n,t){return cr(Ge(cr(n/t))*t)}function al(n,t){return cr(bi(cr(n/t))*t)}function Tp(n,t){return cr(ai(cr(n/t))*t)}function Ge(n,t=0){if(Ap(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return xn(i)/e}var Ns=new Map;function Ep(n){return((""+n).split(".")[1]||"").length}function Ho(n,t,e,i){let s=[],r=i.map(Ep);for(let o=t;o<e;o++){let a=yn(o),l=Ge(Br(n,o),a);for(let c=0;c<i.length;c++){let f=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?f:Ge(f,d);s.push(u),Ns.set(u,d)}}return s}var Go={},ou=[],zr=[null,null],Ds=Array.isArray,Ap=Number.isInteger,I_=n=>n===void 0;function Kd(n){return typeof n=="string"}function ll(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function L_(n){return n!=null&&typeof n=="object"}var D_=Object.getPrototypeOf(Uint8Array),Rp="__proto__";function kr(n,t=ll){let e;if(Ds(n)){let i=n.find(s=>s!=null);if(Ds(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=kr(n[s],t)}else e=n.slice()}else if(n instanceof D_)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Rp&&(e[i]=kr(n[i],t))}else e=n;return e}function mn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Rp&&(ll(n[s])?mn(n[s],kr(i[s])):n[s]=kr(i[s]))}return n}var N_=0,U_=1,F_=2;function O_(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function B_(n,t){if(V_(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return G_(o[0])||(o=k_(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let f=0;f<c;f++)e.add(l[f])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let f=a[c],d=Array(s).fill(void 0),u=t?t[o][c]:U_,h=[];for(let m=0;m<f.length;m++){let y=f[m],g=r.get(l[m]);y===null?u!=N_&&(d[g]=y,u==F_&&h.push(g)):d[g]=y}O_(d,h,s),i.push(d)}}return i}var z_=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function k_(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function V_(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function G_(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=qn(1,ai((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Cp=["January","February","March","April","May","June","July","August","September","October","November","December"],Pp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Ip(n){return n.slice(0,3)}var H_=Pp.map(Ip),W_=Cp.map(Ip),X_={MMMM:Cp,MMM:W_,WWWW:Pp,WWW:H_};function Oo(n){return(n<10?"0":"")+n}function q_(n){return(n<10?"00":n<100?"0":"")+n}var Y_={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Oo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Oo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Oo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Oo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Oo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>q_(n.getMilliseconds())};function au(n,t){t=t||X_;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Y_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var $_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Z_(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==$_?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Lp=n=>n%1==0,sl=[1,2,2.5,5],J_=Ho(10,-32,0,sl),Dp=Ho(10,0,32,sl),K_=Dp.filter(Lp),or=J_.concat(Dp),lu=`
`,Np="{YYYY}",jd=lu+Np,Up="{M}/{D}",ko=lu+Up,Qa=ko+"/{YY}",Fp="{aa}",j_="{h}:{mm}",Fr=j_+Fp,Qd=lu+Fr,tp=":{ss}",Ne=null;function Op(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ho(10,0,3,sl).filter(Lp):Ho(10,-3,0,sl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Np,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",jd,Ne,Ne,Ne,Ne,Ne,1],[s,Up,jd,Ne,Ne,Ne,Ne,Ne,1],[i,"{h}"+Fp,Qa,Ne,ko,Ne,Ne,Ne,1],[e,Fr,Qa,Ne,ko,Ne,Ne,Ne,1],[t,tp,Qa+" "+Fr,Ne,ko+" "+Fr,Ne,Qd,Ne,1],[n,tp+".{fff}",Qa+" "+Fr,Ne,ko+" "+Fr,Ne,Qd,Ne,1]];function f(d){return(u,h,m,y,g,p)=>{let v=[],w=g>=o,M=g>=r&&g<o,R=d(m),A=Ge(R*n,3),_=Vh(R.getFullYear(),w?0:R.getMonth(),M||w?1:R.getDate()),S=Ge(_*n,3);if(M||w){let I=M?g/r:0,C=w?g/o:0,P=A==S?A:Ge(Vh(_.getFullYear()+C,_.getMonth()+I,1)*n,3),O=new Date(xn(P/n)),k=O.getFullYear(),N=O.getMonth();for(let V=0;P<=y;V++){let W=Vh(k+C*V,N+I*V,1),z=W-d(Ge(W*n,3));P=Ge((+W+z)*n,3),P<=y&&v.push(P)}}else{let I=g>=s?s:g,C=ai(m)-ai(A),P=S+C+al(A-S,I);v.push(P);let O=d(P),k=O.getHours()+O.getMinutes()/e+O.getSeconds()/i,N=g/i,V=u.axes[h]._space,W=p/V;for(;P=Ge(P+g,n==1?0:3),!(P>y);)if(N>1){let z=ai(Ge(k+N,6))%24,Z=d(P).getHours()-z;Z>1&&(Z=-1),P-=Z*i,k=(k+N)%24;let et=v[v.length-1];Ge((P-et)/g,3)*W>=.7&&v.push(P)}else v.push(P)}return v}}return[l,c,f]}var[Q_,tx,ex]=Op(1),[nx,ix,sx]=Op(.001);Ho(2,-53,53,[1]);function ep(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function np(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,f,d,u,h;return i.map(m=>{let y=n(m),g=y.getFullYear(),p=y.getMonth(),v=y.getDate(),w=y.getHours(),M=y.getMinutes(),R=y.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||v!=f&&a[4]||w!=d&&a[5]||M!=u&&a[6]||R!=h&&a[7]||a[1];return l=g,c=p,f=v,d=w,u=M,h=R,A(y)})}}function rx(n,t){let e=au(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Vh(n,t,e){return new Date(n,t,e)}function ip(n,t){return t(n)}var ox="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function sp(n,t){return(e,i,s,r)=>r==null?eu:t(n(i))}function ax(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function lx(n,t){return n.series[t].fill(n,t)}var cx={show:!0,live:!0,isolate:!1,mount:R_,markers:{show:!0,width:2,stroke:ax,fill:lx,dash:"solid"},idx:null,idxs:null,values:[]};function hx(n,t){let e=n.cursor.points,i=Si(),s=e.size(n,t);Ze(i,Bo,s),Ze(i,zo,s);let r=s/-2;Ze(i,"marginLeft",r),Ze(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ze(i,"borderWidth",o),i}function ux(n,t){let e=n.series[t].points;return e._fill||e._stroke}function fx(n,t){let e=n.series[t].points;return e._stroke||e._fill}function dx(n,t){return n.series[t].points.size}var Gh=[0,0];function px(n,t,e){return Gh[0]=t,Gh[1]=e,Gh}function tl(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Hh(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var mx={show:!0,x:!0,y:!0,lock:!1,move:px,points:{one:!1,show:hx,size:dx,width:0,stroke:fx,fill:ux},bind:{mousedown:tl,mouseup:tl,click:tl,dblclick:tl,mousemove:Hh,mouseleave:Hh,mouseenter:Hh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Bp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},cu=mn({},Bp,{filter:wp}),zp=mn({},cu,{size:10}),kp=mn({},Bp,{show:!1}),hu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Vp="bold "+hu,Gp=1.5,rp={show:!0,scale:"x",stroke:tu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Vp,side:2,grid:cu,ticks:zp,border:kp,font:hu,lineGap:Gp,rotate:0},gx="Value",_x="Time",op={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function xx(n,t,e,i,s){return t.map(r=>r==null?"":ru(r))}function yx(n,t,e,i,s,r,o){let a=[],l=Ns.get(s)||0;e=o?e:Ge(al(e,s),l);for(let c=e;c<=i;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Zh(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?hs:Mp,f=ai(c(e));s=Br(l,f),l==10&&(s=or[Ni(s,or)]);let d=e,u=s*l;l==10&&(u=or[Ni(u,or)]);do a.push(d),d=d+s,l==10&&!Ns.has(d)&&(d=Ge(d,Ns.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=or[Ni(u,or)]));while(d<=i);return a}function vx(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Zh(n,t,qn(l,e),i,s):[l],f=i>=0&&e<=0?[0]:[];return(e<-l?Zh(n,t,qn(l,-i),-e,s):[l]).reverse().map(u=>-u).concat(f,c)}var Hp=/./,Mx=/[12357]/,Sx=/[125]/,ap=/1/,Jh=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function bx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,f=l(10,o),d=l(9,o)-f>=c?Hp:l(7,o)-f>=c?Mx:l(5,o)-f>=c?Sx:ap;if(d==ap){let u=yn(l(1,o)-f);if(u<c)return Jh(t.slice().reverse(),a.distr,d,bi(c/u)).reverse()}return Jh(t,a.distr,d,1)}function wx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=yn(l(1,o)-l(2,o));return c<a?Jh(t.slice().reverse(),3,Hp,bi(a/c)).reverse():t}function Tx(n,t,e,i){return i==null?eu:t==null?"":ru(t)}var lp={show:!0,scale:"y",stroke:tu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Vp,side:3,grid:cu,ticks:zp,border:kp,font:hu,lineGap:Gp,rotate:0};function Ex(n,t){let e=3+(n||1)*2;return Ge(e*t,3)}function Ax(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=yn(o-r),l=n.series[t],c=a/(l.points.space*Pe);return i[1]-i[0]<=c}var cp={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},Wp=(n,t,e,i,s)=>s,hp={show:!0,auto:!0,sorted:0,gaps:Wp,alpha:1,facets:[mn({},cp,{scale:"x"}),mn({},cp,{scale:"y"})]},up={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Wp,alpha:1,points:{show:Ax,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function Rx(n,t,e,i,s){return e/10}var Xp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Cx=mn({},Xp,{time:!1,ori:1}),fp={};function qp(n,t){let e=fp[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let f=0;f<e.plots.length;f++)e.plots[f]!=s&&e.plots[f].pub(i,s,r,o,a,l,c)}},n!=null&&(fp[n]=e)),e}var Vr=1,Kh=2;function hr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],f=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,h=a.top,m=a.width,y=a.height,g=n.valToPosH,p=n.valToPosV;return f.ori==0?e(s,l,c,f,d,g,p,u,h,m,y,hl,Hr,fl,$p,Jp):e(s,l,c,f,d,p,g,h,u,y,m,ul,Wr,du,Zp,Kp)}function uu(n,t){let e=0,i=0,s=Ee(n.bands,ou);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Px(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function us(n,t,e,i,s,r){return hr(n,t,(o,a,l,c,f,d,u,h,m,y,g)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),w=c.ori==0?Hr:Wr,M,R;v==1?(M=e,R=i):(M=i,R=e);let A=p(d(a[M],c,y,h)),_=p(u(l[M],f,g,m)),S=p(d(a[R],c,y,h)),I=p(u(r==1?f.max:f.min,f,g,m)),C=new Path2D(s);return w(C,S,I),w(C,A,I),w(C,A,_),C})}function cl(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?fl:du,l=e;for(let d=0;d<n.length;d++){let u=n[d];if(u[1]>u[0]){let h=u[0]-l;h>0&&a(o,l,i,h,i+r),l=u[1]}}let c=e+s-l,f=10;c>0&&a(o,l,i-f/2,c,i+r+f)}return o}function Ix(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function fu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,u=c;if(s==1)for(;++c<=i&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let h=r(n[d]),m=u==d?h:r(n[u]),y=d-s;h=o<=0&&y>=0&&y<l?r(n[y]):h;let p=u+s;m=o>=0&&p>=0&&p<l?r(n[p]):m,m>=h&&a.push([h,m])}return a}function dp(n){return n==0?bp:n==1?xn:t=>rr(t,n)}function Yp(n){let t=n==0?hl:ul,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,f=0)=>{c==0&&f==0?i(s,r,o,a,l):(c=Ui(c,a/2,l/2),f=Ui(f,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,f),e(s,r,o+l,r,o,f),e(s,r,o,r+a,o,c),s.closePath())}}var hl=(n,t,e)=>{n.moveTo(t,e)},ul=(n,t,e)=>{n.moveTo(e,t)},Hr=(n,t,e)=>{n.lineTo(t,e)},Wr=(n,t,e)=>{n.lineTo(e,t)},fl=Yp(0),du=Yp(1),$p=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Zp=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Jp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Kp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function jp(n){return(t,e,i,s,r)=>hr(t,e,(o,a,l,c,f,d,u,h,m,y,g)=>{let{pxRound:p,points:v}=o,w,M;c.ori==0?(w=hl,M=$p):(w=ul,M=Zp);let R=Ge(v.width*Pe,3),A=(v.size-v.width)/2*Pe,_=Ge(A*2,3),S=new Path2D,I=new Path2D,{left:C,top:P,width:O,height:k}=t.bbox;fl(I,C-_,P-_,O+_*2,k+_*2);let N=V=>{if(l[V]!=null){let W=p(d(a[V],c,y,h)),z=p(u(l[V],f,g,m));w(S,W+A,z),M(S,W,z,A,0,el*2)}};if(r)r.forEach(N);else for(let V=i;V<=s;V++)N(V);return{stroke:R>0?S:null,fill:S,clip:I,flags:Vr|Kh}})}function Qp(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var Lx=Qp(Hr),Dx=Qp(Wr);function tm(n){let t=Ee(n?.alignGaps,0);return(e,i,s,r)=>hr(e,i,(o,a,l,c,f,d,u,h,m,y,g)=>{[s,r]=rl(l,s,r);let p=o.pxRound,v=k=>p(d(k,c,y,h)),w=k=>p(u(k,f,g,m)),M,R;c.ori==0?(M=Hr,R=Lx):(M=Wr,R=Dx);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vr},S=_.stroke,I=!1;if(r-s>=y*4){let k=rt=>e.posToVal(rt,c.key,!0),N=null,V=null,W,z,tt,X=v(a[A==1?s:r]),Z=v(a[s]),et=v(a[r]),st=k(A==1?Z+1:et-1);for(let rt=A==1?s:r;rt>=s&&rt<=r;rt+=A){let j=a[rt],pt=(A==1?j<st:j>st)?X:v(j),xt=l[rt];pt==X?xt!=null?(z=xt,N==null?(M(S,pt,w(z)),W=N=V=z):z<N?N=z:z>V&&(V=z)):xt===null&&(I=!0):(N!=null&&R(S,X,w(N),w(V),w(W),w(z)),xt!=null?(z=xt,M(S,pt,w(z)),N=V=W=z):(N=V=null,xt===null&&(I=!0)),X=pt,st=k(X+A))}N!=null&&N!=V&&tt!=X&&R(S,X,w(N),w(V),w(W),w(z))}else for(let k=A==1?s:r;k>=s&&k<=r;k+=A){let N=l[k];N===null?I=!0:N!=null&&M(S,v(a[k]),w(N))}let[P,O]=uu(e,i);if(o.fill!=null||P!=0){let k=_.fill=new Path2D(S),N=o.fillTo(e,i,o.min,o.max,P),V=w(N),W=v(a[s]),z=v(a[r]);A==-1&&([z,W]=[W,z]),M(k,z,V),M(k,W,V)}if(!o.spanGaps){let k=[];I&&k.push(...fu(a,l,s,r,A,v,t)),_.gaps=k=o.gaps(e,i,s,r,k),_.clip=cl(k,c.ori,h,m,y,g)}return O!=0&&(_.band=O==2?[us(e,i,s,r,S,-1),us(e,i,s,r,S,1)]:us(e,i,s,r,S,O)),_})}function Nx(n){let t=Ee(n.align,1),e=Ee(n.ascDesc,!1),i=Ee(n.alignGaps,0),s=Ee(n.extend,!1);return(r,o,a,l)=>hr(r,o,(c,f,d,u,h,m,y,g,p,v,w)=>{[a,l]=rl(d,a,l);let M=c.pxRound,{left:R,width:A}=r.bbox,_=Z=>M(m(Z,u,v,g)),S=Z=>M(y(Z,h,w,p)),I=u.ori==0?Hr:Wr,C={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vr},P=C.stroke,O=u.dir*(u.ori==0?1:-1),k=S(d[O==1?a:l]),N=_(f[O==1?a:l]),V=N,W=N;s&&t==-1&&(W=R,I(P,W,k)),I(P,N,k);for(let Z=O==1?a:l;Z>=a&&Z<=l;Z+=O){let et=d[Z];if(et==null)continue;let st=_(f[Z]),rt=S(et);t==1?I(P,st,k):I(P,V,rt),I(P,st,rt),k=rt,V=st}let z=V;s&&t==1&&(z=R+A,I(P,z,k));let[tt,X]=uu(r,o);if(c.fill!=null||tt!=0){let Z=C.fill=new Path2D(P),et=c.fillTo(r,o,c.min,c.max,tt),st=S(et);I(Z,z,st),I(Z,W,st)}if(!c.spanGaps){let Z=[];Z.push(...fu(f,d,a,l,O,_,i));let et=c.width*Pe/2,st=e||t==1?et:-et,rt=e||t==-1?-et:et;Z.forEach(j=>{j[0]+=st,j[1]+=rt}),C.gaps=Z=c.gaps(r,o,a,l,Z),C.clip=cl(Z,u.ori,g,p,v,w)}return X!=0&&(C.band=X==2?[us(r,o,a,l,P,-1),us(r,o,a,l,P,1)]:us(r,o,a,l,P,X)),C})}function pp(n,t,e,i,s,r,o=Ve){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let f=yn(n[l]-n[a]);f<c&&(c=f,o=yn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function Ux(n){n=n||Go;let t=Ee(n.size,[.6,Ve,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Se(s),o=1-t[0],a=Ee(t[1],Ve),l=Ee(t[2],1),c=Ee(n.disp,Go),f=Ee(n.each,h=>{}),{fill:d,stroke:u}=c;return(h,m,y,g)=>hr(h,m,(p,v,w,M,R,A,_,S,I,C,P)=>{let O=p.pxRound,k=e,N=i*Pe,V=a*Pe,W=l*Pe,z,tt;M.ori==0?[z,tt]=r(h,m):[tt,z]=r(h,m);let X=M.dir*(M.ori==0?1:-1),Z=M.ori==0?fl:du,et=M.ori==0?f:(Pt,Ft,Jt,bt,Fe,Gt,Kt)=>{f(Pt,Ft,Jt,Fe,bt,Kt,Gt)},st=Ee(h.bands,ou).find(Pt=>Pt.series[0]==m),rt=st!=null?st.dir:0,j=p.fillTo(h,m,p.min,p.max,rt),dt=O(_(j,R,P,I)),pt,xt,St,Wt=C,gt=O(p.width*Pe),yt=!1,Xt=null,qt=null,Yt=null,ie=null;d!=null&&(gt==0||u!=null)&&(yt=!0,Xt=d.values(h,m,y,g),qt=new Map,new Set(Xt).forEach(Pt=>{Pt!=null&&qt.set(Pt,new Path2D)}),gt>0&&(Yt=u.values(h,m,y,g),ie=new Map,new Set(Yt).forEach(Pt=>{Pt!=null&&ie.set(Pt,new Path2D)})));let{x0:se,size:Ae}=c;if(se!=null&&Ae!=null){k=1,v=se.values(h,m,y,g),se.unit==2&&(v=v.map(Jt=>h.posToVal(S+Jt*C,M.key,!0)));let Pt=Ae.values(h,m,y,g);Ae.unit==2?xt=Pt[0]*C:xt=A(Pt[0],M,C,S)-A(0,M,C,S),Wt=pp(v,w,A,M,C,S,Wt),St=Wt-xt+N}else Wt=pp(v,w,A,M,C,S,Wt),St=Wt*o+N,xt=Wt-St;St<1&&(St=0),gt>=xt/2&&(gt=0),St<5&&(O=bp);let ge=St>0,we=Wt-St-(ge?gt:0);xt=O($h(we,W,V)),pt=(k==0?xt/2:k==X?0:xt)-k*X*((k==0?N/2:0)+(ge?gt/2:0));let ce={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},He=yt?null:new Path2D,Le=null;if(st!=null)Le=h.data[st.series[1]];else{let{y0:Pt,y1:Ft}=c;Pt!=null&&Ft!=null&&(w=Ft.values(h,m,y,g),Le=Pt.values(h,m,y,g))}let Re=z*xt,F=tt*xt;for(let Pt=X==1?y:g;Pt>=y&&Pt<=g;Pt+=X){let Ft=w[Pt];if(Ft==null)continue;if(Le!=null){let q=Le[Pt]??0;if(Ft-q==0)continue;dt=_(q,R,P,I)}let Jt=M.distr!=2||c!=null?v[Pt]:Pt,bt=A(Jt,M,C,S),Fe=_(Ee(Ft,j),R,P,I),Gt=O(bt-pt),Kt=O(qn(Fe,dt)),L=O(Ui(Fe,dt)),b=Kt-L;if(Ft!=null){let q=Ft<0?F:Re,ut=Ft<0?Re:F;yt?(gt>0&&Yt[Pt]!=null&&Z(ie.get(Yt[Pt]),Gt,L+ai(gt/2),xt,qn(0,b-gt),q,ut),Xt[Pt]!=null&&Z(qt.get(Xt[Pt]),Gt,L+ai(gt/2),xt,qn(0,b-gt),q,ut)):Z(He,Gt,L+ai(gt/2),xt,qn(0,b-gt),q,ut),et(h,m,Pt,Gt-gt/2,L,xt+gt,b)}}return gt>0?ce.stroke=yt?ie:He:yt||(ce._fill=p.width==0?p._fill:p._stroke??p._fill,ce.width=0),ce.fill=yt?qt:He,ce})}function Fx(n,t){let e=Ee(t?.alignGaps,0);return(i,s,r,o)=>hr(i,s,(a,l,c,f,d,u,h,m,y,g,p)=>{[r,o]=rl(c,r,o);let v=a.pxRound,w=z=>v(u(z,f,g,m)),M=z=>v(h(z,d,p,y)),R,A,_;f.ori==0?(R=hl,_=Hr,A=Jp):(R=ul,_=Wr,A=Kp);let S=f.dir*(f.ori==0?1:-1),I=w(l[S==1?r:o]),C=I,P=[],O=[];for(let z=S==1?r:o;z>=r&&z<=o;z+=S)if(c[z]!=null){let X=l[z],Z=w(X);P.push(C=Z),O.push(M(c[z]))}let k={stroke:n(P,O,R,_,A,v),fill:null,clip:null,band:null,gaps:null,flags:Vr},N=k.stroke,[V,W]=uu(i,s);if(a.fill!=null||V!=0){let z=k.fill=new Path2D(N),tt=a.fillTo(i,s,a.min,a.max,V),X=M(tt);_(z,C,X),_(z,I,X)}if(!a.spanGaps){let z=[];z.push(...fu(l,c,r,o,S,w,e)),k.gaps=z=a.gaps(i,s,r,o,z),k.clip=cl(z,f.ori,m,y,g,p)}return W!=0&&(k.band=W==2?[us(i,s,r,o,N,-1),us(i,s,r,o,N,1)]:us(i,s,r,o,N,W)),k})}function Ox(n){return Fx(Bx,n)}function Bx(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),f=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)f[u]=t[u+1]-t[u],d[u]=n[u+1]-n[u],c[u]=f[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+d[u]/3,t[u]+l[u]*d[u]/3,n[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,n[u+1],t[u+1])}return a}var jh=new Set;function mp(){for(let n of jh)n.syncRect(!0)}Gr&&(lr(x_,Or,mp),lr(y_,Or,mp,!0),lr(nl,Or,()=>{Cn.pxRatio=Pe}));var zx=tm(),kx=jp();function gp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Qh(r,o,t,e))}function Vx(n,t){return n.map((e,i)=>i==0?{}:mn({},t,e))}function Qh(n,t,e,i){return mn({},t==0?e:i,n)}function em(n,t,e){return t==null?zr:[t,e]}var Gx=em;function Hx(n,t,e){return t==null?zr:il(t,e,su,!0)}function nm(n,t,e,i){return t==null?zr:ol(t,e,n.scales[i].log,!1)}var Wx=nm;function im(n,t,e,i){return t==null?zr:iu(t,e,n.scales[i].log,!1)}var Xx=im;function qx(n,t,e,i,s){let r=qn($d(n),$d(t)),o=t-n,a=Ni(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Ns.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function _p(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=xn((e=+s)*Pe))+"px"),[n,t,e]}function Yx(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ge(t[2]*Pe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Cn(n,t,e){let i={mode:Ee(n.mode,1)},s=i.mode;function r(x,T,D,U){let H=T.valToPct(x);return U+D*(T.dir==-1?1-H:H)}function o(x,T,D,U){let H=T.valToPct(x);return U+D*(T.dir==-1?H:1-H)}function a(x,T,D,U){return T.ori==0?r(x,T,D,U):o(x,T,D,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Si(t_);if(n.id!=null&&(c.id=n.id),oi(c,n.class),n.title){let x=Si(i_,c);x.textContent=n.title}let f=Di("canvas"),d=i.ctx=f.getContext("2d"),u=Si(s_,c);lr("click",u,x=>{x.target===m&&(qe!=Cr||Ke!=Pr)&&Ln.click(i,x)},!0);let h=i.under=Si(r_,u);u.appendChild(f);let m=i.over=Si(o_,u);n=kr(n);let y=+Ee(n.pxAlign,1),g=dp(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let p=n.ms||.001,v=i.series=s==1?gp(n.series||[],op,up,!1):Vx(n.series||[null],hp),w=i.axes=gp(n.axes||[],rp,lp,!0),M=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=Se(x.fill||null),x.dir=Ee(x.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ls,series:xe},S=(n.drawOrder||["axes","series"]).map(x=>_[x]);function I(x){let T=x.distr==3?D=>hs(D>0?D:x.clamp(i,D,x.min,x.max,x.key)):x.distr==4?D=>kh(D,x.asinh):x.distr==100?D=>x.fwd(D):D=>D;return D=>{let U=T(D),{_min:H,_max:K}=x,ct=K-H;return(U-H)/ct}}function C(x){let T=M[x];if(T==null){let D=(n.scales||Go)[x]||Go;if(D.from!=null){C(D.from);let U=mn({},M[D.from],D,{key:x});U.valToPct=I(U),M[x]=U}else{T=M[x]=mn({},x==A?Xp:Cx,D),T.key=x;let U=T.time,H=T.range,K=Ds(H);if((x!=A||s==2&&!U)&&(K&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Xd:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Xd:{mode:1,hard:H[1],soft:H[1]}},K=!1),!K&&ll(H))){let ct=H;H=(mt,Tt,Ut)=>Tt==null?zr:il(Tt,Ut,ct)}T.range=Se(H||(U?Gx:x==A?T.distr==3?Wx:T.distr==4?Xx:em:T.distr==3?nm:T.distr==4?im:Hx)),T.auto=Se(K?!1:T.auto),T.clamp=Se(T.clamp||Rx),T._min=T._max=null,T.valToPct=I(T)}}}C("x"),C("y"),s==1&&v.forEach(x=>{C(x.scale)}),w.forEach(x=>{C(x.scale)});for(let x in n.scales)C(x);let P=M[A],O=P.distr,k,N;P.ori==0?(oi(c,e_),k=r,N=o):(oi(c,n_),k=o,N=r);let V={};for(let x in M){let T=M[x];(T.min!=null||T.max!=null)&&(V[x]={min:T.min,max:T.max},T.min=T.max=null)}let W=n.tzDate||(x=>new Date(xn(x/p))),z=n.fmtDate||au,tt=p==1?ex(W):sx(W),X=np(W,ep(p==1?tx:ix,z)),Z=sp(W,ip(ox,z)),et=[],st=i.legend=mn({},cx,n.legend),rt=i.cursor=mn({},mx,{drag:{y:s==2}},n.cursor),j=st.show,dt=rt.show,pt=st.markers;st.idxs=et,pt.width=Se(pt.width),pt.dash=Se(pt.dash),pt.stroke=Se(pt.stroke),pt.fill=Se(pt.fill);let xt,St,Wt,gt=[],yt=[],Xt,qt=!1,Yt={};if(st.live){let x=v[1]?v[1].values:null;qt=x!=null,Xt=qt?x(i,1,0):{_:0};for(let T in Xt)Yt[T]=eu}if(j)if(xt=Di("table",f_,c),Wt=Di("tbody",null,xt),st.mount(i,xt),qt){St=Di("thead",null,xt,Wt);let x=Di("tr",null,St);Di("th",null,x);for(var ie in Xt)Di("th",Ld,x).textContent=ie}else oi(xt,p_),st.live&&oi(xt,d_);let se={show:!0},Ae={show:!1};function ge(x,T){if(T==0&&(qt||!st.live||s==2))return zr;let D=[],U=Di("tr",m_,Wt,Wt.childNodes[T]);oi(U,x.class),x.show||oi(U,ar);let H=Di("th",null,U);if(pt.show){let mt=Si(g_,H);if(T>0){let Tt=pt.width(i,T);Tt&&(mt.style.border=Tt+"px "+pt.dash(i,T)+" "+pt.stroke(i,T)),mt.style.background=pt.fill(i,T)}}let K=Si(Ld,H);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,T>0&&(pt.show||(K.style.color=x.width>0?pt.stroke(i,T):pt.fill(i,T)),ce("click",H,mt=>{if(rt._lock)return;re(mt);let Tt=v.indexOf(x);if((mt.ctrlKey||mt.metaKey)!=st.isolate){let Ut=v.some((Ot,zt)=>zt>0&&zt!=Tt&&Ot.show);v.forEach((Ot,zt)=>{zt>0&&Yi(zt,Ut?zt==Tt?se:Ae:se,!0,fn.setSeries)})}else Yi(Tt,{show:!x.show},!0,fn.setSeries)},!1),oe&&ce(Fd,H,mt=>{rt._lock||(re(mt),Yi(v.indexOf(x),Lr,!0,fn.setSeries))},!1));for(var ct in Xt){let mt=Di("td",__,U);mt.textContent="--",D.push(mt)}return[U,D]}let we=new Map;function ce(x,T,D,U=!0){let H=we.get(T)||{},K=rt.bind[x](i,T,D,U);K&&(lr(x,T,H[x]=K),we.set(T,H))}function He(x,T,D){let U=we.get(T)||{};for(let H in U)(x==null||H==x)&&(Yh(H,T,U[H]),delete U[H]);x==null&&we.delete(T)}let Le=0,Re=0,F=0,Pt=0,Ft=0,Jt=0,bt=Ft,Fe=Jt,Gt=F,Kt=Pt,L=0,b=0,q=0,ut=0;i.bbox={};let at=!1,vt=!1,wt=!1,nt=!1,ot=!1,_t=!1;function B(x,T,D){(D||x!=i.width||T!=i.height)&&lt(x,T),de(!1),wt=!0,vt=!0,Nn()}function lt(x,T){i.width=Le=F=x,i.height=Re=Pt=T,Ft=Jt=0,Et(),$t();let D=i.bbox;L=D.left=rr(Ft*Pe,.5),b=D.top=rr(Jt*Pe,.5),q=D.width=rr(F*Pe,.5),ut=D.height=rr(Pt*Pe,.5)}let it=3;function At(){let x=!1,T=0;for(;!x;){T++;let D=Er(T),U=qi(T);x=T==it||D&&U,x||(lt(i.width,i.height),vt=!0)}}function Mt({width:x,height:T}){B(x,T)}i.setSize=Mt;function Et(){let x=!1,T=!1,D=!1,U=!1;w.forEach((H,K)=>{if(H.show&&H._show){let{side:ct,_size:mt}=H,Tt=ct%2,Ut=H.label!=null?H.labelSize:0,Ot=mt+Ut;Ot>0&&(Tt?(F-=Ot,ct==3?(Ft+=Ot,U=!0):D=!0):(Pt-=Ot,ct==0?(Jt+=Ot,x=!0):T=!0))}}),Wi[0]=x,Wi[1]=D,Wi[2]=T,Wi[3]=U,F-=Ci[1]+Ci[3],Ft+=Ci[3],Pt-=Ci[2]+Ci[0],Jt+=Ci[0]}function $t(){let x=Ft+F,T=Jt+Pt,D=Ft,U=Jt;function H(K,ct){switch(K){case 1:return x+=ct,x-ct;case 2:return T+=ct,T-ct;case 3:return D-=ct,D+ct;case 0:return U-=ct,U+ct}}w.forEach((K,ct)=>{if(K.show&&K._show){let mt=K.side;K._pos=H(mt,K._size),K.label!=null&&(K._lpos=H(mt,K.labelSize))}})}if(rt.dataIdx==null){let x=rt.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let D=x.prox=Se(x.prox),U=x.bias??=0;rt.dataIdx=(H,K,ct,mt)=>{if(K==0)return ct;let Tt=ct,Ut=D(H,K,ct,mt)??Ve,Ot=Ut>=0&&Ut<Ve,zt=P.ori==0?F:Pt,ue=rt.left,Ce=t[0],Te=t[K];if(T.has(Te[ct])){Tt=null;let ve=null,ee=null,Zt;if(U==0||U==-1)for(Zt=ct;ve==null&&Zt-- >0;)T.has(Te[Zt])||(ve=Zt);if(U==0||U==1)for(Zt=ct;ee==null&&Zt++<Te.length;)T.has(Te[Zt])||(ee=Zt);if(ve!=null||ee!=null)if(Ot){let $e=ve==null?-1/0:k(Ce[ve],P,zt,0),nn=ee==null?1/0:k(Ce[ee],P,zt,0),An=ue-$e,ke=nn-ue;An<=ke?An<=Ut&&(Tt=ve):ke<=Ut&&(Tt=ee)}else Tt=ee==null?ve:ve==null?ee:ct-ve<=ee-ct?ve:ee}else Ot&&yn(ue-k(Ce[ct],P,zt,0))>Ut&&(Tt=null);return Tt}}let re=x=>{rt.event=x};rt.idxs=et,rt._lock=!1;let ft=rt.points;ft.show=Se(ft.show),ft.size=Se(ft.size),ft.stroke=Se(ft.stroke),ft.width=Se(ft.width),ft.fill=Se(ft.fill);let kt=i.focus=mn({},n.focus||{alpha:.3},rt.focus),oe=kt.prox>=0,It=oe&&ft.one,fe=[],Xe=[],kn=[];function Ro(x,T){let D=ft.show(i,T);if(D instanceof HTMLElement)return oi(D,u_),oi(D,x.class),Ki(D,-10,-10,F,Pt),m.insertBefore(D,fe[T]),D}function br(x,T){if(s==1||T>0){let D=s==1&&M[x.scale].time,U=x.value;x.value=D?Kd(U)?sp(W,ip(U,z)):U||Z:U||Tx,x.label=x.label||(D?_x:gx)}if(It||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||zx||C_,x.fillTo=Se(x.fillTo||Px),x.pxAlign=+Ee(x.pxAlign,y),x.pxRound=dp(x.pxAlign),x.stroke=Se(x.stroke||null),x.fill=Se(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let D=Ex(qn(1,x.width),1),U=x.points=mn({},{size:D,width:qn(1,D*.2),stroke:x.stroke,space:D*2,paths:kx,_stroke:null,_fill:null},x.points);U.show=Se(U.show),U.filter=Se(U.filter),U.fill=Se(U.fill),U.stroke=Se(U.stroke),U.paths=Se(U.paths),U.pxAlign=x.pxAlign}if(j){let D=ge(x,T);gt.splice(T,0,D[0]),yt.splice(T,0,D[1]),st.values.push(null)}if(dt){et.splice(T,0,null);let D=null;It?T==0&&(D=Ro(x,T)):T>0&&(D=Ro(x,T)),fe.splice(T,0,D),Xe.splice(T,0,0),kn.splice(T,0,0)}En("addSeries",T)}function Eh(x,T){T=T??v.length,x=s==1?Qh(x,T,op,up):Qh(x,T,{},hp),v.splice(T,0,x),br(v[T],T)}i.addSeries=Eh;function Ga(x){if(v.splice(x,1),j){st.values.splice(x,1),yt.splice(x,1);let T=gt.splice(x,1)[0];He(null,T.firstChild),T.remove()}dt&&(et.splice(x,1),fe.splice(x,1)[0].remove(),Xe.splice(x,1),kn.splice(x,1)),En("delSeries",x)}i.delSeries=Ga;let Wi=[!1,!1,!1,!1];function rs(x,T){if(x._show=x.show,x.show){let D=x.side%2,U=M[x.scale];U==null&&(x.scale=D?v[1].scale:A,U=M[x.scale]);let H=U.time;x.size=Se(x.size),x.space=Se(x.space),x.rotate=Se(x.rotate),Ds(x.incrs)&&x.incrs.forEach(ct=>{!Ns.has(ct)&&Ns.set(ct,Ep(ct))}),x.incrs=Se(x.incrs||(U.distr==2?K_:H?p==1?Q_:nx:or)),x.splits=Se(x.splits||(H&&U.distr==1?tt:U.distr==3?Zh:U.distr==4?vx:yx)),x.stroke=Se(x.stroke),x.grid.stroke=Se(x.grid.stroke),x.ticks.stroke=Se(x.ticks.stroke),x.border.stroke=Se(x.border.stroke);let K=x.values;x.values=Ds(K)&&!Ds(K[0])?Se(K):H?Ds(K)?np(W,ep(K,z)):Kd(K)?rx(W,K):K||X:K||xx,x.filter=Se(x.filter||(U.distr>=3&&U.log==10?bx:U.distr==3&&U.log==2?wx:wp)),x.font=_p(x.font),x.labelFont=_p(x.labelFont),x._size=x.size(i,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Wi[T]=!0,x._el=Si(a_,u))}}function os(x,T,D,U){let[H,K,ct,mt]=D,Tt=T%2,Ut=0;return Tt==0&&(mt||K)&&(Ut=T==0&&!H||T==2&&!ct?xn(rp.size/3):0),Tt==1&&(H||ct)&&(Ut=T==1&&!K||T==3&&!mt?xn(lp.size/2):0),Ut}let Co=i.padding=(n.padding||[os,os,os,os]).map(x=>Se(Ee(x,os))),Ci=i._padding=Co.map((x,T)=>x(i,T,Wi,0)),tn,an=null,ln=null,Xi=s==1?v[0].idxs:null,ni=null,Es=!1;function Po(x,T){if(t=x??[],i.data=i._data=t,s==2){tn=0;for(let D=1;D<v.length;D++)tn+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ni=t[0],tn=ni.length;let D=t;if(O==2){D=t.slice();let U=D[0]=Array(tn);for(let H=0;H<tn;H++)U[H]=H}i._data=t=D}if(de(!0),En("setData"),O==2&&(wt=!0),T!==!1){let D=P;D.auto(i,Es)?Io():Cs(A,D.min,D.max),nt=nt||rt.left>=0,_t=!0,Nn()}}i.setData=Po;function Io(){Es=!0;let x,T;s==1&&(tn>0?(an=Xi[0]=0,ln=Xi[1]=tn-1,x=t[0][an],T=t[0][ln],O==2?(x=an,T=ln):x==T&&(O==3?[x,T]=ol(x,x,P.log,!1):O==4?[x,T]=iu(x,x,P.log,!1):P.time?T=x+xn(86400/p):[x,T]=il(x,T,su,!0))):(an=Xi[0]=x=null,ln=Xi[1]=T=null)),Cs(A,x,T)}let wr,As,Tr,E,G,Q,$,J,Rt,Lt;function Ct(x,T,D,U,H,K){x??=Nd,D??=ou,U??="butt",H??=Nd,K??="round",x!=wr&&(d.strokeStyle=wr=x),H!=As&&(d.fillStyle=As=H),T!=Tr&&(d.lineWidth=Tr=T),K!=G&&(d.lineJoin=G=K),U!=Q&&(d.lineCap=Q=U),D!=E&&d.setLineDash(E=D)}function Dt(x,T,D,U){T!=As&&(d.fillStyle=As=T),x!=$&&(d.font=$=x),D!=J&&(d.textAlign=J=D),U!=Rt&&(d.textBaseline=Rt=U)}function Ht(x,T,D,U,H=0){if(U.length>0&&x.auto(i,Es)&&(T==null||T.min==null)){let K=Ee(an,0),ct=Ee(ln,U.length-1),mt=D.min==null?b_(U,K,ct,H,x.distr==3):[D.min,D.max];x.min=Ui(x.min,D.min=mt[0]),x.max=qn(x.max,D.max=mt[1])}}let le={min:null,max:null};function _e(){for(let U in M){let H=M[U];V[U]==null&&(H.min==null||V[A]!=null&&H.auto(i,Es))&&(V[U]=le)}for(let U in M){let H=M[U];V[U]==null&&H.from!=null&&V[H.from]!=null&&(V[U]=le)}V[A]!=null&&de(!0);let x={};for(let U in V){let H=V[U];if(H!=null){let K=x[U]=kr(M[U],L_);if(H.min!=null)mn(K,H);else if(U!=A||s==2)if(tn==0&&K.from==null){let ct=K.range(i,null,null,U);K.min=ct[0],K.max=ct[1]}else K.min=Ve,K.max=-Ve}}if(tn>0){v.forEach((U,H)=>{if(s==1){let K=U.scale,ct=V[K];if(ct==null)return;let mt=x[K];if(H==0){let Tt=mt.range(i,mt.min,mt.max,K);mt.min=Tt[0],mt.max=Tt[1],an=Ni(mt.min,t[0]),ln=Ni(mt.max,t[0]),ln-an>1&&(t[0][an]<mt.min&&an++,t[0][ln]>mt.max&&ln--),U.min=ni[an],U.max=ni[ln]}else U.show&&U.auto&&Ht(mt,ct,U,t[H],U.sorted);U.idxs[0]=an,U.idxs[1]=ln}else if(H>0&&U.show&&U.auto){let[K,ct]=U.facets,mt=K.scale,Tt=ct.scale,[Ut,Ot]=t[H],zt=x[mt],ue=x[Tt];zt!=null&&Ht(zt,V[mt],K,Ut,K.sorted),ue!=null&&Ht(ue,V[Tt],ct,Ot,ct.sorted),U.min=ct.min,U.max=ct.max}});for(let U in x){let H=x[U],K=V[U];if(H.from==null&&(K==null||K.min==null)){let ct=H.range(i,H.min==Ve?null:H.min,H.max==-Ve?null:H.max,U);H.min=ct[0],H.max=ct[1]}}}for(let U in x){let H=x[U];if(H.from!=null){let K=x[H.from];if(K.min==null)H.min=H.max=null;else{let ct=H.range(i,K.min,K.max,U);H.min=ct[0],H.max=ct[1]}}}let T={},D=!1;for(let U in x){let H=x[U],K=M[U];if(K.min!=H.min||K.max!=H.max){K.min=H.min,K.max=H.max;let ct=K.distr;K._min=ct==3?hs(K.min):ct==4?kh(K.min,K.asinh):ct==100?K.fwd(K.min):K.min,K._max=ct==3?hs(K.max):ct==4?kh(K.max,K.asinh):ct==100?K.fwd(K.max):K.max,T[U]=D=!0}}if(D){v.forEach((U,H)=>{s==2?H>0&&T.y&&(U._paths=null):T[U.scale]&&(U._paths=null)});for(let U in T)wt=!0,En("setScale",U);dt&&rt.left>=0&&(nt=_t=!0)}for(let U in V)V[U]=null}function Vt(x){let T=$h(an-1,0,tn-1),D=$h(ln+1,0,tn-1);for(;x[T]==null&&T>0;)T--;for(;x[D]==null&&D<tn-1;)D++;return[T,D]}function xe(){if(tn>0){let x=v.some(T=>T._focus)&&Lt!=kt.alpha;x&&(d.globalAlpha=Lt=kt.alpha),v.forEach((T,D)=>{if(D>0&&T.show&&(Qe(D,!1),Qe(D,!0),T._paths==null)){let U=Lt;Lt!=T.alpha&&(d.globalAlpha=Lt=T.alpha);let H=s==2?[0,t[D][0].length-1]:Vt(t[D]);T._paths=T.paths(i,D,H[0],H[1]),Lt!=U&&(d.globalAlpha=Lt=U)}}),v.forEach((T,D)=>{if(D>0&&T.show){let U=Lt;Lt!=T.alpha&&(d.globalAlpha=Lt=T.alpha),T._paths!=null&&Oe(D,!1);{let H=T._paths!=null?T._paths.gaps:null,K=T.points.show(i,D,an,ln,H),ct=T.points.filter(i,D,K,H);(K||ct)&&(T.points._paths=T.points.paths(i,D,an,ln,ct),Oe(D,!0))}Lt!=U&&(d.globalAlpha=Lt=U),En("drawSeries",D)}}),x&&(d.globalAlpha=Lt=1)}}function Qe(x,T){let D=T?v[x].points:v[x];D._stroke=D.stroke(i,x),D._fill=D.fill(i,x)}function Oe(x,T){let D=T?v[x].points:v[x],{stroke:U,fill:H,clip:K,flags:ct,_stroke:mt=D._stroke,_fill:Tt=D._fill,_width:Ut=D.width}=D._paths;Ut=Ge(Ut*Pe,3);let Ot=null,zt=Ut%2/2;T&&Tt==null&&(Tt=Ut>0?"#fff":mt);let ue=D.pxAlign==1&&zt>0;if(ue&&d.translate(zt,zt),!T){let Ce=L-Ut/2,Te=b-Ut/2,ve=q+Ut,ee=ut+Ut;Ot=new Path2D,Ot.rect(Ce,Te,ve,ee)}T?Bt(mt,Ut,D.dash,D.cap,Tt,U,H,ct,K):Be(x,mt,Ut,D.dash,D.cap,Tt,U,H,ct,Ot,K),ue&&d.translate(-zt,-zt)}function Be(x,T,D,U,H,K,ct,mt,Tt,Ut,Ot){let zt=!1;Tt!=0&&R.forEach((ue,Ce)=>{if(ue.series[0]==x){let Te=v[ue.series[1]],ve=t[ue.series[1]],ee=(Te._paths||Go).band;Ds(ee)&&(ee=ue.dir==1?ee[0]:ee[1]);let Zt,$e=null;Te.show&&ee&&T_(ve,an,ln)?($e=ue.fill(i,Ce)||K,Zt=Te._paths.clip):ee=null,Bt(T,D,U,H,$e,ct,mt,Tt,Ut,Ot,Zt,ee),zt=!0}}),zt||Bt(T,D,U,H,K,ct,mt,Tt,Ut,Ot)}let _n=Vr|Kh;function Bt(x,T,D,U,H,K,ct,mt,Tt,Ut,Ot,zt){Ct(x,T,D,U,H),(Tt||Ut||zt)&&(d.save(),Tt&&d.clip(Tt),Ut&&d.clip(Ut)),zt?(mt&_n)==_n?(d.clip(zt),Ot&&d.clip(Ot),Me(H,ct),cn(x,K,T)):mt&Kh?(Me(H,ct),d.clip(zt),cn(x,K,T)):mt&Vr&&(d.save(),d.clip(zt),Ot&&d.clip(Ot),Me(H,ct),d.restore(),cn(x,K,T)):(Me(H,ct),cn(x,K,T)),(Tt||Ut||zt)&&d.restore()}function cn(x,T,D){D>0&&(T instanceof Map?T.forEach((U,H)=>{d.strokeStyle=wr=H,d.stroke(U)}):T!=null&&x&&d.stroke(T))}function Me(x,T){T instanceof Map?T.forEach((D,U)=>{d.fillStyle=As=U,d.fill(D)}):T!=null&&x&&d.fill(T)}function as(x,T,D,U){let H=w[x],K;if(U<=0)K=[0,0];else{let ct=H._space=H.space(i,x,T,D,U),mt=H._incrs=H.incrs(i,x,T,D,U,ct);K=qx(T,D,mt,U,ct)}return H._found=K}function hn(x,T,D,U,H,K,ct,mt,Tt,Ut){let Ot=ct%2/2;y==1&&d.translate(Ot,Ot),Ct(mt,ct,Tt,Ut,mt),d.beginPath();let zt,ue,Ce,Te,ve=H+(U==0||U==3?-K:K);D==0?(ue=H,Te=ve):(zt=H,Ce=ve);for(let ee=0;ee<x.length;ee++)T[ee]!=null&&(D==0?zt=Ce=x[ee]:ue=Te=x[ee],d.moveTo(zt,ue),d.lineTo(Ce,Te));d.stroke(),y==1&&d.translate(-Ot,-Ot)}function Er(x){let T=!0;return w.forEach((D,U)=>{if(!D.show)return;let H=M[D.scale];if(H.min==null){D._show&&(T=!1,D._show=!1,de(!1));return}else D._show||(T=!1,D._show=!0,de(!1));let K=D.side,ct=K%2,{min:mt,max:Tt}=H,[Ut,Ot]=as(U,mt,Tt,ct==0?F:Pt);if(Ot==0)return;let zt=H.distr==2,ue=D._splits=D.splits(i,U,mt,Tt,Ut,Ot,zt),Ce=H.distr==2?ue.map(Zt=>ni[Zt]):ue,Te=H.distr==2?ni[ue[1]]-ni[ue[0]]:Ut,ve=D._values=D.values(i,D.filter(i,Ce,U,Ot,Te),U,Ot,Te);D._rotate=K==2?D.rotate(i,ve,U,Ot):0;let ee=D._size;D._size=bi(D.size(i,ve,U,x)),ee!=null&&D._size!=ee&&(T=!1)}),T}function qi(x){let T=!0;return Co.forEach((D,U)=>{let H=D(i,U,Wi,x);H!=Ci[U]&&(T=!1),Ci[U]=H}),T}function ls(){for(let x=0;x<w.length;x++){let T=w[x];if(!T.show||!T._show)continue;let D=T.side,U=D%2,H,K,ct=T.stroke(i,x),mt=D==0||D==3?-1:1,[Tt,Ut]=T._found;if(T.label!=null){let Hn=T.labelGap*mt,ri=xn((T._lpos+Hn)*Pe);Dt(T.labelFont[0],ct,"center",D==2?"top":Dd),d.save(),U==1?(H=K=0,d.translate(ri,xn(b+ut/2)),d.rotate((D==3?-el:el)/2)):(H=xn(L+q/2),K=ri);let er=Sp(T.label)?T.label(i,x,Tt,Ut):T.label;d.fillText(er,H,K),d.restore()}if(Ut==0)continue;let Ot=M[T.scale],zt=U==0?q:ut,ue=U==0?L:b,Ce=T._splits,Te=Ot.distr==2?Ce.map(Hn=>ni[Hn]):Ce,ve=Ot.distr==2?ni[Ce[1]]-ni[Ce[0]]:Tt,ee=T.ticks,Zt=T.border,$e=ee.show?ee.size:0,nn=xn($e*Pe),An=xn((T.alignTo==2?T._size-$e-T.gap:T.gap)*Pe),ke=T._rotate*-el/180,sn=g(T._pos*Pe),ii=(nn+An)*mt,Gn=sn+ii;K=U==0?Gn:0,H=U==1?Gn:0;let yi=T.font[0],Pi=T.align==1?Ur:T.align==2?Oh:ke>0?Ur:ke<0?Oh:U==0?"center":D==3?Oh:Ur,Zi=ke||U==1?"middle":D==2?"top":Dd;Dt(yi,ct,Pi,Zi);let si=T.font[1]*T.lineGap,vi=Ce.map(Hn=>g(a(Hn,Ot,zt,ue))),Ii=T._values;for(let Hn=0;Hn<Ii.length;Hn++){let ri=Ii[Hn];if(ri!=null){U==0?H=vi[Hn]:K=vi[Hn],ri=""+ri;let er=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Wn=0;Wn<er.length;Wn++){let pd=er[Wn];ke?(d.save(),d.translate(H,K+Wn*si),d.rotate(ke),d.fillText(pd,0,0),d.restore()):d.fillText(pd,H,K+Wn*si)}}}ee.show&&hn(vi,ee.filter(i,Te,x,Ut,ve),U,D,sn,nn,Ge(ee.width*Pe,3),ee.stroke(i,x),ee.dash,ee.cap);let Ji=T.grid;Ji.show&&hn(vi,Ji.filter(i,Te,x,Ut,ve),U,U==0?2:1,U==0?b:L,U==0?ut:q,Ge(Ji.width*Pe,3),Ji.stroke(i,x),Ji.dash,Ji.cap),Zt.show&&hn([sn],[1],U==0?1:0,U==0?1:2,U==1?b:L,U==1?ut:q,Ge(Zt.width*Pe,3),Zt.stroke(i,x),Zt.dash,Zt.cap)}En("drawAxes")}function de(x){v.forEach((T,D)=>{D>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(U=>{U.min=null,U.max=null})))})}let en=!1,Vn=!1,ze=[];function un(){Vn=!1;for(let x=0;x<ze.length;x++)En(...ze[x]);ze.length=0}function Nn(){en||(z_(Jf),en=!0)}function Ha(x,T=!1){en=!0,Vn=T,x(i),Jf(),T&&ze.length>0&&queueMicrotask(un)}i.batch=Ha;function Jf(){if(at&&(_e(),at=!1),wt&&(At(),wt=!1),vt){if(Ze(h,Ur,Ft),Ze(h,"top",Jt),Ze(h,Bo,F),Ze(h,zo,Pt),Ze(m,Ur,Ft),Ze(m,"top",Jt),Ze(m,Bo,F),Ze(m,zo,Pt),Ze(u,Bo,Le),Ze(u,zo,Re),f.width=xn(Le*Pe),f.height=xn(Re*Pe),w.forEach(({_el:x,_show:T,_size:D,_pos:U,side:H})=>{if(x!=null)if(T){let K=H===3||H===0?D:0,ct=H%2==1;Ze(x,ct?"left":"top",U-K),Ze(x,ct?"width":"height",D),Ze(x,ct?"top":"left",ct?Jt:Ft),Ze(x,ct?"height":"width",ct?Pt:F),qh(x,ar)}else oi(x,ar)}),wr=As=Tr=G=Q=$=J=Rt=E=null,Lt=1,No(!0),Ft!=bt||Jt!=Fe||F!=Gt||Pt!=Kt){de(!1);let x=F/Gt,T=Pt/Kt;if(dt&&!nt&&rt.left>=0){rt.left*=x,rt.top*=T,Ar&&Ki(Ar,xn(rt.left),0,F,Pt),Rr&&Ki(Rr,0,xn(rt.top),F,Pt);for(let D=0;D<fe.length;D++){let U=fe[D];U!=null&&(Xe[D]*=x,kn[D]*=T,Ki(U,bi(Xe[D]),bi(kn[D]),F,Pt))}}if(Ye.show&&!ot&&Ye.left>=0&&Ye.width>0){Ye.left*=x,Ye.width*=x,Ye.top*=T,Ye.height*=T;for(let D in Lh)Ze(Ir,D,Ye[D])}bt=Ft,Fe=Jt,Gt=F,Kt=Pt}En("setSize"),vt=!1}Le>0&&Re>0&&(d.clearRect(0,0,f.width,f.height),En("drawClear"),S.forEach(x=>x()),En("draw")),Ye.show&&ot&&(Wa(Ye),ot=!1),dt&&nt&&(tr(null,!0,!1),nt=!1),st.show&&st.live&&_t&&(Ph(),_t=!1),l||(l=!0,i.status=1,En("ready")),Es=!1,en=!1}i.redraw=(x,T)=>{wt=T||!1,x!==!1?Cs(A,P.min,P.max):Nn()};function Ah(x,T){let D=M[x];if(D.from==null){if(tn==0){let U=D.range(i,T.min,T.max,x);T.min=U[0],T.max=U[1]}if(T.min>T.max){let U=T.min;T.min=T.max,T.max=U}if(tn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==A&&D.distr==2&&tn>0&&(T.min=Ni(T.min,t[0]),T.max=Ni(T.max,t[0]),T.min==T.max&&T.max++),V[x]=T,at=!0,Nn()}}i.setScale=Ah;let Rh,Ch,Ar,Rr,Kf,jf,Cr,Pr,Qf,td,qe,Ke,Rs=!1,Ln=rt.drag,wn=Ln.x,Tn=Ln.y;dt&&(rt.x&&(Rh=Si(c_,m)),rt.y&&(Ch=Si(h_,m)),P.ori==0?(Ar=Rh,Rr=Ch):(Ar=Ch,Rr=Rh),qe=rt.left,Ke=rt.top);let Ye=i.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ir=Ye.show?Si(l_,Ye.over?m:h):null;function Wa(x,T){if(Ye.show){for(let D in x)Ye[D]=x[D],D in Lh&&Ze(Ir,D,x[D]);T!==!1&&En("setSelect")}}i.setSelect=Wa;function L0(x){if(v[x].show)j&&qh(gt[x],ar);else if(j&&oi(gt[x],ar),dt){let D=It?fe[0]:fe[x];D!=null&&Ki(D,-10,-10,F,Pt)}}function Cs(x,T,D){Ah(x,{min:T,max:D})}function Yi(x,T,D,U){T.focus!=null&&O0(x),T.show!=null&&v.forEach((H,K)=>{K>0&&(x==K||x==null)&&(H.show=T.show,L0(K),s==2?(Cs(H.facets[0].scale,null,null),Cs(H.facets[1].scale,null,null)):Cs(H.scale,null,null),Nn())}),D!==!1&&En("setSeries",x,T),U&&Uo("setSeries",i,x,T)}i.setSeries=Yi;function D0(x,T){mn(R[x],T)}function N0(x,T){x.fill=Se(x.fill||null),x.dir=Ee(x.dir,-1),T=T??R.length,R.splice(T,0,x)}function U0(x){x==null?R.length=0:R.splice(x,1)}i.addBand=N0,i.setBand=D0,i.delBand=U0;function F0(x,T){v[x].alpha=T,dt&&fe[x]!=null&&(fe[x].style.opacity=T),j&&gt[x]&&(gt[x].style.opacity=T)}let cs,Ps,Qs,Lr={focus:!0};function O0(x){if(x!=Qs){let T=x==null,D=kt.alpha!=1;v.forEach((U,H)=>{if(s==1||H>0){let K=T||H==0||H==x;U._focus=T?null:K,D&&F0(H,K?1:kt.alpha)}}),Qs=x,D&&Nn()}}j&&oe&&ce(Od,xt,x=>{rt._lock||(re(x),Qs!=null&&Yi(null,Lr,!0,fn.setSeries))});function $i(x,T,D){let U=M[T];D&&(x=x/Pe-(U.ori==1?Jt:Ft));let H=F;U.ori==1&&(H=Pt,x=H-x),U.dir==-1&&(x=H-x);let K=U._min,ct=U._max,mt=x/H,Tt=K+(ct-K)*mt,Ut=U.distr;return Ut==3?Br(10,Tt):Ut==4?A_(Tt,U.asinh):Ut==100?U.bwd(Tt):Tt}function B0(x,T){let D=$i(x,A,T);return Ni(D,t[0],an,ln)}i.valToIdx=x=>Ni(x,t[0]),i.posToIdx=B0,i.posToVal=$i,i.valToPos=(x,T,D)=>M[T].ori==0?r(x,M[T],D?q:F,D?L:0):o(x,M[T],D?ut:Pt,D?b:0),i.setCursor=(x,T,D)=>{qe=x.left,Ke=x.top,tr(null,T,D)};function ed(x,T){Ze(Ir,Ur,Ye.left=x),Ze(Ir,Bo,Ye.width=T)}function nd(x,T){Ze(Ir,"top",Ye.top=x),Ze(Ir,zo,Ye.height=T)}let Lo=P.ori==0?ed:nd,Do=P.ori==1?ed:nd;function z0(){if(j&&st.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&qt)continue;let T=st.values[x],D=0;for(let U in T)yt[x][D++].firstChild.nodeValue=T[U]}}function Ph(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((D,U)=>{et[U]=D}):I_(x.idx)||et.fill(x.idx),st.idx=et[0]),j&&st.live){for(let D=0;D<v.length;D++)(D>0||s==1&&!qt)&&k0(D,et[D]);z0()}_t=!1,T!==!1&&En("setLegend")}i.setLegend=Ph;function k0(x,T){let D=v[x],U=x==0&&O==2?ni:t[x],H;qt?H=D.values(i,x,T)??Yt:(H=D.value(i,T==null?null:U[T],x,T),H=H==null?Yt:{_:H}),st.values[x]=H}function tr(x,T,D){Qf=qe,td=Ke,[qe,Ke]=rt.move(i,qe,Ke),rt.left=qe,rt.top=Ke,dt&&(Ar&&Ki(Ar,xn(qe),0,F,Pt),Rr&&Ki(Rr,0,xn(Ke),F,Pt));let U,H=an>ln;cs=Ve,Ps=null;let K=P.ori==0?F:Pt,ct=P.ori==1?F:Pt;if(qe<0||tn==0||H){U=rt.idx=null;for(let mt=0;mt<v.length;mt++){let Tt=fe[mt];Tt!=null&&Ki(Tt,-10,-10,F,Pt)}oe&&Yi(null,Lr,!0,x==null&&fn.setSeries),st.live&&(et.fill(U),_t=!0)}else{let mt,Tt,Ut;s==1&&(mt=P.ori==0?qe:Ke,Tt=$i(mt,A),U=rt.idx=Ni(Tt,t[0],an,ln),Ut=k(t[0][U],P,K,0));let Ot=-10,zt=-10,ue=0,Ce=0,Te=!0,ve="",ee="";for(let Zt=s==2?1:0;Zt<v.length;Zt++){let $e=v[Zt],nn=et[Zt],An=nn==null?null:s==1?t[Zt][nn]:t[Zt][1][nn],ke=rt.dataIdx(i,Zt,U,Tt),sn=ke==null?null:s==1?t[Zt][ke]:t[Zt][1][ke];if(_t=_t||sn!=An||ke!=nn,et[Zt]=ke,Zt>0&&$e.show){let ii=ke==null?-10:ke==U?Ut:k(s==1?t[0][ke]:t[Zt][0][ke],P,K,0),Gn=sn==null?-10:N(sn,s==1?M[$e.scale]:M[$e.facets[1].scale],ct,0);if(oe&&sn!=null){let yi=P.ori==1?qe:Ke,Pi=yn(kt.dist(i,Zt,ke,Gn,yi));if(Pi<cs){let Zi=kt.bias;if(Zi!=0){let si=$i(yi,$e.scale),vi=sn>=0?1:-1,Ii=si>=0?1:-1;Ii==vi&&(Ii==1?Zi==1?sn>=si:sn<=si:Zi==1?sn<=si:sn>=si)&&(cs=Pi,Ps=Zt)}else cs=Pi,Ps=Zt}}if(_t||It){let yi,Pi;P.ori==0?(yi=ii,Pi=Gn):(yi=Gn,Pi=ii);let Zi,si,vi,Ii,Ji,Hn,ri=!0,er=ft.bbox;if(er!=null){ri=!1;let Wn=er(i,Zt);vi=Wn.left,Ii=Wn.top,Zi=Wn.width,si=Wn.height}else vi=yi,Ii=Pi,Zi=si=ft.size(i,Zt);if(Hn=ft.fill(i,Zt),Ji=ft.stroke(i,Zt),It)Zt==Ps&&cs<=kt.prox&&(Ot=vi,zt=Ii,ue=Zi,Ce=si,Te=ri,ve=Hn,ee=Ji);else{let Wn=fe[Zt];Wn!=null&&(Xe[Zt]=vi,kn[Zt]=Ii,Wd(Wn,Zi,si,ri),Gd(Wn,Hn,Ji),Ki(Wn,bi(vi),bi(Ii),F,Pt))}}}}if(It){let Zt=kt.prox,$e=Qs==null?cs<=Zt:cs>Zt||Ps!=Qs;if(_t||$e){let nn=fe[0];nn!=null&&(Xe[0]=Ot,kn[0]=zt,Wd(nn,ue,Ce,Te),Gd(nn,ve,ee),Ki(nn,bi(Ot),bi(zt),F,Pt))}}}if(Ye.show&&Rs)if(x!=null){let[mt,Tt]=fn.scales,[Ut,Ot]=fn.match,[zt,ue]=x.cursor.sync.scales,Ce=x.cursor.drag;if(wn=Ce._x,Tn=Ce._y,wn||Tn){let{left:Te,top:ve,width:ee,height:Zt}=x.select,$e=x.scales[zt].ori,nn=x.posToVal,An,ke,sn,ii,Gn,yi=mt!=null&&Ut(mt,zt),Pi=Tt!=null&&Ot(Tt,ue);yi&&wn?($e==0?(An=Te,ke=ee):(An=ve,ke=Zt),sn=M[mt],ii=k(nn(An,zt),sn,K,0),Gn=k(nn(An+ke,zt),sn,K,0),Lo(Ui(ii,Gn),yn(Gn-ii))):Lo(0,K),Pi&&Tn?($e==1?(An=Te,ke=ee):(An=ve,ke=Zt),sn=M[Tt],ii=N(nn(An,ue),sn,ct,0),Gn=N(nn(An+ke,ue),sn,ct,0),Do(Ui(ii,Gn),yn(Gn-ii))):Do(0,ct)}else Dh()}else{let mt=yn(Qf-Kf),Tt=yn(td-jf);if(P.ori==1){let ue=mt;mt=Tt,Tt=ue}wn=Ln.x&&mt>=Ln.dist,Tn=Ln.y&&Tt>=Ln.dist;let Ut=Ln.uni;Ut!=null?wn&&Tn&&(wn=mt>=Ut,Tn=Tt>=Ut,!wn&&!Tn&&(Tt>mt?Tn=!0:wn=!0)):Ln.x&&Ln.y&&(wn||Tn)&&(wn=Tn=!0);let Ot,zt;wn&&(P.ori==0?(Ot=Cr,zt=qe):(Ot=Pr,zt=Ke),Lo(Ui(Ot,zt),yn(zt-Ot)),Tn||Do(0,ct)),Tn&&(P.ori==1?(Ot=Cr,zt=qe):(Ot=Pr,zt=Ke),Do(Ui(Ot,zt),yn(zt-Ot)),wn||Lo(0,K)),!wn&&!Tn&&(Lo(0,0),Do(0,0))}if(Ln._x=wn,Ln._y=Tn,x==null){if(D){if(dd!=null){let[mt,Tt]=fn.scales;fn.values[0]=mt!=null?$i(P.ori==0?qe:Ke,mt):null,fn.values[1]=Tt!=null?$i(P.ori==1?qe:Ke,Tt):null}Uo(Bh,i,qe,Ke,F,Pt,U)}if(oe){let mt=D&&fn.setSeries,Tt=kt.prox;Qs==null?cs<=Tt&&Yi(Ps,Lr,!0,mt):cs>Tt?Yi(null,Lr,!0,mt):Ps!=Qs&&Yi(Ps,Lr,!0,mt)}}_t&&(st.idx=U,Ph()),T!==!1&&En("setCursor")}let Is=null;Object.defineProperty(i,"rect",{get(){return Is==null&&No(!1),Is}});function No(x=!1){x?Is=null:(Is=m.getBoundingClientRect(),En("syncRect",Is))}function id(x,T,D,U,H,K,ct){rt._lock||Rs&&x!=null&&x.movementX==0&&x.movementY==0||(Ih(x,T,D,U,H,K,ct,!1,x!=null),x!=null?tr(null,!0,!0):tr(T,!0,!1))}function Ih(x,T,D,U,H,K,ct,mt,Tt){if(Is==null&&No(!1),re(x),x!=null)D=x.clientX-Is.left,U=x.clientY-Is.top;else{if(D<0||U<0){qe=-10,Ke=-10;return}let[Ut,Ot]=fn.scales,zt=T.cursor.sync,[ue,Ce]=zt.values,[Te,ve]=zt.scales,[ee,Zt]=fn.match,$e=T.axes[0].side%2==1,nn=P.ori==0?F:Pt,An=P.ori==1?F:Pt,ke=$e?K:H,sn=$e?H:K,ii=$e?U:D,Gn=$e?D:U;if(Te!=null?D=ee(Ut,Te)?a(ue,M[Ut],nn,0):-10:D=nn*(ii/ke),ve!=null?U=Zt(Ot,ve)?a(Ce,M[Ot],An,0):-10:U=An*(Gn/sn),P.ori==1){let yi=D;D=U,U=yi}}Tt&&(T==null||T.cursor.event.type==Bh)&&((D<=1||D>=F-1)&&(D=rr(D,F)),(U<=1||U>=Pt-1)&&(U=rr(U,Pt))),mt?(Kf=D,jf=U,[Cr,Pr]=rt.move(i,D,U)):(qe=D,Ke=U)}let Lh={width:0,height:0,left:0,top:0};function Dh(){Wa(Lh,!1)}let sd,rd,od,ad;function ld(x,T,D,U,H,K,ct){Rs=!0,wn=Tn=Ln._x=Ln._y=!1,Ih(x,T,D,U,H,K,ct,!0,!1),x!=null&&(ce(zh,Wh,cd,!1),Uo(Ud,i,Cr,Pr,F,Pt,null));let{left:mt,top:Tt,width:Ut,height:Ot}=Ye;sd=mt,rd=Tt,od=Ut,ad=Ot}function cd(x,T,D,U,H,K,ct){Rs=Ln._x=Ln._y=!1,Ih(x,T,D,U,H,K,ct,!1,!0);let{left:mt,top:Tt,width:Ut,height:Ot}=Ye,zt=Ut>0||Ot>0,ue=sd!=mt||rd!=Tt||od!=Ut||ad!=Ot;if(zt&&ue&&Wa(Ye),Ln.setScale&&zt&&ue){let Ce=mt,Te=Ut,ve=Tt,ee=Ot;if(P.ori==1&&(Ce=Tt,Te=Ot,ve=mt,ee=Ut),wn&&Cs(A,$i(Ce,A),$i(Ce+Te,A)),Tn)for(let Zt in M){let $e=M[Zt];Zt!=A&&$e.from==null&&$e.min!=Ve&&Cs(Zt,$i(ve+ee,Zt),$i(ve,Zt))}Dh()}else rt.lock&&(rt._lock=!rt._lock,tr(T,!0,x!=null));x!=null&&(He(zh,Wh),Uo(zh,i,qe,Ke,F,Pt,null))}function V0(x,T,D,U,H,K,ct){if(rt._lock)return;re(x);let mt=Rs;if(Rs){let Tt=!0,Ut=!0,Ot=10,zt,ue;P.ori==0?(zt=wn,ue=Tn):(zt=Tn,ue=wn),zt&&ue&&(Tt=qe<=Ot||qe>=F-Ot,Ut=Ke<=Ot||Ke>=Pt-Ot),zt&&Tt&&(qe=qe<Cr?0:F),ue&&Ut&&(Ke=Ke<Pr?0:Pt),tr(null,!0,!0),Rs=!1}qe=-10,Ke=-10,et.fill(null),tr(null,!0,!0),mt&&(Rs=mt)}function hd(x,T,D,U,H,K,ct){rt._lock||(re(x),Io(),Dh(),x!=null&&Uo(Bd,i,qe,Ke,F,Pt,null))}function ud(){w.forEach(Yx),B(i.width,i.height,!0)}lr(nl,Or,ud);let Dr={};Dr.mousedown=ld,Dr.mousemove=id,Dr.mouseup=cd,Dr.dblclick=hd,Dr.setSeries=(x,T,D,U)=>{let H=fn.match[2];D=H(i,T,D),D!=-1&&Yi(D,U,!0,!1)},dt&&(ce(Ud,m,ld),ce(Bh,m,id),ce(Fd,m,x=>{re(x),No(!1)}),ce(Od,m,V0),ce(Bd,m,hd),jh.add(i),i.syncRect=No);let Xa=i.hooks=n.hooks||{};function En(x,T,D){Vn?ze.push([x,T,D]):x in Xa&&Xa[x].forEach(U=>{U.call(null,i,T,D)})}(n.plugins||[]).forEach(x=>{for(let T in x.hooks)Xa[T]=(Xa[T]||[]).concat(x.hooks[T])});let fd=(x,T,D)=>D,fn=mn({key:null,setSeries:!1,filters:{pub:Zd,sub:Zd},scales:[A,v[1]?v[1].scale:null],match:[Jd,Jd,fd],values:[null,null]},rt.sync);fn.match.length==2&&fn.match.push(fd),rt.sync=fn;let dd=fn.key,Nh=qp(dd);function Uo(x,T,D,U,H,K,ct){fn.filters.pub(x,T,D,U,H,K,ct)&&Nh.pub(x,T,D,U,H,K,ct)}Nh.sub(i);function G0(x,T,D,U,H,K,ct){fn.filters.sub(x,T,D,U,H,K,ct)&&Dr[x](null,T,D,U,H,K,ct)}i.pub=G0;function H0(){Nh.unsub(i),jh.delete(i),we.clear(),Yh(nl,Or,ud),c.remove(),xt?.remove(),En("destroy")}i.destroy=H0;function Uh(){En("init",n,t),Po(t||n.data,!1),V[A]?Ah(A,V[A]):Io(),ot=Ye.show&&(Ye.width>0||Ye.height>0),nt=_t=!0,B(n.width,n.height)}return v.forEach(br),w.forEach(rs),e?e instanceof HTMLElement?(e.appendChild(c),Uh()):e(i,Uh):Uh(),i}Cn.assign=mn;Cn.fmtNum=ru;Cn.rangeNum=il;Cn.rangeLog=ol;Cn.rangeAsinh=iu;Cn.orient=hr;Cn.pxRatio=Pe;Cn.join=B_;Cn.fmtDate=au,Cn.tzDate=Z_;Cn.sync=qp;{Cn.addGap=Ix,Cn.clipGaps=cl;let n=Cn.paths={points:jp};n.linear=tm,n.stepped=Nx,n.bars=Ux,n.spline=Ox}function fs(n,t){let e=0,i=n.length;for(;e<i;){let s=e+i>>1;n[s]<t?e=s+1:i=s}return e}function mu(n,[t,e]){return[Math.max(fs(n,t)-1,0),Math.min(fs(n,e)+1,n.length)]}function dl(n,t,e){if(n.length===0||e<n[0]-1||e>n[n.length-1]+1)return NaN;let i=Math.min(Math.max(fs(n,e),1),n.length-1),s=n[i]-n[i-1],r=s>0?Math.min(Math.max((e-n[i-1])/s,0),1):0;return t[i-1]+r*(t[i]-t[i-1])}function sm(n,t,e){let[i,s]=[1/0,-1/0],[r,o]=mu(n,e);for(let a=r;a<o;a++)t[a]<i&&(i=t[a]),t[a]>s&&(s=t[a]);return[i,s]}var pu=(n,t)=>`${n.toFixed(1)} ${t.toFixed(1)}`;function rm(n,t,e,i,s){let[r,o]=mu(n,e),a=o-r>2*Math.abs(s(e[1])-s(e[0])),l="",c="M",f=u=>{l+=c+pu(i(t[u]),s(n[u])),c="L"},d=r;for(;d<o;){if(!Number.isFinite(t[d])){c="M",d++;continue}if(!a){f(d++);continue}let u=Math.round(s(n[d])),[h,m,y]=[d,d,d];for(;y+1<o&&Math.round(s(n[y+1]))===u&&Number.isFinite(t[y+1]);)y++,t[y]<t[h]&&(h=y),t[y]>t[m]&&(m=y);for(let g of[...new Set([d,Math.min(h,m),Math.max(h,m),y])])f(g);d=y+1}return l}function pl(n,t,e,i,s,r){let[o,a]=mu(n,i),l=Math.max(Math.floor((a-o)/(2*Math.abs(r(i[1])-r(i[0]))+1)),1),c=[],f=[];for(let d=o;d<a;d+=l){let[u,h]=[1/0,-1/0];for(let m=d;m<Math.min(d+l,a);m++)t[m]<u&&(u=t[m]),e[m]>h&&(h=e[m]);u<=h&&(c.push(pu(s(h),r(n[d]))),f.push(pu(s(u),r(n[d]))))}return c.length>1?`M${c.join("L")}L${f.reverse().join("L")}Z`:""}function om(n,t,e){let i=new Float32Array(t.length),[s,r,o]=[0,0,0];for(let a=0;a<t.length;a++){for(;r<t.length&&n[r]<=n[a]+e;)o+=t[r++];for(;n[s]<n[a]-e;)o-=t[s++];i[a]=o/(r-s)}return i}function ml(n,t,e){let i=new Float32Array(t.length),s=0;for(let r=0;r<t.length;r++){for(;n[s]<n[r]-e;)s++;let o=-1/0;for(let a=s;a<t.length&&n[a]<=n[r]+e;a++)o=Math.max(o,t[a]);i[r]=o}return i}var gu=[["contact_force_N","Contact force of the node","force"],["tension_N","Effective tension","force"],["torque_N_m","Torque","torque"],["rotary_speed_rad_per_s","Rotary speed","rotary speed"],["bending_moment_N_m","Bending moment","torque"],["offset_high_m","Offset to the high side","diameter"],["offset_right_m","Offset to the right","diameter"]];var $x=Cn.sync("time");function am(n){let t=ht("div",{class:"histories"}),e=[],i=!1;function s(p){let v=p.history,w=n.time_plots.map(R=>({...R,columns:R.columns.filter(([A])=>v[A])})).filter(R=>R.columns.length).filter(R=>R.columns.some(([A])=>v[A].some(_=>_!==0))).map(R=>({...R,times:v.time_s,values:R.columns.map(([A])=>v[A])})),M=o(p);return M?[...w,M]:w}let r="contact_force_N";function o(p){let{frames:v,contact:w}=p;if(v?.channels[r]){let M=v.md_m.length,R=Wo(v.md_m,Qt.depth),[A,_,S]=gu.find(([C])=>C===r),I=Float32Array.from(v.time_s,(C,P)=>v.channels[A][P*M+R]);return{title:`${_} at ${pn(v.md_m[R],"length",5)}`,dimension:S,columns:[[A,"node"]],times:v.time_s,values:[I],chooses:gu.filter(([C])=>v.channels[C])}}if(w){let M=w.md_m.length,R=Wo(w.md_m,Qt.depth),A=Float32Array.from(w.time_s,(_,S)=>w.side_force[S*M+R]);return{title:`Side force around ${pn(w.md_m[R],"length",5)}`,dimension:"force per length",columns:[["side_force_N_per_m","side force"]],times:w.time_s,values:[A]}}return null}function a(){e.forEach(w=>w.destroy()),e=[];let p=Xn(n),v=p?s(p).map(w=>l(w,p)):[];t.replaceChildren(...v.map(w=>w.element));for(let{plot:w,body:M}of v)e.push(c(w,M,p))}function l(p,v){let w=ht("div",{class:"plot"}),M=Rn(p.dimension),R=ht("h3",{},p.points&&p.columns.length===1?p.columns[0][1].replace(/^./,A=>A.toUpperCase()):p.title,M&&ht("span",{class:"unit"},` ${M}`));return p.chooses&&R.append(ht("select",{class:"noprint","aria-label":"Quantity of the chosen node",onchange:A=>{r=A.target.value,a()}},p.chooses.map(([A,_])=>ht("option",{value:A,selected:A===r},_)))),{plot:p,body:w,element:ht("figure",{class:"card history"},R,w)}}function c(p,v,w){let M=f(p),R=[Array.from(p.times),...p.values.map(C=>yd(C,p.dimension))],A=p.columns.map(([,C],P)=>{let O=C==="set";return{label:C,stroke:O?on("muted"):Fo([0,2,3][P]??P),width:O?1:1.4,dash:O?[5,4]:void 0,spanGaps:!!p.points,points:{show:!1},value:(k,N)=>N===null?"–":Un(N)}});M!==null&&(R.push(R[0].map(()=>M)),A.push({label:"soft string",stroke:Fo(1),width:1.4,dash:[7,4],points:{show:!1},value:(C,P)=>Un(P??NaN)}));let _={stroke:on("muted"),grid:{stroke:on("grid"),width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},S=Qt.times??[0,Math.max(w.history.time_s.at(-1),.001)],I=new Cn({width:Math.max(v.clientWidth,200),height:200,cursor:{sync:{key:$x.key,scales:["x",null]},drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:{live:!0,markers:{width:0,fill:(C,P)=>C.series[P].stroke(C,P)}},scales:{x:{time:!1,min:S[0],max:S[1]},y:{dir:p.points?-1:1,range:(C,P,O)=>Zx(P,O,p.dimension)}},axes:[{..._,size:30,values:(C,P)=>P.map(O=>Ls(String(Number(O.toFixed(6))))),label:void 0},{..._,size:62,values:(C,P)=>P.map(O=>Ls(String(Number(O.toFixed(6)))))}],series:[{label:"time, s",value:(C,P)=>P===null?"–":P.toFixed(2)},...A],hooks:{setScale:[(C,P)=>P==="x"&&d(C)],drawClear:[C=>u(C,w)],draw:[C=>h(C,w)]}},R,v);return m(I),I}function f(p){let v=Mi(n,"soft");if(!p.soft||!v)return null;let w=v.profile[p.soft]?.[0];return Number.isFinite(w)?De(w,p.dimension):null}function d(p){if(i||p.scales.x.min==null||e.length===0)return;i=!0;let{min:v,max:w}=p.scales.x,R=Xn(n).history.time_s.at(-1);for(let A of e)A!==p&&A.setScale("x",{min:v,max:w});rn({times:v<=1e-6&&w>=R-1e-6?null:[v,w]}),i=!1}function u(p,v){let{ctx:w,bbox:M}=p,R=p.valToPos(v.window_s,"x",!0),A=Math.min(Math.max(R,M.left),M.left+M.width);w.save(),w.fillStyle=on("settling"),w.fillRect(M.left,M.top,A-M.left,M.height),w.restore()}function h(p,v){let{ctx:w,bbox:M}=p,R=devicePixelRatio,A=-1/0;w.save(),w.font=`${10*R}px system-ui, sans-serif`,w.textAlign="left",w.fillStyle=on("muted"),w.strokeStyle=on("muted"),w.setLineDash([2*R,3*R]);let _=Qt.moment===null?[]:[[Qt.moment,""]];for(let[S,I]of[...v.notes,..._]){let C=p.valToPos(S,"x",!0);if(C<M.left||C>M.left+M.width)continue;w.beginPath(),w.moveTo(C,M.top),w.lineTo(C,M.top+M.height),w.stroke();let P=w.measureText(I).width;I&&C>A&&C+P<M.left+M.width&&(w.fillText(I,C+3*R,M.top+11*R),A=C+P+8*R)}w.restore()}function m(p){let{over:v}=p,w=()=>Xn(n).history.time_s.at(-1),M=(R,A)=>{let _=Math.max(R,0),S=Math.min(A,w());S-_>.001&&p.setScale("x",{min:_,max:S})};v.addEventListener("wheel",R=>{if(!R.ctrlKey&&!R.metaKey)return;R.preventDefault();let A=p.posToVal(R.clientX-v.getBoundingClientRect().left,"x"),_=Math.exp(R.deltaY*.002);M(A+(p.scales.x.min-A)*_,A+(p.scales.x.max-A)*_)},{passive:!1}),v.addEventListener("mousedown",R=>{if(!R.shiftKey)return;R.stopImmediatePropagation();let A=R.clientX,{min:_,max:S}=p.scales.x,I=C=>{let P=(A-C.clientX)/v.clientWidth*(S-_),O=Math.min(Math.max(P,-_),w()-S);M(_+O,S+O)};addEventListener("mousemove",I),addEventListener("mouseup",()=>removeEventListener("mousemove",I),{once:!0})},{capture:!0}),v.addEventListener("dblclick",()=>p.setScale("x",{min:0,max:w()}))}dn("units operation depth",a),dn("times",()=>{if(i)return;let p=Xn(n);if(!p)return;let[v,w]=Qt.times??[0,p.history.time_s.at(-1)];i=!0;for(let M of e)M.setScale("x",{min:v,max:w});i=!1}),dn("moment",()=>e.forEach(p=>p.redraw(!1,!1)));let y=0;new ResizeObserver(()=>{if(t.clientWidth!==y){y=t.clientWidth;for(let p of e)p.setSize({width:Math.max(p.root.parentElement.clientWidth,200),height:200})}}).observe(t);let g=ht("p",{class:"hint noprint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics");return{element:ht("div",{},g,t),redraw:a}}function Zx(n,t,e){if(n===null||t===null)return[0,1];let i=.002*Math.max(Math.abs(n),Math.abs(t))||De(1,e),s=Math.max(t-n,i),r=(n+t)/2;return[r-.58*s,r+.58*s]}function Wo(n,t){let e=Math.min(Math.max(fs(n,t??0),1),n.length-1);return Math.abs(n[e]-t)<Math.abs(n[e-1]-t)?e:e-1}var lm=matchMedia("(prefers-color-scheme: dark)"),_u=!1,Us=()=>_u,Jx=()=>!_u&&(Qt.theme==="dark"||Qt.theme==="auto"&&lm.matches);function cm(n){let t=()=>{document.documentElement.dataset.theme=Jx()?"dark":"light"},e=()=>{t(),n()};lm.addEventListener("change",e);let i=s=>()=>{_u=s;for(let r of document.querySelectorAll("details.prints"))s?(r.dataset.was=r.open?"open":"",r.open=!0):r.open=r.dataset.was==="open";e()};return addEventListener("beforeprint",i(!0)),addEventListener("afterprint",i(!1)),t(),s=>{rn({theme:s}),e()}}function ci(n,t,e){let i=t-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],step:1};let s=i/Math.max(e,1),r=10**Math.floor(Math.log10(s)),o=[1,2,2.5,5,10].map(l=>l*r).find(l=>l>=s*.999),a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=t+o*1e-9;l++)a.push(l*o);return{values:a,step:o}}function hm(n,t,e){for(let s=Math.floor(e/24);s>1;s--){let r=ci(n,t,s),o=Math.max(...r.values.map(a=>hi(a,r.step).length));if(1.25*6.2*o+5<=r.step/(t-n)*e)return r}return ci(n,t,1)}function hi(n,t){let e=Math.abs(n)<t*1e-6?0:n,i=0;for(;i<8&&Math.abs(t*10**i-Math.round(t*10**i))>1e-6;)i++;return Ls(e.toFixed(i))}function um(n,t,e,i){if(!(n<=t)||n===0&&t===0)return[0,i];(e||n>0&&n<.35*t)&&(n=Math.min(n,0)),(e||t<0&&t>.35*n)&&(t=Math.max(t,0));let r=.05*(t-n||Math.abs(t)*.2||1);return[n===0?0:n-r,t===0?0:t+r]}var gl=58,fm=96,_l=10,dm=34,xu=430,Kx=730;function jx(n,t){let e=n.filter(Number.isFinite).map(Math.abs).sort((i,s)=>i-s);return e[Math.floor(t*(e.length-1))]||1}function pm(n){let t="side_force",e=ht("canvas",{class:"map",role:"img","aria-label":"Contact over depth and time"}),i=ht("p",{class:"readout-line"}," "),s=ht("div",{class:"map-holder"},e),r=ht("div",{class:"tools noprint"},nr("What the map shows",[["side_force","Side force, by side"],["contact_force","Contact force"]],t,h=>{t=h,a()}),ht("span",{class:"hint"},"follows the depths and times in view above; click to choose a depth and a time")),o=h=>({depths:Qt.depths??[0,h.contact.md_m.at(-1)],times:Qt.times??[h.contact.from_s,h.contact.time_s.at(-1)]});function a(){let h=Xn(n);if(!h?.contact)return;let m=Math.max(devicePixelRatio,2),y=Us()?Kx:s.clientWidth||1200;e.width=y*m,e.height=xu*m,e.style.aspectRatio=`${y} / ${xu}`;let g=e.getContext("2d");g.scale(m,m),g.font="11px system-ui, sans-serif";let{depths:p,times:v}=o(h),w={left:gl,top:_l,width:y-gl-fm,height:xu-_l-dm},M=jx(Array.from(h.contact[t]),.985),R=t==="side_force",A=Za(R),_=S=>A(R?.5+.5*S/M:S/M);l(g,h,w,p,v,_),c(g,w,p,v,h),f(g,w,M,_)}function l(h,m,y,[g,p],[v,w],M){let{contact:R}=m,A=R.md_m.length,_=new ImageData(R.time_s.length,Math.round(y.height));for(let P=0;P<_.height;P++){let O=Wo(R.md_m,g+(P+.5)/_.height*(p-g));for(let k=0;k<_.width;k++){let[N,V,W]=M(R[t][k*A+O]||0);_.data.set([N,V,W,255],4*(P*_.width+k))}}let S=new OffscreenCanvas(_.width,_.height);S.getContext("2d").putImageData(_,0,0),h.save(),h.beginPath(),h.rect(y.left,y.top,y.width,y.height),h.clip(),h.imageSmoothingEnabled=!1;let I=P=>y.left+(P-v)/(w-v)*y.width,C=R.from_s;R.time_s.forEach((P,O)=>{h.drawImage(S,O,0,1,_.height,I(C),y.top,I(P)-I(C)+.5,y.height),C=P}),h.restore()}function c(h,m,[y,g],[p,v],w){let M=I=>m.top+(I-y)/(g-y)*m.height,R=I=>m.left+(I-p)/(v-p)*m.width;h.fillStyle=h.strokeStyle=on("muted"),h.textBaseline="middle",h.textAlign="right";let A=ci(De(y,"length"),De(g,"length"),9);for(let I of A.values)h.fillText(hi(I,A.step),m.left-8,M(Li(I,"length")));h.textAlign="center",h.textBaseline="top";let _=ci(p,v,12);for(let I of _.values)h.fillText(hi(I,_.step),R(I),m.top+m.height+6);h.fillText("time, s",m.left+m.width/2,m.top+m.height+20),h.save(),h.translate(9,m.top+m.height/2),h.rotate(-Math.PI/2),h.fillText(`MD, ${Rn("length")}`,0,-4),h.restore(),h.strokeStyle=on("frame"),h.strokeRect(m.left,m.top,m.width,m.height);let S=(I,C,P,O)=>{h.beginPath(),h.moveTo(I,C),h.lineTo(P,O),h.stroke()};h.strokeStyle=on("text"),h.setLineDash([4,4]),w.window_s>p&&w.window_s<v&&(S(R(w.window_s),m.top,R(w.window_s),m.top+m.height),h.textAlign="left",h.fillStyle=on("text"),h.fillText("window ▸",R(w.window_s)+4,m.top+4)),h.setLineDash([1,3]);for(let{kind:I,to_m:C}of n.hole)I==="casing"&&C>y&&C<g&&(S(m.left,M(C),m.left+m.width,M(C)),h.textAlign="left",h.fillStyle=on("text"),h.fillText("shoe",m.left+4,M(C)-13));h.setLineDash([]),Qt.depth!==null&&Qt.depth>y&&Qt.depth<g&&S(m.left,M(Qt.depth),m.left+m.width,M(Qt.depth)),Qt.moment!==null&&Qt.moment>p&&Qt.moment<v&&S(R(Qt.moment),m.top,R(Qt.moment),m.top+m.height)}function f(h,m,y,g){let p=m.left+m.width+14,v=t==="side_force"?-y:0,w=120;for(let R=0;R<w;R++){let[A,_,S]=g(v+(R+.5)/w*(y-v));h.fillStyle=`rgb(${A} ${_} ${S})`,h.fillRect(p,m.top+m.height*(1-(R+1)/w),12,m.height/w+.6)}h.strokeStyle=on("frame"),h.strokeRect(p,m.top,12,m.height);let M=ci(De(v,"force per length"),De(y,"force per length"),6);h.fillStyle=on("muted"),h.textAlign="left",h.textBaseline="middle";for(let R of M.values){let A=(Li(R,"force per length")-v)/(y-v);h.fillText(hi(R,M.step),p+17,m.top+m.height*(1-A))}h.fillText(Rn("force per length"),p,m.top+m.height+12),t==="side_force"&&(h.save(),h.textAlign="center",h.translate(p+66,m.top+m.height*.25),h.rotate(-Math.PI/2),h.fillText("high side",0,0),h.restore(),h.save(),h.textAlign="center",h.translate(p+66,m.top+m.height*.75),h.rotate(-Math.PI/2),h.fillText("low side",0,0),h.restore())}function d(h){let m=Xn(n);if(!m?.contact)return null;let y=e.getBoundingClientRect(),{depths:g,times:p}=o(m),v=(h.clientX-y.left-gl)/(y.width-gl-fm),w=(h.clientY-y.top-_l)/(y.height-_l-dm);return v<0||v>1||w<0||w>1?null:{depth:g[0]+w*(g[1]-g[0]),moment:p[0]+v*(p[1]-p[0])}}e.addEventListener("pointermove",h=>{let m=d(h);if(rn({pointer:m?.depth??null}),!m)return void(i.textContent=" ");let{contact:y}=Xn(n),g=Math.min(Math.max(Array.from(y.time_s).findIndex(w=>w>=m.moment),0),y.time_s.length-1),p=y[t][g*y.md_m.length+Wo(y.md_m,m.depth)],v=t==="contact_force"||Math.abs(p)===0?"":p>0?", high side":", low side";i.textContent=`MD ${pn(m.depth,"length",5)}, ${Un(m.moment,4)} s: ${pn(Math.abs(p),"force per length",3)}${v}`}),e.addEventListener("pointerleave",()=>{rn({pointer:null}),i.textContent=" "}),e.addEventListener("click",h=>{let m=d(h);m&&rn(m)}),dn("units operation depths times depth moment",a);let u=0;return new ResizeObserver(()=>{s.clientWidth!==u&&(u=s.clientWidth,a())}).observe(s),{element:ht("div",{},r,s,i),redraw:a}}function mm(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function Qx(n){if(n.f32!==void 0)return new Float32Array(mm(n.f32));let[t,e,i]=n.i16,s=new Int16Array(mm(t)),r=new Float32Array(s.length);for(let o=0;o<s.length;o++)r[o]=s[o]===-32768?NaN:e+i*s[o];return r}function yu(n){return Array.isArray(n)?n.map(yu):n===null||typeof n!="object"?n:typeof n.f32=="string"||Array.isArray(n.i16)?Qx(n):Object.fromEntries(Object.entries(n).map(([t,e])=>[t,yu(e)]))}function gm(){return yu(JSON.parse(document.getElementById("report").textContent))}function _m(n,t,e){let i=cm(e);return ht("header",{},ht("div",{class:"title-line"},ht("h1",{},n),ht("div",{class:"controls noprint"},nr("Units",[["si","SI"],["metric","Metric"],["field","US field"]],Qt.units,s=>rn({units:s})),nr("Colours",[["auto","Auto"],["light","Light"],["dark","Dark"]],Qt.theme,i),ht("button",{type:"button",onclick:()=>print()},"Print"))),t)}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Zm=0,Zu=1,Jm=2;var Aa=1,Km=2,So=3,$s=0,jn=1,Ei=2,xr=0,bo=1,Ju=2,Ku=3,ju=4,jm=5;var yr=100,Qm=101,tg=102,eg=103,ng=104,ig=200,sg=201,rg=202,og=203,Qu=204,tf=205,ag=206,lg=207,cg=208,hg=209,ug=210,fg=211,dg=212,pg=213,mg=214,Xl=0,ql=1,Yl=2,co=3,$l=4,Zl=5,Jl=6,Kl=7,Ec=0,gg=1,_g=2,ns=0,ef=1,nf=2,sf=3,rf=4,of=5,af=6,lf=7;var cf=300,vr=301,wo=302,Ac=303,Rc=304,jl=1e3,Qi=1001,Ql=1002,In=1003,xg=1004;var Ra=1005;var Jn=1006,Cc=1007;var bs=1008;var ti=1009,hf=1010,uf=1011,To=1012,Pc=1013,ki=1014,Vi=1015,Gi=1016,Ic=1017,Lc=1018,Mr=1020,ff=35902,df=35899,pf=1021,mf=1022,Hi=1023,vs=1026,ws=1027,gf=1028,Dc=1029,Zs=1030,Nc=1031;var Uc=1033,Ca=33776,Pa=33777,Ia=33778,La=33779,Fc=35840,Oc=35841,Bc=35842,zc=35843,kc=36196,Vc=37492,Gc=37496,Hc=37488,Wc=37489,Da=37490,Xc=37491,qc=37808,Yc=37809,$c=37810,Zc=37811,Jc=37812,Kc=37813,jc=37814,Qc=37815,th=37816,eh=37817,nh=37818,ih=37819,sh=37820,rh=37821,oh=36492,ah=36494,lh=36495,ch=36283,hh=36284,Na=36285,uh=36286;var na=2300,tc=2301,Hl=2302,Gu=2303,Hu=2400,Wu=2401,Xu=2402;var yg=3200;var fh=0,vg=1,Ts="",di="srgb",ia="srgb-linear",sa="linear",Ue="srgb";var Wl=7680;var Mg=519,Sg=512,bg=513,wg=514,_f=515,Tg=516,Eg=517,xf=518,yf=519,vf=35044;var Mf="300 es",Ti=2e3,ho=2001;function ty(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function ey(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ra(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ag(){let n=ra("canvas");return n.style.display="block",n}var xm={},uo=null;function oa(...n){let t="THREE."+n.shift();uo?uo("log",t,...n):console.log(t,...n)}function Rg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function te(...n){n=Rg(n);let t="THREE."+n.shift();if(uo)uo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ae(...n){n=Rg(n);let t="THREE."+n.shift();if(uo)uo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Qo(...n){let t=n.join(" ");t in xm||(xm[t]=!0,te(...n))}function Cg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Pg={[Xl]:Xl,[Yl]:Jl,[$l]:$l,[co]:Zl,[ql]:ql,[Jl]:Yl,[Kl]:Kl,[Zl]:co},zi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ym=1234567,ta=Math.PI/180,fo=180/Math.PI;function Js(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]+"-"+Fn[t&255]+Fn[t>>8&255]+"-"+Fn[t>>16&15|64]+Fn[t>>24&255]+"-"+Fn[e&63|128]+Fn[e>>8&255]+"-"+Fn[e>>16&255]+Fn[e>>24&255]+Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]).toLowerCase()}function ye(n,t,e){return Math.max(t,Math.min(e,n))}function Sf(n,t){return(n%t+t)%t}function ny(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function iy(n,t,e){return n!==t?(e-n)/(t-n):0}function ea(n,t,e){return(1-e)*n+e*t}function sy(n,t,e,i){return ea(n,t,1-Math.exp(-e*i))}function ry(n,t=1){return t-Math.abs(Sf(n,t*2)-t)}function oy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function ay(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function ly(n,t){return n+Math.floor(Math.random()*(t-n+1))}function cy(n,t){return n+Math.random()*(t-n)}function hy(n){return n*(.5-Math.random())}function uy(n){n!==void 0&&(ym=n);let t=ym+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function fy(n){return n*ta}function dy(n){return n*fo}function py(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function my(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function bf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function gy(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),f=o((t+i)/2),d=r((t-i)/2),u=o((t-i)/2),h=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*f,l*d,l*u,a*c);break;case"YZY":n.set(l*u,a*f,l*d,a*c);break;case"ZXZ":n.set(l*d,l*u,a*f,a*c);break;case"XZX":n.set(a*f,l*m,l*h,a*c);break;case"YXY":n.set(l*h,a*f,l*m,a*c);break;case"ZYZ":n.set(l*m,l*h,a*f,a*c);break;default:te("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function dh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function wf(n,t){if(t.constructor===Float32Array)return n;let e=dh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Tf(n,t){if(t.constructor===Float32Array)return n;let e=dh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Ef={DEG2RAD:ta,RAD2DEG:fo,generateUUID:Js,clamp:ye,euclideanModulo:Sf,mapLinear:ny,inverseLerp:iy,lerp:ea,damp:sy,pingpong:ry,smoothstep:oy,smootherstep:ay,randInt:ly,randFloat:cy,randFloatSpread:hy,seededRandom:uy,degToRad:fy,radToDeg:dy,isPowerOfTwo:py,ceilPowerOfTwo:my,floorPowerOfTwo:bf,setQuaternionFromProperEuler:gy,normalize:Tf,denormalize:wf},jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ye(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},mi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],f=i[s+2],d=i[s+3],u=r[o+0],h=r[o+1],m=r[o+2],y=r[o+3];if(d!==y||l!==u||c!==h||f!==m){let g=l*u+c*h+f*m+d*y;g<0&&(u=-u,h=-h,m=-m,y=-y,g=-g);let p=1-a;if(g<.9995){let v=Math.acos(g),w=Math.sin(v);p=Math.sin(p*v)/w,a=Math.sin(a*v)/w,l=l*p+u*a,c=c*p+h*a,f=f*p+m*a,d=d*p+y*a}else{l=l*p+u*a,c=c*p+h*a,f=f*p+m*a,d=d*p+y*a;let v=1/Math.sqrt(l*l+c*c+f*f+d*d);l*=v,c*=v,f*=v,d*=v}}t[e]=l,t[e+1]=c,t[e+2]=f,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],f=i[s+3],d=r[o],u=r[o+1],h=r[o+2],m=r[o+3];return t[e]=a*m+f*d+l*h-c*u,t[e+1]=l*m+f*u+c*d-a*h,t[e+2]=c*m+f*h+a*u-l*d,t[e+3]=f*m-a*d-l*u-c*h,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),f=a(s/2),d=a(r/2),u=l(i/2),h=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=u*f*d+c*h*m,this._y=c*h*d-u*f*m,this._z=c*f*m+u*h*d,this._w=c*f*d-u*h*m;break;case"YXZ":this._x=u*f*d+c*h*m,this._y=c*h*d-u*f*m,this._z=c*f*m-u*h*d,this._w=c*f*d+u*h*m;break;case"ZXY":this._x=u*f*d-c*h*m,this._y=c*h*d+u*f*m,this._z=c*f*m+u*h*d,this._w=c*f*d-u*h*m;break;case"ZYX":this._x=u*f*d-c*h*m,this._y=c*h*d+u*f*m,this._z=c*f*m-u*h*d,this._w=c*f*d+u*h*m;break;case"YZX":this._x=u*f*d+c*h*m,this._y=c*h*d+u*f*m,this._z=c*f*m-u*h*d,this._w=c*f*d-u*h*m;break;case"XZY":this._x=u*f*d-c*h*m,this._y=c*h*d-u*f*m,this._z=c*f*m+u*h*d,this._w=c*f*d+u*h*m;break;default:te("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],f=e[6],d=e[10],u=i+a+d;if(u>0){let h=.5/Math.sqrt(u+1);this._w=.25/h,this._x=(f-l)*h,this._y=(r-c)*h,this._z=(o-s)*h}else if(i>a&&i>d){let h=2*Math.sqrt(1+i-a-d);this._w=(f-l)/h,this._x=.25*h,this._y=(s+o)/h,this._z=(r+c)/h}else if(a>d){let h=2*Math.sqrt(1+a-i-d);this._w=(r-c)/h,this._x=(s+o)/h,this._y=.25*h,this._z=(l+f)/h}else{let h=2*Math.sqrt(1+d-i-a);this._w=(o-s)/h,this._x=(r+c)/h,this._y=(l+f)/h,this._z=.25*h}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,f=e._w;return this._x=i*f+o*a+s*c-r*l,this._y=s*f+o*l+r*a-i*c,this._z=r*f+o*c+i*l-s*a,this._w=o*f-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),f=Math.sin(c);l=Math.sin(l*c)/f,e=Math.sin(e*c)/f,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Y=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(vm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(vm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),f=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*f,this.y=i+l*f+a*c-r*d,this.z=s+l*d+r*f-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return vu.copy(this).projectOnVector(t),this.sub(vu)}reflect(t){return this.sub(vu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ye(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},vu=new Y,vm=new mi,he=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let f=this.elements;return f[0]=t,f[1]=s,f[2]=a,f[3]=e,f[4]=r,f[5]=l,f[6]=i,f[7]=o,f[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],f=i[4],d=i[7],u=i[2],h=i[5],m=i[8],y=s[0],g=s[3],p=s[6],v=s[1],w=s[4],M=s[7],R=s[2],A=s[5],_=s[8];return r[0]=o*y+a*v+l*R,r[3]=o*g+a*w+l*A,r[6]=o*p+a*M+l*_,r[1]=c*y+f*v+d*R,r[4]=c*g+f*w+d*A,r[7]=c*p+f*M+d*_,r[2]=u*y+h*v+m*R,r[5]=u*g+h*w+m*A,r[8]=u*p+h*M+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8];return e*o*f-e*a*c-i*r*f+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],d=f*o-a*c,u=a*l-f*r,h=c*r-o*l,m=e*d+i*u+s*h;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return t[0]=d*y,t[1]=(s*c-f*i)*y,t[2]=(a*i-s*o)*y,t[3]=u*y,t[4]=(f*e-s*l)*y,t[5]=(s*r-a*e)*y,t[6]=h*y,t[7]=(i*l-c*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Qo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Mu.makeScale(t,e)),this}rotate(t){return Qo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Mu.makeRotation(-t)),this}translate(t,e){return Qo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Mu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Mu=new he,Mm=new he().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Sm=new he().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _y(){let n={enabled:!0,workingColorSpace:ia,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ue&&(s.r=ys(s.r),s.g=ys(s.g),s.b=ys(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ue&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ts?sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ia]:{primaries:t,whitePoint:i,transfer:sa,toXYZ:Mm,fromXYZ:Sm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:t,whitePoint:i,transfer:Ue,toXYZ:Mm,fromXYZ:Sm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:di}}}),n}var be=_y();function ys(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function lo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Xr,ec=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Xr===void 0&&(Xr=ra("canvas")),Xr.width=t.width,Xr.height=t.height;let s=Xr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Xr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ra("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ys(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ys(e[i]/255)*255):e[i]=ys(e[i]);return{data:e,width:t.width,height:t.height}}else return te("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},xy=0,po=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:xy++}),this.uuid=Js(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Su(s[o].image)):r.push(Su(s[o]))}else r=Su(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Su(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?ec.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(te("Texture: Unable to serialize Texture."),{})}var yy=0,bu=new Y,Kn=class n extends zi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Qi,s=Qi,r=Jn,o=bs,a=Hi,l=ti,c=n.DEFAULT_ANISOTROPY,f=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:yy++}),this.uuid=Js(),this.name="",this.source=new po(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new jt(0,0),this.repeat=new jt(1,1),this.center=new jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new he,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=f,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(bu).x}get height(){return this.source.getSize(bu).y}get depth(){return this.source.getSize(bu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){te(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==cf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case jl:t.x=t.x-Math.floor(t.x);break;case Qi:t.x=t.x<0?0:1;break;case Ql:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case jl:t.y=t.y-Math.floor(t.y);break;case Qi:t.y=t.y<0?0:1;break;case Ql:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=cf;Kn.DEFAULT_ANISOTROPY=1;var je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],f=l[4],d=l[8],u=l[1],h=l[5],m=l[9],y=l[2],g=l[6],p=l[10];if(Math.abs(f-u)<.01&&Math.abs(d-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(f+u)<.1&&Math.abs(d+y)<.1&&Math.abs(m+g)<.1&&Math.abs(c+h+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,M=(h+1)/2,R=(p+1)/2,A=(f+u)/4,_=(d+y)/4,S=(m+g)/4;return w>M&&w>R?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=A/i,r=_/i):M>R?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=A/s,r=S/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=_/r,s=S/r),this.set(i,s,r,e),this}let v=Math.sqrt((g-m)*(g-m)+(d-y)*(d-y)+(u-f)*(u-f));return Math.abs(v)<.001&&(v=1),this.x=(g-m)/v,this.y=(d-y)/v,this.z=(u-f)/v,this.w=Math.acos((c+h+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},nc=class extends zi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new po(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends nc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},aa=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var ic=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var We=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,f,d,u,h,m,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,f,d,u,h,m,y,g)}set(t,e,i,s,r,o,a,l,c,f,d,u,h,m,y,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=f,p[10]=d,p[14]=u,p[3]=h,p[7]=m,p[11]=y,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/qr.setFromMatrixColumn(t,0).length(),r=1/qr.setFromMatrixColumn(t,1).length(),o=1/qr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),f=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*f,h=o*d,m=a*f,y=a*d;e[0]=l*f,e[4]=-l*d,e[8]=c,e[1]=h+m*c,e[5]=u-y*c,e[9]=-a*l,e[2]=y-u*c,e[6]=m+h*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*f,h=l*d,m=c*f,y=c*d;e[0]=u+y*a,e[4]=m*a-h,e[8]=o*c,e[1]=o*d,e[5]=o*f,e[9]=-a,e[2]=h*a-m,e[6]=y+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*f,h=l*d,m=c*f,y=c*d;e[0]=u-y*a,e[4]=-o*d,e[8]=m+h*a,e[1]=h+m*a,e[5]=o*f,e[9]=y-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*f,h=o*d,m=a*f,y=a*d;e[0]=l*f,e[4]=m*c-h,e[8]=u*c+y,e[1]=l*d,e[5]=y*c+u,e[9]=h*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,h=o*c,m=a*l,y=a*c;e[0]=l*f,e[4]=y-u*d,e[8]=m*d+h,e[1]=d,e[5]=o*f,e[9]=-a*f,e[2]=-c*f,e[6]=h*d+m,e[10]=u-y*d}else if(t.order==="XZY"){let u=o*l,h=o*c,m=a*l,y=a*c;e[0]=l*f,e[4]=-d,e[8]=c*f,e[1]=u*d+y,e[5]=o*f,e[9]=h*d-m,e[2]=m*d-h,e[6]=a*f,e[10]=y*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(vy,t,My)}lookAt(t,e,i){let s=this.elements;return ui.subVectors(t,e),ui.lengthSq()===0&&(ui.z=1),ui.normalize(),Fs.crossVectors(i,ui),Fs.lengthSq()===0&&(Math.abs(i.z)===1?ui.x+=1e-4:ui.z+=1e-4,ui.normalize(),Fs.crossVectors(i,ui)),Fs.normalize(),xl.crossVectors(ui,Fs),s[0]=Fs.x,s[4]=xl.x,s[8]=ui.x,s[1]=Fs.y,s[5]=xl.y,s[9]=ui.y,s[2]=Fs.z,s[6]=xl.z,s[10]=ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],f=i[1],d=i[5],u=i[9],h=i[13],m=i[2],y=i[6],g=i[10],p=i[14],v=i[3],w=i[7],M=i[11],R=i[15],A=s[0],_=s[4],S=s[8],I=s[12],C=s[1],P=s[5],O=s[9],k=s[13],N=s[2],V=s[6],W=s[10],z=s[14],tt=s[3],X=s[7],Z=s[11],et=s[15];return r[0]=o*A+a*C+l*N+c*tt,r[4]=o*_+a*P+l*V+c*X,r[8]=o*S+a*O+l*W+c*Z,r[12]=o*I+a*k+l*z+c*et,r[1]=f*A+d*C+u*N+h*tt,r[5]=f*_+d*P+u*V+h*X,r[9]=f*S+d*O+u*W+h*Z,r[13]=f*I+d*k+u*z+h*et,r[2]=m*A+y*C+g*N+p*tt,r[6]=m*_+y*P+g*V+p*X,r[10]=m*S+y*O+g*W+p*Z,r[14]=m*I+y*k+g*z+p*et,r[3]=v*A+w*C+M*N+R*tt,r[7]=v*_+w*P+M*V+R*X,r[11]=v*S+w*O+M*W+R*Z,r[15]=v*I+w*k+M*z+R*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],f=t[2],d=t[6],u=t[10],h=t[14],m=t[3],y=t[7],g=t[11],p=t[15],v=l*h-c*u,w=a*h-c*d,M=a*u-l*d,R=o*h-c*f,A=o*u-l*f,_=o*d-a*f;return e*(y*v-g*w+p*M)-i*(m*v-g*R+p*A)+s*(m*w-y*R+p*_)-r*(m*M-y*A+g*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],f=t[10];return e*(o*f-a*c)-i*(r*f-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],d=t[9],u=t[10],h=t[11],m=t[12],y=t[13],g=t[14],p=t[15],v=e*a-i*o,w=e*l-s*o,M=e*c-r*o,R=i*l-s*a,A=i*c-r*a,_=s*c-r*l,S=f*y-d*m,I=f*g-u*m,C=f*p-h*m,P=d*g-u*y,O=d*p-h*y,k=u*p-h*g,N=v*k-w*O+M*P+R*C-A*I+_*S;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/N;return t[0]=(a*k-l*O+c*P)*V,t[1]=(s*O-i*k-r*P)*V,t[2]=(y*_-g*A+p*R)*V,t[3]=(u*A-d*_-h*R)*V,t[4]=(l*C-o*k-c*I)*V,t[5]=(e*k-s*C+r*I)*V,t[6]=(g*M-m*_-p*w)*V,t[7]=(f*_-u*M+h*w)*V,t[8]=(o*O-a*C+c*S)*V,t[9]=(i*C-e*O-r*S)*V,t[10]=(m*A-y*M+p*v)*V,t[11]=(d*M-f*A-h*v)*V,t[12]=(a*I-o*P-l*S)*V,t[13]=(e*P-i*I+s*S)*V,t[14]=(y*w-m*R-g*v)*V,t[15]=(f*R-d*w+u*v)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,f=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,f*a+i,f*l-s*o,0,c*l-s*a,f*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,f=o+o,d=a+a,u=r*c,h=r*f,m=r*d,y=o*f,g=o*d,p=a*d,v=l*c,w=l*f,M=l*d,R=i.x,A=i.y,_=i.z;return s[0]=(1-(y+p))*R,s[1]=(h+M)*R,s[2]=(m-w)*R,s[3]=0,s[4]=(h-M)*A,s[5]=(1-(u+p))*A,s[6]=(g+v)*A,s[7]=0,s[8]=(m+w)*_,s[9]=(g-v)*_,s[10]=(1-(u+y))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=qr.set(s[0],s[1],s[2]).length(),a=qr.set(s[4],s[5],s[6]).length(),l=qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Fi.copy(this);let c=1/o,f=1/a,d=1/l;return Fi.elements[0]*=c,Fi.elements[1]*=c,Fi.elements[2]*=c,Fi.elements[4]*=f,Fi.elements[5]*=f,Fi.elements[6]*=f,Fi.elements[8]*=d,Fi.elements[9]*=d,Fi.elements[10]*=d,e.setFromRotationMatrix(Fi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Ti,l=!1){let c=this.elements,f=2*r/(e-t),d=2*r/(i-s),u=(e+t)/(e-t),h=(i+s)/(i-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===Ti)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===ho)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=h,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ti,l=!1){let c=this.elements,f=2/(e-t),d=2/(i-s),u=-(e+t)/(e-t),h=-(i+s)/(i-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===Ti)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===ho)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=h,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},qr=new Y,Fi=new We,vy=new Y(0,0,0),My=new Y(1,1,1),Fs=new Y,xl=new Y,ui=new Y,bm=new We,wm=new mi,Ms=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],f=s[9],d=s[2],u=s[6],h=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-f,h),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(a,h),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ye(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,h),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,h),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-f,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,h));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-f,h),this._y=0);break;default:te("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return bm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(bm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return wm.setFromEuler(this),this.setFromQuaternion(wm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ms.DEFAULT_ORDER="XYZ";var la=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Sy=0,Tm=new Y,Yr=new mi,ds=new We,yl=new Y,Xo=new Y,by=new Y,wy=new mi,Em=new Y(1,0,0),Am=new Y(0,1,0),Rm=new Y(0,0,1),Cm={type:"added"},Ty={type:"removed"},$r={type:"childadded",child:null},wu={type:"childremoved",child:null},Dn=class n extends zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Sy++}),this.uuid=Js(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new Y,e=new Ms,i=new mi,s=new Y(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new We},normalMatrix:{value:new he}}),this.matrix=new We,this.matrixWorld=new We,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new la,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.multiply(Yr),this}rotateOnWorldAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.premultiply(Yr),this}rotateX(t){return this.rotateOnAxis(Em,t)}rotateY(t){return this.rotateOnAxis(Am,t)}rotateZ(t){return this.rotateOnAxis(Rm,t)}translateOnAxis(t,e){return Tm.copy(t).applyQuaternion(this.quaternion),this.position.add(Tm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Em,t)}translateY(t){return this.translateOnAxis(Am,t)}translateZ(t){return this.translateOnAxis(Rm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?yl.copy(t):yl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Xo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(Xo,yl,this.up):ds.lookAt(yl,Xo,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Yr.setFromRotationMatrix(ds),this.quaternion.premultiply(Yr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ae("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Cm),$r.child=t,this.dispatchEvent($r),$r.child=null):ae("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Ty),wu.child=t,this.dispatchEvent(wu),wu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Cm),$r.child=t,this.dispatchEvent($r),$r.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,t,by),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,wy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,f=l.length;c<f;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),f=o(t.images),d=o(t.shapes),u=o(t.skeletons),h=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),f.length>0&&(i.images=f),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),h.length>0&&(i.animations=h),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let f=a[c];delete f.metadata,l.push(f)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new Y(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var mr=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ey={type:"move"},mo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new mr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new mr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new mr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let y of t.hand.values()){let g=e.getJointPose(y,i),p=this._getHandJoint(c,y);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let f=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=f.position.distanceTo(d.position),h=.02,m=.005;c.inputState.pinching&&u>h+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=h-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ey)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new mr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Ig={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Os={h:0,s:0,l:0},vl={h:0,s:0,l:0};function Tu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var pe=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=di){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,be.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=be.workingColorSpace){return this.r=t,this.g=e,this.b=i,be.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=be.workingColorSpace){if(t=Sf(t,1),e=ye(e,0,1),i=ye(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Tu(o,r,t+1/3),this.g=Tu(o,r,t),this.b=Tu(o,r,t-1/3)}return be.colorSpaceToWorking(this,s),this}setStyle(t,e=di){function i(r){r!==void 0&&parseFloat(r)<1&&te("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:te("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);te("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=di){let i=Ig[t.toLowerCase()];return i!==void 0?this.setHex(i,e):te("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ys(t.r),this.g=ys(t.g),this.b=ys(t.b),this}copyLinearToSRGB(t){return this.r=lo(t.r),this.g=lo(t.g),this.b=lo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=di){return be.workingToColorSpace(On.copy(this),t),Math.round(ye(On.r*255,0,255))*65536+Math.round(ye(On.g*255,0,255))*256+Math.round(ye(On.b*255,0,255))}getHexString(t=di){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=be.workingColorSpace){be.workingToColorSpace(On.copy(this),e);let i=On.r,s=On.g,r=On.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,f=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=f<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=f,t}getRGB(t,e=be.workingColorSpace){return be.workingToColorSpace(On.copy(this),e),t.r=On.r,t.g=On.g,t.b=On.b,t}getStyle(t=di){be.workingToColorSpace(On.copy(this),t);let e=On.r,i=On.g,s=On.b;return t!==di?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Os),this.setHSL(Os.h+t,Os.s+e,Os.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Os),t.getHSL(vl);let i=ea(Os.h,vl.h,e),s=ea(Os.s,vl.s,e),r=ea(Os.l,vl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},On=new pe;pe.NAMES=Ig;var ca=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ms,this.environmentIntensity=1,this.environmentRotation=new Ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Oi=new Y,ps=new Y,Eu=new Y,ms=new Y,Zr=new Y,Jr=new Y,Pm=new Y,Au=new Y,Ru=new Y,Cu=new Y,Pu=new je,Iu=new je,Lu=new je,xs=class n{constructor(t=new Y,e=new Y,i=new Y){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Oi.subVectors(t,e),s.cross(Oi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Oi.subVectors(s,e),ps.subVectors(i,e),Eu.subVectors(t,e);let o=Oi.dot(Oi),a=Oi.dot(ps),l=Oi.dot(Eu),c=ps.dot(ps),f=ps.dot(Eu),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,h=(c*l-a*f)*u,m=(o*f-a*l)*u;return r.set(1-h-m,m,h)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ms)===null?!1:ms.x>=0&&ms.y>=0&&ms.x+ms.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ms.x),l.addScaledVector(o,ms.y),l.addScaledVector(a,ms.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Pu.setScalar(0),Iu.setScalar(0),Lu.setScalar(0),Pu.fromBufferAttribute(t,e),Iu.fromBufferAttribute(t,i),Lu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Pu,r.x),o.addScaledVector(Iu,r.y),o.addScaledVector(Lu,r.z),o}static isFrontFacing(t,e,i,s){return Oi.subVectors(i,e),ps.subVectors(t,e),Oi.cross(ps).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Oi.subVectors(this.c,this.b),ps.subVectors(this.a,this.b),Oi.cross(ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Zr.subVectors(s,i),Jr.subVectors(r,i),Au.subVectors(t,i);let l=Zr.dot(Au),c=Jr.dot(Au);if(l<=0&&c<=0)return e.copy(i);Ru.subVectors(t,s);let f=Zr.dot(Ru),d=Jr.dot(Ru);if(f>=0&&d<=f)return e.copy(s);let u=l*d-f*c;if(u<=0&&l>=0&&f<=0&&l-f>0)return o=l/(l-f),e.copy(i).addScaledVector(Zr,o);Cu.subVectors(t,r);let h=Zr.dot(Cu),m=Jr.dot(Cu);if(m>=0&&h<=m)return e.copy(r);let y=h*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(Jr,a);let g=f*m-h*d;if(g<=0&&d-f>=0&&h-m>=0)return Pm.subVectors(r,s),a=(d-f)/(d-f+(h-m)),e.copy(s).addScaledVector(Pm,a);let p=1/(g+y+u);return o=y*p,a=u*p,e.copy(i).addScaledVector(Zr,o).addScaledVector(Jr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Vs=class{constructor(t=new Y(1/0,1/0,1/0),e=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Bi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Bi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Bi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Bi):Bi.fromBufferAttribute(r,o),Bi.applyMatrix4(t.matrixWorld),this.expandByPoint(Bi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ml.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ml.copy(i.boundingBox)),Ml.applyMatrix4(t.matrixWorld),this.union(Ml)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Bi),Bi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qo),Sl.subVectors(this.max,qo),Kr.subVectors(t.a,qo),jr.subVectors(t.b,qo),Qr.subVectors(t.c,qo),Bs.subVectors(jr,Kr),zs.subVectors(Qr,jr),ur.subVectors(Kr,Qr);let e=[0,-Bs.z,Bs.y,0,-zs.z,zs.y,0,-ur.z,ur.y,Bs.z,0,-Bs.x,zs.z,0,-zs.x,ur.z,0,-ur.x,-Bs.y,Bs.x,0,-zs.y,zs.x,0,-ur.y,ur.x,0];return!Du(e,Kr,jr,Qr,Sl)||(e=[1,0,0,0,1,0,0,0,1],!Du(e,Kr,jr,Qr,Sl))?!1:(bl.crossVectors(Bs,zs),e=[bl.x,bl.y,bl.z],Du(e,Kr,jr,Qr,Sl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Bi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Bi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(gs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),gs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),gs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),gs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),gs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),gs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),gs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),gs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(gs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},gs=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Bi=new Y,Ml=new Vs,Kr=new Y,jr=new Y,Qr=new Y,Bs=new Y,zs=new Y,ur=new Y,qo=new Y,Sl=new Y,bl=new Y,fr=new Y;function Du(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){fr.fromArray(n,r);let a=s.x*Math.abs(fr.x)+s.y*Math.abs(fr.y)+s.z*Math.abs(fr.z),l=t.dot(fr),c=e.dot(fr),f=i.dot(fr);if(Math.max(-Math.max(l,c,f),Math.min(l,c,f))>a)return!1}return!0}var gn=new Y,wl=new jt,Ay=0,Zn=class extends zi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ay++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=vf,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=t!==void 0?dh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)wl.fromBufferAttribute(this,e),wl.applyMatrix3(t),this.setXY(e,wl.x,wl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.applyMatrix3(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.applyMatrix4(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.applyNormalMatrix(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.transformDirection(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):wf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Tf(t,this.array)}};var ha=class extends Zn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ua=class extends Zn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Bn=class extends Zn{constructor(t,e,i){super(new Float32Array(t),e,i)}},Ry=new Vs,Yo=new Y,Nu=new Y,gr=class{constructor(t=new Y,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Ry.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Yo.subVectors(t,this.center);let e=Yo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Yo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Nu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Yo.copy(t.center).add(Nu)),this.expandByPoint(Yo.copy(t.center).sub(Nu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Cy=0,wi=new We,Uu=new Dn,to=new Y,fi=new Vs,$o=new Vs,Pn=new Y,Qn=class n extends zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Cy++}),this.uuid=Js(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ty(t)?ua:ha)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new he().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return wi.makeRotationFromQuaternion(t),this.applyMatrix4(wi),this}rotateX(t){return wi.makeRotationX(t),this.applyMatrix4(wi),this}rotateY(t){return wi.makeRotationY(t),this.applyMatrix4(wi),this}rotateZ(t){return wi.makeRotationZ(t),this.applyMatrix4(wi),this}translate(t,e,i){return wi.makeTranslation(t,e,i),this.applyMatrix4(wi),this}scale(t,e,i){return wi.makeScale(t,e,i),this.applyMatrix4(wi),this}lookAt(t){return Uu.lookAt(t),Uu.updateMatrix(),this.applyMatrix4(Uu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(to).negate(),this.translate(to.x,to.y,to.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Bn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&te("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Vs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ae("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ae('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new gr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ae("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(t){let i=this.boundingSphere.center;if(fi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];$o.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(fi.min,$o.min),fi.expandByPoint(Pn),Pn.addVectors(fi.max,$o.max),fi.expandByPoint(Pn)):(fi.expandByPoint($o.min),fi.expandByPoint($o.max))}fi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Pn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Pn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,f=a.count;c<f;c++)Pn.fromBufferAttribute(a,c),l&&(to.fromBufferAttribute(t,c),Pn.add(to)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ae('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ae("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new Y,l[I]=new Y;let f=new Y,d=new Y,u=new Y,h=new jt,m=new jt,y=new jt,g=new Y,p=new Y;function v(I,C,P){c[I]=c[C]=c[P]=1,f.fromBufferAttribute(i,I),d.fromBufferAttribute(i,C),u.fromBufferAttribute(i,P),h.fromBufferAttribute(r,I),m.fromBufferAttribute(r,C),y.fromBufferAttribute(r,P),d.sub(f),u.sub(f),m.sub(h),y.sub(h);let O=1/(m.x*y.y-y.x*m.y);isFinite(O)&&(g.copy(d).multiplyScalar(y.y).addScaledVector(u,-m.y).multiplyScalar(O),p.copy(u).multiplyScalar(m.x).addScaledVector(d,-y.x).multiplyScalar(O),a[I].add(g),a[C].add(g),a[P].add(g),l[I].add(p),l[C].add(p),l[P].add(p))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let I=0,C=w.length;I<C;++I){let P=w[I],O=P.start,k=P.count;for(let N=O,V=O+k;N<V;N+=3)v(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let M=new Y,R=new Y,A=new Y,_=new Y;function S(I){A.fromBufferAttribute(s,I),_.copy(A);let C=a[I];M.copy(C),M.sub(A.multiplyScalar(A.dot(C))).normalize(),R.crossVectors(_,C);let O=R.dot(l[I])<0?-1:1;o.setXYZW(I,M.x,M.y,M.z,O)}for(let I=0,C=i.count;I<C;++I)c[I]&&S(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Zn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,h=i.count;u<h;u++)i.setXYZ(u,0,0,0);let s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,f=new Y,d=new Y;if(t)for(let u=0,h=t.count;u<h;u+=3){let m=t.getX(u+0),y=t.getX(u+1),g=t.getX(u+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,g),f.subVectors(o,r),d.subVectors(s,r),f.cross(d),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,g),a.add(f),l.add(f),c.add(f),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let u=0,h=e.count;u<h;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),f.subVectors(o,r),d.subVectors(s,r),f.cross(d),i.setXYZ(u+0,f.x,f.y,f.z),i.setXYZ(u+1,f.x,f.y,f.z),i.setXYZ(u+2,f.x,f.y,f.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Pn.fromBufferAttribute(t,e),Pn.normalize(),t.setXYZ(e,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function t(a,l){let c=a.array,f=a.itemSize,d=a.normalized,u=new c.constructor(l.length*f),h=0,m=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?h=l[y]*a.data.stride+a.offset:h=l[y]*f;for(let p=0;p<f;p++)u[m++]=c[h++]}return new Zn(u,f,d)}if(this.index===null)return te("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let f=0,d=c.length;f<d;f++){let u=c[f],h=t(u,i);l.push(h)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],f=[];for(let d=0,u=c.length;d<u;d++){let h=c[d];f.push(h.toJSON(t.data))}f.length>0&&(s[l]=f,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let f=s[c];this.setAttribute(c,f.clone(e))}let r=t.morphAttributes;for(let c in r){let f=[],d=r[c];for(let u=0,h=d.length;u<h;u++)f.push(d[u].clone(e));this.morphAttributes[c]=f}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,f=o.length;c<f;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},sc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=vf,this.updateRanges=[],this.version=0,this.uuid=Js()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Im(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Im(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Im(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Js()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Yn=new Y,fa=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?dh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyMatrix4(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyNormalMatrix(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.transformDirection(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){oa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Zn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){oa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):wf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Tf(t,this.data.array)}},Fu=new Y,Py=new Y,Iy=new he,pi=class{constructor(t=new Y(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Fu.subVectors(i,e).cross(Py.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Fu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Iy.getNormalMatrix(t),s=this.coplanarPoint(Fu).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Ly=0,ts=class extends zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ly++}),this.uuid=Js(),this.name="",this.type="Material",this.blending=bo,this.side=$s,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qu,this.blendDst=tf,this.blendEquation=yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new pe(0,0,0),this.blendAlpha=0,this.depthFunc=co,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Mg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Wl,this.stencilZFail=Wl,this.stencilZPass=Wl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){te(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){te(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new pe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new pi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new jt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},go=class extends ts{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new pe(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},eo,Zo=new Y,no=new Y,io=new Y,so=new jt,Jo=new jt,Lg=new We,Tl=new Y,Ko=new Y,El=new Y,Lm=new jt,Ou=new jt,Dm=new jt,da=class extends Dn{constructor(t=new go){if(super(),this.isSprite=!0,this.type="Sprite",eo===void 0){eo=new Qn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new sc(e,5);eo.setIndex([0,1,2,0,2,3]),eo.setAttribute("position",new fa(i,3,0,!1)),eo.setAttribute("uv",new fa(i,2,3,!1))}this.geometry=eo,this.material=t,this.center=new jt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ae('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),no.setFromMatrixScale(this.matrixWorld),Lg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),io.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&no.multiplyScalar(-io.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Al(Tl.set(-.5,-.5,0),io,o,no,s,r),Al(Ko.set(.5,-.5,0),io,o,no,s,r),Al(El.set(.5,.5,0),io,o,no,s,r),Lm.set(0,0),Ou.set(1,0),Dm.set(1,1);let a=t.ray.intersectTriangle(Tl,Ko,El,!1,Zo);if(a===null&&(Al(Ko.set(-.5,.5,0),io,o,no,s,r),Ou.set(0,1),a=t.ray.intersectTriangle(Tl,El,Ko,!1,Zo),a===null))return;let l=t.ray.origin.distanceTo(Zo);l<t.near||l>t.far||e.push({distance:l,point:Zo.clone(),uv:xs.getInterpolation(Zo,Tl,Ko,El,Lm,Ou,Dm,new jt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Al(n,t,e,i,s,r){so.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Jo.x=r*so.x-s*so.y,Jo.y=s*so.x+r*so.y):Jo.copy(so),n.copy(t),n.x+=Jo.x,n.y+=Jo.y,n.applyMatrix4(Lg)}var _s=new Y,Bu=new Y,Rl=new Y,Cl=new Y,_r=class{constructor(t=new Y,e=new Y(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_s)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_s.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_s.copy(this.origin).addScaledVector(this.direction,e),_s.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Bu.copy(t).add(e).multiplyScalar(.5),Rl.copy(e).sub(t).normalize(),Cl.copy(this.origin).sub(Bu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Rl),a=Cl.dot(this.direction),l=-Cl.dot(Rl),c=Cl.lengthSq(),f=Math.abs(1-o*o),d,u,h,m;if(f>0)if(d=o*l-a,u=o*a-l,m=r*f,d>=0)if(u>=-m)if(u<=m){let y=1/f;d*=y,u*=y,h=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),h=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),h=-d*d+u*(u+2*l)+c;else u<=-m?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),h=-d*d+u*(u+2*l)+c):u<=m?(d=0,u=Math.min(Math.max(-r,-l),r),h=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),h=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),h=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Bu).addScaledVector(Rl,u),h}intersectSphere(t,e){if(t.radius<0)return null;_s.subVectors(t.center,this.origin);let i=_s.dot(this.direction),s=_s.dot(_s)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,f=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(i=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),f>=0?(r=(t.min.y-u.y)*f,o=(t.max.y-u.y)*f):(r=(t.max.y-u.y)*f,o=(t.min.y-u.y)*f),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,_s)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,f=a.z,d=t.x-o.x,u=t.y-o.y,h=t.z-o.z,m=e.x-o.x,y=e.y-o.y,g=e.z-o.z,p=i.x-o.x,v=i.y-o.y,w=i.z-o.z,M=Math.abs(l),R=Math.abs(c),A=Math.abs(f),_,S,I,C,P,O,k,N,V,W,z,tt;if(M>=R&&M>=A?(I=l,O=d,V=m,tt=p,l>=0?(_=c,S=f,C=u,P=h,k=y,N=g,W=v,z=w):(_=f,S=c,C=h,P=u,k=g,N=y,W=w,z=v)):R>=A?(I=c,O=u,V=y,tt=v,c>=0?(_=f,S=l,C=h,P=d,k=g,N=m,W=w,z=p):(_=l,S=f,C=d,P=h,k=m,N=g,W=p,z=w)):(I=f,O=h,V=g,tt=w,f>=0?(_=l,S=c,C=d,P=u,k=m,N=y,W=p,z=v):(_=c,S=l,C=u,P=d,k=y,N=m,W=v,z=p)),I===0)return null;let X=_/I,Z=S/I,et=1/I,st=C-X*O,rt=P-Z*O,j=k-X*V,dt=N-Z*V,pt=W-X*tt,xt=z-Z*tt,St=pt*dt-xt*j,Wt=st*xt-rt*pt,gt=j*rt-dt*st;if(s){if(St<0||Wt<0||gt<0)return null}else if((St<0||Wt<0||gt<0)&&(St>0||Wt>0||gt>0))return null;let yt=St+Wt+gt;if(yt===0)return null;let Xt=et*(St*O+Wt*V+gt*tt);return(yt>0?Xt<0:Xt>0)?null:this.at(Xt/yt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rc=class extends ts{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Ec,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Nm=new We,dr=new _r,Pl=new gr,Um=new Y,Il=new Y,Ll=new Y,Dl=new Y,zu=new Y,Nl=new Y,Fm=new Y,Ul=new Y,_i=class extends Dn{constructor(t=new Qn,e=new rc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let f=a[l],d=r[l];f!==0&&(zu.fromBufferAttribute(d,t),o?Nl.addScaledVector(zu,f):Nl.addScaledVector(zu.sub(e),f))}e.add(Nl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Pl.copy(i.boundingSphere),Pl.applyMatrix4(r),dr.copy(t.ray).recast(t.near),!(Pl.containsPoint(dr.origin)===!1&&(dr.intersectSphere(Pl,Um)===null||dr.origin.distanceToSquared(Um)>(t.far-t.near)**2))&&(Nm.copy(r).invert(),dr.copy(t.ray).applyMatrix4(Nm),!(i.boundingBox!==null&&dr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,dr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,f=r.attributes.uv1,d=r.attributes.normal,u=r.groups,h=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=u.length;m<y;m++){let g=u[m],p=o[g.materialIndex],v=Math.max(g.start,h.start),w=Math.min(a.count,Math.min(g.start+g.count,h.start+h.count));for(let M=v,R=w;M<R;M+=3){let A=a.getX(M),_=a.getX(M+1),S=a.getX(M+2);s=Fl(this,p,t,i,c,f,d,A,_,S),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,h.start),y=Math.min(a.count,h.start+h.count);for(let g=m,p=y;g<p;g+=3){let v=a.getX(g),w=a.getX(g+1),M=a.getX(g+2);s=Fl(this,o,t,i,c,f,d,v,w,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=u.length;m<y;m++){let g=u[m],p=o[g.materialIndex],v=Math.max(g.start,h.start),w=Math.min(l.count,Math.min(g.start+g.count,h.start+h.count));for(let M=v,R=w;M<R;M+=3){let A=M,_=M+1,S=M+2;s=Fl(this,p,t,i,c,f,d,A,_,S),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,h.start),y=Math.min(l.count,h.start+h.count);for(let g=m,p=y;g<p;g+=3){let v=g,w=g+1,M=g+2;s=Fl(this,o,t,i,c,f,d,v,w,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Dy(n,t,e,i,s,r,o,a){let l;if(t.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===$s,a),l===null)return null;Ul.copy(a),Ul.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ul);return c<e.near||c>e.far?null:{distance:c,point:Ul.clone(),object:n}}function Fl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Il),n.getVertexPosition(l,Ll),n.getVertexPosition(c,Dl);let f=Dy(n,t,e,i,Il,Ll,Dl,Fm);if(f){let d=new Y;xs.getBarycoord(Fm,Il,Ll,Dl,d),s&&(f.uv=xs.getInterpolatedAttribute(s,a,l,c,d,new jt)),r&&(f.uv1=xs.getInterpolatedAttribute(r,a,l,c,d,new jt)),o&&(f.normal=xs.getInterpolatedAttribute(o,a,l,c,d,new Y),f.normal.dot(i.direction)>0&&f.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new Y,materialIndex:0};xs.getNormal(Il,Ll,Dl,u.normal),f.face=u,f.barycoord=d}return f}var oc=class extends Kn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=In,f=In,d,u){super(null,o,a,l,c,f,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var pr=new gr,Ny=new jt(.5,.5),Ol=new Y,Gs=class{constructor(t=new pi,e=new pi,i=new pi,s=new pi,r=new pi,o=new pi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ti,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],f=r[4],d=r[5],u=r[6],h=r[7],m=r[8],y=r[9],g=r[10],p=r[11],v=r[12],w=r[13],M=r[14],R=r[15];if(s[0].setComponents(c-o,h-f,p-m,R-v).normalize(),s[1].setComponents(c+o,h+f,p+m,R+v).normalize(),s[2].setComponents(c+a,h+d,p+y,R+w).normalize(),s[3].setComponents(c-a,h-d,p-y,R-w).normalize(),i)s[4].setComponents(l,u,g,M).normalize(),s[5].setComponents(c-l,h-u,p-g,R-M).normalize();else if(s[4].setComponents(c-l,h-u,p-g,R-M).normalize(),e===Ti)s[5].setComponents(c+l,h+u,p+g,R+M).normalize();else if(e===ho)s[5].setComponents(l,u,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),pr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),pr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(pr)}intersectsSprite(t){pr.center.set(0,0,0);let e=Ny.distanceTo(t.center);return pr.radius=.7071067811865476+e,pr.applyMatrix4(t.matrixWorld),this.intersectsSphere(pr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ol.x=s.normal.x>0?t.max.x:t.min.x,Ol.y=s.normal.y>0?t.max.y:t.min.y,Ol.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ol)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Om=new We,ac=class n{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Om.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Gs),i[s].setFromProjectionMatrix(Om,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Gs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var _o=class extends ts{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new pe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},lc=new Y,cc=new Y,Bm=new We,jo=new _r,Bl=new gr,ku=new Y,zm=new Y,hc=class extends Dn{constructor(t=new Qn,e=new _o){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)lc.fromBufferAttribute(e,s-1),cc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=lc.distanceTo(cc);t.setAttribute("lineDistance",new Bn(i,1))}else te("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Bl.copy(i.boundingSphere),Bl.applyMatrix4(s),Bl.radius+=r,t.ray.intersectsSphere(Bl)===!1)return;Bm.copy(s).invert(),jo.copy(t.ray).applyMatrix4(Bm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,f=i.index,u=i.attributes.position;if(f!==null){let h=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let y=h,g=m-1;y<g;y+=c){let p=f.getX(y),v=f.getX(y+1),w=zl(this,t,jo,l,p,v,y);w&&e.push(w)}if(this.isLineLoop){let y=f.getX(m-1),g=f.getX(h),p=zl(this,t,jo,l,y,g,m-1);p&&e.push(p)}}else{let h=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=h,g=m-1;y<g;y+=c){let p=zl(this,t,jo,l,y,y+1,y);p&&e.push(p)}if(this.isLineLoop){let y=zl(this,t,jo,l,m-1,h,m-1);y&&e.push(y)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function zl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),e.distanceSqToSegment(lc,cc,ku,zm)>i)return;ku.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ku);if(!(c<t.near||c>t.far))return{distance:c,point:zm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var km=new Y,Vm=new Y,pa=class extends hc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)km.fromBufferAttribute(e,s),Vm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+km.distanceTo(Vm);t.setAttribute("lineDistance",new Bn(i,1))}else te("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ma=class extends Kn{constructor(t=[],e=vr,i,s,r,o,a,l,c,f){super(t,e,i,s,r,o,a,l,c,f),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ga=class extends Kn{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ss=class extends Kn{constructor(t,e,i=ki,s,r,o,a=In,l=In,c,f=vs,d=1){if(f!==vs&&f!==ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,l,f,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new po(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},_a=class extends Ss{constructor(t,e=ki,i=vr,s,r,o=In,a=In,l,c=vs){let f={width:t,height:t,depth:1},d=[f,f,f,f,f,f];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},xa=class extends Kn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},xo=class n extends Qn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],f=[],d=[],u=0,h=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Bn(c,3)),this.setAttribute("normal",new Bn(f,3)),this.setAttribute("uv",new Bn(d,2));function m(y,g,p,v,w,M,R,A,_,S,I){let C=M/_,P=R/S,O=M/2,k=R/2,N=A/2,V=_+1,W=S+1,z=0,tt=0,X=new Y;for(let Z=0;Z<W;Z++){let et=Z*P-k;for(let st=0;st<V;st++){let rt=st*C-O;X[y]=rt*v,X[g]=et*w,X[p]=N,c.push(X.x,X.y,X.z),X[y]=0,X[g]=0,X[p]=A>0?1:-1,f.push(X.x,X.y,X.z),d.push(st/_),d.push(1-Z/S),z+=1}}for(let Z=0;Z<S;Z++)for(let et=0;et<_;et++){let st=u+et+V*Z,rt=u+et+V*(Z+1),j=u+(et+1)+V*(Z+1),dt=u+(et+1)+V*Z;l.push(st,rt,dt),l.push(rt,j,dt),tt+=6}a.addGroup(h,tt,I),h+=tt,u+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ya=class n extends Qn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,f=l+1,d=t/a,u=e/l,h=[],m=[],y=[],g=[];for(let p=0;p<f;p++){let v=p*u-o;for(let w=0;w<c;w++){let M=w*d-r;m.push(M,-v,0),y.push(0,0,1),g.push(w/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let w=v+c*p,M=v+c*(p+1),R=v+1+c*(p+1),A=v+1+c*p;h.push(w,M,A),h.push(M,R,A)}this.setIndex(h),this.setAttribute("position",new Bn(m,3)),this.setAttribute("normal",new Bn(y,3)),this.setAttribute("uv",new Bn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function Sr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Gm(s))s.isRenderTargetTexture?(te("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Gm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function zn(n){let t={};for(let e=0;e<n.length;e++){let i=Sr(n[e]);for(let s in i)t[s]=i[s]}return t}function Gm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Uy(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Af(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:be.workingColorSpace}var Dg={clone:Sr,merge:zn},Fy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Oy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,es=class extends ts{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Fy,this.fragmentShader=Oy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Sr(t.uniforms),this.uniformsGroups=Uy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new pe().setHex(s.value);break;case"v2":this.uniforms[i].value=new jt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[i].value=new je().fromArray(s.value);break;case"m3":this.uniforms[i].value=new he().fromArray(s.value);break;case"m4":this.uniforms[i].value=new We().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},uc=class extends es{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var yo=class extends ts{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new pe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=fh,this.normalScale=new jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Ec,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},fc=class extends ts{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=yg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},dc=class extends ts{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ro(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function kl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Hs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},pc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hu,endingEnd:Hu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wu:r=t,a=2*e-i;break;case Xu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Wu:o=t,l=2*i-e;break;case Xu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,f=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*f,this._offsetNext=o*f}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,h=this._weightNext,m=(i-e)/(s-e),y=m*m,g=y*m,p=-u*g+2*u*y-u*m,v=(1+u)*g+(-1.5-2*u)*y+(-.5+u)*m+1,w=(-1-h)*g+(1.5+h)*y+.5*m,M=h*g-h*y;for(let R=0;R!==a;++R)r[R]=p*o[f+R]+v*o[c+R]+w*o[l+R]+M*o[d+R];return r}},mc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=(i-e)/(s-e),d=1-f;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*f;return r}},gc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},_c=class extends Hs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this.inTangents,d=this.outTangents;if(!f||!d){let m=(i-e)/(s-e),y=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*y+o[l+g]*m;return r}let u=a*2,h=t-1;for(let m=0;m!==a;++m){let y=o[c+m],g=o[l+m],p=h*u+m*2,v=d[p],w=d[p+1],M=t*u+m*2,R=f[M],A=f[M+1],_=zy(i,e,v,R,s);r[m]=Ng(_,y,w,A,g)}return r}};function Ng(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function By(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function zy(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Ng(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=By(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ro(e,this.TimeBufferType),this.values=ro(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ro(t.times,Array),values:ro(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),kl(t.settings)&&(i.settings={inTangents:ro(t.settings.inTangents,Array),outTangents:ro(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new gc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new pc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new _c(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case na:e=this.InterpolantFactoryMethodDiscrete;break;case tc:e=this.InterpolantFactoryMethodLinear;break;case Hl:e=this.InterpolantFactoryMethodSmooth;break;case Gu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return te("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return na;case this.InterpolantFactoryMethodLinear:return tc;case this.InterpolantFactoryMethodSmooth:return Hl;case this.InterpolantFactoryMethodBezier:return Gu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;kl(this.settings)&&(Hm(this.settings.inTangents,t),Hm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;kl(this.settings)&&(Wm(this.settings.inTangents,t),Wm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ae("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ae("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ae("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ae("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&ey(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ae("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Hl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],f=t[a+1];if(c!==f&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,u=d-i,h=d+i;for(let m=0;m!==i;++m){let y=e[d+m];if(y!==e[u+m]||y!==e[h+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,u=o*i;for(let h=0;h!==i;++h)e[u+h]=e[d+h]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,kl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Hm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Wm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=tc;var Ws=class extends xi{constructor(t,e,i){super(t,e,i)}};Ws.prototype.ValueTypeName="bool";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=na;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var xc=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}};xc.prototype.ValueTypeName="color";var yc=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}};yc.prototype.ValueTypeName="number";var vc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let f=c+a;c!==f;c+=4)mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},va=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new vc(this.times,this.values,this.getValueSize(),t)}};va.prototype.ValueTypeName="quaternion";va.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends xi{constructor(t,e,i){super(t,e,i)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=na;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var Mc=class extends xi{constructor(t,e,i,s){super(t,e,i,s)}};Mc.prototype.ValueTypeName="vector";var Sc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(f){a++,r===!1&&s.onStart!==void 0&&s.onStart(f,o,a),r=!0},this.itemEnd=function(f){o++,s.onProgress!==void 0&&s.onProgress(f,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(f){s.onError!==void 0&&s.onError(f)},this.resolveURL=function(f){return f=f.normalize("NFC"),l?l(f):f},this.setURLModifier=function(f){return l=f,this},this.addHandler=function(f,d){return c.push(f,d),this},this.removeHandler=function(f){let d=c.indexOf(f);return d!==-1&&c.splice(d,2),this},this.getHandler=function(f){for(let d=0,u=c.length;d<u;d+=2){let h=c[d],m=c[d+1];if(h.global&&(h.lastIndex=0),h.test(f))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ug=new Sc,bc=class{constructor(t){this.manager=t!==void 0?t:Ug,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};bc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ma=class extends Dn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new pe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Vu=new We,Xm=new Y,qm=new Y,wc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new jt(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new We,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gs,this._frameExtents=new jt(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Xm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Xm),qm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(qm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Vu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Vu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===ho||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Vu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Vl=new Y,Gl=new mi,ji=new Y,Sa=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new We,this.projectionMatrix=new We,this.projectionMatrixInverse=new We,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Vl,Gl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,ji.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Vl,Gl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ks=new Y,Ym=new jt,$m=new jt,$n=class extends Sa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=fo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ta*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return fo*2*Math.atan(Math.tan(ta*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ks.x,ks.y).multiplyScalar(-t/ks.z),ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ks.x,ks.y).multiplyScalar(-t/ks.z)}getViewSize(t,e){return this.getViewBounds(t,Ym,$m),e.subVectors($m,Ym)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ta*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ba=class extends Sa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,f=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=f*this.view.offsetY,l=a-f*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},qu=class extends wc{constructor(){super(new ba(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wa=class extends Ma{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new qu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Ta=class extends Ma{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var oo=-90,ao=1,vo=class extends Dn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(oo,ao,t,e);s.layers=this.layers,this.add(s);let r=new $n(oo,ao,t,e);r.layers=this.layers,this.add(r);let o=new $n(oo,ao,t,e);o.layers=this.layers,this.add(o);let a=new $n(oo,ao,t,e);a.layers=this.layers,this.add(a);let l=new $n(oo,ao,t,e);l.layers=this.layers,this.add(l);let c=new $n(oo,ao,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ti)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ho)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,f]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),h=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,f),t.setRenderTarget(d,u,h),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Tc=class extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Rf="\\[\\]\\.:\\/",ky=new RegExp("["+Rf+"]","g"),Cf="[^"+Rf+"]",Vy="[^"+Rf.replace("\\.","")+"]",Gy=/((?:WC+[\/:])*)/.source.replace("WC",Cf),Hy=/(WCOD+)?/.source.replace("WCOD",Vy),Wy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Cf),Xy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Cf),qy=new RegExp("^"+Gy+Hy+Wy+Xy+"$"),Yy=["material","materials","bones","map"],Yu=class{constructor(t,e,i){let s=i||Je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Je=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(ky,"")}static parseTrackName(t){let e=qy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Yy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){te("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ae("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ae("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ae("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let f=0;f<t.length;f++)if(t[f].name===c){c=f;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ae("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ae("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ae("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ae("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ae("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ae("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ae("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Je.Composite=Yu;Je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Je.prototype.GetterByBindingType=[Je.prototype._getValue_direct,Je.prototype._getValue_array,Je.prototype._getValue_arrayElement,Je.prototype._getValue_toArray];Je.prototype.SetterByBindingTypeAndVersioning=[[Je.prototype._setValue_direct,Je.prototype._setValue_direct_setNeedsUpdate,Je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_array,Je.prototype._setValue_array_setNeedsUpdate,Je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_arrayElement,Je.prototype._setValue_arrayElement_setNeedsUpdate,Je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_fromArray,Je.prototype._setValue_fromArray_setNeedsUpdate,Je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var lT=new Float32Array(1);var Mo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ye(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var $u=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ea=class extends zi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Pf(n,t,e,i){let s=$y(i);switch(e){case pf:return n*t;case gf:return n*t/s.components*s.byteLength;case Dc:return n*t/s.components*s.byteLength;case Zs:return n*t*2/s.components*s.byteLength;case Nc:return n*t*2/s.components*s.byteLength;case mf:return n*t*3/s.components*s.byteLength;case Hi:return n*t*4/s.components*s.byteLength;case Uc:return n*t*4/s.components*s.byteLength;case Ca:case Pa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ia:case La:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Oc:case zc:return Math.max(n,16)*Math.max(t,8)/4;case Fc:case Bc:return Math.max(n,8)*Math.max(t,8)/2;case kc:case Vc:case Hc:case Wc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Gc:case Da:case Xc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case qc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Yc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case $c:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Zc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Kc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case jc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Qc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case th:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case eh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case nh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case ih:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case sh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case rh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case oh:case ah:case lh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case ch:case hh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Na:case uh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function $y(n){switch(n){case ti:case hf:return{byteLength:1,components:1};case To:case uf:case Gi:return{byteLength:2,components:1};case Ic:case Lc:return{byteLength:2,components:4};case ki:case Pc:case Vi:return{byteLength:4,components:1};case ff:case df:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?te("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function i0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Jy(n){let t=new WeakMap;function e(a,l){let c=a.array,f=a.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,f),a.onUploadCallback();let h;if(c instanceof Float32Array)h=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)h=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?h=n.HALF_FLOAT:h=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)h=n.SHORT;else if(c instanceof Uint32Array)h=n.UNSIGNED_INT;else if(c instanceof Int32Array)h=n.INT;else if(c instanceof Int8Array)h=n.BYTE;else if(c instanceof Uint8Array)h=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)h=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:h,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let f=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,f);else{d.sort((h,m)=>h.start-m.start);let u=0;for(let h=1;h<d.length;h++){let m=d[u],y=d[h];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++u,d[u]=y)}d.length=u+1;for(let h=0,m=d.length;h<m;h++){let y=d[h];n.bufferSubData(c,y.start*f.BYTES_PER_ELEMENT,f,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let f=t.get(a);(!f||f.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ky=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,jy=`#ifdef USE_ALPHAHASH
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
#endif`,Qy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,tv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ev=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,nv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,iv=`#ifdef USE_AOMAP
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
#endif`,sv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,rv=`#ifdef USE_BATCHING
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
#endif`,ov=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,av=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,lv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,cv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,hv=`#ifdef USE_IRIDESCENCE
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
#endif`,uv=`#ifdef USE_BUMPMAP
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
#endif`,fv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,pv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,mv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,gv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_v=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,xv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,yv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,vv=`#define PI 3.141592653589793
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
} // validated`,Mv=`vec3 transformedNormal = objectNormal;
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
#endif`,Sv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,bv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,wv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Tv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ev="gl_FragColor = linearToOutputTexel( gl_FragColor );",Av=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Rv=`#ifdef USE_ENVMAP
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
#endif`,Cv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Pv=`#ifdef USE_ENVMAP
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
#endif`,Iv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Lv=`#ifdef USE_ENVMAP
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
#endif`,Dv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Nv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Uv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Fv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ov=`#ifdef USE_GRADIENTMAP
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
}`,Bv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,zv=`LambertMaterial material;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Vv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Gv=`#ifdef USE_ENVMAP
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
#endif`,Hv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Wv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Xv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,qv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Yv=`PhysicalMaterial material;
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
#endif`,$v=`uniform sampler2D dfgLUT;
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
}`,Zv=`
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
#endif`,Jv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Kv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jv=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Qv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,tM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,eM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,nM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,iM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,sM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,rM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,oM=`#if defined( USE_POINTS_UV )
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
#endif`,aM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,lM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,cM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,hM=`#if defined( USE_MORPHCOLORS )
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
#endif`,uM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,fM=`#ifdef USE_MORPHTARGETS
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
#endif`,pM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,mM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,gM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_M=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,yM=`#ifdef USE_NORMALMAP
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
#endif`,vM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,MM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,SM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,bM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,wM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,TM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,EM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,AM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,RM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,CM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,PM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,IM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,LM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,DM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,NM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,UM=`float getShadowMask() {
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
}`,FM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,OM=`#ifdef USE_SKINNING
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
#endif`,BM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,zM=`#ifdef USE_SKINNING
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
#endif`,VM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,GM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,HM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,WM=`#ifdef USE_TRANSMISSION
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
#endif`,XM=`#ifdef USE_TRANSMISSION
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
#endif`,qM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,YM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$M=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ZM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,JM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,KM=`uniform sampler2D t2D;
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
}`,jM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,QM=`uniform float backgroundBlurriness;
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
}`,tS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,eS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nS=`#include <common>
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
}`,iS=`#if DEPTH_PACKING == 3200
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
}`,sS=`#define DISTANCE
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
}`,rS=`#define DISTANCE
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
}`,oS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,aS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,lS=`uniform float scale;
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
}`,cS=`uniform vec3 diffuse;
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
}`,hS=`#include <common>
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
}`,uS=`uniform vec3 diffuse;
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
}`,fS=`#define LAMBERT
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
}`,pS=`#define MATCAP
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
}`,mS=`#define MATCAP
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
}`,gS=`#define NORMAL
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
}`,_S=`#define NORMAL
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
}`,xS=`#define PHONG
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
}`,yS=`#define PHONG
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
}`,vS=`#define STANDARD
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
}`,MS=`#define STANDARD
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
}`,SS=`#define TOON
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
}`,bS=`#define TOON
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
}`,wS=`uniform float size;
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
}`,TS=`uniform vec3 diffuse;
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
}`,ES=`#include <common>
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
}`,AS=`uniform vec3 color;
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
}`,RS=`uniform float rotation;
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
}`,CS=`uniform vec3 diffuse;
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
}`,me={alphahash_fragment:Ky,alphahash_pars_fragment:jy,alphamap_fragment:Qy,alphamap_pars_fragment:tv,alphatest_fragment:ev,alphatest_pars_fragment:nv,aomap_fragment:iv,aomap_pars_fragment:sv,batching_pars_vertex:rv,batching_vertex:ov,begin_vertex:av,beginnormal_vertex:lv,bsdfs:cv,iridescence_fragment:hv,bumpmap_pars_fragment:uv,clipping_planes_fragment:fv,clipping_planes_pars_fragment:dv,clipping_planes_pars_vertex:pv,clipping_planes_vertex:mv,color_fragment:gv,color_pars_fragment:_v,color_pars_vertex:xv,color_vertex:yv,common:vv,defaultnormal_vertex:Mv,displacementmap_pars_vertex:Sv,displacementmap_vertex:bv,emissivemap_fragment:wv,emissivemap_pars_fragment:Tv,colorspace_fragment:Ev,colorspace_pars_fragment:Av,envmap_fragment:Rv,envmap_common_pars_fragment:Cv,envmap_pars_fragment:Pv,envmap_pars_vertex:Iv,envmap_physical_pars_fragment:Gv,envmap_vertex:Lv,fog_vertex:Dv,fog_pars_vertex:Nv,fog_fragment:Uv,fog_pars_fragment:Fv,gradientmap_pars_fragment:Ov,lightmap_pars_fragment:Bv,lights_lambert_fragment:zv,lights_lambert_pars_fragment:kv,lights_pars_begin:Vv,lights_toon_fragment:Hv,lights_toon_pars_fragment:Wv,lights_phong_fragment:Xv,lights_phong_pars_fragment:qv,lights_physical_fragment:Yv,lights_physical_pars_fragment:$v,lights_fragment_begin:Zv,lights_fragment_maps:Jv,lights_fragment_end:Kv,lightprobes_pars_fragment:jv,logdepthbuf_fragment:Qv,logdepthbuf_pars_fragment:tM,logdepthbuf_pars_vertex:eM,logdepthbuf_vertex:nM,map_fragment:iM,map_pars_fragment:sM,map_particle_fragment:rM,map_particle_pars_fragment:oM,metalnessmap_fragment:aM,metalnessmap_pars_fragment:lM,morphinstance_vertex:cM,morphcolor_vertex:hM,morphnormal_vertex:uM,morphtarget_pars_vertex:fM,morphtarget_vertex:dM,normal_fragment_begin:pM,normal_fragment_maps:mM,normal_pars_fragment:gM,normal_pars_vertex:_M,normal_vertex:xM,normalmap_pars_fragment:yM,clearcoat_normal_fragment_begin:vM,clearcoat_normal_fragment_maps:MM,clearcoat_pars_fragment:SM,iridescence_pars_fragment:bM,opaque_fragment:wM,packing:TM,premultiplied_alpha_fragment:EM,project_vertex:AM,dithering_fragment:RM,dithering_pars_fragment:CM,roughnessmap_fragment:PM,roughnessmap_pars_fragment:IM,shadowmap_pars_fragment:LM,shadowmap_pars_vertex:DM,shadowmap_vertex:NM,shadowmask_pars_fragment:UM,skinbase_vertex:FM,skinning_pars_vertex:OM,skinning_vertex:BM,skinnormal_vertex:zM,specularmap_fragment:kM,specularmap_pars_fragment:VM,tonemapping_fragment:GM,tonemapping_pars_fragment:HM,transmission_fragment:WM,transmission_pars_fragment:XM,uv_pars_fragment:qM,uv_pars_vertex:YM,uv_vertex:$M,worldpos_vertex:ZM,background_vert:JM,background_frag:KM,backgroundCube_vert:jM,backgroundCube_frag:QM,cube_vert:tS,cube_frag:eS,depth_vert:nS,depth_frag:iS,distance_vert:sS,distance_frag:rS,equirect_vert:oS,equirect_frag:aS,linedashed_vert:lS,linedashed_frag:cS,meshbasic_vert:hS,meshbasic_frag:uS,meshlambert_vert:fS,meshlambert_frag:dS,meshmatcap_vert:pS,meshmatcap_frag:mS,meshnormal_vert:gS,meshnormal_frag:_S,meshphong_vert:xS,meshphong_frag:yS,meshphysical_vert:vS,meshphysical_frag:MS,meshtoon_vert:SS,meshtoon_frag:bS,points_vert:wS,points_frag:TS,shadow_vert:ES,shadow_frag:AS,sprite_vert:RS,sprite_frag:CS},Nt={common:{diffuse:{value:new pe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new he}},envmap:{envMap:{value:null},envMapRotation:{value:new he},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new he}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new he}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new he},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new he},normalScale:{value:new jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new he},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new he}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new he}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new he}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new pe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new pe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0},uvTransform:{value:new he}},sprite:{diffuse:{value:new pe(16777215)},opacity:{value:1},center:{value:new jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}}},ss={basic:{uniforms:zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)},specular:{value:new pe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:zn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:zn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:zn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:zn([Nt.points,Nt.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:zn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:zn([Nt.common,Nt.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:zn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:zn([Nt.sprite,Nt.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new he},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new he}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:zn([Nt.common,Nt.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:zn([Nt.lights,Nt.fog,{color:{value:new pe(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};ss.physical={uniforms:zn([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new he},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new he},clearcoatNormalScale:{value:new jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new he},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new he},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new he},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new he},sheen:{value:0},sheenColor:{value:new pe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new he},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new he},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new he},transmissionSamplerSize:{value:new jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new he},attenuationDistance:{value:0},attenuationColor:{value:new pe(0)},specularColor:{value:new pe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new he},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new he},anisotropyVector:{value:new jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new he}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var ph={r:0,b:0,g:0},PS=new We,s0=new he;s0.set(-1,0,0,0,1,0,0,0,1);function IS(n,t,e,i,s,r){let o=new pe(0),a=s===!0?0:1,l,c,f=null,d=0,u=null;function h(v){let w=v.isScene===!0?v.background:null;if(w&&w.isTexture){let M=v.backgroundBlurriness>0;w=t.get(w,M)}return w}function m(v){let w=!1,M=h(v);M===null?g(o,a):M&&M.isColor&&(g(M,1),w=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,w){let M=h(w);M&&M.isCubeTexture?(c===void 0&&(c=new _i(new xo(1,1,1),new es({name:"BackgroundCubeMaterial",uniforms:Sr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(PS.makeRotationFromEuler(w.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(s0),c.material.toneMapped=be.getTransfer(M.colorSpace)!==Ue,(f!==M||d!==M.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,f=M,d=M.version,u=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new _i(new ya(2,2),new es({name:"BackgroundMaterial",uniforms:Sr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:$s,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=be.getTransfer(M.colorSpace)!==Ue,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(f!==M||d!==M.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,f=M,d=M.version,u=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,w){v.getRGB(ph,Af(n)),e.buffers.color.setClear(ph.r,ph.g,ph.b,w,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,w=1){o.set(v),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:m,addToRenderList:y,dispose:p}}function LS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(P,O,k,N,V){let W=!1,z=d(P,N,k,O);r!==z&&(r=z,c(r.object)),W=h(P,N,k,V),W&&m(P,N,k,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,M(P,O,k,N),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function f(P){return n.deleteVertexArray(P)}function d(P,O,k,N){let V=N.wireframe===!0,W=i[O.id];W===void 0&&(W={},i[O.id]=W);let z=P.isInstancedMesh===!0?P.id:0,tt=W[z];tt===void 0&&(tt={},W[z]=tt);let X=tt[k.id];X===void 0&&(X={},tt[k.id]=X);let Z=X[V];return Z===void 0&&(Z=u(l()),X[V]=Z),Z}function u(P){let O=[],k=[],N=[];for(let V=0;V<e;V++)O[V]=0,k[V]=0,N[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:k,attributeDivisors:N,object:P,attributes:{},index:null}}function h(P,O,k,N){let V=r.attributes,W=O.attributes,z=0,tt=k.getAttributes();for(let X in tt)if(tt[X].location>=0){let et=V[X],st=W[X];if(st===void 0&&(X==="instanceMatrix"&&P.instanceMatrix&&(st=P.instanceMatrix),X==="instanceColor"&&P.instanceColor&&(st=P.instanceColor)),et===void 0||et.attribute!==st||st&&et.data!==st.data)return!0;z++}return r.attributesNum!==z||r.index!==N}function m(P,O,k,N){let V={},W=O.attributes,z=0,tt=k.getAttributes();for(let X in tt)if(tt[X].location>=0){let et=W[X];et===void 0&&(X==="instanceMatrix"&&P.instanceMatrix&&(et=P.instanceMatrix),X==="instanceColor"&&P.instanceColor&&(et=P.instanceColor));let st={};st.attribute=et,et&&et.data&&(st.data=et.data),V[X]=st,z++}r.attributes=V,r.attributesNum=z,r.index=N}function y(){let P=r.newAttributes;for(let O=0,k=P.length;O<k;O++)P[O]=0}function g(P){p(P,0)}function p(P,O){let k=r.newAttributes,N=r.enabledAttributes,V=r.attributeDivisors;k[P]=1,N[P]===0&&(n.enableVertexAttribArray(P),N[P]=1),V[P]!==O&&(n.vertexAttribDivisor(P,O),V[P]=O)}function v(){let P=r.newAttributes,O=r.enabledAttributes;for(let k=0,N=O.length;k<N;k++)O[k]!==P[k]&&(n.disableVertexAttribArray(k),O[k]=0)}function w(P,O,k,N,V,W,z){z===!0?n.vertexAttribIPointer(P,O,k,V,W):n.vertexAttribPointer(P,O,k,N,V,W)}function M(P,O,k,N){y();let V=N.attributes,W=k.getAttributes(),z=O.defaultAttributeValues;for(let tt in W){let X=W[tt];if(X.location>=0){let Z=V[tt];if(Z===void 0&&(tt==="instanceMatrix"&&P.instanceMatrix&&(Z=P.instanceMatrix),tt==="instanceColor"&&P.instanceColor&&(Z=P.instanceColor)),Z!==void 0){let et=Z.normalized,st=Z.itemSize,rt=t.get(Z);if(rt===void 0)continue;let j=rt.buffer,dt=rt.type,pt=rt.bytesPerElement,xt=dt===n.INT||dt===n.UNSIGNED_INT||Z.gpuType===Pc;if(Z.isInterleavedBufferAttribute){let St=Z.data,Wt=St.isInterleavedBuffer===!0?St.stride:St.itemSize,gt=Z.offset;if(St.isInstancedInterleavedBuffer||St.isInstancedBufferAttribute){for(let yt=0;yt<X.locationSize;yt++)p(X.location+yt,St.meshPerAttribute);P.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=St.meshPerAttribute*St.count)}else for(let yt=0;yt<X.locationSize;yt++)g(X.location+yt);n.bindBuffer(n.ARRAY_BUFFER,j);for(let yt=0;yt<X.locationSize;yt++)w(X.location+yt,st/X.locationSize,dt,et,Wt*pt,(gt+st/X.locationSize*yt)*pt,xt)}else{if(Z.isInstancedBufferAttribute){for(let St=0;St<X.locationSize;St++)p(X.location+St,Z.meshPerAttribute);P.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let St=0;St<X.locationSize;St++)g(X.location+St);n.bindBuffer(n.ARRAY_BUFFER,j);for(let St=0;St<X.locationSize;St++)w(X.location+St,st/X.locationSize,dt,et,st*pt,st/X.locationSize*St*pt,xt)}}else if(z!==void 0){let et=z[tt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(X.location,et);break;case 3:n.vertexAttrib3fv(X.location,et);break;case 4:n.vertexAttrib4fv(X.location,et);break;default:n.vertexAttrib1fv(X.location,et)}}}}v()}function R(){I();for(let P in i){let O=i[P];for(let k in O){let N=O[k];for(let V in N){let W=N[V];for(let z in W)f(W[z].object),delete W[z];delete N[V]}}delete i[P]}}function A(P){if(i[P.id]===void 0)return;let O=i[P.id];for(let k in O){let N=O[k];for(let V in N){let W=N[V];for(let z in W)f(W[z].object),delete W[z];delete N[V]}}delete i[P.id]}function _(P){for(let O in i){let k=i[O];for(let N in k){let V=k[N];if(V[P.id]===void 0)continue;let W=V[P.id];for(let z in W)f(W[z].object),delete W[z];delete V[P.id]}}}function S(P){for(let O in i){let k=i[O],N=P.isInstancedMesh===!0?P.id:0,V=k[N];if(V!==void 0){for(let W in V){let z=V[W];for(let tt in z)f(z[tt].object),delete z[tt];delete V[W]}delete k[N],Object.keys(k).length===0&&delete i[O]}}}function I(){C(),o=!0,r!==s&&(r=s,c(r.object))}function C(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:C,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:S,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:g,disableUnusedAttributes:v}}function DS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,f){f!==0&&(n.drawArraysInstanced(i,l,c,f),e.update(c,i,f))}function a(l,c,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,f);let u=0;for(let h=0;h<f;h++)u+=c[h];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function NS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Hi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let S=_===Gi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ti&&_!==Vi&&!S&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",f=l(c);f!==c&&(te("WebGLRenderer:",c,"not supported, using",f,"instead."),c=f);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&te("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&te("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let h=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:h,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:v,maxVaryings:w,maxFragmentUniforms:M,maxSamples:R,samples:A}}function US(n){let t=this,e=null,i=0,s=!1,r=!1,o=new pi,a=new he,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let h=d.length!==0||u||i!==0||s;return s=u,i=d.length,h},this.beginShadows=function(){r=!0,f(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=f(d,u,0)},this.setState=function(d,u,h){let m=d.clippingPlanes,y=d.clipIntersection,g=d.clipShadows,p=n.get(d);if(!s||m===null||m.length===0||r&&!g)r?f(null):c();else{let v=r?0:i,w=v*4,M=p.clippingState||null;l.value=M,M=f(m,u,w,h);for(let R=0;R!==w;++R)M[R]=e[R];p.clippingState=M,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function f(d,u,h,m){let y=d!==null?d.length:0,g=null;if(y!==0){if(g=l.value,m!==!0||g===null){let p=h+y*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<p)&&(g=new Float32Array(p));for(let w=0,M=h;w!==y;++w,M+=4)o.copy(d[w]).applyMatrix4(v,a),o.normal.toArray(g,M),g[M+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,g}}var Oa=class extends gi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ma(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new xo(5,5,5),r=new es({name:"CubemapFromEquirect",uniforms:Sr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:xr});r.uniforms.tEquirect.value=e;let o=new _i(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=Jn),new vo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Fg=256,FS=3,OS=20,r0=256,o0=16,BS=3,zS=new Y,kS=new pe,gh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new vo(1,10,null),this._boxMesh=new _i(new xo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=zS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),f=this._getSourceTarget(!0);e>0&&(f.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,h=l.autoClearDepth,m=l.autoClearStencil,y=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(t.background=l.getClearColor(kS));let g=new vo(i,s,f);return g.position.copy(a),g.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=h,l.autoClearStencil=m,t.background=y,e>0&&(f.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=zg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Bg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Fg,bf(t))}_fromTexture(t,e){t.mapping===vr||t.mapping===wo?this._setSize(t.image.length===0?Fg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Og(t,!1,!1),i=Math.log2(t)-FS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Og(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===vr||t.mapping===wo?(this._cubemapMaterial===null&&(this._cubemapMaterial=zg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Bg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=VS(),this._integrationMaterial=GS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/o0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-BS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(r0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=HS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Og(n,t,e){return new Oa(n,{minFilter:bs,generateMipmaps:t,type:Gi,colorSpace:ia,depthBuffer:e})}function Ba(n,t,e){return new es({name:n,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:jn,blending:xr,depthTest:!1,depthWrite:!1})}function VS(){return Ba("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${r0}u

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
	`)}function GS(){return Ba("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:o0}},`

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
	`)}function HS(){return Ba("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${OS}
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
	`)}function Bg(){return Ba("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function zg(){return Ba("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function WS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,h=!1){return u==null?null:h?o(u):r(u)}function r(u){if(u&&u.isTexture){let h=u.mapping;if(h===Ac||h===Rc)if(t.has(u)){let m=t.get(u).texture;return a(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let y=new Oa(m.height);return y.fromEquirectangularTexture(n,u),t.set(u,y),u.addEventListener("dispose",c),a(y.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let h=u.mapping,m=h===Ac||h===Rc,y=h===vr||h===wo;if(m||y){let g=e.get(u),p=g!==void 0?g.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return i===null&&(i=new gh(n)),g=m?i.fromEquirectangular(u,g):i.fromCubemap(u,g),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),g.texture;if(g!==void 0)return g.texture;{let v=u.image;return m&&v&&v.height>0||y&&v&&l(v)?(i===null&&(i=new gh(n)),g=m?i.fromEquirectangular(u):i.fromCubemap(u),g.texture.pmremVersion=u.pmremVersion,e.set(u,g),u.addEventListener("dispose",f),g.texture):null}}}return u}function a(u,h){return h===Ac?u.mapping=vr:h===Rc&&(u.mapping=wo),u}function l(u){let h=0,m=6;for(let y=0;y<m;y++)u[y]!==void 0&&h++;return h===m}function c(u){let h=u.target;h.removeEventListener("dispose",c);let m=t.get(h);m!==void 0&&(t.delete(h),m.dispose())}function f(u){let h=u.target;h.removeEventListener("dispose",f);let m=e.get(h);m!==void 0&&(e.delete(h),m.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function XS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Qo("WebGLRenderer: "+i+" extension not supported."),s}}}function qS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(t.remove(y),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function f(m){let y=m.attributes;for(let g in y)t.update(y[g],n.ARRAY_BUFFER)}function d(m){let y=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let v=y!==null?y.array.length:g.array.length/3-1,w=g.count>=65535?ua:ha,M=new w(Math.ceil(v/3)*6,1),R=M.array;if(y!==null){let _=y.array;p=y.version;for(let S=0,I=0;S<v;S+=3){let C=_[S+0],P=_[S+1],O=_[S+2];R[I++]=C,R[I++]=P,R[I++]=P,R[I++]=O,R[I++]=O,R[I++]=C}}else{p=g.version;for(let _=0,S=0;_<v;_+=3){let I=_+0,C=_+1,P=_+2;R[S++]=I,R[S++]=C,R[S++]=C,R[S++]=P,R[S++]=P,R[S++]=I}}M.version=p;let A=r.get(m);A&&t.remove(A),r.set(m,M)}function u(m){let y=r.get(m);if(y){let g=m.index;g!==null&&y.version<g.version&&d(m)}else d(m);return r.get(m)}function h(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:f,getWireframeAttribute:u,dispose:h}}function YS(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*o),e.update(u,i,1)}function c(d,u,h){h!==0&&(n.drawElementsInstanced(i,u,r,d*o,h),e.update(u,i,h))}function f(d,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,h);let y=0;for(let g=0;g<h;g++)y+=u[g];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=f}function $S(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ae("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function ZS(n,t,e){let i=new WeakMap,s=new je;function r(o,a,l){let c=o.morphTargetInfluences,f=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=f!==void 0?f.length:0,u=i.get(a);if(u===void 0||u.count!==d){let I=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",I)};u!==void 0&&u.texture.dispose();let h=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],w=0;h===!0&&(w=1),m===!0&&(w=2),y===!0&&(w=3);let M=a.attributes.position.count*w,R=1;M>t.maxTextureSize&&(R=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let A=new Float32Array(M*R*4*d),_=new aa(A,M,R,d);_.type=Vi,_.needsUpdate=!0;let S=w*4;for(let C=0;C<d;C++){let P=g[C],O=p[C],k=v[C],N=M*R*4*C;for(let V=0;V<P.count;V++){let W=V*S;h===!0&&(s.fromBufferAttribute(P,V),A[N+W+0]=s.x,A[N+W+1]=s.y,A[N+W+2]=s.z,A[N+W+3]=0),m===!0&&(s.fromBufferAttribute(O,V),A[N+W+4]=s.x,A[N+W+5]=s.y,A[N+W+6]=s.z,A[N+W+7]=0),y===!0&&(s.fromBufferAttribute(k,V),A[N+W+8]=s.x,A[N+W+9]=s.y,A[N+W+10]=s.z,A[N+W+11]=k.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new jt(M,R)},i.set(a,u),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let h=0;for(let y=0;y<c.length;y++)h+=c[y];let m=a.morphTargetsRelative?1:1-h;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function JS(n,t,e,i,s){let r=new WeakMap;function o(c){let f=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==f&&(t.update(u),r.set(u,f)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==f&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,f))),c.isSkinnedMesh){let h=c.skeleton;r.get(h)!==f&&(h.update(),r.set(h,f))}return u}function a(){r=new WeakMap}function l(c){let f=c.target;f.removeEventListener("dispose",l),i.releaseStatesOfObject(f),e.remove(f.instanceMatrix),f.instanceColor!==null&&e.remove(f.instanceColor)}return{update:o,dispose:a}}var KS={[ef]:"LINEAR_TONE_MAPPING",[nf]:"REINHARD_TONE_MAPPING",[sf]:"CINEON_TONE_MAPPING",[rf]:"ACES_FILMIC_TONE_MAPPING",[af]:"AGX_TONE_MAPPING",[lf]:"NEUTRAL_TONE_MAPPING",[of]:"CUSTOM_TONE_MAPPING"};function jS(n,t,e,i,s,r){let o=new gi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,f=new Qn;f.setAttribute("position",new Bn([-1,3,0,-1,-1,0,3,-1,0],3)),f.setAttribute("uv",new Bn([0,2,0,0,2,0],2));let d=new uc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new _i(f,d),h=new ba(-1,1,1,-1,0,1),m=null,y=null,g=!1,p,v=null,w=[],M=!1;this.setSize=function(R,A){o.setSize(R,A),a!==null&&a.setSize(R,A),l!==null&&l.setSize(R,A);for(let _=0;_<w.length;_++){let S=w[_];S.setSize&&S.setSize(R,A)}},this.setEffects=function(R){w=R,M=w.length>0&&w[0].isRenderPass===!0;let A=o.width,_=o.height;w.length>0&&a===null&&(a=new gi(A,_,{type:Gi,depthBuffer:!1,stencilBuffer:!1}),l=new gi(A,_,{type:Gi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&w.some(I=>I.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Ss(A,_),r===!0&&(c.format=ws,c.type=Mr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let I=0;I<w.length;I++){let C=w[I];C.setSize&&C.setSize(A,_),S&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(c)}},this.begin=function(R,A){if(g||R.toneMapping===ns&&w.length===0)return!1;if(v=A,A!==null){let _=A.width,S=A.height;(o.width!==_||o.height!==S)&&this.setSize(_,S)}return M===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=ns,!0},this.hasRenderPass=function(){return M},this.end=function(R,A){R.toneMapping=p,g=!0;let _=o,S=a;for(let I=0;I<w.length;I++){let C=w[I];C.enabled!==!1&&(C.render(R,S,_,A),C.needsSwap!==!1&&(_=S,S=S===a?l:a))}if(m!==R.outputColorSpace||y!==R.toneMapping){m=R.outputColorSpace,y=R.toneMapping,d.defines={},be.getTransfer(m)===Ue&&(d.defines.SRGB_TRANSFER="");let I=KS[y];I&&(d.defines[I]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,R.setRenderTarget(v),R.render(u,h),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),f.dispose(),d.dispose()}}var a0=new Kn,l0=new Ss(1,1),c0=new _a(1),h0=new aa,u0=new ic,f0=new ma,kg=[],Vg=[],Gg=new Float32Array(16),Hg=new Float32Array(9),Wg=new Float32Array(4);function Ao(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=kg[s];if(r===void 0&&(r=new Float32Array(s),kg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function vn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Mn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function xh(n,t){let e=Vg[t];e===void 0&&(e=new Int32Array(t),Vg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function QS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function tb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2fv(this.addr,t),Mn(e,t)}}function eb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vn(e,t))return;n.uniform3fv(this.addr,t),Mn(e,t)}}function nb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4fv(this.addr,t),Mn(e,t)}}function ib(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Mn(e,t)}else{if(vn(e,i))return;Wg.set(i),n.uniformMatrix2fv(this.addr,!1,Wg),Mn(e,i)}}function sb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Mn(e,t)}else{if(vn(e,i))return;Hg.set(i),n.uniformMatrix3fv(this.addr,!1,Hg),Mn(e,i)}}function rb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Mn(e,t)}else{if(vn(e,i))return;Gg.set(i),n.uniformMatrix4fv(this.addr,!1,Gg),Mn(e,i)}}function ob(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function ab(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2iv(this.addr,t),Mn(e,t)}}function lb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;n.uniform3iv(this.addr,t),Mn(e,t)}}function cb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4iv(this.addr,t),Mn(e,t)}}function hb(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function ub(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2uiv(this.addr,t),Mn(e,t)}}function fb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;n.uniform3uiv(this.addr,t),Mn(e,t)}}function db(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4uiv(this.addr,t),Mn(e,t)}}function yh(n){return n.version===0&&(n.compareFunction=yf,n.needsUpdate=!0),n}function pb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=yh(l0):r=a0,e.setTexture2D(t||r,s)}function mb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||u0,s)}function gb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=yh(c0):r=f0,e.setTextureCube(t||r,s)}function _b(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||h0,s)}function xb(n){switch(n){case 5126:return QS;case 35664:return tb;case 35665:return eb;case 35666:return nb;case 35674:return ib;case 35675:return sb;case 35676:return rb;case 5124:case 35670:return ob;case 35667:case 35671:return ab;case 35668:case 35672:return lb;case 35669:case 35673:return cb;case 5125:return hb;case 36294:return ub;case 36295:return fb;case 36296:return db;case 35678:case 36198:case 36298:case 36306:case 35682:return pb;case 35679:case 36299:case 36307:return mb;case 35680:case 36300:case 36308:case 36293:return gb;case 36289:case 36303:case 36311:case 36292:return _b}}function yb(n,t){n.uniform1fv(this.addr,t)}function vb(n,t){let e=Ao(t,this.size,2);n.uniform2fv(this.addr,e)}function Mb(n,t){let e=Ao(t,this.size,3);n.uniform3fv(this.addr,e)}function Sb(n,t){let e=Ao(t,this.size,4);n.uniform4fv(this.addr,e)}function bb(n,t){let e=Ao(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function wb(n,t){let e=Ao(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Tb(n,t){let e=Ao(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Eb(n,t){n.uniform1iv(this.addr,t)}function Ab(n,t){n.uniform2iv(this.addr,t)}function Rb(n,t){n.uniform3iv(this.addr,t)}function Cb(n,t){n.uniform4iv(this.addr,t)}function Pb(n,t){n.uniform1uiv(this.addr,t)}function Ib(n,t){n.uniform2uiv(this.addr,t)}function Lb(n,t){n.uniform3uiv(this.addr,t)}function Db(n,t){n.uniform4uiv(this.addr,t)}function Nb(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=yh(l0):o=a0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Ub(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||u0,r[o])}function Fb(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=yh(c0):o=f0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Ob(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||h0,r[o])}function Bb(n){switch(n){case 5126:return yb;case 35664:return vb;case 35665:return Mb;case 35666:return Sb;case 35674:return bb;case 35675:return wb;case 35676:return Tb;case 5124:case 35670:return Eb;case 35667:case 35671:return Ab;case 35668:case 35672:return Rb;case 35669:case 35673:return Cb;case 5125:return Pb;case 36294:return Ib;case 36295:return Lb;case 36296:return Db;case 35678:case 36198:case 36298:case 36306:case 35682:return Nb;case 35679:case 36299:case 36307:return Ub;case 35680:case 36300:case 36308:case 36293:return Fb;case 36289:case 36303:case 36311:case 36292:return Ob}}var Df=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=xb(e.type)}},Nf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Bb(e.type)}},Uf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},If=/(\w+)(\])?(\[|\.)?/g;function Xg(n,t){n.seq.push(t),n.map[t.id]=t}function zb(n,t,e){let i=n.name,s=i.length;for(If.lastIndex=0;;){let r=If.exec(i),o=If.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Xg(e,c===void 0?new Df(a,n,t):new Nf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new Uf(a),Xg(e,d)),e=d}}}var Eo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);zb(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function qg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var kb=37297,Vb=0;function Gb(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Yg=new he;function Hb(n){be._getMatrix(Yg,be.workingColorSpace,n);let t=`mat3( ${Yg.elements.map(e=>e.toFixed(4))} )`;switch(be.getTransfer(n)){case sa:return[t,"LinearTransferOETF"];case Ue:return[t,"sRGBTransferOETF"];default:return te("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function $g(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Gb(n.getShaderSource(t),a)}else return r}function Wb(n,t){let e=Hb(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Xb={[ef]:"Linear",[nf]:"Reinhard",[sf]:"Cineon",[rf]:"ACESFilmic",[af]:"AgX",[lf]:"Neutral",[of]:"Custom"};function qb(n,t){let e=Xb[t];return e===void 0?(te("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var mh=new Y;function Yb(){be.getLuminanceCoefficients(mh);let n=mh.x.toFixed(4),t=mh.y.toFixed(4),e=mh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $b(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function Zb(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Jb(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Fa(n){return n!==""}function Zg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Jg(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Kb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ff(n){return n.replace(Kb,jb)}function jb(n,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ff(e)}var Qb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Kg(n){return n.replace(Qb,tw)}function tw(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function jg(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var ew={[Aa]:"SHADOWMAP_TYPE_PCF",[So]:"SHADOWMAP_TYPE_VSM"};function nw(n){return ew[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var iw={[wo]:"ENVMAP_MODE_REFRACTION"};function sw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":iw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var rw={[Ec]:"ENVMAP_BLENDING_MULTIPLY",[gg]:"ENVMAP_BLENDING_MIX",[_g]:"ENVMAP_BLENDING_ADD"};function ow(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":rw[n.combine]||"ENVMAP_BLENDING_NONE"}function aw(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=nw(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",f=sw(e),d=ow(e),u=$b(e),h=Zb(r),m=s.createProgram(),y,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,h].filter(Fa).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,h].filter(Fa).join(`
`),g.length>0&&(g+=`
`)):(y=[jg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,h,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+f:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),g=[jg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,h,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+f:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ns?"#define TONE_MAPPING":"",e.toneMapping!==ns?me.tonemapping_pars_fragment:"",e.toneMapping!==ns?qb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,Wb("linearToOutputTexel",e.outputColorSpace),Yb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fa).join(`
`)),o=Ff(o),o=Zg(o,e),o=Jg(o,e),a=Ff(a),a=Zg(a,e),a=Jg(a,e),o=Kg(o),a=Kg(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",e.glslVersion===Mf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Mf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=p+y+o,w=p+g+a,M=qg(s,s.VERTEX_SHADER,v),R=qg(s,s.FRAGMENT_SHADER,w);s.attachShader(m,M),s.attachShader(m,R),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(C){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(m)||"",O=s.getShaderInfoLog(M)||"",k=s.getShaderInfoLog(R)||"",N=P.trim(),V=O.trim(),W=k.trim(),z=!0,tt=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,M,R);else{let X=$g(s,M,"vertex"),Z=$g(s,R,"fragment");ae("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+N+`
`+X+`
`+Z)}else N!==""?te("WebGLProgram: Program Info Log:",N):(V===""||W==="")&&(tt=!1);tt&&(C.diagnostics={runnable:z,programLog:N,vertexShader:{log:V,prefix:y},fragmentShader:{log:W,prefix:g}})}s.deleteShader(M),s.deleteShader(R),_=new Eo(s,m),S=Jb(s,m)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let S;this.getAttributes=function(){return S===void 0&&A(this),S};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(m,kb)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Vb++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=R,this}var lw=0,Of=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Bf(t),e.set(t,i)),i}},Bf=class{constructor(t){this.id=lw++,this.code=t,this.usedTimes=0}};function cw(n){return n===Zs||n===Da||n===Na}function hw(n,t,e,i,s,r){let o=new la,a=new Of,l=new Set,c=[],f=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function h(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,S,I,C,P,O){let k=C.fog,N=P.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?C.environment:null,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=t.get(_.envMap||V,W),tt=u[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&te("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let Z=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,et=Z!==void 0?Z.length:0,st=0;N.morphAttributes.position!==void 0&&(st=1),N.morphAttributes.normal!==void 0&&(st=2),N.morphAttributes.color!==void 0&&(st=3);let rt,j,dt,pt;if(tt){let It=ss[tt];rt=It.vertexShader,j=It.fragmentShader}else{rt=_.vertexShader,j=_.fragmentShader;let It=a.getVertexShaderStage(_),fe=a.getFragmentShaderStage(_);a.update(_,It,fe),dt=It.id,pt=fe.id}let xt=n.getRenderTarget(),St=n.state.buffers.depth.getReversed(),Wt=P.isInstancedMesh===!0,gt=P.isBatchedMesh===!0,yt=!!_.map,Xt=!!_.matcap,qt=!!z,Yt=qt&&z.isPMREMTexture===!0,ie=!!_.aoMap,se=!!_.lightMap,Ae=!!_.bumpMap&&_.wireframe===!1,ge=!!_.normalMap,we=!!_.displacementMap,ce=!!_.emissiveMap,He=!!_.metalnessMap,Le=!!_.roughnessMap,Re=_.anisotropy>0,F=_.clearcoat>0,Pt=_.diffuseRoughness>0,Ft=_.dispersion>0,Jt=_.retroreflectivity>0,bt=_.iridescence>0,Fe=_.sheen>0,Gt=_.transmission>0,Kt=Re&&!!_.anisotropyMap,L=F&&!!_.clearcoatMap,b=F&&!!_.clearcoatNormalMap,q=F&&!!_.clearcoatRoughnessMap,ut=Pt&&!!_.diffuseRoughnessMap,at=bt&&!!_.iridescenceMap,vt=bt&&!!_.iridescenceThicknessMap,wt=Fe&&!!_.sheenColorMap,nt=Fe&&!!_.sheenRoughnessMap,ot=!!_.specularMap,_t=!!_.specularColorMap,B=!!_.specularIntensityMap,lt=Gt&&!!_.transmissionMap,it=Gt&&!!_.thicknessMap,At=!!_.gradientMap,Mt=!!_.alphaMap,Et=_.alphaTest>0,$t=!!_.alphaHash,re=!!_.extensions,ft=ns;_.toneMapped&&(xt===null||xt.isXRRenderTarget===!0)&&(ft=n.toneMapping);let kt=Yt?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,oe={shaderID:tt,shaderType:_.type,shaderName:_.name,vertexShader:rt,fragmentShader:j,defines:_.defines,customVertexShaderID:dt,customFragmentShaderID:pt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:gt,batchingColor:gt&&P._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&P.instanceColor!==null,instancingMorph:Wt&&P.morphTexture!==null,outputColorSpace:xt===null?n.outputColorSpace:xt.isXRRenderTarget===!0?xt.texture.colorSpace:be.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:yt,matcap:Xt,envMap:qt,envMapMode:qt&&z.mapping,envMapPMREM:Yt,envMapMaxLod:Yt?kt.length-1:null,envMapSize:Yt?kt[0].width:null,aoMap:ie,lightMap:se,bumpMap:Ae,normalMap:ge,displacementMap:we,emissiveMap:ce,normalMapObjectSpace:ge&&_.normalMapType===vg,normalMapTangentSpace:ge&&_.normalMapType===fh,packedNormalMap:ge&&_.normalMapType===fh&&cw(_.normalMap.format),metalnessMap:He,roughnessMap:Le,anisotropy:Re,anisotropyMap:Kt,clearcoat:F,clearcoatMap:L,clearcoatNormalMap:b,clearcoatRoughnessMap:q,diffuseRoughness:Pt,diffuseRoughnessMap:ut,dispersion:Ft,retroreflection:Jt,iridescence:bt,iridescenceMap:at,iridescenceThicknessMap:vt,sheen:Fe,sheenColorMap:wt,sheenRoughnessMap:nt,specularMap:ot,specularColorMap:_t,specularIntensityMap:B,transmission:Gt,transmissionMap:lt,thicknessMap:it,gradientMap:At,opaque:_.transparent===!1&&_.blending===bo&&_.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Et,alphaHash:$t,combine:_.combine,mapUv:yt&&h(_.map.channel),aoMapUv:ie&&h(_.aoMap.channel),lightMapUv:se&&h(_.lightMap.channel),bumpMapUv:Ae&&h(_.bumpMap.channel),normalMapUv:ge&&h(_.normalMap.channel),displacementMapUv:we&&h(_.displacementMap.channel),emissiveMapUv:ce&&h(_.emissiveMap.channel),metalnessMapUv:He&&h(_.metalnessMap.channel),roughnessMapUv:Le&&h(_.roughnessMap.channel),anisotropyMapUv:Kt&&h(_.anisotropyMap.channel),clearcoatMapUv:L&&h(_.clearcoatMap.channel),clearcoatNormalMapUv:b&&h(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&h(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&h(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&h(_.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&h(_.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&h(_.sheenColorMap.channel),sheenRoughnessMapUv:nt&&h(_.sheenRoughnessMap.channel),specularMapUv:ot&&h(_.specularMap.channel),specularColorMapUv:_t&&h(_.specularColorMap.channel),specularIntensityMapUv:B&&h(_.specularIntensityMap.channel),transmissionMapUv:lt&&h(_.transmissionMap.channel),thicknessMapUv:it&&h(_.thicknessMap.channel),alphaMapUv:Mt&&h(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(ge||Re),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!N.attributes.uv&&(yt||Mt),fog:!!k,useFog:_.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&ge===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:St,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:st,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:O.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ft,decodeVideoTexture:yt&&_.map.isVideoTexture===!0&&be.getTransfer(_.map.colorSpace)===Ue,decodeVideoTextureEmissive:ce&&_.emissiveMap.isVideoTexture===!0&&be.getTransfer(_.emissiveMap.colorSpace)===Ue,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ei,flipSided:_.side===jn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:re&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(re&&_.extensions.multiDraw===!0||gt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return oe.vertexUv1s=l.has(1),oe.vertexUv2s=l.has(2),oe.vertexUv3s=l.has(3),l.clear(),oe}function y(_){let S=[];if(_.shaderID?S.push(_.shaderID):(S.push(_.customVertexShaderID),S.push(_.customFragmentShaderID)),_.defines!==void 0)for(let I in _.defines)S.push(I),S.push(_.defines[I]);return _.isRawShaderMaterial===!1&&(g(S,_),p(S,_),S.push(n.outputColorSpace)),S.push(_.customProgramCacheKey),S.join()}function g(_,S){_.push(S.precision),_.push(S.outputColorSpace),_.push(S.envMapMode),_.push(S.envMapPMREM),_.push(S.envMapMaxLod),_.push(S.envMapSize),_.push(S.mapUv),_.push(S.alphaMapUv),_.push(S.lightMapUv),_.push(S.aoMapUv),_.push(S.bumpMapUv),_.push(S.normalMapUv),_.push(S.displacementMapUv),_.push(S.emissiveMapUv),_.push(S.metalnessMapUv),_.push(S.roughnessMapUv),_.push(S.anisotropyMapUv),_.push(S.clearcoatMapUv),_.push(S.clearcoatNormalMapUv),_.push(S.clearcoatRoughnessMapUv),_.push(S.diffuseRoughnessMapUv),_.push(S.iridescenceMapUv),_.push(S.iridescenceThicknessMapUv),_.push(S.sheenColorMapUv),_.push(S.sheenRoughnessMapUv),_.push(S.specularMapUv),_.push(S.specularColorMapUv),_.push(S.specularIntensityMapUv),_.push(S.transmissionMapUv),_.push(S.thicknessMapUv),_.push(S.combine),_.push(S.fogExp2),_.push(S.sizeAttenuation),_.push(S.morphTargetsCount),_.push(S.numSunLights),_.push(S.numDirLights),_.push(S.numPointLights),_.push(S.numSpotLights),_.push(S.numSpotLightMaps),_.push(S.numHemiLights),_.push(S.numRectAreaLights),_.push(S.numSunLightShadows),_.push(S.numDirLightShadows),_.push(S.numPointLightShadows),_.push(S.numSpotLightShadows),_.push(S.numSpotLightShadowsWithMaps),_.push(S.numLightProbes),_.push(S.numLightProbeGrids),_.push(S.shadowMapType),_.push(S.toneMapping),_.push(S.numClippingPlanes),_.push(S.numClipIntersection),_.push(S.depthPacking)}function p(_,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let S=u[_.type],I;if(S){let C=ss[S];I=Dg.clone(C.uniforms)}else I=_.uniforms;return I}function w(_,S){let I=f.get(S);return I!==void 0?++I.usedTimes:(I=new aw(n,S,_,s),c.push(I),f.set(S,I)),I}function M(_){if(--_.usedTimes===0){let S=c.indexOf(_);c[S]=c[c.length-1],c.pop(),f.delete(_.cacheKey),_.destroy()}}function R(_){a.remove(_)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:w,releaseProgram:M,releaseShaderCache:R,programs:c,dispose:A}}function uw(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function fw(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Qg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function t0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let h=0;return u.isInstancedMesh&&(h+=2),u.isSkinnedMesh&&(h+=1),h}function a(u,h,m,y,g,p){let v=n[t];return v===void 0?(v={id:u.id,object:u,geometry:h,material:m,materialVariant:o(u),groupOrder:y,renderOrder:u.renderOrder,z:g,group:p},n[t]=v):(v.id=u.id,v.object=u,v.geometry=h,v.material=m,v.materialVariant=o(u),v.groupOrder=y,v.renderOrder=u.renderOrder,v.z=g,v.group=p),t++,v}function l(u,h,m,y,g,p,v){v.reversedDepth===!0&&(g=-g);let w=a(u,h,m,y,g,p);m.transmission>0?i.push(w):m.transparent===!0?s.push(w):e.push(w)}function c(u,h,m,y,g,p){let v=a(u,h,m,y,g,p);m.transmission>0?i.unshift(v):m.transparent===!0?s.unshift(v):e.unshift(v)}function f(u,h){e.length>1&&e.sort(u||fw),i.length>1&&i.sort(h||Qg),s.length>1&&s.sort(h||Qg)}function d(){for(let u=t,h=n.length;u<h;u++){let m=n[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:f}}function dw(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new t0,n.set(i,[o])):s>=r.length?(o=new t0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function pw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new Y,color:new pe};break;case"SpotLight":e={position:new Y,direction:new Y,color:new pe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new Y,color:new pe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new Y,skyColor:new pe,groundColor:new pe};break;case"RectAreaLight":e={color:new pe,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return n[t.id]=e,e}}}function mw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var gw=0;function _w(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function xw(n){let t=new pw,e=mw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Y);let s=new Y,r=new We,o=new We;function a(c){let f=0,d=0,u=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let h=0,m=0,y=0,g=0,p=0,v=0,w=0,M=0,R=0,A=0,_=0,S=0,I=0,C=0;c.sort(_w);for(let O=0,k=c.length;O<k;O++){let N=c[O],V=N.color,W=N.intensity,z=N.distance,tt=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Zs?tt=N.shadow.map.texture:tt=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)f+=V.r*W,d+=V.g*W,u+=V.b*W;else if(N.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(N.sh.coefficients[X],W);C++}else if(N.isSunLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Z=N.shadow,et=e.get(N);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[m]=et,i.sunShadowMap[m]=tt;let st=Z.getViewportCount();for(let rt=0;rt<st;rt++)i.sunShadowMatrix[y+rt]=Z.getMatrix(rt),i.sunShadowCascade[y+rt]=Z._cascadeData[rt];y+=st,m++}i.sun[h]=X,h++}else if(N.isDirectionalLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Z=N.shadow,et=e.get(N);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize=Z.mapSize,i.directionalShadow[g]=et,i.directionalShadowMap[g]=tt,i.directionalShadowMatrix[g]=N.shadow.matrix,R++}i.directional[g]=X,g++}else if(N.isSpotLight){let X=t.get(N);X.position.setFromMatrixPosition(N.matrixWorld),X.color.copy(V).multiplyScalar(W),X.distance=z,X.coneCos=Math.cos(N.angle),X.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),X.decay=N.decay,i.spot[v]=X;let Z=N.shadow;if(N.map&&(i.spotLightMap[S]=N.map,S++,Z.updateMatrices(N),N.castShadow&&I++),i.spotLightMatrix[v]=Z.matrix,N.castShadow){let et=e.get(N);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize=Z.mapSize,i.spotShadow[v]=et,i.spotShadowMap[v]=tt,_++}v++}else if(N.isRectAreaLight){let X=t.get(N);X.color.copy(V).multiplyScalar(W),X.halfWidth.set(N.width*.5,0,0),X.halfHeight.set(0,N.height*.5,0),i.rectArea[w]=X,w++}else if(N.isPointLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),X.distance=N.distance,X.decay=N.decay,N.castShadow){let Z=N.shadow,et=e.get(N);et.shadowIntensity=Z.intensity,et.shadowBias=Z.bias,et.shadowNormalBias=Z.normalBias,et.shadowRadius=Z.radius,et.shadowMapSize=Z.mapSize,et.shadowCameraNear=Z.camera.near,et.shadowCameraFar=Z.camera.far,i.pointShadow[p]=et,i.pointShadowMap[p]=tt,i.pointShadowMatrix[p]=N.shadow.matrix,A++}i.point[p]=X,p++}else if(N.isHemisphereLight){let X=t.get(N);X.skyColor.copy(N.color).multiplyScalar(W),X.groundColor.copy(N.groundColor).multiplyScalar(W),i.hemi[M]=X,M++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Nt.LTC_FLOAT_1,i.rectAreaLTC2=Nt.LTC_FLOAT_2):(i.rectAreaLTC1=Nt.LTC_HALF_1,i.rectAreaLTC2=Nt.LTC_HALF_2)),i.ambient[0]=f,i.ambient[1]=d,i.ambient[2]=u;let P=i.hash;(P.sunLength!==h||P.directionalLength!==g||P.pointLength!==p||P.spotLength!==v||P.rectAreaLength!==w||P.hemiLength!==M||P.numSunShadows!==m||P.numDirectionalShadows!==R||P.numPointShadows!==A||P.numSpotShadows!==_||P.numSpotMaps!==S||P.numLightProbes!==C)&&(i.sun.length=h,i.directional.length=g,i.spot.length=v,i.rectArea.length=w,i.point.length=p,i.hemi.length=M,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+S-I,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=C,P.sunLength=h,P.directionalLength=g,P.pointLength=p,P.spotLength=v,P.rectAreaLength=w,P.hemiLength=M,P.numSunShadows=m,P.numDirectionalShadows=R,P.numPointShadows=A,P.numSpotShadows=_,P.numSpotMaps=S,P.numLightProbes=C,i.version=gw++)}function l(c,f){let d=0,u=0,h=0,m=0,y=0,g=0,p=f.matrixWorldInverse;for(let v=0,w=c.length;v<w;v++){let M=c[v];if(M.isSunLight){let R=i.sun[d];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),d++}else if(M.isDirectionalLight){let R=i.directional[u];R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),u++}else if(M.isSpotLight){let R=i.spot[m];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),m++}else if(M.isRectAreaLight){let R=i.rectArea[y];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(M.width*.5,0,0),R.halfHeight.set(0,M.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(M.isPointLight){let R=i.point[h];R.position.setFromMatrixPosition(M.matrixWorld),R.position.applyMatrix4(p),h++}else if(M.isHemisphereLight){let R=i.hemi[g];R.direction.setFromMatrixPosition(M.matrixWorld),R.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:i}}function e0(n){let t=new xw(n),e=[],i=[],s=[];function r(d){f.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let f={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:f,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function yw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new e0(n),t.set(s,[a])):r>=o.length?(a=new e0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var vw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Mw=`uniform sampler2D shadow_pass;
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
}`,Sw=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],bw=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],n0=new We,Ua=new Y,Lf=new Y;function ww(n,t,e){let i=new Gs,s=new jt,r=new jt,o=new je,a=new fc,l=new dc,c={},f=e.maxTextureSize,d={[$s]:jn,[jn]:$s,[Ei]:Ei},u=new es({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new jt},radius:{value:4}},vertexShader:vw,fragmentShader:Mw}),h=u.clone();h.defines.HORIZONTAL_PASS=1;let m=new Qn;m.setAttribute("position",new Zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new _i(m,u),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Aa;let p=this.type;this.render=function(A,_,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===Km&&(te("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Aa);let I=n.getRenderTarget(),C=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),O=n.state;O.setBlending(xr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let k=p!==this.type;k&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(V=>V.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,V=A.length;N<V;N++){let W=A[N],z=W.shadow;if(z===void 0){te("WebGLShadowMap:",W,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let tt=z.getFrameExtents();s.multiply(tt),r.copy(z.mapSize),(s.x>f||s.y>f)&&(s.x>f&&(r.x=Math.floor(f/tt.x),s.x=r.x*tt.x,z.mapSize.x=r.x),s.y>f&&(r.y=Math.floor(f/tt.y),s.y=r.y*tt.y,z.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=X,z.map===null||k===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===So){if(W.isPointLight){te("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new gi(s.x,s.y,{format:Zs,type:Gi,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),z.map.texture.name=W.name+".shadowMap",z.map.depthTexture=new Ss(s.x,s.y,Vi),z.map.depthTexture.name=W.name+".shadowMapDepth",z.map.depthTexture.format=vs,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=In,z.map.depthTexture.magFilter=In}else W.isPointLight?(z.map=new Oa(s.x),z.map.depthTexture=new _a(s.x,ki)):(z.map=new gi(s.x,s.y),z.map.depthTexture=new Ss(s.x,s.y,ki)),z.map.depthTexture.name=W.name+".shadowMap",z.map.depthTexture.format=vs,this.type===Aa?(z.map.depthTexture.compareFunction=X?xf:_f,z.map.depthTexture.minFilter=Jn,z.map.depthTexture.magFilter=Jn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=In,z.map.depthTexture.magFilter=In);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Z=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();W.isPointLight!==!0&&z.updateMatrices(W,S);let et=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:S.layers;for(let st=0;st<Z;st++){let rt=z.getCamera(st);if(W.isPointLight){let j=z.camera,dt=z.matrix,pt=W.distance||j.far;pt!==j.far&&(j.far=pt,j.updateProjectionMatrix()),Ua.setFromMatrixPosition(W.matrixWorld),j.position.copy(Ua),Lf.copy(j.position),Lf.add(Sw[st]),j.up.copy(bw[st]),j.lookAt(Lf),j.updateMatrixWorld(),dt.makeTranslation(-Ua.x,-Ua.y,-Ua.z),n0.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),z._frustum.setFromProjectionMatrix(n0,j.coordinateSystem,j.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,st),n.clear();else{st===0&&(n.setRenderTarget(z.map),n.clear());let j=z.getViewport(st);o.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),O.viewport(o)}i=z.getFrustum(st),M(_,S,rt,W,et,this.type)}z.isPointLightShadow!==!0&&this.type===So&&v(z,S),z.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(I,C,P)};function v(A,_){let S=t.update(y);u.defines.VSM_SAMPLES!==A.blurSamples&&(u.defines.VSM_SAMPLES=A.blurSamples,h.defines.VSM_SAMPLES=A.blurSamples,u.needsUpdate=!0,h.needsUpdate=!0),A.mapPass===null?A.mapPass=new gi(s.x,s.y,{format:Zs,type:Gi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),u.uniforms.shadow_pass.value=A.map.depthTexture,u.uniforms.resolution.value.set(A.map.width,A.map.height),u.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(_,null,S,u,y,null),h.uniforms.shadow_pass.value=A.mapPass.texture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(_,null,S,h,y,null)}function w(A,_,S,I){let C=null,P=S.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(P!==void 0)C=P;else if(C=S.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=C.uuid,k=_.uuid,N=c[O];N===void 0&&(N={},c[O]=N);let V=N[k];V===void 0&&(V=C.clone(),N[k]=V,_.addEventListener("dispose",R)),C=V}if(C.visible=_.visible,C.wireframe=_.wireframe,I===So?C.side=_.shadowSide!==null?_.shadowSide:_.side:C.side=_.shadowSide!==null?_.shadowSide:d[_.side],C.alphaMap=_.alphaMap,C.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,C.map=_.map,C.clipShadows=_.clipShadows,C.clippingPlanes=_.clippingPlanes,C.clipIntersection=_.clipIntersection,C.displacementMap=_.displacementMap,C.displacementScale=_.displacementScale,C.displacementBias=_.displacementBias,C.wireframeLinewidth=_.wireframeLinewidth,C.linewidth=_.linewidth,S.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let O=n.properties.get(C);O.light=S}return C}function M(A,_,S,I,C,P){if(A.visible===!1)return;if(A.layers.test(C)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&P===So)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,A.matrixWorld);let N=t.update(A),V=A.material;if(Array.isArray(V)){let W=N.groups;for(let z=0,tt=W.length;z<tt;z++){let X=W[z],Z=V[X.materialIndex];if(Z&&Z.visible){let et=w(A,Z,I,P);A.onBeforeShadow(n,A,_,S,N,et,X),n.renderBufferDirect(S,null,N,et,A,X),A.onAfterShadow(n,A,_,S,N,et,X)}}}else if(V.visible){let W=w(A,V,I,P);A.onBeforeShadow(n,A,_,S,N,W,null),n.renderBufferDirect(S,null,N,W,A,null),A.onAfterShadow(n,A,_,S,N,W,null)}}let k=A.children;for(let N=0,V=k.length;N<V;N++)M(k[N],_,S,I,C,P)}function R(A){A.target.removeEventListener("dispose",R);for(let S in c){let I=c[S],C=A.target.uuid;C in I&&(I[C].dispose(),delete I[C])}}}function Tw(n,t){function e(){let B=!1,lt=new je,it=null,At=new je(0,0,0,0);return{setMask:function(Mt){it!==Mt&&!B&&(n.colorMask(Mt,Mt,Mt,Mt),it=Mt)},setLocked:function(Mt){B=Mt},setClear:function(Mt,Et,$t,re,ft){ft===!0&&(Mt*=re,Et*=re,$t*=re),lt.set(Mt,Et,$t,re),At.equals(lt)===!1&&(n.clearColor(Mt,Et,$t,re),At.copy(lt))},reset:function(){B=!1,it=null,At.set(-1,0,0,0)}}}function i(){let B=!1,lt=!1,it=null,At=null,Mt=null;return{setReversed:function(Et){if(lt!==Et){let $t=t.get("EXT_clip_control");Et?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),lt=Et;let re=Mt;Mt=null,this.setClear(re)}},getReversed:function(){return lt},setTest:function(Et){Et?St(n.DEPTH_TEST):Wt(n.DEPTH_TEST)},setMask:function(Et){it!==Et&&!B&&(n.depthMask(Et),it=Et)},setFunc:function(Et){if(lt&&(Et=Pg[Et]),At!==Et){switch(Et){case Xl:n.depthFunc(n.NEVER);break;case ql:n.depthFunc(n.ALWAYS);break;case Yl:n.depthFunc(n.LESS);break;case co:n.depthFunc(n.LEQUAL);break;case $l:n.depthFunc(n.EQUAL);break;case Zl:n.depthFunc(n.GEQUAL);break;case Jl:n.depthFunc(n.GREATER);break;case Kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=Et}},setLocked:function(Et){B=Et},setClear:function(Et){Mt!==Et&&(Mt=Et,lt&&(Et=1-Et),n.clearDepth(Et))},reset:function(){B=!1,it=null,At=null,Mt=null,lt=!1}}}function s(){let B=!1,lt=null,it=null,At=null,Mt=null,Et=null,$t=null,re=null,ft=null;return{setTest:function(kt){B||(kt?St(n.STENCIL_TEST):Wt(n.STENCIL_TEST))},setMask:function(kt){lt!==kt&&!B&&(n.stencilMask(kt),lt=kt)},setFunc:function(kt,oe,It){(it!==kt||At!==oe||Mt!==It)&&(n.stencilFunc(kt,oe,It),it=kt,At=oe,Mt=It)},setOp:function(kt,oe,It){(Et!==kt||$t!==oe||re!==It)&&(n.stencilOp(kt,oe,It),Et=kt,$t=oe,re=It)},setLocked:function(kt){B=kt},setClear:function(kt){ft!==kt&&(n.clearStencil(kt),ft=kt)},reset:function(){B=!1,lt=null,it=null,At=null,Mt=null,Et=null,$t=null,re=null,ft=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,f={},d={},u={},h=new WeakMap,m=[],y=null,g=!1,p=null,v=null,w=null,M=null,R=null,A=null,_=null,S=new pe(0,0,0),I=0,C=!1,P=null,O=null,k=null,N=null,V=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,tt=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec(X)[1]),z=tt>=1):X.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),z=tt>=2);let Z=null,et={},st=n.getParameter(n.SCISSOR_BOX),rt=n.getParameter(n.VIEWPORT),j=new je().fromArray(st),dt=new je().fromArray(rt);function pt(B,lt,it,At){let Mt=new Uint8Array(4),Et=n.createTexture();n.bindTexture(B,Et),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $t=0;$t<it;$t++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(lt+$t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Et}let xt={};xt[n.TEXTURE_2D]=pt(n.TEXTURE_2D,n.TEXTURE_2D,1),xt[n.TEXTURE_CUBE_MAP]=pt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),xt[n.TEXTURE_2D_ARRAY]=pt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),xt[n.TEXTURE_3D]=pt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),St(n.DEPTH_TEST),o.setFunc(co),Ae(!1),ge(Zu),St(n.CULL_FACE),ie(xr);function St(B){f[B]!==!0&&(n.enable(B),f[B]=!0)}function Wt(B){f[B]!==!1&&(n.disable(B),f[B]=!1)}function gt(B,lt){return u[B]!==lt?(n.bindFramebuffer(B,lt),u[B]=lt,B===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=lt),B===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function yt(B,lt){let it=m,At=!1;if(B){it=h.get(lt),it===void 0&&(it=[],h.set(lt,it));let Mt=B.textures;if(it.length!==Mt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Et=0,$t=Mt.length;Et<$t;Et++)it[Et]=n.COLOR_ATTACHMENT0+Et;it.length=Mt.length,At=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,At=!0);At&&n.drawBuffers(it)}function Xt(B){return y!==B?(n.useProgram(B),y=B,!0):!1}let qt={[yr]:n.FUNC_ADD,[Qm]:n.FUNC_SUBTRACT,[tg]:n.FUNC_REVERSE_SUBTRACT};qt[eg]=n.MIN,qt[ng]=n.MAX;let Yt={[ig]:n.ZERO,[sg]:n.ONE,[rg]:n.SRC_COLOR,[Qu]:n.SRC_ALPHA,[ug]:n.SRC_ALPHA_SATURATE,[cg]:n.DST_COLOR,[ag]:n.DST_ALPHA,[og]:n.ONE_MINUS_SRC_COLOR,[tf]:n.ONE_MINUS_SRC_ALPHA,[hg]:n.ONE_MINUS_DST_COLOR,[lg]:n.ONE_MINUS_DST_ALPHA,[fg]:n.CONSTANT_COLOR,[dg]:n.ONE_MINUS_CONSTANT_COLOR,[pg]:n.CONSTANT_ALPHA,[mg]:n.ONE_MINUS_CONSTANT_ALPHA};function ie(B,lt,it,At,Mt,Et,$t,re,ft,kt){if(B===xr){g===!0&&(Wt(n.BLEND),g=!1);return}if(g===!1&&(St(n.BLEND),g=!0),B!==jm){if(B!==p||kt!==C){if((v!==yr||R!==yr)&&(n.blendEquation(n.FUNC_ADD),v=yr,R=yr),kt)switch(B){case bo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ju:n.blendFunc(n.ONE,n.ONE);break;case Ku:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case ju:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ae("WebGLState: Invalid blending: ",B);break}else switch(B){case bo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ju:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ku:ae("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ju:ae("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ae("WebGLState: Invalid blending: ",B);break}w=null,M=null,A=null,_=null,S.set(0,0,0),I=0,p=B,C=kt}return}Mt=Mt||lt,Et=Et||it,$t=$t||At,(lt!==v||Mt!==R)&&(n.blendEquationSeparate(qt[lt],qt[Mt]),v=lt,R=Mt),(it!==w||At!==M||Et!==A||$t!==_)&&(n.blendFuncSeparate(Yt[it],Yt[At],Yt[Et],Yt[$t]),w=it,M=At,A=Et,_=$t),(re.equals(S)===!1||ft!==I)&&(n.blendColor(re.r,re.g,re.b,ft),S.copy(re),I=ft),p=B,C=!1}function se(B,lt){B.side===Ei?Wt(n.CULL_FACE):St(n.CULL_FACE);let it=B.side===jn;lt&&(it=!it),Ae(it),B.blending===bo&&B.transparent===!1?ie(xr):ie(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let At=B.stencilWrite;a.setTest(At),At&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),ce(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?St(n.SAMPLE_ALPHA_TO_COVERAGE):Wt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ae(B){P!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),P=B)}function ge(B){B!==Zm?(St(n.CULL_FACE),B!==O&&(B===Zu?n.cullFace(n.BACK):B===Jm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Wt(n.CULL_FACE),O=B}function we(B){B!==k&&(z&&n.lineWidth(B),k=B)}function ce(B,lt,it){B?(St(n.POLYGON_OFFSET_FILL),(N!==lt||V!==it)&&(N=lt,V=it,o.getReversed()&&(lt=-lt,it=-it),n.polygonOffset(lt,it))):Wt(n.POLYGON_OFFSET_FILL)}function He(B){B?St(n.SCISSOR_TEST):Wt(n.SCISSOR_TEST)}function Le(B){B===void 0&&(B=n.TEXTURE0+W-1),Z!==B&&(n.activeTexture(B),Z=B)}function Re(B,lt,it){it===void 0&&(Z===null?it=n.TEXTURE0+W-1:it=Z);let At=et[it];At===void 0&&(At={type:void 0,texture:void 0},et[it]=At),(At.type!==B||At.texture!==lt)&&(Z!==it&&(n.activeTexture(it),Z=it),n.bindTexture(B,lt||xt[B]),At.type=B,At.texture=lt)}function F(){let B=et[Z];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(B){ae("WebGLState:",B)}}function Ft(){try{n.compressedTexImage3D(...arguments)}catch(B){ae("WebGLState:",B)}}function Jt(){try{n.texSubImage2D(...arguments)}catch(B){ae("WebGLState:",B)}}function bt(){try{n.texSubImage3D(...arguments)}catch(B){ae("WebGLState:",B)}}function Fe(){try{n.compressedTexSubImage2D(...arguments)}catch(B){ae("WebGLState:",B)}}function Gt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){ae("WebGLState:",B)}}function Kt(){try{n.texStorage2D(...arguments)}catch(B){ae("WebGLState:",B)}}function L(){try{n.texStorage3D(...arguments)}catch(B){ae("WebGLState:",B)}}function b(){try{n.texImage2D(...arguments)}catch(B){ae("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){ae("WebGLState:",B)}}function ut(B){return d[B]!==void 0?d[B]:n.getParameter(B)}function at(B,lt){d[B]!==lt&&(n.pixelStorei(B,lt),d[B]=lt)}function vt(B){j.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),j.copy(B))}function wt(B){dt.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),dt.copy(B))}function nt(B,lt){let it=c.get(lt);it===void 0&&(it=new WeakMap,c.set(lt,it));let At=it.get(B);At===void 0&&(At=n.getUniformBlockIndex(lt,B.name),n.uniformBlockBinding(lt,At,At),it.set(B,At))}function ot(B,lt,it){let Mt=c.get(lt).get(B);l[Mt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,it),l[Mt]=it)}function _t(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),f={},d={},Z=null,et={},u={},l={},h=new WeakMap,m=[],y=null,g=!1,p=null,v=null,w=null,M=null,R=null,A=null,_=null,S=new pe(0,0,0),I=0,C=!1,P=null,O=null,k=null,N=null,V=null,j.set(0,0,n.canvas.width,n.canvas.height),dt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:St,disable:Wt,bindFramebuffer:gt,drawBuffers:yt,useProgram:Xt,setBlending:ie,setMaterial:se,setFlipSided:Ae,setCullFace:ge,setLineWidth:we,setPolygonOffset:ce,setScissorTest:He,activeTexture:Le,bindTexture:Re,unbindTexture:F,compressedTexImage2D:Pt,compressedTexImage3D:Ft,texImage2D:b,texImage3D:q,pixelStorei:at,getParameter:ut,updateUBOMapping:nt,uniformBlockBinding:ot,texStorage2D:Kt,texStorage3D:L,texSubImage2D:Jt,texSubImage3D:bt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:Gt,scissor:vt,viewport:wt,reset:_t}}function Ew(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new jt,f=new WeakMap,d=new Set,u,h=new WeakMap,m=new Set,y=new FinalizationRegistry(L=>m.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(L,b){return g?new OffscreenCanvas(L,b):ra("canvas")}function v(L,b,q){let ut=1,at=Kt(L);if((at.width>q||at.height>q)&&(ut=q/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let vt=Math.floor(ut*at.width),wt=Math.floor(ut*at.height);u===void 0&&(u=p(vt,wt));let nt=b?p(vt,wt):u;return nt.width=vt,nt.height=wt,nt.getContext("2d").drawImage(L,0,0,vt,wt),te("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+vt+"x"+wt+")."),nt}else return"data"in L&&te("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),L;return L}function w(L){return L.generateMipmaps}function M(L){n.generateMipmap(L)}function R(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(L,b,q,ut,at,vt=!1){if(L!==null){if(n[L]!==void 0)return n[L];te("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let wt;ut&&(wt=t.get("EXT_texture_norm16"),wt||te("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=b;if(b===n.RED&&(q===n.FLOAT&&(nt=n.R32F),q===n.HALF_FLOAT&&(nt=n.R16F),q===n.UNSIGNED_BYTE&&(nt=n.R8),q===n.UNSIGNED_SHORT&&wt&&(nt=wt.R16_EXT),q===n.SHORT&&wt&&(nt=wt.R16_SNORM_EXT)),b===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.R8UI),q===n.UNSIGNED_SHORT&&(nt=n.R16UI),q===n.UNSIGNED_INT&&(nt=n.R32UI),q===n.BYTE&&(nt=n.R8I),q===n.SHORT&&(nt=n.R16I),q===n.INT&&(nt=n.R32I)),b===n.RG&&(q===n.FLOAT&&(nt=n.RG32F),q===n.HALF_FLOAT&&(nt=n.RG16F),q===n.UNSIGNED_BYTE&&(nt=n.RG8),q===n.UNSIGNED_SHORT&&wt&&(nt=wt.RG16_EXT),q===n.SHORT&&wt&&(nt=wt.RG16_SNORM_EXT)),b===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.RG8UI),q===n.UNSIGNED_SHORT&&(nt=n.RG16UI),q===n.UNSIGNED_INT&&(nt=n.RG32UI),q===n.BYTE&&(nt=n.RG8I),q===n.SHORT&&(nt=n.RG16I),q===n.INT&&(nt=n.RG32I)),b===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),q===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),q===n.UNSIGNED_INT&&(nt=n.RGB32UI),q===n.BYTE&&(nt=n.RGB8I),q===n.SHORT&&(nt=n.RGB16I),q===n.INT&&(nt=n.RGB32I)),b===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),q===n.UNSIGNED_INT&&(nt=n.RGBA32UI),q===n.BYTE&&(nt=n.RGBA8I),q===n.SHORT&&(nt=n.RGBA16I),q===n.INT&&(nt=n.RGBA32I)),b===n.RGB&&(q===n.UNSIGNED_SHORT&&wt&&(nt=wt.RGB16_EXT),q===n.SHORT&&wt&&(nt=wt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),b===n.RGBA){let ot=vt?sa:be.getTransfer(at);q===n.FLOAT&&(nt=n.RGBA32F),q===n.HALF_FLOAT&&(nt=n.RGBA16F),q===n.UNSIGNED_BYTE&&(nt=ot===Ue?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&wt&&(nt=wt.RGBA16_EXT),q===n.SHORT&&wt&&(nt=wt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function _(L,b){let q;return L?b===null||b===ki||b===Mr?q=n.DEPTH24_STENCIL8:b===Vi?q=n.DEPTH32F_STENCIL8:b===To&&(q=n.DEPTH24_STENCIL8,te("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===ki||b===Mr?q=n.DEPTH_COMPONENT24:b===Vi?q=n.DEPTH_COMPONENT32F:b===To&&(q=n.DEPTH_COMPONENT16),q}function S(L,b){return w(L)===!0||L.isFramebufferTexture&&L.minFilter!==In&&L.minFilter!==Jn?Math.log2(Math.max(b.width,b.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?b.mipmaps.length:1}function I(L){let b=new WeakRef(L);i.get(L).__ref=b,m.add(b),y.register(L,b,b)}function C(L){let b=i.get(L).__ref;b!==void 0&&(m.delete(b),y.unregister(b))}function P(L){k(L.target)}function O(L){N(L.target)}function k(L){L.removeEventListener("dispose",P),C(L),W(L),L.isVideoTexture&&f.delete(L),L.isHTMLTexture&&d.delete(L)}function N(L){L.removeEventListener("dispose",O),C(L),tt(L)}function V(){for(let L of m){let b=L.deref();b!==void 0&&(b.isRenderTarget===!0?N(b):k(b))}m.clear(),d.clear()}function W(L){let b=i.get(L);if(b.__webglInit===void 0)return;let q=L.source,ut=h.get(q);if(ut){let at=ut[b.__cacheKey];at.usedTimes--,at.usedTimes===0&&z(L),Object.keys(ut).length===0&&h.delete(q)}i.remove(L)}function z(L){let b=i.get(L);n.deleteTexture(b.__webglTexture);let q=L.source,ut=h.get(q);delete ut[b.__cacheKey],o.memory.textures--}function tt(L){let b=i.get(L);b.__depthDisposeCallback&&b.__depthDisposeCallback();let q=L.depthTexture;if(q&&q.renderTarget===L&&k(q),L.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(b.__webglFramebuffer[at]))for(let vt=0;vt<b.__webglFramebuffer[at].length;vt++)n.deleteFramebuffer(b.__webglFramebuffer[at][vt]);else n.deleteFramebuffer(b.__webglFramebuffer[at]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[at])}else{if(Array.isArray(b.__webglFramebuffer))for(let at=0;at<b.__webglFramebuffer.length;at++)n.deleteFramebuffer(b.__webglFramebuffer[at]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let at=0;at<b.__webglColorRenderbuffer.length;at++)b.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[at]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ut=L.textures;for(let at=0,vt=ut.length;at<vt;at++){let wt=i.get(ut[at]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(ut[at])}i.remove(L)}let X=0;function Z(){X=0}function et(){return X}function st(L){X=L}function rt(){let L=X;return L>=s.maxTextures&&te("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,L}function j(L){let b=[];return b.push(L.wrapS),b.push(L.wrapT),b.push(L.wrapR||0),b.push(L.magFilter),b.push(L.minFilter),b.push(L.anisotropy),b.push(L.internalFormat),b.push(L.format),b.push(L.type),b.push(L.generateMipmaps),b.push(L.mipmapsAutoUpdate),b.push(L.premultiplyAlpha),b.push(L.flipY),b.push(L.unpackAlignment),b.push(L.colorSpace),b.join()}function dt(L,b){let q=i.get(L);if(L.isVideoTexture&&Fe(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&q.__version!==L.version){let ut=L.image;if(ut===null)te("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)te("WebGLRenderer: Texture marked for update but image is incomplete");else{se(q,L,b);return}}else L.isExternalTexture&&(q.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+b)}function pt(L,b){let q=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&q.__version!==L.version){se(q,L,b);return}else L.isExternalTexture&&(q.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+b)}function xt(L,b){let q=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&q.__version!==L.version){se(q,L,b);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+b)}function St(L,b){let q=i.get(L);if(L.version>0&&q.__version!==L.version){Ae(q,L,b);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+b)}let Wt={[jl]:n.REPEAT,[Qi]:n.CLAMP_TO_EDGE,[Ql]:n.MIRRORED_REPEAT},gt={[In]:n.NEAREST,[xg]:n.NEAREST_MIPMAP_NEAREST,[Ra]:n.NEAREST_MIPMAP_LINEAR,[Jn]:n.LINEAR,[Cc]:n.LINEAR_MIPMAP_NEAREST,[bs]:n.LINEAR_MIPMAP_LINEAR},yt={[Sg]:n.NEVER,[yf]:n.ALWAYS,[bg]:n.LESS,[_f]:n.LEQUAL,[wg]:n.EQUAL,[xf]:n.GEQUAL,[Tg]:n.GREATER,[Eg]:n.NOTEQUAL};function Xt(L,b){if(b.type===Vi&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Jn||b.magFilter===Cc||b.magFilter===Ra||b.magFilter===bs||b.minFilter===Jn||b.minFilter===Cc||b.minFilter===Ra||b.minFilter===bs)&&te("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,Wt[b.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,Wt[b.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,Wt[b.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,gt[b.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,gt[b.minFilter]),b.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,yt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===In||b.minFilter!==Ra&&b.minFilter!==bs||b.type===Vi&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function qt(L,b){let q=!1;L.__webglInit===void 0&&(L.__webglInit=!0,b.addEventListener("dispose",P),I(b));let ut=b.source,at=h.get(ut);at===void 0&&(at={},h.set(ut,at));let vt=j(b);if(vt!==L.__cacheKey){at[vt]===void 0&&(at[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[vt].usedTimes++;let wt=at[L.__cacheKey];wt!==void 0&&(at[L.__cacheKey].usedTimes--,wt.usedTimes===0&&z(b)),L.__cacheKey=vt,L.__webglTexture=at[vt].texture}return q}function Yt(L,b,q){return Math.floor(Math.floor(L/q)/b)}function ie(L,b,q,ut){let vt=L.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,b.width,b.height,q,ut,b.data);else{vt.sort((B,lt)=>B.start-lt.start);let wt=0;for(let B=1;B<vt.length;B++){let lt=vt[wt],it=vt[B],At=lt.start+lt.count,Mt=Yt(it.start,b.width,4),Et=Yt(lt.start,b.width,4);it.start<=At+1&&Mt===Et&&Yt(it.start+it.count-1,b.width,4)===Mt?lt.count=Math.max(lt.count,it.start+it.count-lt.start):(++wt,vt[wt]=it)}vt.length=wt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),ot=e.getParameter(n.UNPACK_SKIP_PIXELS),_t=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,b.width);for(let B=0,lt=vt.length;B<lt;B++){let it=vt[B],At=Math.floor(it.start/4),Mt=Math.ceil(it.count/4),Et=At%b.width,$t=Math.floor(At/b.width),re=Mt,ft=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Et),e.pixelStorei(n.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(n.TEXTURE_2D,0,Et,$t,re,ft,q,ut,b.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(n.UNPACK_SKIP_ROWS,_t)}}function se(L,b,q){let ut=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ut=n.TEXTURE_3D);let at=qt(L,b),vt=b.source;e.bindTexture(ut,L.__webglTexture,n.TEXTURE0+q);let wt=i.get(vt);if(vt.version!==wt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ft=be.getPrimaries(be.workingColorSpace),kt=b.colorSpace===Ts?null:be.getPrimaries(b.colorSpace),oe=b.colorSpace===Ts||ft===kt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,oe)}e.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment);let ot=v(b.image,!1,s.maxTextureSize);ot=Gt(b,ot);let _t=r.convert(b.format,b.colorSpace),B=r.convert(b.type),lt=A(b.internalFormat,_t,B,b.normalized,b.colorSpace,b.isVideoTexture);Xt(ut,b);let it,At=b.mipmaps,Mt=b.isVideoTexture!==!0,Et=wt.__version===void 0||at===!0,$t=vt.dataReady,re=S(b,ot);if(b.isDepthTexture)lt=_(b.format===ws,b.type),Et&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,lt,ot.width,ot.height):e.texImage2D(n.TEXTURE_2D,0,lt,ot.width,ot.height,0,_t,B,null));else if(b.isDataTexture)if(At.length>0){Mt&&Et&&e.texStorage2D(n.TEXTURE_2D,re,lt,At[0].width,At[0].height);for(let ft=0,kt=At.length;ft<kt;ft++)it=At[ft],Mt?$t&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,it.width,it.height,_t,B,it.data):e.texImage2D(n.TEXTURE_2D,ft,lt,it.width,it.height,0,_t,B,it.data);b.generateMipmaps=!1}else Mt?(Et&&e.texStorage2D(n.TEXTURE_2D,re,lt,ot.width,ot.height),$t&&ie(b,ot,_t,B)):e.texImage2D(n.TEXTURE_2D,0,lt,ot.width,ot.height,0,_t,B,ot.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){Mt&&Et&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,lt,At[0].width,At[0].height,ot.depth);for(let ft=0,kt=At.length;ft<kt;ft++)if(it=At[ft],b.format!==Hi)if(_t!==null)if(Mt){if($t)if(b.layerUpdates.size>0){let oe=Pf(it.width,it.height,b.format,b.type);for(let It of b.layerUpdates){let fe=it.data.subarray(It*oe/it.data.BYTES_PER_ELEMENT,(It+1)*oe/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,It,it.width,it.height,1,_t,fe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,0,it.width,it.height,ot.depth,_t,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ft,lt,it.width,it.height,ot.depth,0,it.data,0,0);else te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?$t&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,0,it.width,it.height,ot.depth,_t,B,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ft,lt,it.width,it.height,ot.depth,0,_t,B,it.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{Mt&&Et&&e.texStorage2D(n.TEXTURE_2D,re,lt,At[0].width,At[0].height);for(let ft=0,kt=At.length;ft<kt;ft++)it=At[ft],b.format!==Hi?_t!==null?Mt?$t&&e.compressedTexSubImage2D(n.TEXTURE_2D,ft,0,0,it.width,it.height,_t,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ft,lt,it.width,it.height,0,it.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?$t&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,it.width,it.height,_t,B,it.data):e.texImage2D(n.TEXTURE_2D,ft,lt,it.width,it.height,0,_t,B,it.data)}else if(b.isDataArrayTexture)if(Mt){if(Et&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,lt,ot.width,ot.height,ot.depth),$t)if(b.layerUpdates.size>0){let ft=Pf(ot.width,ot.height,b.format,b.type);for(let kt of b.layerUpdates){let oe=ot.data.subarray(kt*ft/ot.data.BYTES_PER_ELEMENT,(kt+1)*ft/ot.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,kt,ot.width,ot.height,1,_t,B,oe)}b.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ot.width,ot.height,ot.depth,_t,B,ot.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,ot.width,ot.height,ot.depth,0,_t,B,ot.data);else if(b.isData3DTexture)Mt?(Et&&e.texStorage3D(n.TEXTURE_3D,re,lt,ot.width,ot.height,ot.depth),$t&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ot.width,ot.height,ot.depth,_t,B,ot.data)):e.texImage3D(n.TEXTURE_3D,0,lt,ot.width,ot.height,ot.depth,0,_t,B,ot.data);else if(b.isFramebufferTexture){if(Et)if(Mt)e.texStorage2D(n.TEXTURE_2D,re,lt,ot.width,ot.height);else{let ft=ot.width,kt=ot.height;for(let oe=0;oe<re;oe++)e.texImage2D(n.TEXTURE_2D,oe,lt,ft,kt,0,_t,B,null),ft>>=1,kt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in n){let ft=n.canvas;if(ft.hasAttribute("layoutsubtree")||ft.setAttribute("layoutsubtree","true"),ot.parentNode!==ft){ft.appendChild(ot),d.add(b),ft.onpaint=kt=>{let oe=kt.changedElements;for(let It of d)oe.includes(It.image)&&(It.needsUpdate=!0)},ft.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ot);else{let oe=n.RGBA,It=n.RGBA,fe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,oe,It,fe,ot)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(Mt&&Et){let ft=Kt(At[0]);e.texStorage2D(n.TEXTURE_2D,re,lt,ft.width,ft.height)}for(let ft=0,kt=At.length;ft<kt;ft++)it=At[ft],Mt?$t&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,_t,B,it):e.texImage2D(n.TEXTURE_2D,ft,lt,_t,B,it);b.generateMipmaps=!1}else if(Mt){if(Et){let ft=Kt(ot);e.texStorage2D(n.TEXTURE_2D,re,lt,ft.width,ft.height)}$t&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,_t,B,ot)}else e.texImage2D(n.TEXTURE_2D,0,lt,_t,B,ot);w(b)&&b.mipmapsAutoUpdate===!0&&M(ut),wt.__version=vt.version,b.onUpdate&&b.onUpdate(b)}L.__version=b.version}function Ae(L,b,q){if(b.image.length!==6)return;let ut=qt(L,b),at=b.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+q);let vt=i.get(at);if(at.version!==vt.__version||ut===!0){e.activeTexture(n.TEXTURE0+q);let wt=be.getPrimaries(be.workingColorSpace),nt=b.colorSpace===Ts?null:be.getPrimaries(b.colorSpace),ot=b.colorSpace===Ts||wt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ot);let _t=b.isCompressedTexture||b.image[0].isCompressedTexture,B=b.image[0]&&b.image[0].isDataTexture,lt=[];for(let It=0;It<6;It++)!_t&&!B?lt[It]=v(b.image[It],!0,s.maxCubemapSize):lt[It]=B?b.image[It].image:b.image[It],lt[It]=Gt(b,lt[It]);let it=lt[0],At=r.convert(b.format,b.colorSpace),Mt=r.convert(b.type),Et=A(b.internalFormat,At,Mt,b.normalized,b.colorSpace),$t=b.isVideoTexture!==!0,re=vt.__version===void 0||ut===!0,ft=at.dataReady,kt=S(b,it);Xt(n.TEXTURE_CUBE_MAP,b);let oe;if(b.isDepthTexture){if(Et=_(b.format===ws,b.type),re)if($t)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Et,it.width,it.height);else for(let It=0;It<6;It++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Et,it.width,it.height,0,At,Mt,null)}else if(_t){$t&&re&&e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,Et,it.width,it.height);for(let It=0;It<6;It++){oe=lt[It].mipmaps;for(let fe=0;fe<oe.length;fe++){let Xe=oe[fe];b.format!==Hi?At!==null?$t?ft&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,Xe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,Et,Xe.width,Xe.height,0,Xe.data):te("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,Mt,Xe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,Et,Xe.width,Xe.height,0,At,Mt,Xe.data)}}}else{if(oe=b.mipmaps,$t&&re){oe.length>0&&kt++;let It=Kt(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,Et,It.width,It.height)}for(let It=0;It<6;It++)if(B){$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,lt[It].width,lt[It].height,At,Mt,lt[It].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Et,lt[It].width,lt[It].height,0,At,Mt,lt[It].data);for(let fe=0;fe<oe.length;fe++){let kn=oe[fe].image[It].image;$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,kn.width,kn.height,At,Mt,kn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,Et,kn.width,kn.height,0,At,Mt,kn.data)}}else{$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,At,Mt,lt[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Et,At,Mt,lt[It]);for(let fe=0;fe<oe.length;fe++){let Xe=oe[fe];$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,At,Mt,Xe.image[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,Et,At,Mt,Xe.image[It])}}}w(b)&&b.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),vt.__version=at.version,b.onUpdate&&b.onUpdate(b)}L.__version=b.version}function ge(L,b,q,ut,at,vt){let wt=r.convert(q.format,q.colorSpace),nt=r.convert(q.type),ot=A(q.internalFormat,wt,nt,q.normalized,q.colorSpace),_t=i.get(b),B=i.get(q);if(B.__renderTarget=b,!_t.__hasExternalTextures){let lt=Math.max(1,b.width>>vt),it=Math.max(1,b.height>>vt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,vt,ot,lt,it,b.depth,0,wt,nt,null):e.texImage2D(at,vt,ot,lt,it,0,wt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),bt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,at,B.__webglTexture,0,Jt(b)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,at,B.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function we(L,b,q){if(n.bindRenderbuffer(n.RENDERBUFFER,L),b.depthBuffer){let ut=b.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,vt=_(b.stencilBuffer,at),wt=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;bt(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Jt(b),vt,b.width,b.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Jt(b),vt,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,vt,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,L)}else{let ut=b.textures;for(let at=0;at<ut.length;at++){let vt=ut[at],wt=r.convert(vt.format,vt.colorSpace),nt=r.convert(vt.type),ot=A(vt.internalFormat,wt,nt,vt.normalized,vt.colorSpace);bt(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Jt(b),ot,b.width,b.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Jt(b),ot,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,ot,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ce(L,b,q){let ut=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(b.depthTexture);at.__renderTarget=b;let vt=ut?b.depthTexture.image[0]:b.depthTexture.image;(!at.__webglTexture||vt.width!==b.width||vt.height!==b.height)&&(vt.width=b.width,vt.height=b.height,b.depthTexture.needsUpdate=!0),ut?St(b.depthTexture,0):dt(b.depthTexture,0);let wt=at.__webglTexture,nt=Jt(b),ot=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,_t=b.depthTexture.format===ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(b.depthTexture.format===vs)bt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,ot,wt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,_t,ot,wt,0);else if(b.depthTexture.format===ws)bt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,ot,wt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,_t,ot,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function He(L){let b=i.get(L),q=L.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==L.depthTexture){let ut=L.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ut){let at=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),b.__depthDisposeCallback=at}b.__boundDepthTexture=ut}if(L.depthTexture&&!b.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)ce(b.__webglFramebuffer[ut],L,ut);else L.texture.mipmaps.length>0?ce(b.__webglFramebuffer[0],L,0):ce(b.__webglFramebuffer,L,0);else if(q){b.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[ut]),b.__webglDepthbuffer[ut]===void 0)b.__webglDepthbuffer[ut]=n.createRenderbuffer(),we(b.__webglDepthbuffer[ut],L,!1);else{let at=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=b.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,vt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),we(b.__webglDepthbuffer,L,!1);else{let at=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Le(L,b,q){let ut=i.get(L);b!==void 0&&ge(ut.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&He(L)}function Re(L){let b=L.texture,q=i.get(L),ut=i.get(b);L.addEventListener("dispose",O),I(L);let at=L.textures,vt=L.isWebGLCubeRenderTarget===!0,wt=at.length>1;if(wt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=b.version,o.memory.textures++),vt){q.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(b.mipmaps.length>0){q.__webglFramebuffer[nt]=[];for(let ot=0;ot<b.mipmaps.length;ot++)q.__webglFramebuffer[nt][ot]=n.createFramebuffer()}else q.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(b.mipmaps.length>0){q.__webglFramebuffer=[];for(let nt=0;nt<b.mipmaps.length;nt++)q.__webglFramebuffer[nt]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(wt)for(let nt=0,ot=at.length;nt<ot;nt++){let _t=i.get(at[nt]);_t.__webglTexture===void 0&&(_t.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&bt(L)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let ot=at[nt];q.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[nt]);let _t=r.convert(ot.format,ot.colorSpace),B=r.convert(ot.type),lt=A(ot.internalFormat,_t,B,ot.normalized,ot.colorSpace,L.isXRRenderTarget===!0),it=Jt(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,lt,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,q.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),we(q.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),Xt(n.TEXTURE_CUBE_MAP,b);for(let nt=0;nt<6;nt++)if(b.mipmaps.length>0)for(let ot=0;ot<b.mipmaps.length;ot++)ge(q.__webglFramebuffer[nt][ot],L,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,ot);else ge(q.__webglFramebuffer[nt],L,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);w(b)?M(n.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let nt=0,ot=at.length;nt<ot;nt++){let _t=at[nt],B=i.get(_t),lt=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(lt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,B.__webglTexture),Xt(lt,_t),ge(q.__webglFramebuffer,L,_t,n.COLOR_ATTACHMENT0+nt,lt,0),w(_t)&&M(lt)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(nt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,ut.__webglTexture),Xt(nt,b),b.mipmaps.length>0)for(let ot=0;ot<b.mipmaps.length;ot++)ge(q.__webglFramebuffer[ot],L,b,n.COLOR_ATTACHMENT0,nt,ot);else ge(q.__webglFramebuffer,L,b,n.COLOR_ATTACHMENT0,nt,0);w(b)?M(nt):b.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&He(L)}function F(L){let b=L.textures;for(let q=0,ut=b.length;q<ut;q++){let at=b[q];if(w(at)&&at.mipmapsAutoUpdate===!0){let vt=R(L),wt=i.get(at).__webglTexture;e.bindTexture(vt,wt),M(vt),e.unbindTexture()}}}let Pt=[];function Ft(L){if(L.samples>0){if(bt(L)===!1){let b=L.textures,q=L.width,ut=L.height,at=n.COLOR_BUFFER_BIT,vt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(L),nt=b.length>1;if(nt)for(let _t=0;_t<b.length;_t++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let _t=0;_t<b.length;_t++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[_t]);let B=i.get(b[_t]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,ut,0,0,q,ut,at,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+_t),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Pt.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let _t=0;_t<b.length;_t++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,wt.__webglColorRenderbuffer[_t]);let B=i.get(b[_t]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let b=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function Jt(L){return Math.min(s.maxSamples,L.samples)}function bt(L){let b=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Fe(L){let b=o.render.frame;f.get(L)!==b&&(f.set(L,b),L.update())}function Gt(L,b){let q=L.colorSpace,ut=L.format,at=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||q!==ia&&q!==Ts&&(be.getTransfer(q)===Ue?(ut!==Hi||at!==ti)&&te("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ae("WebGLTextures: Unsupported texture color space:",q)),b}function Kt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=rt,this.resetTextureUnits=Z,this.getTextureUnits=et,this.setTextureUnits=st,this.setTexture2D=dt,this.setTexture2DArray=pt,this.setTexture3D=xt,this.setTextureCube=St,this.rebindTextures=Le,this.setupRenderTarget=Re,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Ft,this.setupDepthRenderbuffer=He,this.setupFrameBufferTexture=ge,this.useMultisampledRTT=bt,this.dispose=V}function Aw(n,t){function e(i,s=Ts){let r,o=be.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===Ic)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Lc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ff)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===df)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===hf)return n.BYTE;if(i===uf)return n.SHORT;if(i===To)return n.UNSIGNED_SHORT;if(i===Pc)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===Gi)return n.HALF_FLOAT;if(i===pf)return n.ALPHA;if(i===mf)return n.RGB;if(i===Hi)return n.RGBA;if(i===vs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===gf)return n.RED;if(i===Dc)return n.RED_INTEGER;if(i===Zs)return n.RG;if(i===Nc)return n.RG_INTEGER;if(i===Uc)return n.RGBA_INTEGER;if(i===Ca||i===Pa||i===Ia||i===La)if(o===Ue)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Fc||i===Oc||i===Bc||i===zc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Fc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Oc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Bc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===zc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===kc||i===Vc||i===Gc||i===Hc||i===Wc||i===Da||i===Xc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===kc||i===Vc)return o===Ue?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Gc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Hc)return r.COMPRESSED_R11_EAC;if(i===Wc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Da)return r.COMPRESSED_RG11_EAC;if(i===Xc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===qc||i===Yc||i===$c||i===Zc||i===Jc||i===Kc||i===jc||i===Qc||i===th||i===eh||i===nh||i===ih||i===sh||i===rh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===qc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Yc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===$c)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Zc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Jc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Kc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===jc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Qc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===th)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===eh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===nh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ih)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===sh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===rh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===oh||i===ah||i===lh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===oh)return o===Ue?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ah)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===lh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ch||i===hh||i===Na||i===uh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===ch)return r.COMPRESSED_RED_RGTC1_EXT;if(i===hh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Na)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===uh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Mr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var Rw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Cw=`
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

}`,zf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new xa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new es({vertexShader:Rw,fragmentShader:Cw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new _i(new ya(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},kf=class extends zi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,f=null,d=null,u=null,h=null,m=null,y=typeof XRWebGLBinding<"u",g=new zf,p={},v=e.getContextAttributes(),w=null,M=null,R=[],A=[],_=new jt,S=null,I=null,C=new $n;C.viewport=new je;let P=new $n;P.viewport=new je;let O=[C,P],k=new Tc,N=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let dt=R[j];return dt===void 0&&(dt=new mo,R[j]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(j){let dt=R[j];return dt===void 0&&(dt=new mo,R[j]=dt),dt.getGripSpace()},this.getHand=function(j){let dt=R[j];return dt===void 0&&(dt=new mo,R[j]=dt),dt.getHandSpace()};function W(j){let dt=A.indexOf(j.inputSource);if(dt===-1)return;let pt=R[dt];pt!==void 0&&(pt.update(j.inputSource,j.frame,c||o),pt.dispatchEvent({type:j.type,data:j.inputSource}))}function z(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",tt);for(let j=0;j<R.length;j++){let dt=A[j];dt!==null&&(A[j]=null,R[j].disconnect(dt))}N=null,V=null,g.reset();for(let j in p)delete p[j];if(t.setRenderTarget(w),h=null,u=null,d=null,s=null,M=null,rt.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(_.width,_.height,!1),I!==null){let j=I.camera;j.fov=I.fov,j.zoom=I.zoom,j.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,i.isPresenting===!0&&te("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,i.isPresenting===!0&&te("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return u!==null?u:h},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",z),s.addEventListener("inputsourceschange",tt),v.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let pt=null,xt=null,St=null;v.depth&&(St=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,pt=v.stencil?ws:vs,xt=v.stencil?Mr:ki);let Wt={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Wt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),M=new gi(u.textureWidth,u.textureHeight,{format:Hi,type:ti,depthTexture:new Ss(u.textureWidth,u.textureHeight,xt,void 0,void 0,void 0,void 0,void 0,void 0,pt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let pt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};h=new XRWebGLLayer(s,e,pt),s.updateRenderState({baseLayer:h}),t.setPixelRatio(1),t.setSize(h.framebufferWidth,h.framebufferHeight,!1),M=new gi(h.framebufferWidth,h.framebufferHeight,{format:Hi,type:ti,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),rt.setContext(s),rt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function tt(j){for(let dt=0;dt<j.removed.length;dt++){let pt=j.removed[dt],xt=A.indexOf(pt);xt>=0&&(A[xt]=null,R[xt].disconnect(pt))}for(let dt=0;dt<j.added.length;dt++){let pt=j.added[dt],xt=A.indexOf(pt);if(xt===-1){for(let Wt=0;Wt<R.length;Wt++)if(Wt>=A.length){A.push(pt),xt=Wt;break}else if(A[Wt]===null){A[Wt]=pt,xt=Wt;break}if(xt===-1)break}let St=R[xt];St&&St.connect(pt)}}function X(j,dt){dt===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(dt.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let dt=j.near,pt=j.far;g.texture!==null&&(g.depthNear>0&&(dt=g.depthNear),g.depthFar>0&&(pt=g.depthFar)),k.near=P.near=C.near=dt,k.far=P.far=C.far=pt,(N!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),N=k.near,V=k.far),k.layers.mask=j.layers.mask|6,C.layers.mask=k.layers.mask&-5,P.layers.mask=k.layers.mask&-3;let xt=j.parent,St=k.cameras;X(k,xt);for(let Wt=0;Wt<St.length;Wt++)X(St[Wt],xt);k.projectionMatrix.copy(C.projectionMatrix),k.projectionMatrixInverse.copy(C.projectionMatrixInverse),I===null&&j.isPerspectiveCamera&&(I={camera:j,fov:j.fov,zoom:j.zoom}),Z(j,k,xt)};function Z(j,dt,pt){pt===null?j.matrix.copy(dt.matrixWorld):(j.matrix.copy(pt.matrixWorld),j.matrix.invert(),j.matrix.multiply(dt.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(dt.projectionMatrix),j.projectionMatrixInverse.copy(dt.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=fo*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(u===null&&h===null))return l},this.setFoveation=function(j){l=j,u!==null&&(u.fixedFoveation=j),h!==null&&h.fixedFoveation!==void 0&&(h.fixedFoveation=j)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(k)},this.getCameraTexture=function(j){return p[j]};let et=null;function st(j,dt){if(f=dt.getViewerPose(c||o),m=dt,f!==null){let pt=f.views;h!==null&&(t.setRenderTargetFramebuffer(M,h.framebuffer),t.setRenderTarget(M));let xt=!1;pt.length!==k.cameras.length&&(k.cameras.length=0,xt=!0);for(let yt=0;yt<pt.length;yt++){let Xt=pt[yt],qt=null;if(h!==null)qt=h.getViewport(Xt);else{let ie=d.getViewSubImage(u,Xt);qt=ie.viewport,yt===0&&(t.setRenderTargetTextures(M,ie.colorTexture,ie.depthStencilTexture),t.setRenderTarget(M))}let Yt=O[yt];Yt===void 0&&(Yt=new $n,Yt.layers.enable(yt),Yt.viewport=new je,O[yt]=Yt),Yt.matrix.fromArray(Xt.transform.matrix),Yt.matrix.decompose(Yt.position,Yt.quaternion,Yt.scale),Yt.projectionMatrix.fromArray(Xt.projectionMatrix),Yt.projectionMatrixInverse.copy(Yt.projectionMatrix).invert(),Yt.viewport.set(qt.x,qt.y,qt.width,qt.height),yt===0&&(k.matrix.copy(Yt.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),xt===!0&&k.cameras.push(Yt)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=i.getBinding();let yt=d.getDepthInformation(pt[0]);yt&&yt.isValid&&yt.texture&&g.init(yt,s.renderState)}if(St&&St.includes("camera-access")&&y){t.state.unbindTexture(),d=i.getBinding();for(let yt=0;yt<pt.length;yt++){let Xt=pt[yt].camera;if(Xt){let qt=p[Xt];qt||(qt=new xa,p[Xt]=qt);let Yt=d.getCameraImage(Xt);qt.sourceTexture=Yt}}}}for(let pt=0;pt<R.length;pt++){let xt=A[pt],St=R[pt];xt!==null&&St!==void 0&&St.update(xt,dt,c||o)}et&&et(j,dt),dt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:dt}),m=null}let rt=new i0;rt.setAnimationLoop(st),this.setAnimationLoop=function(j){et=j},this.dispose=function(){}}},Pw=new We,d0=new he;d0.set(-1,0,0,0,1,0,0,0,1);function Iw(n,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,Af(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,v,w,M){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),d(g,p)):p.isMeshPhongMaterial?(r(g,p),f(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),u(g,p),p.isMeshPhysicalMaterial&&h(g,p,M)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),y(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,v,w):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===jn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===jn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let v=t.get(p),w=v.envMap,M=v.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(Pw.makeRotationFromEuler(M)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(d0),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,v,w){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*v,g.scale.value=w*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function f(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function d(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function u(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function h(g,p,v){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===jn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function y(g,p){let v=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Lw(n,t,e,i){let s={},r={};function o(v,w){let M=w.program;i.uniformBlockBinding(v,M,s[v.id])}function a(v,w){let M=s[v.id];M===void 0&&(m(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",g));let R=w.program;i.updateUBOMapping(v,R);let A=t.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let w=n.createBuffer(),M=v.__size,R=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,M,R),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(v){let w=s[v.id],M=v.uniforms,R=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,_=M.length;A<_;A++){let S=M[A];if(Array.isArray(S))for(let I=0,C=S.length;I<C;I++)f(S[I],A,I,R);else f(S,A,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(v,w,M,R){if(u(v,w,M,R)===!0){let A=v.__offset,_=v.value;if(Array.isArray(_)){let S=0;for(let I=0;I<_.length;I++){let C=_[I],P=y(C,!0);d(C,v.__data,S),S+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function d(v,w,M){typeof v=="number"||typeof v=="boolean"?w[M]=v:v.isMatrix3?(w[M]=v.elements[0],w[M+1]=v.elements[1],w[M+2]=v.elements[2],w[M+3]=0,w[M+4]=v.elements[3],w[M+5]=v.elements[4],w[M+6]=v.elements[5],w[M+7]=0,w[M+8]=v.elements[6],w[M+9]=v.elements[7],w[M+10]=v.elements[8],w[M+11]=0):ArrayBuffer.isView(v)?w.set(v.subarray(0,w.length-M),M):v.toArray(w,M)}function u(v,w,M,R){let A=v.value,_=w+"_"+M;if(Array.isArray(A)){R[_]===void 0&&(R[_]=[]);let S=R[_],I=!1;for(let C=0;C<A.length;C++)h(A[C],S,C)===!0&&(I=!0);return I}return h(A,R,_)}function h(v,w,M){if(w[M]===void 0)return typeof v=="number"||typeof v=="boolean"?w[M]=v:ArrayBuffer.isView(v)?w[M]=v.slice():w[M]=v.clone(),!0;{let R=w[M];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return w[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function m(v){let w=v.uniforms,M=0,R=16;for(let _=0,S=w.length;_<S;_++){let I=Array.isArray(w[_])?w[_]:[w[_]];for(let C=0,P=I.length;C<P;C++){let O=I[C],k=Array.isArray(O.value)?O.value:[O.value],N=Array.isArray(w[_])||Array.isArray(O.value),V=M;for(let z=0,tt=k.length;z<tt;z++){let X=k[z],Z=y(X,N),et=M%R,st=et%Z.boundary,rt=et+st;M+=st,rt!==0&&R-rt<Z.storage&&(M+=R-rt),z===0&&(V=M),M+=Z.storage}let W=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new W((M-V)/Float32Array.BYTES_PER_ELEMENT),O.__offset=V}}let A=M%R;return A>0&&(M+=R-A),v.__size=M,v.__cache={},this}function y(v,w){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?te("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):te("WebGLRenderer: Unsupported uniform value type.",v),w===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(v){let w=v.target;w.removeEventListener("dispose",g),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var Dw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function Nw(){return is===null&&(is=new oc(Dw,16,16,Zs,Gi),is.name="DFG_LUT",is.minFilter=Jn,is.magFilter=Jn,is.wrapS=Qi,is.wrapT=Qi,is.generateMipmaps=!1,is.needsUpdate=!0),is}var _h=class{constructor(t={}){let{canvas:e=Ag(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:f="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:h=ti}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let y=h,g=new Set([Uc,Nc,Dc]),p=new Set([ti,ki,To,Mr,Ic,Lc]),v=new Uint32Array(4),w=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},R=null,A=null,_=[],S=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,P=!1,O=null,k=null,N=null,V=null;this._outputColorSpace=di;let W=0,z=0,tt=null,X=-1,Z=null,et=new je,st=new je,rt=null,j=new pe(0),dt=0,pt=e.width,xt=e.height,St=1,Wt=null,gt=null,yt=new je(0,0,pt,xt),Xt=new je(0,0,pt,xt),qt=!1,Yt=new Gs,ie=new ac,se=!1,Ae=!1,ge=new We,we=new Y,ce=new je,He={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Le=!1;function Re(){return tt===null?St:1}let F=i;function Pt(E,G){return e.getContext(E,G)}let Ft,Jt,bt,Fe,Gt,Kt,L,b,q,ut,at,vt,wt,nt,ot,_t,B,lt,it,At,Mt,Et,$t;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:f,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",oe,!1),e.addEventListener("webglcontextcreationerror",It,!1),F===null){let G="webgl2";if(F=Pt(G,E),F===null)throw Pt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}re()}catch(E){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",It,!1),ae("WebGLRenderer: "+E.message),E}function re(){Ft=new XS(F),Ft.init(),Mt=new Aw(F,Ft),Jt=new NS(F,Ft,t,Mt),bt=new Tw(F,Ft),Jt.reversedDepthBuffer&&u&&bt.buffers.depth.setReversed(!0),k=F.createFramebuffer(),N=F.createFramebuffer(),V=F.createFramebuffer(),Fe=new $S(F),Gt=new uw,Kt=new Ew(F,Ft,bt,Gt,Jt,Mt,Fe),L=new WS(C),b=new Jy(F),Et=new LS(F,b),q=new qS(F,b,Fe,Et),ut=new JS(F,q,b,Et,Fe),lt=new ZS(F,Jt,Kt),ot=new US(Gt),at=new hw(C,L,Ft,Jt,Et,ot),vt=new Iw(C,Gt),wt=new dw,nt=new yw(Ft),B=new IS(C,L,bt,ut,m,l),_t=new ww(C,ut,Jt),$t=new Lw(F,Fe,Jt,bt),it=new DS(F,Ft,Fe),At=new YS(F,Ft,Fe),Fe.programs=at.programs,C.capabilities=Jt,C.extensions=Ft,C.properties=Gt,C.renderLists=wt,C.shadowMap=_t,C.state=bt,C.info=Fe}y!==ti&&(I=new jS(y,e.width,e.height,a,s,r));let ft=new kf(C,F);this.xr=ft,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=Ft.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ft.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return St},this.setPixelRatio=function(E){E!==void 0&&(St=E,this.setSize(pt,xt,!1))},this.getSize=function(E){return E.set(pt,xt)},this.setSize=function(E,G,Q=!0){if(ft.isPresenting){te("WebGLRenderer: Can't change size while VR device is presenting.");return}pt=E,xt=G,e.width=Math.floor(E*St),e.height=Math.floor(G*St),Q===!0&&(e.style.width=E+"px",e.style.height=G+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,E,G)},this.getDrawingBufferSize=function(E){return E.set(pt*St,xt*St).floor()},this.setDrawingBufferSize=function(E,G,Q){pt=E,xt=G,St=Q,e.width=Math.floor(E*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,E,G)},this.setEffects=function(E){if(y===ti){ae("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let G=0;G<E.length;G++)if(E[G].isOutputPass===!0){te("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(et)},this.getViewport=function(E){return E.copy(yt)},this.setViewport=function(E,G,Q,$){E.isVector4?yt.set(E.x,E.y,E.z,E.w):yt.set(E,G,Q,$),bt.viewport(et.copy(yt).multiplyScalar(Re()).round())},this.getScissor=function(E){return E.copy(Xt)},this.setScissor=function(E,G,Q,$){E.isVector4?Xt.set(E.x,E.y,E.z,E.w):Xt.set(E,G,Q,$),bt.scissor(st.copy(Xt).multiplyScalar(Re()).round())},this.getScissorTest=function(){return qt},this.setScissorTest=function(E){bt.setScissorTest(qt=E)},this.setOpaqueSort=function(E){Wt=E},this.setTransparentSort=function(E){gt=E},this.getClearColor=function(E){return E.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(E=!0,G=!0,Q=!0){let $=0;if(E){let J=!1;if(tt!==null){let Rt=tt.texture.format;J=g.has(Rt)}if(J){let Rt=tt.texture.type,Lt=p.has(Rt),Ct=B.getClearColor(),Dt=B.getClearAlpha(),Ht=Ct.r,le=Ct.g,_e=Ct.b;Lt?(v[0]=Ht,v[1]=le,v[2]=_e,v[3]=Dt,F.clearBufferuiv(F.COLOR,0,v)):(w[0]=Ht,w[1]=le,w[2]=_e,w[3]=Dt,F.clearBufferiv(F.COLOR,0,w))}else $|=F.COLOR_BUFFER_BIT}G&&($|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&($|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&F.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),O=E},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",It,!1),B.dispose(),wt.dispose(),nt.dispose(),Kt.dispose(),Gt.dispose(),L.dispose(),ut.dispose(),q.dispose(),Et.dispose(),$t.dispose(),at.dispose(),ft.dispose(),ft.removeEventListener("sessionstart",Ga),ft.removeEventListener("sessionend",Wi),rs.stop()};function kt(E){E.preventDefault(),oa("WebGLRenderer: Context Lost."),P=!0}function oe(){oa("WebGLRenderer: Context Restored."),P=!1;let E=Fe.autoReset,G=_t.enabled,Q=_t.autoUpdate,$=_t.needsUpdate,J=_t.type;re(),Fe.autoReset=E,_t.enabled=G,_t.autoUpdate=Q,_t.needsUpdate=$,_t.type=J}function It(E){ae("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function fe(E){let G=E.target;G.removeEventListener("dispose",fe),Xe(G)}function Xe(E){kn(E),Gt.remove(E)}function kn(E){let G=Gt.get(E).programs;G!==void 0&&(G.forEach(function(Q){at.releaseProgram(Q)}),E.isShaderMaterial&&at.releaseShaderCache(E))}this.renderBufferDirect=function(E,G,Q,$,J,Rt){G===null&&(G=He);let Lt=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ct=Io(E,G,Q,$,J);bt.setMaterial($,Lt);let Dt=Q.index,Ht=1;if($.wireframe===!0){if(Dt=q.getWireframeAttribute(Q),Dt===void 0)return;Ht=2}let le=Q.drawRange,_e=Q.attributes.position,Vt=le.start*Ht,xe=(le.start+le.count)*Ht;Rt!==null&&(Vt=Math.max(Vt,Rt.start*Ht),xe=Math.min(xe,(Rt.start+Rt.count)*Ht)),Dt!==null?(Vt=Math.max(Vt,0),xe=Math.min(xe,Dt.count)):_e!=null&&(Vt=Math.max(Vt,0),xe=Math.min(xe,_e.count));let Qe=xe-Vt;if(Qe<0||Qe===1/0)return;Et.setup(J,$,Ct,Q,Dt);let Oe,Be=it;if(Dt!==null&&(Oe=b.get(Dt),Be=At,Be.setIndex(Oe)),J.isMesh)$.wireframe===!0?(bt.setLineWidth($.wireframeLinewidth*Re()),Be.setMode(F.LINES)):Be.setMode(F.TRIANGLES);else if(J.isLine){let _n=$.linewidth;_n===void 0&&(_n=1),bt.setLineWidth(_n*Re()),J.isLineSegments?Be.setMode(F.LINES):J.isLineLoop?Be.setMode(F.LINE_LOOP):Be.setMode(F.LINE_STRIP)}else J.isPoints?Be.setMode(F.POINTS):J.isSprite&&Be.setMode(F.TRIANGLES);if(J.isBatchedMesh)if(Ft.get("WEBGL_multi_draw"))Be.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let _n=J._multiDrawStarts,Bt=J._multiDrawCounts,cn=J._multiDrawCount,Me=Dt?b.get(Dt).bytesPerElement:1,as=Gt.get($).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)as.setValue(F,"_gl_DrawID",hn),Be.render(_n[hn]/Me,Bt[hn])}else if(J.isInstancedMesh)Be.renderInstances(Vt,Qe,J.count);else if(Q.isInstancedBufferGeometry){let _n=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Bt=Math.min(Q.instanceCount,_n);Be.renderInstances(Vt,Qe,Bt)}else Be.render(Vt,Qe)};function Ro(E,G,Q,$){O!==null&&E.isNodeMaterial&&O.setObject($,E),se===!0&&ot.setState(E,Q,!1),E.transparent===!0&&E.side===Ei&&E.forceSinglePass===!1?(E.side=jn,E.needsUpdate=!0,Xi(E,G,$),E.side=$s,E.needsUpdate=!0,Xi(E,G,$),E.side=Ei):Xi(E,G,$)}this.compile=function(E,G,Q=null){Q===null&&(Q=E),O!==null&&O.renderStart(E,G,Q),A=nt.get(Q),A.init(G),S.push(A),Q.traverseVisible(function(J){J.isLight&&J.layers.test(G.layers)&&(A.pushLight(J),J.castShadow&&A.pushShadow(J))}),E!==Q&&E.traverseVisible(function(J){J.isLight&&J.layers.test(G.layers)&&(A.pushLight(J),J.castShadow&&A.pushShadow(J))}),A.setupLights(),O!==null&&O.updateLights(A.state.lightsArray),Ae=this.localClippingEnabled,se=ot.init(this.clippingPlanes,Ae),se===!0&&ot.setGlobalState(this.clippingPlanes,G),O!==null&&_t.render(A.state.shadowsArray,Q,G);let $=new Set;return E.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Rt=J.material;if(Rt)if(Array.isArray(Rt))for(let Lt=0;Lt<Rt.length;Lt++){let Ct=Rt[Lt];Ro(Ct,Q,G,J),$.add(Ct)}else Ro(Rt,Q,G,J),$.add(Rt)}),A=S.pop(),O!==null&&O.renderEnd(),$},this.compileAsync=function(E,G,Q=null){let $=this.compile(E,G,Q);return new Promise(J=>{function Rt(){if($.forEach(function(Lt){let Dt=Gt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&$.delete(Lt)}),$.size===0){J(E);return}setTimeout(Rt,10)}Ft.get("KHR_parallel_shader_compile")!==null?Rt():setTimeout(Rt,10)})};let br=null;function Eh(E){br&&br(E)}function Ga(){rs.stop()}function Wi(){rs.start()}let rs=new i0;rs.setAnimationLoop(Eh),typeof self<"u"&&rs.setContext(self),this.setAnimationLoop=function(E){br=E,ft.setAnimationLoop(E),E===null?rs.stop():rs.start()},ft.addEventListener("sessionstart",Ga),ft.addEventListener("sessionend",Wi),this.render=function(E,G){if(G!==void 0&&G.isCamera!==!0){ae("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(E,G);let Q=ft.enabled===!0&&ft.isPresenting===!0,$=I!==null&&(tt===null||Q)&&I.begin(C,tt);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ft.enabled===!0&&ft.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ft.cameraAutoUpdate===!0&&ft.updateCamera(G),G=ft.getCamera()),E.isScene===!0&&E.onBeforeRender(C,E,G,tt),A=nt.get(E,S.length),A.init(G),A.state.textureUnits=Kt.getTextureUnits(),S.push(A),ge.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?ie.setFromArrayCamera(G):Yt.setFromProjectionMatrix(ge,Ti,G.reversedDepth),Ae=this.localClippingEnabled,se=ot.init(this.clippingPlanes,Ae),R=wt.get(E,_.length),R.init(),_.push(R),this.info.render.frame++,ft.enabled===!0&&ft.isPresenting===!0){let Lt=C.xr.getDepthSensingMesh();Lt!==null&&os(Lt,G,-1/0,C.sortObjects)}os(E,G,0,C.sortObjects),R.finish(),O!==null&&O.updateLights(A.state.lightsArray),C.sortObjects===!0&&R.sort(Wt,gt),Le=ft.enabled===!1||ft.isPresenting===!1||ft.hasDepthSensing()===!1,Le&&B.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),se===!0&&ot.beginShadows();let J=A.state.shadowsArray;if(_t.render(J,E,G),se===!0&&ot.endShadows(),($&&I.hasRenderPass())===!1){let Lt=R.opaque,Ct=R.transmissive;if(A.setupLights(),G.isArrayCamera){let Dt=G.cameras;if(Ct.length>0)for(let Ht=0,le=Dt.length;Ht<le;Ht++){let _e=Dt[Ht];Ci(Lt,Ct,E,_e)}Le&&B.render(E);for(let Ht=0,le=Dt.length;Ht<le;Ht++){let _e=Dt[Ht];Co(R,E,_e,_e.viewport)}}else Ct.length>0&&Ci(Lt,Ct,E,G),Le&&B.render(E),Co(R,E,G)}tt!==null&&z===0&&(Kt.updateMultisampleRenderTarget(tt),Kt.updateRenderTargetMipmap(tt)),$&&I.end(C),E.isScene===!0&&E.onAfterRender(C,E,G),Et.resetDefaultState(),X=-1,Z=null,S.pop(),S.length>0?(A=S[S.length-1],Kt.setTextureUnits(A.state.textureUnits),se===!0&&ot.setGlobalState(C.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?R=_[_.length-1]:R=null,O!==null&&O.renderEnd()};function os(E,G,Q,$){if(E.visible===!1)return;if(E.layers.test(G.layers)){if(E.isGroup)Q=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(G);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Lt=G.isArrayCamera?ie:Yt;if(!E.frustumCulled||E.intersectsFrustum(Lt)){$&&ce.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ge);let Ct=ut.update(E),Dt=E.material;Dt.visible&&R.push(E,Ct,Dt,Q,ce.z,null,G)}}else if(E.isMesh||E.isLine||E.isPoints){let Lt=G.isArrayCamera?ie:Yt;if(!E.frustumCulled||E.intersectsFrustum(Lt)){let Ct=ut.update(E),Dt=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),ce.copy(E.boundingSphere.center)):(Ct.boundingSphere===null&&Ct.computeBoundingSphere(),ce.copy(Ct.boundingSphere.center)),ce.applyMatrix4(E.matrixWorld).applyMatrix4(ge)),Array.isArray(Dt)){let Ht=Ct.groups;for(let le=0,_e=Ht.length;le<_e;le++){let Vt=Ht[le],xe=Dt[Vt.materialIndex];xe&&xe.visible&&R.push(E,Ct,xe,Q,ce.z,Vt,G)}}else Dt.visible&&R.push(E,Ct,Dt,Q,ce.z,null,G)}}}let Rt=E.children;for(let Lt=0,Ct=Rt.length;Lt<Ct;Lt++)os(Rt[Lt],G,Q,$)}function Co(E,G,Q,$){let{opaque:J,transmissive:Rt,transparent:Lt}=E;A.setupLightsView(Q),se===!0&&ot.setGlobalState(C.clippingPlanes,Q),$&&bt.viewport(et.copy($)),J.length>0&&tn(J,G,Q),Rt.length>0&&tn(Rt,G,Q),Lt.length>0&&tn(Lt,G,Q),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function Ci(E,G,Q,$){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[$.id]===void 0){let Vt=Ft.has("EXT_color_buffer_half_float")||Ft.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[$.id]=new gi(1,1,{generateMipmaps:!0,type:Vt?Gi:ti,minFilter:bs,samples:Math.max(4,Jt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:be.workingColorSpace})}let Rt=A.state.transmissionRenderTarget[$.id],Lt=$.viewport||et;Rt.setSize(Lt.z*C.transmissionResolutionScale,Lt.w*C.transmissionResolutionScale);let Ct=C.getRenderTarget(),Dt=C.getActiveCubeFace(),Ht=C.getActiveMipmapLevel();C.setRenderTarget(Rt),C.getClearColor(j),dt=C.getClearAlpha(),dt<1&&C.setClearColor(16777215,.5),C.clear(),Le&&B.render(Q);let le=C.toneMapping;C.toneMapping=ns;let _e=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),A.setupLightsView($),se===!0&&ot.setGlobalState(C.clippingPlanes,$),tn(E,Q,$),Kt.updateMultisampleRenderTarget(Rt),Kt.updateRenderTargetMipmap(Rt),Ft.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let xe=0,Qe=G.length;xe<Qe;xe++){let Oe=G[xe],{object:Be,geometry:_n,material:Bt,group:cn}=Oe;if(Bt.side===Ei&&Be.layers.test($.layers)){let Me=Bt.side;Bt.side=jn,Bt.needsUpdate=!0,an(Be,Q,$,_n,Bt,cn),Bt.side=Me,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(Rt),Kt.updateRenderTargetMipmap(Rt))}C.setRenderTarget(Ct,Dt,Ht),C.setClearColor(j,dt),_e!==void 0&&($.viewport=_e),C.toneMapping=le}function tn(E,G,Q){let $=G.isScene===!0?G.overrideMaterial:null;for(let J=0,Rt=E.length;J<Rt;J++){let Lt=E[J],{object:Ct,geometry:Dt,group:Ht}=Lt,le=Lt.material;le.allowOverride===!0&&$!==null&&(le=$),Ct.layers.test(Q.layers)&&an(Ct,G,Q,Dt,le,Ht)}}function an(E,G,Q,$,J,Rt){O!==null&&J.isNodeMaterial&&O.setObject(E,J),E.onBeforeRender(C,G,Q,$,J,Rt),E.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),J.onBeforeRender(C,G,Q,$,E,Rt),J.transparent===!0&&J.side===Ei&&J.forceSinglePass===!1?(J.side=jn,J.needsUpdate=!0,C.renderBufferDirect(Q,G,$,J,E,Rt),J.side=$s,J.needsUpdate=!0,C.renderBufferDirect(Q,G,$,J,E,Rt),J.side=Ei):C.renderBufferDirect(Q,G,$,J,E,Rt),E.onAfterRender(C,G,Q,$,J,Rt)}function ln(E){let G=0;for(let Q of E)Q.texture!==null&&G++;return G}function Xi(E,G,Q){G.isScene!==!0&&(G=He);let $=Gt.get(E),J=A.state.lights,Rt=A.state.shadowsArray,Lt=J.state.version,Ct=at.getParameters(E,J.state,Rt,G,Q,A.state.lightProbeGridArray),Dt=at.getProgramCacheKey(Ct),Ht=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?G.environment:null,$.fog=G.fog;let le=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=L.get(E.envMap||$.environment,le),$.envMapRotation=$.environment!==null&&E.envMap===null?G.environmentRotation:E.envMapRotation,Ht===void 0&&(E.addEventListener("dispose",fe),Ht=new Map,$.programs=Ht,$.programVariants=new Map);let _e=Ht.get(Dt);if(_e!==void 0){if($.currentProgram===_e&&$.lightsStateVersion===Lt)return Po(E,Ct),_e}else Ct.uniforms=at.getUniforms(E),O!==null&&E.isNodeMaterial&&O.build(E,Q,Ct),E.onBeforeCompile(Ct,C),_e=at.acquireProgram(Ct,Dt),Ht.set(Dt,_e),$.uniforms=Ct.uniforms;let Vt=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Vt.clippingPlanes=ot.uniform),Po(E,Ct),$.needsLights=As(E),$.lightsStateVersion=Lt,$.needsLights&&(Vt.ambientLightColor.value=J.state.ambient,Vt.lightProbe.value=J.state.probe,Vt.sunLights.value=J.state.sun,Vt.sunLightShadows.value=J.state.sunShadow,Vt.directionalLights.value=J.state.directional,Vt.directionalLightShadows.value=J.state.directionalShadow,Vt.spotLights.value=J.state.spot,Vt.spotLightShadows.value=J.state.spotShadow,Vt.rectAreaLights.value=J.state.rectArea,Vt.ltc_1.value=J.state.rectAreaLTC1,Vt.ltc_2.value=J.state.rectAreaLTC2,Vt.pointLights.value=J.state.point,Vt.pointLightShadows.value=J.state.pointShadow,Vt.hemisphereLights.value=J.state.hemi,Vt.sunShadowMatrix.value=J.state.sunShadowMatrix,Vt.sunShadowCascade.value=J.state.sunShadowCascade,Vt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Vt.spotLightMatrix.value=J.state.spotLightMatrix,Vt.spotLightMap.value=J.state.spotLightMap,Vt.pointShadowMatrix.value=J.state.pointShadowMatrix),$.numLightProbeGrids=ln(A.state.lightProbeGridArray),$.currentProgram=_e,$.uniformsList=null,_e}function ni(E,G,Q,$,J){let Rt=Gt.get(E),Lt=Rt.currentProgram.id+","+$+","+J,Ct=Rt.programVariants.get(Lt);return Ct===void 0?(Ct=Xi(E,G,Q),Rt.programVariants.set(Lt,Ct)):(Rt.currentProgram=Ct,Rt.uniformsList=null,Rt.outputColorSpace=$,Rt.toneMapping=J),Ct}function Es(E){if(E.uniformsList===null){let G=E.currentProgram.getUniforms();E.uniformsList=Eo.seqWithValue(G.seq,E.uniforms)}return E.uniformsList}function Po(E,G){let Q=Gt.get(E);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function Io(E,G,Q,$,J){G.isScene!==!0&&(G=He),Kt.resetTextureUnits();let Rt=G.fog,Lt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?G.environment:null,Ct=tt===null?C.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:be.workingColorSpace,Dt=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Ht=L.get($.envMap||Lt,Dt),le=$.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,_e=!!Q.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Vt=!!Q.morphAttributes.position,xe=!!Q.morphAttributes.normal,Qe=!!Q.morphAttributes.color,Oe=ns;$.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(Oe=C.toneMapping);let Be=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,_n=Be!==void 0?Be.length:0,Bt=Gt.get($),cn=A.state.lights;if(se===!0&&(Ae===!0||E!==Z)){let ze=E===Z&&$.id===X;ot.setState($,E,ze)}let Me=!1,as=!1;$.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==cn.state.version||J.isBatchedMesh&&Bt.batching===!1||!J.isBatchedMesh&&Bt.batching===!0||J.isBatchedMesh&&Bt.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Bt.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Bt.instancing===!1||!J.isInstancedMesh&&Bt.instancing===!0||J.isSkinnedMesh&&Bt.skinning===!1||!J.isSkinnedMesh&&Bt.skinning===!0||J.isInstancedMesh&&Bt.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Bt.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Bt.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Bt.instancingMorph===!1&&J.morphTexture!==null||Bt.envMap!==Ht||$.fog===!0&&Bt.fog!==Rt||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==ot.numPlanes||Bt.numIntersection!==ot.numIntersection)||Bt.vertexAlphas!==le||Bt.vertexTangents!==_e||Bt.morphTargets!==Vt||Bt.morphNormals!==xe||Bt.morphColors!==Qe||Bt.morphTargetsCount!==_n||Bt.numLightProbeGrids!==ln(A.state.lightProbeGridArray)?Me=!0:(Bt.outputColorSpace!==Ct||Bt.toneMapping!==Oe)&&(as=!0):(Me=!0,Bt.__version=$.version);let hn=Bt.currentProgram;(Me===!0||as===!0)&&(hn=as===!0?ni($,G,J,Ct,Oe):Xi($,G,J),O&&$.isNodeMaterial&&O.onUpdateProgram($,hn,Bt));let Er=!1,qi=!1,ls=!1,de=hn.getUniforms(),en=Bt.uniforms;if(bt.useProgram(hn.program)&&(Er=!0,qi=!0,ls=!0),$.id!==X&&(X=$.id,qi=!0),Er||Z!==E){bt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),de.setValue(F,"projectionMatrix",E.projectionMatrix),de.setValue(F,"viewMatrix",E.matrixWorldInverse);let un=de.map.cameraPosition;un!==void 0&&un.setValue(F,we.setFromMatrixPosition(E.matrixWorld)),Jt.logarithmicDepthBuffer&&de.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&de.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),Z!==E&&(Z=E,qi=!0,ls=!0)}if(Bt.needsLights&&(cn.state.sunShadowMap.length>0&&de.setValue(F,"sunShadowMap",cn.state.sunShadowMap,Kt),cn.state.directionalShadowMap.length>0&&de.setValue(F,"directionalShadowMap",cn.state.directionalShadowMap,Kt),cn.state.spotShadowMap.length>0&&de.setValue(F,"spotShadowMap",cn.state.spotShadowMap,Kt),cn.state.pointShadowMap.length>0&&de.setValue(F,"pointShadowMap",cn.state.pointShadowMap,Kt)),J.isSkinnedMesh){de.setOptional(F,J,"bindMatrix"),de.setOptional(F,J,"bindMatrixInverse");let ze=J.skeleton;ze&&(ze.boneTexture===null&&ze.computeBoneTexture(),de.setValue(F,"boneTexture",ze.boneTexture,Kt))}J.isBatchedMesh&&(de.setOptional(F,J,"batchingTexture"),de.setValue(F,"batchingTexture",J._matricesTexture,Kt),de.setOptional(F,J,"batchingIdTexture"),de.setValue(F,"batchingIdTexture",J._indirectTexture,Kt),de.setOptional(F,J,"batchingColorTexture"),J._colorsTexture!==null&&de.setValue(F,"batchingColorTexture",J._colorsTexture,Kt));let Vn=Q.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&lt.update(J,Q,hn),(qi||Bt.receiveShadow!==J.receiveShadow)&&(Bt.receiveShadow=J.receiveShadow,de.setValue(F,"receiveShadow",J.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&G.environment!==null&&(en.envMapIntensity.value=G.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=Nw()),qi){if(de.setValue(F,"toneMappingExposure",C.toneMappingExposure),Bt.needsLights&&wr(en,ls),Rt&&$.fog===!0&&vt.refreshFogUniforms(en,Rt),vt.refreshMaterialUniforms(en,$,St,xt,A.state.transmissionRenderTarget[E.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let ze=M,un=0;for(let Nn of A.state.lightProbeGridArray)Nn.texture!==null&&(ze.textures[un]=Nn.texture,ze.min[un]=Nn.boundingBox.min,ze.max[un]=Nn.boundingBox.max,ze.resolution[un]=Nn.resolution,un++);for(let Nn in ze)ze[Nn].length=un;en.probesSH.value=ze.textures,en.probesMin.value=ze.min,en.probesMax.value=ze.max,en.probesResolution.value=ze.resolution}Eo.upload(F,Es(Bt),en,Kt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Eo.upload(F,Es(Bt),en,Kt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&de.setValue(F,"center",J.center),de.setValue(F,"modelViewMatrix",J.modelViewMatrix),de.setValue(F,"normalMatrix",J.normalMatrix),de.setValue(F,"modelMatrix",J.matrixWorld),$.uniformsGroups!==void 0){let ze=$.uniformsGroups;for(let un=0,Nn=ze.length;un<Nn;un++){let Ha=ze[un];$t.update(Ha,hn),$t.bind(Ha,hn)}}return hn}function wr(E,G){E.ambientLightColor.needsUpdate=G,E.lightProbe.needsUpdate=G,E.sunLights.needsUpdate=G,E.sunLightShadows.needsUpdate=G,E.directionalLights.needsUpdate=G,E.directionalLightShadows.needsUpdate=G,E.pointLights.needsUpdate=G,E.pointLightShadows.needsUpdate=G,E.spotLights.needsUpdate=G,E.spotLightShadows.needsUpdate=G,E.rectAreaLights.needsUpdate=G,E.hemisphereLights.needsUpdate=G}function As(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(E,G,Q){let $=Gt.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Gt.get(E.texture).__webglTexture=G,Gt.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:Q,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,G){let Q=Gt.get(E);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(E,G=0,Q=0){tt=E,W=G,z=Q;let $=null,J=!1,Rt=!1;if(E){let Ct=Gt.get(E);if(Ct.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(F.FRAMEBUFFER,Ct.__webglFramebuffer),et.copy(E.viewport),st.copy(E.scissor),rt=E.scissorTest,bt.viewport(et),bt.scissor(st),bt.setScissorTest(rt),X=-1;return}else if(Ct.__webglFramebuffer===void 0)Kt.setupRenderTarget(E);else if(Ct.__hasExternalTextures)Kt.rebindTextures(E,Gt.get(E.texture).__webglTexture,Gt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let le=E.depthTexture;if(Ct.__boundDepthTexture!==le){if(le!==null&&Gt.has(le)&&(E.width!==le.image.width||E.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(E)}}let Dt=E.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(Rt=!0);let Ht=Gt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ht[G])?$=Ht[G][Q]:$=Ht[G],J=!0):E.samples>0&&Kt.useMultisampledRTT(E)===!1?$=Gt.get(E).__webglMultisampledFramebuffer:Array.isArray(Ht)?$=Ht[Q]:$=Ht,et.copy(E.viewport),st.copy(E.scissor),rt=E.scissorTest}else et.copy(yt).multiplyScalar(St).floor(),st.copy(Xt).multiplyScalar(St).floor(),rt=qt;if(Q!==0&&($=k),bt.bindFramebuffer(F.FRAMEBUFFER,$)&&bt.drawBuffers(E,$),bt.viewport(et),bt.scissor(st),bt.setScissorTest(rt),J){let Ct=Gt.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+G,Ct.__webglTexture,Q)}else if(Rt){let Ct=G;for(let Dt=0;Dt<E.textures.length;Dt++){let Ht=Gt.get(E.textures[Dt]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Dt,Ht.__webglTexture,Q,Ct)}}else if(E!==null&&Q!==0){let Ct=Gt.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ct.__webglTexture,Q)}X=-1};function Tr(E){let G=Gt.get(E);return(G.__readFormat!==E.format||G.__readType!==E.type)&&(G.__readFormat=E.format,G.__readType=E.type,G.__formatReadable=Jt.textureFormatReadable(E.format),G.__typeReadable=Jt.textureTypeReadable(E.type)),G}this.readRenderTargetPixels=function(E,G,Q,$,J,Rt,Lt,Ct=0){if(!(E&&E.isWebGLRenderTarget)){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){bt.bindFramebuffer(F.FRAMEBUFFER,Dt);try{let Ht=E.textures[Ct],le=Ht.format,_e=Ht.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ct);let Vt=Tr(Ht);if(Vt.__formatReadable===!1){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=E.width-$&&Q>=0&&Q<=E.height-J&&F.readPixels(G,Q,$,J,Mt.convert(le),Mt.convert(_e),Rt)}finally{let Ht=tt!==null?Gt.get(tt).__webglFramebuffer:null;bt.bindFramebuffer(F.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(E,G,Q,$,J,Rt,Lt,Ct=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(G>=0&&G<=E.width-$&&Q>=0&&Q<=E.height-J){bt.bindFramebuffer(F.FRAMEBUFFER,Dt);let Ht=E.textures[Ct],le=Ht.format,_e=Ht.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ct);let Vt=Tr(Ht);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,xe),F.bufferData(F.PIXEL_PACK_BUFFER,Rt.byteLength,F.STREAM_READ),F.readPixels(G,Q,$,J,Mt.convert(le),Mt.convert(_e),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let Qe=tt!==null?Gt.get(tt).__webglFramebuffer:null;bt.bindFramebuffer(F.FRAMEBUFFER,Qe);let Oe=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Cg(F,Oe,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,xe),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Rt),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(xe),F.deleteSync(Oe),Rt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,G=null,Q=0){let $=Math.pow(2,-Q),J=Math.floor(E.image.width*$),Rt=Math.floor(E.image.height*$),Lt=G!==null?G.x:0,Ct=G!==null?G.y:0;Kt.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Lt,Ct,J,Rt),bt.unbindTexture()},this.copyTextureToTexture=function(E,G,Q=null,$=null,J=0,Rt=0){let Lt,Ct,Dt,Ht,le,_e,Vt,xe,Qe,Oe=E.isCompressedTexture?E.mipmaps[Rt]:E.image;if(Q!==null)Lt=Q.max.x-Q.min.x,Ct=Q.max.y-Q.min.y,Dt=Q.isBox3?Q.max.z-Q.min.z:1,Ht=Q.min.x,le=Q.min.y,_e=Q.isBox3?Q.min.z:0;else{let de=Math.pow(2,-J);Lt=Math.floor(Oe.width*de),Ct=Math.floor(Oe.height*de),E.isDataArrayTexture?Dt=Oe.depth:E.isData3DTexture?Dt=Math.floor(Oe.depth*de):Dt=1,Ht=0,le=0,_e=0}$!==null?(Vt=$.x,xe=$.y,Qe=$.z):(Vt=0,xe=0,Qe=0);let Be=Mt.convert(G.format),_n=Mt.convert(G.type),Bt;G.isData3DTexture?(Kt.setTexture3D(G,0),Bt=F.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Kt.setTexture2DArray(G,0),Bt=F.TEXTURE_2D_ARRAY):(Kt.setTexture2D(G,0),Bt=F.TEXTURE_2D),bt.activeTexture(F.TEXTURE0),bt.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,G.flipY),bt.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),bt.pixelStorei(F.UNPACK_ALIGNMENT,G.unpackAlignment);let cn=bt.getParameter(F.UNPACK_ROW_LENGTH),Me=bt.getParameter(F.UNPACK_IMAGE_HEIGHT),as=bt.getParameter(F.UNPACK_SKIP_PIXELS),hn=bt.getParameter(F.UNPACK_SKIP_ROWS),Er=bt.getParameter(F.UNPACK_SKIP_IMAGES);bt.pixelStorei(F.UNPACK_ROW_LENGTH,Oe.width),bt.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Oe.height),bt.pixelStorei(F.UNPACK_SKIP_PIXELS,Ht),bt.pixelStorei(F.UNPACK_SKIP_ROWS,le),bt.pixelStorei(F.UNPACK_SKIP_IMAGES,_e);let qi=E.isDataArrayTexture||E.isData3DTexture,ls=G.isDataArrayTexture||G.isData3DTexture;if(E.isDepthTexture){let de=Gt.get(E),en=Gt.get(G),Vn=Gt.get(de.__renderTarget),ze=Gt.get(en.__renderTarget);bt.bindFramebuffer(F.READ_FRAMEBUFFER,Vn.__webglFramebuffer),bt.bindFramebuffer(F.DRAW_FRAMEBUFFER,ze.__webglFramebuffer);for(let un=0;un<Dt;un++)qi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Gt.get(E).__webglTexture,J,_e+un),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Gt.get(G).__webglTexture,Rt,Qe+un)),F.blitFramebuffer(Ht,le,Ht+Lt,le+Ct,Vt,xe,Vt+Lt,xe+Ct,F.DEPTH_BUFFER_BIT,F.NEAREST);bt.bindFramebuffer(F.READ_FRAMEBUFFER,null),bt.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(J!==0||E.isRenderTargetTexture||Gt.has(E)){let de=Gt.get(E),en=Gt.get(G);bt.bindFramebuffer(F.READ_FRAMEBUFFER,N),bt.bindFramebuffer(F.DRAW_FRAMEBUFFER,V);for(let Vn=0;Vn<Dt;Vn++)qi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,de.__webglTexture,J,_e+Vn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,de.__webglTexture,J),ls?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,en.__webglTexture,Rt,Qe+Vn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,en.__webglTexture,Rt),J!==0?F.blitFramebuffer(Ht,le,Ht+Lt,le+Ct,Vt,xe,Vt+Lt,xe+Ct,F.COLOR_BUFFER_BIT,F.NEAREST):ls?F.copyTexSubImage3D(Bt,Rt,Vt,xe,Qe+Vn,Ht,le,Lt,Ct):F.copyTexSubImage2D(Bt,Rt,Vt,xe,Ht,le,Lt,Ct);bt.bindFramebuffer(F.READ_FRAMEBUFFER,null),bt.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ls?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(Bt,Rt,Vt,xe,Qe,Lt,Ct,Dt,Be,_n,Oe.data):G.isCompressedArrayTexture?F.compressedTexSubImage3D(Bt,Rt,Vt,xe,Qe,Lt,Ct,Dt,Be,Oe.data):F.texSubImage3D(Bt,Rt,Vt,xe,Qe,Lt,Ct,Dt,Be,_n,Oe):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Rt,Vt,xe,Lt,Ct,Be,_n,Oe.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Rt,Vt,xe,Oe.width,Oe.height,Be,Oe.data):F.texSubImage2D(F.TEXTURE_2D,Rt,Vt,xe,Lt,Ct,Be,_n,Oe);bt.pixelStorei(F.UNPACK_ROW_LENGTH,cn),bt.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Me),bt.pixelStorei(F.UNPACK_SKIP_PIXELS,as),bt.pixelStorei(F.UNPACK_SKIP_ROWS,hn),bt.pixelStorei(F.UNPACK_SKIP_IMAGES,Er),Rt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&F.generateMipmap(Bt),bt.unbindTexture()},this.initRenderTarget=function(E){Gt.get(E).__webglFramebuffer===void 0&&Kt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Kt.setTextureCube(E,0):E.isData3DTexture?Kt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Kt.setTexture2DArray(E,0):Kt.setTexture2D(E,0),bt.unbindTexture()},this.resetState=function(){W=0,z=0,tt=null,bt.reset(),Et.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=be._getDrawingBufferColorSpace(t),e.unpackColorSpace=be._getUnpackColorSpace()}};var p0={type:"change"},Gf={type:"start"},g0={type:"end"},vh=new _r,m0=new pi,Uw=Math.cos(70*Ef.DEG2RAD),Sn=new Y,ei=2*Math.PI,Ie={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Vf=1e-6,Mh=class extends Ea{constructor(t,e=null){super(t,e),this.state=Ie.NONE,this.target=new Y,this.cursor=new Y,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qs.ROTATE,MIDDLE:qs.DOLLY,RIGHT:qs.PAN},this.touches={ONE:Ys.ROTATE,TWO:Ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Y,this._lastQuaternion=new mi,this._lastTargetPosition=new Y,this._quat=new mi().setFromUnitVectors(t.up,new Y(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Mo,this._sphericalDelta=new Mo,this._scale=1,this._panOffset=new Y,this._rotateStart=new jt,this._rotateEnd=new jt,this._rotateDelta=new jt,this._panStart=new jt,this._panEnd=new jt,this._panDelta=new jt,this._dollyStart=new jt,this._dollyEnd=new jt,this._dollyDelta=new jt,this._dollyDirection=new Y,this._mouse=new jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Ow.bind(this),this._onPointerDown=Fw.bind(this),this._onPointerUp=Bw.bind(this),this._onContextMenu=Xw.bind(this),this._onMouseWheel=Vw.bind(this),this._onKeyDown=Gw.bind(this),this._onTouchStart=Hw.bind(this),this._onTouchMove=Ww.bind(this),this._onMouseDown=zw.bind(this),this._onMouseMove=kw.bind(this),this._interceptControlDown=qw.bind(this),this._interceptControlUp=Yw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ie.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(p0),this.update(),this.state=Ie.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Ie.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Y(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Y(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(vh.origin.copy(this.object.position),vh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(vh.direction))<Uw?this.object.lookAt(this.target):(m0.setFromNormalAndCoplanarPoint(this.object.up,this.target),vh.intersectPlane(m0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Vf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Vf||this._lastTargetPosition.distanceToSquared(this.target)>Vf?(this.dispatchEvent(p0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function Fw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Ow(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function Bw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(g0),this.state=Ie.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function zw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ie.DOLLY;break;case qs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ie.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ie.ROTATE}break;case qs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ie.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ie.PAN}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(Gf)}function kw(n){switch(this.state){case Ie.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ie.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ie.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Vw(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ie.NONE||(n.preventDefault(),this.dispatchEvent(Gf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(g0))}function Gw(n){this.enabled!==!1&&this._handleKeyDown(n)}function Hw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ys.ROTATE:if(this.enableRotate===!1){this.state=Ie.NONE;break}this._handleTouchStartRotate(n),this.state=Ie.TOUCH_ROTATE;break;case Ys.PAN:if(this.enablePan===!1){this.state=Ie.NONE;break}this._handleTouchStartPan(n),this.state=Ie.TOUCH_PAN;break;default:this.state=Ie.NONE}break;case 2:switch(this.touches.TWO){case Ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ie.TOUCH_DOLLY_PAN;break;case Ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ie.TOUCH_DOLLY_ROTATE;break;default:this.state=Ie.NONE}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(Gf)}function Ww(n){switch(this._trackPointer(n),this.state){case Ie.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ie.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ie.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ie.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ie.NONE}}function Xw(n){this.enabled!==!1&&n.preventDefault()}function qw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Yw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Sh=class{constructor(t){this.well=t}at(t,e){let{md_m:i,north_m:s,east_m:r,tvd_m:o,high:a}=this.well,l=Math.min(Math.max(fs(i,t),1),i.length-1),c=(t-i[l-1])/(i[l]-i[l-1]||1),f=h=>h[l-1]+c*(h[l]-h[l-1]);e.place=[f(r),-f(o),-f(s)],e.high=Hf([f(a[1]),-f(a[2]),-f(a[0])]);let d=[r,o,s].map(h=>h[l]-h[l-1]),u=Hf([d[0],-d[1],-d[2]]);return e.right=Hf($w(u,e.high)),e}},Hf=n=>{let t=Math.hypot(...n)||1;return n.map(e=>e/t)},$w=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],za=class extends Qn{constructor(t,e){super(),this.rings=t,this.sides=e;let i=t*e;this.setAttribute("position",new Zn(new Float32Array(3*i),3)),this.setAttribute("normal",new Zn(new Float32Array(3*i),3)),this.setAttribute("color",new Zn(new Float32Array(3*i).fill(1),3));let s=[];for(let r=0;r+1<t;r++)for(let o=0;o<e;o++){let[a,l]=[r*e+o,r*e+(o+1)%e];s.push(a,l,a+e,l,l+e,a+e)}this.setIndex(s),this.turns=Array.from({length:e},(r,o)=>[Math.cos(2*Math.PI*o/e),Math.sin(2*Math.PI*o/e)])}ring(t,e,i,s,r){let{position:o,normal:a}=this.attributes;for(let l=0;l<this.sides;l++){let[c,f]=this.turns[l],d=3*(t*this.sides+l);for(let u=0;u<3;u++){let h=c*i[u]+f*s[u];a.array[d+u]=h,o.array[d+u]=e[u]+r*h}}}paint(t,e,i,s){let{color:r}=this.attributes;for(let o=0;o<this.sides;o++)r.array.set([e,i,s],3*(t*this.sides+o))}changed(){for(let t of Object.values(this.attributes))t.needsUpdate=!0;this.computeBoundingSphere()}};var Zw=[["side_force_N_per_m","Side force, by side","force per length",!0],["contact_force_N","Contact force of the node","force",!0],["tension_N","Effective tension","force",!1],["torque_N_m","Torque","torque",!1],["bending_moment_N_m","Bending moment","torque",!1],["rotary_speed_rad_per_s","Rotary speed","rotary speed",!1],["von_mises_stress_max_Pa","Largest von Mises stress","pressure",!1],["contact_fraction","Share of time in contact","percent",!1]];function Jw(n,t){let{profile:e}=t,i=e.md_m,s=e.lateral_offset_m??Kw(n,e),r=jw(e);return{depths:i,high:s.map((o,a)=>-o*Math.cos(r[a])),right:s.map((o,a)=>o*Math.sin(r[a])),values:o=>e[o],has:o=>!!e[o]&&o!=="contact_force_N"}}function Kw(n,t){return t.md_m.map(e=>{let i=o=>e>=o.from_m&&e<=o.to_m,s=n.hole.find(i),r=n.string.find(i);return s&&r?(s.diameter_m-r.contact_od_m)/2:0})}function jw(n){let t=[];for(let s=0;s<n.md_m.length;s++){let r=n.climb_rad?.[s];Number.isFinite(r)?t.push([n.md_m[s],Math.cos(r),Math.sin(r)]):!n.climb_rad&&n.side_force_N_per_m[s]!==0&&t.push([n.md_m[s],n.side_force_N_per_m[s]>0?-1:1,0])}if(t.length===0)return n.md_m.map(()=>0);let e=[0,1,2].map(s=>Float32Array.from(t,r=>r[s])),i=(s,r)=>{let o=dl(e[0],r,Math.min(Math.max(s,e[0][0]),e[0].at(-1)));return Number.isFinite(o)?o:0};return n.md_m.map(s=>Math.atan2(i(s,e[2]),i(s,e[1])))}function Qw(n,t){let e=n.md_m.length,i=s=>n.channels[s].subarray(t*e,(t+1)*e);return{depths:n.md_m.map(s=>s+n.moved_m[t]),high:i("offset_high_m"),right:i("offset_right_m"),values:i,has:s=>!!n.channels[s]}}function _0(n,t,e){return t?.frames&&e!==null?Qw(t.frames,e):Jw(n,Mi(n,"dynamic")??Mi(n,"soft"))}var x0=n=>Zw.filter(([t])=>n.has(t));function y0(n,t,e,i,s){let r=t?.frames&&e!==null?t.frames.channels[i]:n.values(i),o=Array.from(r).filter(Number.isFinite).sort((f,d)=>f-d);if(o.length===0)return[0,1];let a=f=>o[Math.round(f*(o.length-1))];if(s){let f=Math.max(Math.abs(a(.01)),Math.abs(a(.99)))||1;return[-f,f]}let[l,c]=[a(.002),a(.998)];return l<c?[l,c]:[l-.5*Math.abs(l||1),c+.5*Math.abs(c||1)]}function v0(n,t){let e=Math.min(Math.max(fs(n.time_s,t),1),n.time_s.length-1);return e<1?0:t-n.time_s[e-1]<n.time_s[e]-t?e-1:e}function bh(n,t,e,i="text",s=.5){let r=ht("canvas",{}),o=r.getContext("2d"),a="600 44px system-ui, sans-serif";o.font=a,r.width=Math.ceil(o.measureText(n).width)+8,r.height=56,o.font=a,o.textBaseline="middle",o.fillStyle=on(i),o.fillText(n,4,30);let l=new da(new go({map:new ga(r),depthTest:!1,transparent:!0}));return l.position.set(...t),l.center.set(s,.5),l.scale.set(e*r.width/r.height,e,1),l.renderOrder=3,l}function Wf(n,[t,e]){let i=new Y(1/0,1/0,1/0),s=i.clone().negate();for(let o=0;o<=100;o++){let a=new Y(...n.at(t+(e-t)*o/100,{}).place);i.min(a),s.max(a)}let r=.22*s.clone().sub(i).length();for(let o of["x","y","z"]){let l=Math.max(r-(s[o]-i[o]),0)/2+(o==="y"?0:.03*r);i[o]-=l,s[o]+=l}return{low:i,high:s}}function Xf({low:n,high:t},[e,,i]){let[s,r]=e>=0?[n.x,t.x]:[t.x,n.x],[o,a]=i>=0?[n.z,t.z]:[t.z,n.z];return[[s,o],[r,o],[s,a]]}function M0(n,t,e,i){let s=Wf(n,t),{low:r,high:o}=s,[a,l,c]=Xf(s,i),f=o.clone().sub(r).length(),d=Rn("length"),u=ci(De(t[0],"length"),De(t[1],"length"),8),h=u.values.map(w=>{let{place:M,high:R}=n.at(Li(w,"length"),{}),A=e+.012*f;return bh(`${hi(w,u.step)} ${d}`,M.map((_,S)=>_+A*R[S]),.021*f,"text",0)}),m=[],y=(w,M)=>m.push(...w,...M),g=ci(De(-o.y,"length"),De(-r.y,"length"),5),p=g.values.map(w=>{let M=-Li(w,"length"),R=([A,_])=>[A,M,_];return y(R(a),R(l)),y(R(a),R(c)),bh(`TVD ${hi(w,g.step)} ${d}`,R(c),.019*f,"muted",1.06)});for(let[w,M]of[a,l,c])y([w,r.y,M],[w,o.y,M]);let v=new Qn;return v.setAttribute("position",new Bn(m,3)),[new pa(v,new _o({color:on("frame"),transparent:!0,opacity:.35})),...h,...p,bh("N",[(r.x+o.x)/2,o.y,r.z-.04*f],.024*f),bh("E",[o.x+.04*f,o.y,(r.z+o.z)/2],.024*f)]}var qf=520,t1=10;function S0(n){let t=ht("canvas",{class:"space",role:"img","aria-label":"The well in space, the string in it"}),e;try{e=new _h({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0})}catch{return{element:ht("p",{class:"warning"},"This view needs WebGL, which this browser does not give."),redraw:()=>{}}}let i=new Sh(n.well),s=new ca,r=new $n(38,1,1,1e5),o=new Mh(r,t);o.enableDamping=!1,o.enableZoom=!1;let a=new wa(16777215,2.2);s.add(new Ta(16777215,1.6),a);let l=n.well.md_m.at(-1),c=Math.max(...n.hole.map(gt=>gt.diameter_m),.1),f=e1(.03*l/c),d=null,u=null,h=null,m=[],y=ht("canvas",{class:"space-paper"}),g=ht("div",{class:"space-holder"},t,y),p=ht("div",{class:"colour-key"}),v=ht("output",{}),w=ht("input",{type:"range",min:0,step:1,"aria-label":"Moment",oninput:()=>{let gt=Xn(n);rn({moment:gt.frames.time_s[Number(w.value)]})}}),M=ht("button",{type:"button",onclick:()=>h?k():O()},"Play"),R=ht("button",{type:"button",onclick:()=>{k(),rn({moment:null})}},"Mean"),A=ht("div",{class:"moments"},M,R,w,v),_=ht("output",{}),S=ht("input",{type:"range",min:0,max:3.7,step:.01,value:Math.log10(f),"aria-label":"Exaggeration across the hole",oninput:()=>{f=10**Number(S.value),tt()}}),I=ht("span",{}),C=[["Whole well",()=>j(.3)],["From the side",()=>j(.02)],["From above",()=>[.001,1,.001]]].map(([gt,yt])=>ht("button",{type:"button",onclick:()=>dt(yt())},gt)),P=ht("div",{class:"tools noprint"},I,ht("label",{},"Across × ",S,_),C,ht("span",{class:"hint"},"drag to turn, right-drag to move, Ctrl + wheel to go nearer; shows the depths in view above"));t.addEventListener("wheel",gt=>{if(!gt.ctrlKey&&!gt.metaKey)return;gt.preventDefault();let yt=r.position.clone().sub(o.target).multiplyScalar(Math.exp(gt.deltaY*.002));r.position.copy(o.target).add(yt),pt()},{passive:!1}),o.addEventListener("change",pt);function O(){M.textContent="Stop",h=setInterval(()=>{let{frames:gt}=Xn(n),yt=(Number(w.value)+1)%gt.time_s.length;rn({moment:gt.time_s[yt]})},80)}function k(){clearInterval(h),h=null,M.textContent="Play"}let N=()=>Qt.depths??[n.well.md_m[0],l];function V([gt,yt]){let Xt=Array.from(n.well.md_m).filter(ie=>ie>gt&&ie<yt),qt=(yt-gt)/300;return[...Array.from({length:301},(ie,se)=>gt+se*qt),...Xt].sort((ie,se)=>ie-se)}function W(){for(let gt of m)s.remove(gt),gt.geometry?.dispose(),gt.material.map?.dispose(),gt.material.dispose();m=[]}function z(gt){return m.push(gt),s.add(gt),gt}function tt(){W();let[gt,yt]=N(),Xt={};for(let qt of n.hole){let Yt=[Math.max(qt.from_m,gt),Math.min(qt.to_m,yt)];if(Yt[1]<=Yt[0])continue;let ie=V(Yt),se=new za(ie.length,28);ie.forEach((we,ce)=>{i.at(we,Xt),se.ring(ce,Xt.place,Xt.high,Xt.right,qt.diameter_m/2*f)}),se.changed();let Ae=qt.kind==="casing",ge=new yo({color:on(Ae?"casing":"rock"),transparent:!0,opacity:Ae?.16:.26,side:Ei,depthWrite:!1});z(new _i(se,ge)).renderOrder=2}M0(i,[gt,yt],c/2*f,j(.3)).forEach(z),et(),_.textContent=` ${Un(f,2)}`,pt()}let X=null,Z=null;function et(){let gt=Xn(n);u=gt?.frames&&Qt.moment!==null?v0(gt.frames,Qt.moment):null;let yt=_0(n,gt,u),Xt=x0(yt);Xt.some(([Ft])=>Ft===d)||(d=Xt[0][0]);let[,qt,Yt,ie]=Xt.find(([Ft])=>Ft===d);I.replaceChildren(gd("Colour: ",Xt.map(([Ft,Jt])=>[Ft,Jt]),d,Ft=>{d=Ft,et(),pt()}));let[se,Ae]=N(),ge=Array.from(yt.depths,(Ft,Jt)=>[Ft,Jt]).filter(([Ft])=>Ft>=se-1&&Ft<=Ae+1);(!X||Z.geometry!==X||X.rings!==ge.length)&&(Z&&(s.remove(Z),m=m.filter(Ft=>Ft!==Z),Z.geometry.dispose(),Z.material.dispose()),X=new za(Math.max(ge.length,2),t1),Z=z(new _i(X,new yo({vertexColors:!0})))),m.includes(Z)||z(Z);let we=yt.values(d),ce=y0(yt,gt,u,d,ie),He=Za(ie),Le=Ft=>He((Ft-ce[0])/(ce[1]-ce[0])).map(Jt=>Jt/255),Re={},F=new pe,Pt=n.string;ge.forEach(([Ft,Jt],bt)=>{i.at(Math.min(Ft,l),Re);let[Fe,Gt]=[yt.high[Jt]*f||0,yt.right[Jt]*f||0],Kt=Re.place.map((at,vt)=>at+Fe*Re.high[vt]+Gt*Re.right[vt]),L=Pt.find(at=>Ft<=at.to_m)??Pt.at(-1);X.ring(bt,Kt,Re.high,Re.right,(L?.od_m??.12)/2*f);let[b,q,ut]=Number.isFinite(we[Jt])?Le(we[Jt]):[.5,.5,.5];F.setRGB(b,q,ut,"srgb"),X.paint(bt,F.r,F.g,F.b)}),X.changed(),st(qt,Yt,ce,ie,He),A.hidden=!gt?.frames,gt?.frames&&(w.max=gt.frames.time_s.length-1,u!==null&&(w.value=u),R.disabled=u===null,v.textContent=u===null?"mean of the window":`${gt.frames.time_s[u].toFixed(2)} s`)}function st(gt,yt,Xt,qt,Yt){let ie=Array.from({length:21},(we,ce)=>`rgb(${Yt(ce/20).join(" ")}) ${ce*5}%`),se=Xt.map(we=>De(we,yt)),{values:Ae,step:ge}=ci(se[0],se[1],4);p.replaceChildren(ht("span",{},`${gt}${Rn(yt)?`, ${Rn(yt)}`:""}${qt?" (low side −, high side +)":""}, ${sr(Qt.operation)}`),ht("div",{class:"ramp",style:`background:linear-gradient(to right, ${ie.join(",")})`}),ht("div",{class:"ramp-ticks"},Ae.map(we=>ht("span",{style:`left:${(we-se[0])/(se[1]-se[0])*100}%`},hi(we,ge)))))}function rt(){let[gt,yt]=N();return Array.from({length:41},(Xt,qt)=>i.at(gt+(yt-gt)*qt/40,{}).place)}function j(gt){let[yt,Xt]=N().map(Ae=>i.at(Ae,{}).place),[qt,Yt]=[Xt[0]-yt[0],Xt[2]-yt[2]],ie=Math.hypot(qt,Yt);if(ie<.001)return[.6,gt,.8];let se=qt-Yt<0?-1:1;return[-Yt/ie*se,gt,qt/ie*se]}function dt(gt){let{low:yt,high:Xt}=Wf(i,N()),qt=yt.clone().add(Xt).multiplyScalar(.5);o.target.copy(qt);let Yt=t.clientWidth/qf,ie=new Y(...gt).normalize(),se=new Y(0,1,0).cross(ie).normalize(),Ae=ie.clone().cross(se),ge=Math.tan(r.fov*Math.PI/360),we=0,ce=Xf({low:yt,high:Xt},j(.3)).flatMap(([He,Le])=>[yt.y,Xt.y].map(Re=>[He,Re,Le]));for(let He of[...ce,...rt()]){let Le=new Y(...He).sub(qt),Re=Math.max(Math.abs(Le.dot(se))/(ge*Yt*.86),Math.abs(Le.dot(Ae))/(ge*.93));we=Math.max(we,Re+Le.dot(ie))}r.position.copy(qt).addScaledVector(ie,we),r.near=we/200,r.far=we*20,r.updateProjectionMatrix(),o.update(),pt()}function pt(){a.position.copy(r.position),a.target.position.copy(o.target),a.target.updateMatrixWorld(),e.render(s,r),Us()&&([y.width,y.height]=[t.width,t.height],y.getContext("2d").drawImage(t,0,0))}function xt(){let gt=g.clientWidth||1200;e.setPixelRatio(Math.min(devicePixelRatio*(devicePixelRatio<1.5?1.5:1),2.5)),e.setSize(gt,qf,!1),r.aspect=gt/qf,r.updateProjectionMatrix()}function St(){xt(),tt(),dt(j(.3))}dn("units operation",()=>{k(),tt()}),dn("depths",()=>{tt(),dt(r.position.clone().sub(o.target).toArray())}),dn("moment",()=>{et(),pt()});let Wt=0;return new ResizeObserver(()=>{g.clientWidth!==Wt&&(Wt=g.clientWidth,xt(),pt())}).observe(g),{element:ht("div",{},P,g,A,p),redraw:St}}function e1(n){let t=10**Math.floor(Math.log10(Math.max(n,1)));return[5,2,1].map(e=>e*t).find(e=>e<=Math.max(n,1))??1}var b0=4;function w0({cover:n,band:t,picture:e,head:i,height:s,total:r,full:o,view:a,zoom:l}){let c=h=>{let[m,y]=a();return i+(h-m)/(y-m)*s},f=h=>{let m=e.getBoundingClientRect(),[y,g]=a(),p=(h.clientY-m.top)/m.height*r;return y+(p-i)/s*(g-y)},d=null;function u(h){let[m,y]=a(),g=r/e.getBoundingClientRect().height*(y-m)/s,p=v=>{let w=(h.clientY-v.clientY)*g,M=Math.min(Math.max(w,o[0]-m),o[1]-y);l([m+M,y+M])};addEventListener("pointermove",p),addEventListener("pointerup",()=>removeEventListener("pointermove",p),{once:!0})}n.addEventListener("pointerdown",h=>{if(h.button===0){if(h.shiftKey)return u(h);d={depth:f(h),y:h.clientY},n.setPointerCapture(h.pointerId)}}),n.addEventListener("pointermove",h=>{let m=f(h);if(d&&Math.abs(h.clientY-d.y)>b0){let y=[c(d.depth),c(m)].sort((g,p)=>g-p);t.setAttribute("y",y[0]),t.setAttribute("height",y[1]-y[0]),t.setAttribute("visibility","visible")}rn({pointer:m})}),n.addEventListener("pointerup",h=>{if(!d)return;let{depth:m,y}=d;d=null,t.setAttribute("visibility","hidden"),Math.abs(h.clientY-y)>b0?l([m,f(h)]):rn({depth:Math.min(Math.max(m,o[0]),o[1])})}),n.addEventListener("pointerleave",()=>rn({pointer:null})),n.addEventListener("dblclick",()=>l(o)),n.addEventListener("wheel",h=>{if(!h.ctrlKey&&!h.metaKey)return;h.preventDefault();let m=f(h),y=Math.exp(h.deltaY*.002);l(a().map(g=>m+(g-m)*y))},{passive:!1})}var n1=5,T0=n=>n.kind==="casing"?"casing":"open hole";function E0(n,t){let e=r=>t>=r.from_m&&t<=r.to_m,i=n.hole.find(e),s=n.string.find(e);return[i&&`${T0(i)} ${pn(i.diameter_m,"diameter")}`,s&&`${s.name} ${pn(s.od_m,"diameter")}`].filter(Boolean)}function A0(n,{left:t,width:e,top:i,height:s},[r,o],a){let l=t+e/2,c=Math.max(...n.hole.map(y=>y.diameter_m),...n.string.map(y=>y.contact_od_m)),f=y=>(e-22)/2*(y/c),d=ne("g",{"clip-path":"inset(0)"}),u=y=>Math.min(Math.max(a(y),i-12),i+s+12);for(let y of n.hole){if(y.to_m<r||y.from_m>o)continue;let[g,p,v]=[u(y.from_m),u(y.to_m),f(y.diameter_m)],w=ne("title",{},`${T0(y)} ${pn(y.diameter_m,"diameter")}, ${pn(y.from_m,"length",5)} to ${pn(y.to_m,"length",5)}, friction ${y.friction}`);d.append(ne("rect",{x:l-v,y:g,width:2*v,height:Math.max(p-g,0),class:y.kind==="casing"?"bore":"rock"},w));for(let M of[-1,1]){let R=l+M*v;d.append(ne("line",{x1:R,x2:R,y1:g,y2:p,class:y.kind==="casing"?"casing":"wall"})),y.kind==="casing"&&y.to_m<o&&d.append(ne("path",{d:`M${R} ${p}h${M*8}L${R} ${p-9}Z`,class:"shoe"}))}}let h=n.string.at(-1),m=h&&h.to_m-h.from_m<n1?h:null;for(let y of n.string){if(y.to_m<r||y.from_m>o)continue;let[g,p,v]=[u(y.from_m),u(y.to_m),Math.max(f(y.od_m),1.5)],w=ne("title",{},`${y.name}, OD ${pn(y.od_m,"diameter")}, ${pn(y.from_m,"length",5)} to ${pn(y.to_m,"length",5)}`),M=/pipe/i.test(y.name)&&!/heavy/i.test(y.name)?"pipe":"tool",R=y===m?ne("path",{d:`M${l-v} ${Math.min(g,p-5)}h${2*v}v${Math.max(p-g,5)*.5}L${l} ${p+3}L${l-v} ${p-Math.max(p-g,5)*.5}Z`,class:"bit"}):ne("rect",{x:l-v,y:g,width:2*v,height:Math.max(p-g,.7),class:M});R.append(w),d.append(R)}return d}var wh=6;function i1(n,t){if(t.from==="well"){let e=n.well[t.column];return e.length?[{depths:n.well.md_m,values:e,well:!0}]:[]}return n.solved.flatMap(e=>{let i=t.from==="wear"?e.wear:e.profile,s=i[t.column];if(!s)return[];let r=i.md_m,[o,a]=(t.band??[]).map(c=>i[c]),l={solved:e,depths:r,values:s,low:o,high:a};return t.touches&&(l.values=ml(r,s,wh)),t.swings&&(l.far={values:om(r,s,wh),low:o&&ml(r,o.map(c=>-c),wh).map(c=>-c),high:a&&ml(r,a,wh)}),[l]})}var R0=n=>n.tracks.map(t=>({...t,curves:i1(n,t)})).filter(t=>t.curves.length);var s1=400,r1=730,Ai=54,ka=88,Va=14,Ks=82,o1=20;function C0(n){let t=R0(n),i=[0,Math.max(n.well.md_m.at(-1)??0,...n.solved.map(_=>_.profile.md_m?.at(-1)??0))],s=()=>Qt.depths??i,r=ht("div",{class:"tracks"}),o=[],a=["from","to"].map((_,S)=>ht("input",{type:"number","aria-label":`Depths in view, ${_}`,step:"any",onchange:I=>{let C=[...s()];C[S]=Li(Number(I.target.value),"length"),d(C)}})),l=ht("span",{}),c=ht("button",{type:"button",onclick:()=>d(i)},"All depths"),f=ht("div",{class:"tools noprint"},ht("label",{},"Depths from ",a[0]),ht("label",{},"to ",a[1]),l,c,ht("span",{class:"hint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all"));function d([_,S]){let[I,C]=[Math.max(Math.min(_,S),i[0]),Math.min(Math.max(_,S),i[1])];C-I>=2&&rn({depths:I<=i[0]&&C>=i[1]?null:[I,C]})}function u(){let _=Us()?r1:r.clientWidth||1360,I=Math.max(Math.floor((_-Ai-ka-Va)/(126+Va)),1),C=Math.ceil(t.length/Math.min(I,t.length)),P=Math.ceil(t.length/C),O=C===1?640:Us()?370:500;o=Array.from({length:C},(V,W)=>h(t.slice(W*P,(W+1)*P),_,P,O)),r.replaceChildren(...o.map(V=>V.picture));let[k,N]=s();a[0].value=De(k,"length").toFixed(1),a[1].value=De(N,"length").toFixed(1),l.textContent=Rn("length"),c.disabled=Qt.depths===null,v()}function h(_,S,I,C){let[P,O]=s(),k=xt=>Ks+(xt-P)/(O-P)*C,N=Ks+C+o1,V=ne("svg",{viewBox:`0 0 ${S} ${N}`,width:S,height:N,role:"img","aria-label":_.map(xt=>xt.title).join(", ")}),W=Ai+ka+Va,z=(S-W-Va*(I-1)-2)/I;m(V,[P,O],k,S,W);let tt={left:Ai,width:ka,top:Ks,height:C},X=ne("svg",{x:0,y:Ks-10,width:S,height:C+18,viewBox:`0 ${Ks-10} ${S} ${C+18}`});X.append(A0(n,tt,[P,O],k)),V.append(X,ne("text",{x:Ai+ka/2,y:16,class:"title middle"},"Hole, string"));let Z=_.map((xt,St)=>{let Wt={left:W+St*(z+Va),width:z,top:Ks,height:C};return{track:xt,text:y(V,xt,Wt,[P,O],k)}}),et=ne("line",{x1:Ai,x2:S,class:"cursor",visibility:"hidden"}),st=ne("line",{x1:Ai,x2:S,class:"chosen",visibility:"hidden"}),rt=ne("text",{x:2,class:"flag",visibility:"hidden"}),j=ne("g",{class:"readout"}),dt=ne("rect",{x:Ai,width:S-Ai,class:"drag",visibility:"hidden"}),pt=ne("rect",{x:Ai,y:Ks,width:S-Ai,height:C,class:"cover"});return V.append(dt,st,et,rt,j,pt),w0({cover:pt,band:dt,picture:V,head:Ks,height:C,total:N,full:i,view:s,zoom:d}),{picture:V,y:k,readouts:Z,cursor:et,chosenLine:st,flag:rt,what:j}}function m(_,[S,I],C,P,O){let{values:k,step:N}=ci(De(S,"length"),De(I,"length"),12);for(let V of k){let W=C(Li(V,"length"));_.append(ne("line",{x1:O,x2:P,y1:W,y2:W,class:"grid"}),ne("text",{x:Ai-8,y:W+4,class:"tick end"},hi(V,N)))}_.append(ne("text",{x:0,y:16,class:"title"},"MD"),ne("text",{x:0,y:31,class:"unit"},Rn("length")))}function y(_,S,I,[C,P],O){let k=[C,P],N=P-C>s1,V=S.curves.map(st=>N&&st.far?{...st,...st.far}:st),W=S.range;if(!W){let st=V.flatMap(rt=>[rt.values,rt.low,rt.high].filter(Boolean).map(j=>sm(rt.depths,j,k)));W=um(Math.min(...st.map(rt=>rt[0])),Math.max(...st.map(rt=>rt[1])),S.zero||S.sides,Li(1,S.dimension))}let z=st=>I.left+(st-W[0])/(W[1]-W[0])*I.width,tt=ne("svg",{x:I.left,y:I.top,width:I.width,height:I.height,viewBox:`${I.left} ${I.top} ${I.width} ${I.height}`}),X=hm(De(W[0],S.dimension),De(W[1],S.dimension),I.width);for(let st of X.values){let rt=z(Li(st,S.dimension)),j=rt<I.left+8?"start":rt>I.left+I.width-8?"end":"middle";_.append(ne("line",{x1:rt,x2:rt,y1:I.top,y2:I.top+I.height,class:st===0?"zero":"grid"}),ne("text",{x:rt,y:I.top-7,class:`tick ${j}`},hi(st,X.step)))}for(let st of n.hole.filter(rt=>rt.kind==="casing"&&rt.to_m>C&&rt.to_m<P))tt.append(ne("line",{x1:I.left,x2:I.left+I.width,y1:O(st.to_m),y2:O(st.to_m),class:"shoe-depth"}));S.sides&&g(tt,S,k,z,O);for(let st of V){let{colour:rt,dashed:j}=st.well?{colour:"var(--text)",dashed:!1}:Ka(n,st.solved),dt=!st.well&&Nr(n).length>1&&st.solved.operation!==Qt.operation;st.low&&st.high&&tt.append(ne("path",{d:pl(st.depths,st.low,st.high,k,z,O),fill:rt,class:dt?"band faint":"band"})),tt.append(ne("path",{d:rm(st.depths,st.values,k,z,O),stroke:rt,class:`curve${j?" dashed":""}${dt?" faint":""}`}))}S.touches&&p(tt,S,I,k,O);let Z=I.left+I.width/2;_.append(tt,ne("rect",{x:I.left,y:I.top,width:I.width,height:I.height,class:"frame"}),ne("text",{x:Z,y:16,class:"title middle"},S.title),ne("text",{x:Z,y:31,class:"unit middle"},Rn(S.dimension))),S.sides&&_.append(ne("text",{x:I.left,y:I.top+I.height+14,class:"side low"},"◂ low side"),ne("text",{x:I.left+I.width,y:I.top+I.height+14,class:"side high end"},"high side ▸")),S.swings&&N&&_.append(ne("text",{x:I.left,y:I.top+I.height+14,class:"side"},"joint to joint")),S.touches&&_.append(ne("text",{x:I.left,y:I.top+I.height+14,class:"side"},"▌ always ",ne("tspan",{class:"sometimes"},"▌")," at times"));let et=ne("text",{x:Z,y:48,class:"readout middle"});return _.append(et),et}function g(_,S,I,C,P){let O=Mi(n,"dynamic")??Mi(n,"soft"),k=S.curves.find(W=>W.solved===O);if(!k)return;let N=new Float32Array(k.values.length),V=W=>k.values.map(z=>W(z)?z:0);_.append(ne("path",{d:pl(k.depths,N,V(W=>W>0),I,C,P),class:"high-side"}),ne("path",{d:pl(k.depths,V(W=>W<0),N,I,C,P),class:"low-side"}))}function p(_,S,I,C,P){let O=Mi(n,"dynamic"),k=S.curves.find(tt=>tt.solved===O);if(!k)return;let N=tt=>tt<.01?0:tt<=.99?1:2,V=0,{depths:W,values:z}=k;for(let tt=1;tt<=z.length;tt++){if(tt<z.length&&N(z[tt])===N(z[V]))continue;let X=N(z[V]),[Z,et]=[P(W[V]),P(W[Math.min(tt,z.length-1)])];X>0&&et>I.top&&Z<I.top+I.height&&_.append(ne("rect",{x:I.left,y:Z,width:6,height:Math.max(et-Z,.7),class:X===2?"always":"sometimes"})),V=tt}}function v(){let[_,S]=s();for(let{y:I,readouts:C,cursor:P,chosenLine:O,flag:k,what:N}of o){let V=(z,tt)=>{let X=tt!==null&&tt>=_&&tt<=S;if(z.setAttribute("visibility",X?"visible":"hidden"),X)for(let Z of["y1","y2"])z.setAttribute(Z,I(tt));return X};V(O,Qt.depth);let W=V(P,Qt.pointer);k.setAttribute("visibility",W?"visible":"hidden"),k.setAttribute("y",W?I(Qt.pointer)+4:0),k.textContent=W?Un(De(Qt.pointer,"length"),5):"",N.replaceChildren(...(W?E0(n,Qt.pointer):[]).map((z,tt)=>ne("text",{x:Ai+ka/2,y:34+13*tt,class:"readout middle small"},z.length>24?`${z.slice(0,23)}…`:z)));for(let{track:z,text:tt}of C)tt.replaceChildren(...W?w(z):[])}}function w(_){return _.curves.filter(I=>I.well||I.solved.operation===Qt.operation).map((I,C)=>{let P=dl(I.depths,I.values,Qt.pointer),O=I.well?"var(--text)":Ka(n,I.solved).colour;return ne("tspan",{fill:O,dx:C?6:0},Number.isFinite(P)?Un(De(P,_.dimension)):"–")})}function M(){let _=n.solved.map(C=>{let{colour:P,dashed:O}=Ka(n,C);return ht("span",{class:"key"},ne("svg",{width:26,height:10},ne("line",{x1:1,x2:25,y1:5,y2:5,stroke:P,class:`curve${O?" dashed":""}`})),Cd(n,C))}),S=n.runs.length?[ht("span",{class:"key"},ne("svg",{width:26,height:10},ne("rect",{width:26,height:10,fill:"var(--line-0)",class:"band"})),"5–95 % of the time")]:[],I=["high","low"].map(C=>ht("span",{class:"key"},ne("svg",{width:14,height:10},ne("rect",{width:14,height:10,class:`${C}-side`})),`on the ${C} side`));return[..._,...S,...I]}let R=ht("div",{class:"legend"}),A=()=>{R.replaceChildren(...M()),u()};return dn("units depths operation",A),dn("pointer depth",v),new ResizeObserver(()=>!Us()&&r.clientWidth!==Number(o[0]?.picture.getAttribute("width"))&&u()).observe(r),{element:ht("div",{},R,f,r),redraw:A,full:i}}var bn=gm();xd(bn.dimensions);var $f=Nr(bn),a1=bn.runs.at(-1);Object.assign(Qt,{units:bn.units,operation:a1?.operation??$f.at(-1),depth:(bn.well.md_m.at(-1)??0)/2});var Ri={answers:Id(bn),tracks:C0(bn)};bn.runs.length&&(Ri.history=am(bn),Ri.contact=pm(bn));bn.well.md_m.length>1&&(Ri.scene=S0(bn));var js=(n,t,...e)=>ht("section",{id:n},ht("h2",{},t),e),Yf=n=>bn.sheets.filter(t=>t.place===n).map(Ad);function l1(n){let t=n.history.time_s.length,e=t<n.samples?`${n.samples} samples are drawn as ${t}, the smallest and the largest of each few: peaks keep their height`:`all ${n.samples} samples are drawn`,{frames:i}=n,s=i&&(i.time_s.length<i.kept?`; ${i.time_s.length} of ${i.kept} frames`:`; all ${i.kept} frames`),r=i&&i.md_m.length<i.nodes?`, ${i.md_m.length} of ${i.nodes} nodes`:"";return`${sr(n.operation)}: ${e}${s??""}${r}.`}var Th=document.getElementById("page"),P0=$f.length>1?nr("Operation",$f.map(n=>[n,sr(n)]),Qt.operation,n=>rn({operation:n,times:null,moment:null})):null;Th.append(_m(bn.title,Pd(bn),()=>Object.values(Ri).forEach(n=>n.redraw())),js("answer","Answer",P0&&ht("div",{class:"operations"},P0),Ri.answers.element),js("tracks","Along the hole",Ri.tracks.element));var Zf=[];Ri.history&&Zf.push(js("history","In time",Ri.history.element),js("contact","Contact over depth and time",Ri.contact.element));Th.append(...Zf);Ri.scene&&Th.append(js("scene","In space",Ri.scene.element));Th.append(js("results","All numbers",Yf("results")),...bn.runs.length?[js("numerics","Numerics",Yf("numerics"))]:[],js("inputs","Inputs, defaults included",Yf("inputs")),ht("footer",{},ht("p",{},`Made by ${bn.program}. The tables beside this file hold every digit; this page holds what can be seen. `,bn.runs.map(l1).join(" ")),ht("details",{},ht("summary",{},"Plots by uPlot, 3D by three.js: their licences (MIT)"),ht("pre",{},document.getElementById("licences").content.textContent))));var I0=()=>Zf.forEach(n=>n.toggleAttribute("hidden",!Xn(bn)));dn("operation",I0);I0();Object.values(Ri).forEach(n=>n.redraw());document.documentElement.dataset.ready="";})();

(()=>{var F0="http://www.w3.org/2000/svg";function pd(n,t,e){for(let[i,s]of Object.entries(t??{}))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):n.setAttribute(i,s===!0?"":s));for(let i of e.flat(3))i!=null&&n.append(i);return n}function ct(n,t,...e){return pd(document.createElement(n),t,e)}function ne(n,t,...e){return pd(document.createElementNS(F0,n),t,e)}function Dr(n,t,e,i){let s=t.map(([r,o])=>ct("button",{type:"button","aria-pressed":String(r===e),"data-value":r,onclick:()=>{for(let a of s)a.setAttribute("aria-pressed",String(a===s[t.findIndex(l=>l[0]===r)]));i(r)}},o));return ct("div",{class:"choice",role:"group","aria-label":n},s)}function md(n,t,e,i){return ct("label",{class:"select"},n,ct("select",{onchange:s=>i(s.target.value)},t.map(([s,r])=>ct("option",{value:s,selected:s===e},r))))}var qa=new Map,te={units:"si",theme:"auto",operation:null,depths:null,times:null,depth:null,moment:null,pointer:null};function fn(n,t){for(let e of n.split(" "))qa.has(e)||qa.set(e,[]),qa.get(e).push(t)}function dn(n){let t=new Set;for(let[e,i]of Object.entries(n))if(!Object.is(te[e],i)){te[e]=i;for(let s of qa.get(e)??[])t.add(s)}for(let e of t)e()}var O0=["si","metric","field"],gd={};function _d(n){gd=n}function Ya(n){return gd[n]?.[O0.indexOf(te.units)]??{symbol:"",factor:1}}var Rn=n=>Ya(n).symbol,De=(n,t)=>n/Ya(t).factor,Li=(n,t)=>n*Ya(t).factor;function xd(n,t){let e=Ya(t).factor;return Array.from(n,i=>Number.isFinite(i)?i/e:null)}function Un(n,t=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.abs(n);if(e>=1e9||e<1e-4){let[r,o]=n.toExponential(t-1).split("e");return`${yd(String(Number(r)))}·10${B0(Number(o))}`}let i=Math.floor(Math.log10(e))+1,s=Math.min(Math.max(t-i,0),6);return Ds(n.toFixed(s))}function B0(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}var yd=n=>n.replace("-","−");function Ds(n){let[t,e]=n.split("."),i=t.replace("-","").length>4?t.replace(/\B(?=(\d{3})+$)/g," "):t;return yd(e===void 0?i:`${i}.${e}`)}function $a(n,t=6){let e=Un(n,t);return/\.\d*0$/.test(e)?e.replace(/\.?0+$/,""):e}function pn(n,t,e=4,i=Un){let s=Rn(t),r=i(De(n,t),e);return s===""?r:`${r} ${s}`}var vd=n=>Number.isInteger(n)&&Math.abs(n)<1e12?Ds(String(n)):$a(n);function nr(n,t){return n===null||n===""?"–":typeof n=="string"?n:typeof n=="number"?vd(n):pn(n.value,n.dimension,t??6,t?Un:$a)}function z0(n){return n===null||typeof n!="object"?nr(n):$a(De(n.value,n.dimension))}function k0(n,t){if(n===null||typeof n!="object")return nr(n);let e=r=>Math.abs(r)<1e-6*t?0:r,i=e(De(n.value,n.dimension)),s=n.dimension==="ratio"&&Number.isInteger(i)?vd(i):Un(i,5);return n.std===void 0?s:`${s} ± ${Un(e(De(n.std,n.dimension)),2)}`}function Md(n){let t=new Set(n.filter(e=>e!==null&&typeof e=="object").map(e=>e.dimension));return t.size===1?[...t][0]:null}var Sd=n=>n&&Rn(n)!==""?ct("span",{class:"unit"},` ${Rn(n)}`):null,V0=n=>typeof n=="string";function G0(n){let t=e=>Math.max(...e.map(i=>i?.dimension?Math.abs(De(i.value,i.dimension)):0));return n.rows.map(([e,...i])=>ct("tr",{},ct("th",{scope:"row"},e,Sd(Md(i))),i.map(s=>ct("td",{class:"number"},k0(s,t(i))))))}function H0(n){return n.rows.map(t=>ct("tr",{},t.map(e=>ct("td",{class:V0(e)?null:"number"},z0(e)))))}function W0(n){return n.rows.map(([t,e])=>ct("tr",{},ct("th",{scope:"row"},t),ct("td",{},nr(e))))}function bd(n){let t=ct("tbody",{}),e=ct("thead",{}),i=n.place!=="inputs",s=()=>{t.replaceChildren(...i?G0(n):n.heads.length?H0(n):W0(n));let a=l=>i?null:Sd(Md(n.rows.map(c=>c[l])));n.heads.length&&e.replaceChildren(ct("tr",{},n.heads.map((l,c)=>ct("th",{scope:"col"},l,a(c)))))};fn("units",s),s();let r=ct("div",{class:"scrolls"},ct("table",{class:n.heads.length?"grid":"keys"},e,t));if(i)return ct("div",{class:"sheet"},ct("h3",{},n.title),r);let o=n.rows.length>24;return ct("details",{class:`sheet prints${n.heads.length>4?" wide":""}`,open:!o},ct("summary",{},n.title,o?` (${n.rows.length} rows)`:""),r)}var rn=n=>getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim(),Fo=n=>rn(`line-${n%7}`);function wd(n){let t=parseInt(n.slice(1),16);return[t>>16,t>>8&255,t&255]}var X0=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"].map(wd);function q0(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,o)=>r+s*(n[i+1][o]-r))}var Fh=512;function Za(n){let t=n?["low-side-strong","low-side","middle","high-side","high-side-strong"].map(i=>wd(rn(i))):X0,e=Array.from({length:Fh+1},(i,s)=>q0(t,s/Fh));return i=>e[Math.round(Math.min(Math.max(i,0),1)*Fh)]}var ir=n=>n.replaceAll("_"," "),Ja=n=>n==="soft"?"soft string":"dynamics",Nr=n=>[...new Set(n.solved.map(t=>t.operation))];function Ka(n,t){let e=Nr(n),i=t.model==="soft",s=new Set(n.solved.map(o=>o.model)).size>1,r=e.indexOf(t.operation);return{colour:Fo(e.length===1&&s&&i?1:r),dashed:s&&i}}function Td(n,t){return Nr(n).length===1?Ja(t.model):new Set(n.solved.map(i=>i.model)).size===1?ir(t.operation):`${ir(t.operation)}, ${Ja(t.model)}`}var yi=(n,t)=>n.solved.find(e=>e.operation===te.operation&&e.model===t),Xn=n=>n.runs.find(t=>t.operation===te.operation);function Ed(n){let t=ct("dl",{class:"asked"}),e=()=>t.replaceChildren(...n.asked.map(({label:i,value:s})=>ct("div",{},ct("dt",{},i),ct("dd",{},nr(s)))));return fn("units",e),e(),t}function Y0(n){return n>1?["over","over the limit"]:n>.8?["near","near the limit"]:["within","within the limit"]}function $0(n,t){let e=n.value?.dimension,i=[ct("h3",{},n.label),ct("p",{class:"number"},nr(n.value,e==="ratio"||e==="percent"?3:4))];n.worst!==null&&e&&i.push(ct("p",{class:"note"},`mean; at most ${pn(n.worst,e)}`)),t?.value?.dimension===e&&e&&i.push(ct("p",{class:"note"},`soft string ${nr(t.value,4)}`));let s=n.worst??n.value?.value;if(n.limit!==null&&Number.isFinite(s)){let r=s/n.limit,[o,a]=Y0(r);i.push(ct("div",{class:`limit ${o}`},ct("div",{class:"bar"},ct("div",{class:"used",style:`width:${Math.min(Math.max(r,0),1)*100}%`})),ct("p",{class:"note"},ct("strong",{},`${Math.round(r*100)} %, ${a}`),ct("br"),`${n.limit_label} ${e==="percent"||e==="ratio"?"":pn(n.limit,e)}`)))}else i.push(ct("p",{class:"note"},n.limit_label));return ct("div",{class:"card answer"},i)}function Ad(n){let t=ct("div",{}),e=()=>{let i=yi(n,"dynamic"),s=yi(n,"soft"),r=i??s,o=l=>i&&s?.answers.find(c=>c.label===l.label),a=[i,s].filter(l=>l?.message).map(l=>ct("p",{class:"warning"},`${Ja(l.model)}: ${l.message}`));t.replaceChildren(...a,ct("div",{class:"answers"},r.answers.map(l=>$0(l,o(l)))))};return fn("units operation",e),{element:t,redraw:e}}var Z0="uplot",J0="u-hz",K0="u-vt",j0="u-title",Q0="u-wrap",t_="u-under",e_="u-over",n_="u-axis",or="u-off",i_="u-select",s_="u-cursor-x",r_="u-cursor-y",o_="u-cursor-pt",a_="u-legend",l_="u-live",c_="u-inline",h_="u-series",u_="u-marker",Rd="u-label",f_="u-value",Bo="width",zo="height";var Cd="bottom",Ur="left",Oh="right",tu="#000",Pd=tu+"0",Bh="mousemove",Id="mousedown",zh="mouseup",Ld="mouseenter",Dd="mouseleave",Nd="dblclick",d_="resize",p_="scroll",Ud="change",nl="dppxchange",eu="--",Gr=typeof window<"u",Wh=Gr?document:null,Or=Gr?window:null,m_=Gr?navigator:null,Pe,ja;function Xh(){let n=devicePixelRatio;Pe!=n&&(Pe=n,ja&&Yh(Ud,ja,Xh),ja=matchMedia(`(min-resolution: ${Pe-.001}dppx) and (max-resolution: ${Pe+.001}dppx)`),ar(Ud,ja,Xh),Or.dispatchEvent(new CustomEvent(nl)))}function oi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function qh(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ze(n,t,e){n.style[t]=e+"px"}function Di(n,t,e,i){let s=Wh.createElement(n);return t!=null&&oi(s,t),e?.insertBefore(s,i),s}function vi(n,t){return Di("div",n,t)}var Fd=new WeakMap;function Ki(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Fd.get(n);r!=o&&(n.style.transform=r,Fd.set(n,r),t<0||e<0||t>i||e>s?oi(n,or):qh(n,or))}var Od=new WeakMap;function Bd(n,t,e){let i=t+e,s=Od.get(n);i!=s&&(Od.set(n,i),n.style.background=t,n.style.borderColor=e)}var zd=new WeakMap;function kd(n,t,e,i){let s=t+""+e,r=zd.get(n);s!=r&&(zd.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var nu={passive:!0},g_={...nu,capture:!0};function ar(n,t,e,i){t.addEventListener(n,e,i?g_:nu)}function Yh(n,t,e,i){t.removeEventListener(n,e,nu)}Gr&&Xh();function Ni(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ai((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function pp(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var mp=n=>n!=null,gp=n=>n!=null&&n>0,rl=pp(mp),__=pp(gp);function x_(n,t,e,i=0,s=!1){let r=s?__:rl,o=s?gp:mp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ve,l??-Ve]}function ol(n,t,e,i){let s=Hd(n),r=Hd(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?hs:_p,a=s==1?ai:Mi,l=r==1?Mi:ai,c=a(o(yn(n))),u=l(o(yn(t))),f=Br(e,c),h=Br(e,u);return e==10&&(c<0&&(f=Ge(f,-c)),u<0&&(h=Ge(h,-u))),i||e==2?(n=f*s,t=h*r):(n=Mp(n,f),t=al(t,h)),[n,t]}function iu(n,t,e,i){let s=ol(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var su=.1,Vd={mode:3,pad:su},Vo={pad:0,soft:null,mode:0},y_={min:Vo,max:Vo};function il(n,t,e,i){return ll(e)?Gd(n,t,e):(Vo.pad=e,Vo.soft=i?0:null,Vo.mode=i?3:0,Gd(n,t,y_))}function Ee(n,t){return n??t}function v_(n,t,e){for(t=Ee(t,0),e=Ee(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Gd(n,t,e){let i=e.min,s=e.max,r=Ee(i.pad,0),o=Ee(s.pad,0),a=Ee(i.hard,-Ve),l=Ee(s.hard,Ve),c=Ee(i.soft,Ve),u=Ee(s.soft,-Ve),f=Ee(i.mode,0),h=Ee(s.mode,0),d=t-n,m=hs(d),M=qn(yn(n),yn(t)),g=hs(M),p=yn(g-m);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,f==2&&c!=Ve&&(r=0),h==2&&u!=-Ve&&(o=0)));let y=d||M||1e3,w=hs(y),v=Br(10,ai(w)),C=y*(d==0?n==0?.1:1:r),A=Ge(Mp(n-C,v/10),24),_=n>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Ve,S=qn(a,A<_&&n>=_?_:Ui(_,A)),N=y*(d==0?t==0?.1:1:o),R=Ge(al(t+N,v/10),24),P=t<=u&&(h==1||h==3&&R>=u||h==2&&R<=u)?u:-Ve,O=Ui(l,R>P&&t<=P?P:qn(P,R));return S==O&&S==0&&(O=100),[S,O]}var M_=new Intl.NumberFormat(Gr?m_.language:"en-US"),ru=n=>M_.format(n),li=Math,el=li.PI,yn=li.abs,ai=li.floor,xn=li.round,Mi=li.ceil,Ui=li.min,qn=li.max,Br=li.pow,Hd=li.sign,hs=li.log10,_p=li.log2,S_=(n,t=1)=>li.sinh(n)*t,kh=(n,t=1)=>li.asinh(n/t),Ve=1/0;function Wd(n){return(hs((n^n>>31)-(n>>31))|0)+1}function $h(n,t,e){return Ui(qn(n,t),e)}function xp(n){return typeof n=="function"}function Se(n){return xp(n)?n:()=>n}var b_=()=>{},yp=n=>n,vp=(n,t)=>t,w_=n=>null,Xd=n=>!0,qd=(n,t)=>n==t,T_=/\.\d*?(?=9{6,}|0{6,})/gm,lr=n=>{if(bp(n)||Us.has(n))return n;let t=`${n}`,e=t.match(T_);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${lr(s)}e${r}`}return Ge(n,i)};function sr(n,t){return lr(Ge(lr(n/t))*t)}function al(n,t){return lr(Mi(lr(n/t))*t)}function Mp(n,t){return lr(ai(lr(n/t))*t)}function Ge(n,t=0){if(bp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return xn(i)/e}var Us=new Map;function Sp(n){return((""+n).split(".")[1]||"").length}function Ho(n,t,e,i){let s=[],r=i.map(Sp);for(let o=t;o<e;o++){let a=yn(o),l=Ge(Br(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ge(u,f);s.push(h),Us.set(h,f)}}return s}var Go={},ou=[],zr=[null,null],Ns=Array.isArray,bp=Number.isInteger,E_=n=>n===void 0;function Yd(n){return typeof n=="string"}function ll(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function A_(n){return n!=null&&typeof n=="object"}var R_=Object.getPrototypeOf(Uint8Array),wp="__proto__";function kr(n,t=ll){let e;if(Ns(n)){let i=n.find(s=>s!=null);if(Ns(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=kr(n[s],t)}else e=n.slice()}else if(n instanceof R_)e=n.slice();else if(t(n)){e={};for(let i in n)i!=wp&&(e[i]=kr(n[i],t))}else e=n;return e}function mn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=wp&&(ll(n[s])?mn(n[s],kr(i[s])):n[s]=kr(i[s]))}return n}var C_=0,P_=1,I_=2;function L_(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function D_(n,t){if(F_(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return O_(o[0])||(o=U_(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=t?t[o][c]:P_,d=[];for(let m=0;m<u.length;m++){let M=u[m],g=r.get(l[m]);M===null?h!=C_&&(f[g]=M,h==I_&&d.push(g)):f[g]=M}L_(f,d,s),i.push(f)}}return i}var N_=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function U_(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function F_(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function O_(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=qn(1,ai((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Tp=["January","February","March","April","May","June","July","August","September","October","November","December"],Ep=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Ap(n){return n.slice(0,3)}var B_=Ep.map(Ap),z_=Tp.map(Ap),k_={MMMM:Tp,MMM:z_,WWWW:Ep,WWW:B_};function Oo(n){return(n<10?"0":"")+n}function V_(n){return(n<10?"00":n<100?"0":"")+n}var G_={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Oo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Oo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Oo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Oo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Oo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>V_(n.getMilliseconds())};function au(n,t){t=t||k_;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?G_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var H_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function W_(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==H_?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Rp=n=>n%1==0,sl=[1,2,2.5,5],X_=Ho(10,-32,0,sl),Cp=Ho(10,0,32,sl),q_=Cp.filter(Rp),rr=X_.concat(Cp),lu=`
`,Pp="{YYYY}",$d=lu+Pp,Ip="{M}/{D}",ko=lu+Ip,Qa=ko+"/{YY}",Lp="{aa}",Y_="{h}:{mm}",Fr=Y_+Lp,Zd=lu+Fr,Jd=":{ss}",Ne=null;function Dp(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ho(10,0,3,sl).filter(Rp):Ho(10,-3,0,sl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Pp,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",$d,Ne,Ne,Ne,Ne,Ne,1],[s,Ip,$d,Ne,Ne,Ne,Ne,Ne,1],[i,"{h}"+Lp,Qa,Ne,ko,Ne,Ne,Ne,1],[e,Fr,Qa,Ne,ko,Ne,Ne,Ne,1],[t,Jd,Qa+" "+Fr,Ne,ko+" "+Fr,Ne,Zd,Ne,1],[n,Jd+".{fff}",Qa+" "+Fr,Ne,ko+" "+Fr,Ne,Zd,Ne,1]];function u(f){return(h,d,m,M,g,p)=>{let y=[],w=g>=o,v=g>=r&&g<o,C=f(m),A=Ge(C*n,3),_=Vh(C.getFullYear(),w?0:C.getMonth(),v||w?1:C.getDate()),S=Ge(_*n,3);if(v||w){let N=v?g/r:0,R=w?g/o:0,P=A==S?A:Ge(Vh(_.getFullYear()+R,_.getMonth()+N,1)*n,3),O=new Date(xn(P/n)),V=O.getFullYear(),L=O.getMonth();for(let k=0;P<=M;k++){let H=Vh(V+R*k,L+N*k,1),F=H-f(Ge(H*n,3));P=Ge((+H+F)*n,3),P<=M&&y.push(P)}}else{let N=g>=s?s:g,R=ai(m)-ai(A),P=S+R+al(A-S,N);y.push(P);let O=f(P),V=O.getHours()+O.getMinutes()/e+O.getSeconds()/i,L=g/i,k=h.axes[d]._space,H=p/k;for(;P=Ge(P+g,n==1?0:3),!(P>M);)if(L>1){let F=ai(Ge(V+L,6))%24,$=f(P).getHours()-F;$>1&&($=-1),P-=$*i,V=(V+L)%24;let tt=y[y.length-1];Ge((P-tt)/g,3)*H>=.7&&y.push(P)}else y.push(P)}return y}}return[l,c,u]}var[$_,Z_,J_]=Dp(1),[K_,j_,Q_]=Dp(.001);Ho(2,-53,53,[1]);function Kd(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function jd(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,f,h,d;return i.map(m=>{let M=n(m),g=M.getFullYear(),p=M.getMonth(),y=M.getDate(),w=M.getHours(),v=M.getMinutes(),C=M.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||y!=u&&a[4]||w!=f&&a[5]||v!=h&&a[6]||C!=d&&a[7]||a[1];return l=g,c=p,u=y,f=w,h=v,d=C,A(M)})}}function tx(n,t){let e=au(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Vh(n,t,e){return new Date(n,t,e)}function Qd(n,t){return t(n)}var ex="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function tp(n,t){return(e,i,s,r)=>r==null?eu:t(n(i))}function nx(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function ix(n,t){return n.series[t].fill(n,t)}var sx={show:!0,live:!0,isolate:!1,mount:b_,markers:{show:!0,width:2,stroke:nx,fill:ix,dash:"solid"},idx:null,idxs:null,values:[]};function rx(n,t){let e=n.cursor.points,i=vi(),s=e.size(n,t);Ze(i,Bo,s),Ze(i,zo,s);let r=s/-2;Ze(i,"marginLeft",r),Ze(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ze(i,"borderWidth",o),i}function ox(n,t){let e=n.series[t].points;return e._fill||e._stroke}function ax(n,t){let e=n.series[t].points;return e._stroke||e._fill}function lx(n,t){return n.series[t].points.size}var Gh=[0,0];function cx(n,t,e){return Gh[0]=t,Gh[1]=e,Gh}function tl(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Hh(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var hx={show:!0,x:!0,y:!0,lock:!1,move:cx,points:{one:!1,show:rx,size:lx,width:0,stroke:ax,fill:ox},bind:{mousedown:tl,mouseup:tl,click:tl,dblclick:tl,mousemove:Hh,mouseleave:Hh,mouseenter:Hh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Np={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},cu=mn({},Np,{filter:vp}),Up=mn({},cu,{size:10}),Fp=mn({},Np,{show:!1}),hu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Op="bold "+hu,Bp=1.5,ep={show:!0,scale:"x",stroke:tu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Op,side:2,grid:cu,ticks:Up,border:Fp,font:hu,lineGap:Bp,rotate:0},ux="Value",fx="Time",np={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function dx(n,t,e,i,s){return t.map(r=>r==null?"":ru(r))}function px(n,t,e,i,s,r,o){let a=[],l=Us.get(s)||0;e=o?e:Ge(al(e,s),l);for(let c=e;c<=i;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Zh(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?hs:_p,u=ai(c(e));s=Br(l,u),l==10&&(s=rr[Ni(s,rr)]);let f=e,h=s*l;l==10&&(h=rr[Ni(h,rr)]);do a.push(f),f=f+s,l==10&&!Us.has(f)&&(f=Ge(f,Us.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=rr[Ni(h,rr)]));while(f<=i);return a}function mx(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Zh(n,t,qn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Zh(n,t,qn(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var zp=/./,gx=/[12357]/,_x=/[125]/,ip=/1/,Jh=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function xx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?zp:l(7,o)-u>=c?gx:l(5,o)-u>=c?_x:ip;if(f==ip){let h=yn(l(1,o)-u);if(h<c)return Jh(t.slice().reverse(),a.distr,f,Mi(c/h)).reverse()}return Jh(t,a.distr,f,1)}function yx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=yn(l(1,o)-l(2,o));return c<a?Jh(t.slice().reverse(),3,zp,Mi(a/c)).reverse():t}function vx(n,t,e,i){return i==null?eu:t==null?"":ru(t)}var sp={show:!0,scale:"y",stroke:tu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Op,side:3,grid:cu,ticks:Up,border:Fp,font:hu,lineGap:Bp,rotate:0};function Mx(n,t){let e=3+(n||1)*2;return Ge(e*t,3)}function Sx(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=yn(o-r),l=n.series[t],c=a/(l.points.space*Pe);return i[1]-i[0]<=c}var rp={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},kp=(n,t,e,i,s)=>s,op={show:!0,auto:!0,sorted:0,gaps:kp,alpha:1,facets:[mn({},rp,{scale:"x"}),mn({},rp,{scale:"y"})]},ap={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:kp,alpha:1,points:{show:Sx,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function bx(n,t,e,i,s){return e/10}var Vp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},wx=mn({},Vp,{time:!1,ori:1}),lp={};function Gp(n,t){let e=lp[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(lp[n]=e)),e}var Vr=1,Kh=2;function cr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,m=a.width,M=a.height,g=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,f,g,p,h,d,m,M,hl,Hr,fl,Wp,qp):e(s,l,c,u,f,p,g,d,h,M,m,ul,Wr,du,Xp,Yp)}function uu(n,t){let e=0,i=0,s=Ee(n.bands,ou);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Tx(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function us(n,t,e,i,s,r){return cr(n,t,(o,a,l,c,u,f,h,d,m,M,g)=>{let p=o.pxRound,y=c.dir*(c.ori==0?1:-1),w=c.ori==0?Hr:Wr,v,C;y==1?(v=e,C=i):(v=i,C=e);let A=p(f(a[v],c,M,d)),_=p(h(l[v],u,g,m)),S=p(f(a[C],c,M,d)),N=p(h(r==1?u.max:u.min,u,g,m)),R=new Path2D(s);return w(R,S,N),w(R,A,N),w(R,A,_),R})}function cl(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?fl:du,l=e;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Ex(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function fu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let d=r(n[f]),m=h==f?d:r(n[h]),M=f-s;d=o<=0&&M>=0&&M<l?r(n[M]):d;let p=h+s;m=o>=0&&p>=0&&p<l?r(n[p]):m,m>=d&&a.push([d,m])}return a}function cp(n){return n==0?yp:n==1?xn:t=>sr(t,n)}function Hp(n){let t=n==0?hl:ul,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ui(c,a/2,l/2),u=Ui(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var hl=(n,t,e)=>{n.moveTo(t,e)},ul=(n,t,e)=>{n.moveTo(e,t)},Hr=(n,t,e)=>{n.lineTo(t,e)},Wr=(n,t,e)=>{n.lineTo(e,t)},fl=Hp(0),du=Hp(1),Wp=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Xp=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},qp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Yp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function $p(n){return(t,e,i,s,r)=>cr(t,e,(o,a,l,c,u,f,h,d,m,M,g)=>{let{pxRound:p,points:y}=o,w,v;c.ori==0?(w=hl,v=Wp):(w=ul,v=Xp);let C=Ge(y.width*Pe,3),A=(y.size-y.width)/2*Pe,_=Ge(A*2,3),S=new Path2D,N=new Path2D,{left:R,top:P,width:O,height:V}=t.bbox;fl(N,R-_,P-_,O+_*2,V+_*2);let L=k=>{if(l[k]!=null){let H=p(f(a[k],c,M,d)),F=p(h(l[k],u,g,m));w(S,H+A,F),v(S,H,F,A,0,el*2)}};if(r)r.forEach(L);else for(let k=i;k<=s;k++)L(k);return{stroke:C>0?S:null,fill:S,clip:N,flags:Vr|Kh}})}function Zp(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var Ax=Zp(Hr),Rx=Zp(Wr);function Jp(n){let t=Ee(n?.alignGaps,0);return(e,i,s,r)=>cr(e,i,(o,a,l,c,u,f,h,d,m,M,g)=>{[s,r]=rl(l,s,r);let p=o.pxRound,y=V=>p(f(V,c,M,d)),w=V=>p(h(V,u,g,m)),v,C;c.ori==0?(v=Hr,C=Ax):(v=Wr,C=Rx);let A=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vr},S=_.stroke,N=!1;if(r-s>=M*4){let V=nt=>e.posToVal(nt,c.key,!0),L=null,k=null,H,F,Q,W=y(a[A==1?s:r]),$=y(a[s]),tt=y(a[r]),ht=V(A==1?$+1:tt-1);for(let nt=A==1?s:r;nt>=s&&nt<=r;nt+=A){let Z=a[nt],pt=(A==1?Z<ht:Z>ht)?W:y(Z),St=l[nt];pt==W?St!=null?(F=St,L==null?(v(S,pt,w(F)),H=L=k=F):F<L?L=F:F>k&&(k=F)):St===null&&(N=!0):(L!=null&&C(S,W,w(L),w(k),w(H),w(F)),St!=null?(F=St,v(S,pt,w(F)),L=k=H=F):(L=k=null,St===null&&(N=!0)),W=pt,ht=V(W+A))}L!=null&&L!=k&&Q!=W&&C(S,W,w(L),w(k),w(H),w(F))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let L=l[V];L===null?N=!0:L!=null&&v(S,y(a[V]),w(L))}let[P,O]=uu(e,i);if(o.fill!=null||P!=0){let V=_.fill=new Path2D(S),L=o.fillTo(e,i,o.min,o.max,P),k=w(L),H=y(a[s]),F=y(a[r]);A==-1&&([F,H]=[H,F]),v(V,F,k),v(V,H,k)}if(!o.spanGaps){let V=[];N&&V.push(...fu(a,l,s,r,A,y,t)),_.gaps=V=o.gaps(e,i,s,r,V),_.clip=cl(V,c.ori,d,m,M,g)}return O!=0&&(_.band=O==2?[us(e,i,s,r,S,-1),us(e,i,s,r,S,1)]:us(e,i,s,r,S,O)),_})}function Cx(n){let t=Ee(n.align,1),e=Ee(n.ascDesc,!1),i=Ee(n.alignGaps,0),s=Ee(n.extend,!1);return(r,o,a,l)=>cr(r,o,(c,u,f,h,d,m,M,g,p,y,w)=>{[a,l]=rl(f,a,l);let v=c.pxRound,{left:C,width:A}=r.bbox,_=$=>v(m($,h,y,g)),S=$=>v(M($,d,w,p)),N=h.ori==0?Hr:Wr,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Vr},P=R.stroke,O=h.dir*(h.ori==0?1:-1),V=S(f[O==1?a:l]),L=_(u[O==1?a:l]),k=L,H=L;s&&t==-1&&(H=C,N(P,H,V)),N(P,L,V);for(let $=O==1?a:l;$>=a&&$<=l;$+=O){let tt=f[$];if(tt==null)continue;let ht=_(u[$]),nt=S(tt);t==1?N(P,ht,V):N(P,k,nt),N(P,ht,nt),V=nt,k=ht}let F=k;s&&t==1&&(F=C+A,N(P,F,V));let[Q,W]=uu(r,o);if(c.fill!=null||Q!=0){let $=R.fill=new Path2D(P),tt=c.fillTo(r,o,c.min,c.max,Q),ht=S(tt);N($,F,ht),N($,H,ht)}if(!c.spanGaps){let $=[];$.push(...fu(u,f,a,l,O,_,i));let tt=c.width*Pe/2,ht=e||t==1?tt:-tt,nt=e||t==-1?-tt:tt;$.forEach(Z=>{Z[0]+=ht,Z[1]+=nt}),R.gaps=$=c.gaps(r,o,a,l,$),R.clip=cl($,h.ori,g,p,y,w)}return W!=0&&(R.band=W==2?[us(r,o,a,l,P,-1),us(r,o,a,l,P,1)]:us(r,o,a,l,P,W)),R})}function hp(n,t,e,i,s,r,o=Ve){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=yn(n[l]-n[a]);u<c&&(c=u,o=yn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function Px(n){n=n||Go;let t=Ee(n.size,[.6,Ve,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Se(s),o=1-t[0],a=Ee(t[1],Ve),l=Ee(t[2],1),c=Ee(n.disp,Go),u=Ee(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,m,M,g)=>cr(d,m,(p,y,w,v,C,A,_,S,N,R,P)=>{let O=p.pxRound,V=e,L=i*Pe,k=a*Pe,H=l*Pe,F,Q;v.ori==0?[F,Q]=r(d,m):[Q,F]=r(d,m);let W=v.dir*(v.ori==0?1:-1),$=v.ori==0?fl:du,tt=v.ori==0?u:(Pt,Ft,Jt,bt,Fe,Gt,Kt)=>{u(Pt,Ft,Jt,Fe,bt,Kt,Gt)},ht=Ee(d.bands,ou).find(Pt=>Pt.series[0]==m),nt=ht!=null?ht.dir:0,Z=p.fillTo(d,m,p.min,p.max,nt),dt=O(_(Z,C,P,N)),pt,St,xt,Wt=R,mt=O(p.width*Pe),yt=!1,Xt=null,qt=null,Yt=null,ie=null;f!=null&&(mt==0||h!=null)&&(yt=!0,Xt=f.values(d,m,M,g),qt=new Map,new Set(Xt).forEach(Pt=>{Pt!=null&&qt.set(Pt,new Path2D)}),mt>0&&(Yt=h.values(d,m,M,g),ie=new Map,new Set(Yt).forEach(Pt=>{Pt!=null&&ie.set(Pt,new Path2D)})));let{x0:se,size:Ae}=c;if(se!=null&&Ae!=null){V=1,y=se.values(d,m,M,g),se.unit==2&&(y=y.map(Jt=>d.posToVal(S+Jt*R,v.key,!0)));let Pt=Ae.values(d,m,M,g);Ae.unit==2?St=Pt[0]*R:St=A(Pt[0],v,R,S)-A(0,v,R,S),Wt=hp(y,w,A,v,R,S,Wt),xt=Wt-St+L}else Wt=hp(y,w,A,v,R,S,Wt),xt=Wt*o+L,St=Wt-xt;xt<1&&(xt=0),mt>=St/2&&(mt=0),xt<5&&(O=yp);let ge=xt>0,we=Wt-xt-(ge?mt:0);St=O($h(we,H,k)),pt=(V==0?St/2:V==W?0:St)-V*W*((V==0?L/2:0)+(ge?mt/2:0));let ce={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},He=yt?null:new Path2D,Le=null;if(ht!=null)Le=d.data[ht.series[1]];else{let{y0:Pt,y1:Ft}=c;Pt!=null&&Ft!=null&&(w=Ft.values(d,m,M,g),Le=Pt.values(d,m,M,g))}let Re=F*St,B=Q*St;for(let Pt=W==1?M:g;Pt>=M&&Pt<=g;Pt+=W){let Ft=w[Pt];if(Ft==null)continue;if(Le!=null){let q=Le[Pt]??0;if(Ft-q==0)continue;dt=_(q,C,P,N)}let Jt=v.distr!=2||c!=null?y[Pt]:Pt,bt=A(Jt,v,R,S),Fe=_(Ee(Ft,Z),C,P,N),Gt=O(bt-pt),Kt=O(qn(Fe,dt)),I=O(Ui(Fe,dt)),b=Kt-I;if(Ft!=null){let q=Ft<0?B:Re,ut=Ft<0?Re:B;yt?(mt>0&&Yt[Pt]!=null&&$(ie.get(Yt[Pt]),Gt,I+ai(mt/2),St,qn(0,b-mt),q,ut),Xt[Pt]!=null&&$(qt.get(Xt[Pt]),Gt,I+ai(mt/2),St,qn(0,b-mt),q,ut)):$(He,Gt,I+ai(mt/2),St,qn(0,b-mt),q,ut),tt(d,m,Pt,Gt-mt/2,I,St+mt,b)}}return mt>0?ce.stroke=yt?ie:He:yt||(ce._fill=p.width==0?p._fill:p._stroke??p._fill,ce.width=0),ce.fill=yt?qt:He,ce})}function Ix(n,t){let e=Ee(t?.alignGaps,0);return(i,s,r,o)=>cr(i,s,(a,l,c,u,f,h,d,m,M,g,p)=>{[r,o]=rl(c,r,o);let y=a.pxRound,w=F=>y(h(F,u,g,m)),v=F=>y(d(F,f,p,M)),C,A,_;u.ori==0?(C=hl,_=Hr,A=qp):(C=ul,_=Wr,A=Yp);let S=u.dir*(u.ori==0?1:-1),N=w(l[S==1?r:o]),R=N,P=[],O=[];for(let F=S==1?r:o;F>=r&&F<=o;F+=S)if(c[F]!=null){let W=l[F],$=w(W);P.push(R=$),O.push(v(c[F]))}let V={stroke:n(P,O,C,_,A,y),fill:null,clip:null,band:null,gaps:null,flags:Vr},L=V.stroke,[k,H]=uu(i,s);if(a.fill!=null||k!=0){let F=V.fill=new Path2D(L),Q=a.fillTo(i,s,a.min,a.max,k),W=v(Q);_(F,R,W),_(F,N,W)}if(!a.spanGaps){let F=[];F.push(...fu(l,c,r,o,S,w,e)),V.gaps=F=a.gaps(i,s,r,o,F),V.clip=cl(F,u.ori,m,M,g,p)}return H!=0&&(V.band=H==2?[us(i,s,r,o,L,-1),us(i,s,r,o,L,1)]:us(i,s,r,o,L,H)),V})}function Lx(n){return Ix(Dx,n)}function Dx(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,t[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,t[h+1]-l[h+1]*f[h]/3,n[h+1],t[h+1])}return a}var jh=new Set;function up(){for(let n of jh)n.syncRect(!0)}Gr&&(ar(d_,Or,up),ar(p_,Or,up,!0),ar(nl,Or,()=>{Cn.pxRatio=Pe}));var Nx=Jp(),Ux=$p();function fp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Qh(r,o,t,e))}function Fx(n,t){return n.map((e,i)=>i==0?{}:mn({},t,e))}function Qh(n,t,e,i){return mn({},t==0?e:i,n)}function Kp(n,t,e){return t==null?zr:[t,e]}var Ox=Kp;function Bx(n,t,e){return t==null?zr:il(t,e,su,!0)}function jp(n,t,e,i){return t==null?zr:ol(t,e,n.scales[i].log,!1)}var zx=jp;function Qp(n,t,e,i){return t==null?zr:iu(t,e,n.scales[i].log,!1)}var kx=Qp;function Vx(n,t,e,i,s){let r=qn(Wd(n),Wd(t)),o=t-n,a=Ni(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Us.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function dp(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=xn((e=+s)*Pe))+"px"),[n,t,e]}function Gx(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ge(t[2]*Pe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Cn(n,t,e){let i={mode:Ee(n.mode,1)},s=i.mode;function r(x,T,D,U){let X=T.valToPct(x);return U+D*(T.dir==-1?1-X:X)}function o(x,T,D,U){let X=T.valToPct(x);return U+D*(T.dir==-1?X:1-X)}function a(x,T,D,U){return T.ori==0?r(x,T,D,U):o(x,T,D,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=vi(Z0);if(n.id!=null&&(c.id=n.id),oi(c,n.class),n.title){let x=vi(j0,c);x.textContent=n.title}let u=Di("canvas"),f=i.ctx=u.getContext("2d"),h=vi(Q0,c);ar("click",h,x=>{x.target===m&&(qe!=Rr||Ke!=Cr)&&Ln.click(i,x)},!0);let d=i.under=vi(t_,h);h.appendChild(u);let m=i.over=vi(e_,h);n=kr(n);let M=+Ee(n.pxAlign,1),g=cp(M);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let p=n.ms||.001,y=i.series=s==1?fp(n.series||[],np,ap,!1):Fx(n.series||[null],op),w=i.axes=fp(n.axes||[],ep,sp,!0),v=i.scales={},C=i.bands=n.bands||[];C.forEach(x=>{x.fill=Se(x.fill||null),x.dir=Ee(x.dir,-1)});let A=s==2?y[1].facets[0].scale:y[0].scale,_={axes:ls,series:xe},S=(n.drawOrder||["axes","series"]).map(x=>_[x]);function N(x){let T=x.distr==3?D=>hs(D>0?D:x.clamp(i,D,x.min,x.max,x.key)):x.distr==4?D=>kh(D,x.asinh):x.distr==100?D=>x.fwd(D):D=>D;return D=>{let U=T(D),{_min:X,_max:j}=x,lt=j-X;return(U-X)/lt}}function R(x){let T=v[x];if(T==null){let D=(n.scales||Go)[x]||Go;if(D.from!=null){R(D.from);let U=mn({},v[D.from],D,{key:x});U.valToPct=N(U),v[x]=U}else{T=v[x]=mn({},x==A?Vp:wx,D),T.key=x;let U=T.time,X=T.range,j=Ns(X);if((x!=A||s==2&&!U)&&(j&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Vd:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Vd:{mode:1,hard:X[1],soft:X[1]}},j=!1),!j&&ll(X))){let lt=X;X=(gt,Tt,Ut)=>Tt==null?zr:il(Tt,Ut,lt)}T.range=Se(X||(U?Ox:x==A?T.distr==3?zx:T.distr==4?kx:Kp:T.distr==3?jp:T.distr==4?Qp:Bx)),T.auto=Se(j?!1:T.auto),T.clamp=Se(T.clamp||bx),T._min=T._max=null,T.valToPct=N(T)}}}R("x"),R("y"),s==1&&y.forEach(x=>{R(x.scale)}),w.forEach(x=>{R(x.scale)});for(let x in n.scales)R(x);let P=v[A],O=P.distr,V,L;P.ori==0?(oi(c,J0),V=r,L=o):(oi(c,K0),V=o,L=r);let k={};for(let x in v){let T=v[x];(T.min!=null||T.max!=null)&&(k[x]={min:T.min,max:T.max},T.min=T.max=null)}let H=n.tzDate||(x=>new Date(xn(x/p))),F=n.fmtDate||au,Q=p==1?J_(H):Q_(H),W=jd(H,Kd(p==1?Z_:j_,F)),$=tp(H,Qd(ex,F)),tt=[],ht=i.legend=mn({},sx,n.legend),nt=i.cursor=mn({},hx,{drag:{y:s==2}},n.cursor),Z=ht.show,dt=nt.show,pt=ht.markers;ht.idxs=tt,pt.width=Se(pt.width),pt.dash=Se(pt.dash),pt.stroke=Se(pt.stroke),pt.fill=Se(pt.fill);let St,xt,Wt,mt=[],yt=[],Xt,qt=!1,Yt={};if(ht.live){let x=y[1]?y[1].values:null;qt=x!=null,Xt=qt?x(i,1,0):{_:0};for(let T in Xt)Yt[T]=eu}if(Z)if(St=Di("table",a_,c),Wt=Di("tbody",null,St),ht.mount(i,St),qt){xt=Di("thead",null,St,Wt);let x=Di("tr",null,xt);Di("th",null,x);for(var ie in Xt)Di("th",Rd,x).textContent=ie}else oi(St,c_),ht.live&&oi(St,l_);let se={show:!0},Ae={show:!1};function ge(x,T){if(T==0&&(qt||!ht.live||s==2))return zr;let D=[],U=Di("tr",h_,Wt,Wt.childNodes[T]);oi(U,x.class),x.show||oi(U,or);let X=Di("th",null,U);if(pt.show){let gt=vi(u_,X);if(T>0){let Tt=pt.width(i,T);Tt&&(gt.style.border=Tt+"px "+pt.dash(i,T)+" "+pt.stroke(i,T)),gt.style.background=pt.fill(i,T)}}let j=vi(Rd,X);x.label instanceof HTMLElement?j.appendChild(x.label):j.textContent=x.label,T>0&&(pt.show||(j.style.color=x.width>0?pt.stroke(i,T):pt.fill(i,T)),ce("click",X,gt=>{if(nt._lock)return;re(gt);let Tt=y.indexOf(x);if((gt.ctrlKey||gt.metaKey)!=ht.isolate){let Ut=y.some((Ot,zt)=>zt>0&&zt!=Tt&&Ot.show);y.forEach((Ot,zt)=>{zt>0&&Yi(zt,Ut?zt==Tt?se:Ae:se,!0,un.setSeries)})}else Yi(Tt,{show:!x.show},!0,un.setSeries)},!1),oe&&ce(Ld,X,gt=>{nt._lock||(re(gt),Yi(y.indexOf(x),Ir,!0,un.setSeries))},!1));for(var lt in Xt){let gt=Di("td",f_,U);gt.textContent="--",D.push(gt)}return[U,D]}let we=new Map;function ce(x,T,D,U=!0){let X=we.get(T)||{},j=nt.bind[x](i,T,D,U);j&&(ar(x,T,X[x]=j),we.set(T,X))}function He(x,T,D){let U=we.get(T)||{};for(let X in U)(x==null||X==x)&&(Yh(X,T,U[X]),delete U[X]);x==null&&we.delete(T)}let Le=0,Re=0,B=0,Pt=0,Ft=0,Jt=0,bt=Ft,Fe=Jt,Gt=B,Kt=Pt,I=0,b=0,q=0,ut=0;i.bbox={};let ot=!1,vt=!1,wt=!1,it=!1,rt=!1,_t=!1;function z(x,T,D){(D||x!=i.width||T!=i.height)&&at(x,T),de(!1),wt=!0,vt=!0,Nn()}function at(x,T){i.width=Le=B=x,i.height=Re=Pt=T,Ft=Jt=0,Et(),$t();let D=i.bbox;I=D.left=sr(Ft*Pe,.5),b=D.top=sr(Jt*Pe,.5),q=D.width=sr(B*Pe,.5),ut=D.height=sr(Pt*Pe,.5)}let st=3;function At(){let x=!1,T=0;for(;!x;){T++;let D=Tr(T),U=qi(T);x=T==st||D&&U,x||(at(i.width,i.height),vt=!0)}}function Mt({width:x,height:T}){z(x,T)}i.setSize=Mt;function Et(){let x=!1,T=!1,D=!1,U=!1;w.forEach((X,j)=>{if(X.show&&X._show){let{side:lt,_size:gt}=X,Tt=lt%2,Ut=X.label!=null?X.labelSize:0,Ot=gt+Ut;Ot>0&&(Tt?(B-=Ot,lt==3?(Ft+=Ot,U=!0):D=!0):(Pt-=Ot,lt==0?(Jt+=Ot,x=!0):T=!0))}}),Wi[0]=x,Wi[1]=D,Wi[2]=T,Wi[3]=U,B-=Ci[1]+Ci[3],Ft+=Ci[3],Pt-=Ci[2]+Ci[0],Jt+=Ci[0]}function $t(){let x=Ft+B,T=Jt+Pt,D=Ft,U=Jt;function X(j,lt){switch(j){case 1:return x+=lt,x-lt;case 2:return T+=lt,T-lt;case 3:return D-=lt,D+lt;case 0:return U-=lt,U+lt}}w.forEach((j,lt)=>{if(j.show&&j._show){let gt=j.side;j._pos=X(gt,j._size),j.label!=null&&(j._lpos=X(gt,j.labelSize))}})}if(nt.dataIdx==null){let x=nt.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let D=x.prox=Se(x.prox),U=x.bias??=0;nt.dataIdx=(X,j,lt,gt)=>{if(j==0)return lt;let Tt=lt,Ut=D(X,j,lt,gt)??Ve,Ot=Ut>=0&&Ut<Ve,zt=P.ori==0?B:Pt,ue=nt.left,Ce=t[0],Te=t[j];if(T.has(Te[lt])){Tt=null;let ve=null,ee=null,Zt;if(U==0||U==-1)for(Zt=lt;ve==null&&Zt-- >0;)T.has(Te[Zt])||(ve=Zt);if(U==0||U==1)for(Zt=lt;ee==null&&Zt++<Te.length;)T.has(Te[Zt])||(ee=Zt);if(ve!=null||ee!=null)if(Ot){let $e=ve==null?-1/0:V(Ce[ve],P,zt,0),nn=ee==null?1/0:V(Ce[ee],P,zt,0),An=ue-$e,ke=nn-ue;An<=ke?An<=Ut&&(Tt=ve):ke<=Ut&&(Tt=ee)}else Tt=ee==null?ve:ve==null?ee:lt-ve<=ee-lt?ve:ee}else Ot&&yn(ue-V(Ce[lt],P,zt,0))>Ut&&(Tt=null);return Tt}}let re=x=>{nt.event=x};nt.idxs=tt,nt._lock=!1;let ft=nt.points;ft.show=Se(ft.show),ft.size=Se(ft.size),ft.stroke=Se(ft.stroke),ft.width=Se(ft.width),ft.fill=Se(ft.fill);let kt=i.focus=mn({},n.focus||{alpha:.3},nt.focus),oe=kt.prox>=0,It=oe&&ft.one,fe=[],Xe=[],kn=[];function Ro(x,T){let D=ft.show(i,T);if(D instanceof HTMLElement)return oi(D,o_),oi(D,x.class),Ki(D,-10,-10,B,Pt),m.insertBefore(D,fe[T]),D}function Sr(x,T){if(s==1||T>0){let D=s==1&&v[x.scale].time,U=x.value;x.value=D?Yd(U)?tp(H,Qd(U,F)):U||$:U||vx,x.label=x.label||(D?fx:ux)}if(It||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Nx||w_,x.fillTo=Se(x.fillTo||Tx),x.pxAlign=+Ee(x.pxAlign,M),x.pxRound=cp(x.pxAlign),x.stroke=Se(x.stroke||null),x.fill=Se(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let D=Mx(qn(1,x.width),1),U=x.points=mn({},{size:D,width:qn(1,D*.2),stroke:x.stroke,space:D*2,paths:Ux,_stroke:null,_fill:null},x.points);U.show=Se(U.show),U.filter=Se(U.filter),U.fill=Se(U.fill),U.stroke=Se(U.stroke),U.paths=Se(U.paths),U.pxAlign=x.pxAlign}if(Z){let D=ge(x,T);mt.splice(T,0,D[0]),yt.splice(T,0,D[1]),ht.values.push(null)}if(dt){tt.splice(T,0,null);let D=null;It?T==0&&(D=Ro(x,T)):T>0&&(D=Ro(x,T)),fe.splice(T,0,D),Xe.splice(T,0,0),kn.splice(T,0,0)}En("addSeries",T)}function Eh(x,T){T=T??y.length,x=s==1?Qh(x,T,np,ap):Qh(x,T,{},op),y.splice(T,0,x),Sr(y[T],T)}i.addSeries=Eh;function Ga(x){if(y.splice(x,1),Z){ht.values.splice(x,1),yt.splice(x,1);let T=mt.splice(x,1)[0];He(null,T.firstChild),T.remove()}dt&&(tt.splice(x,1),fe.splice(x,1)[0].remove(),Xe.splice(x,1),kn.splice(x,1)),En("delSeries",x)}i.delSeries=Ga;let Wi=[!1,!1,!1,!1];function rs(x,T){if(x._show=x.show,x.show){let D=x.side%2,U=v[x.scale];U==null&&(x.scale=D?y[1].scale:A,U=v[x.scale]);let X=U.time;x.size=Se(x.size),x.space=Se(x.space),x.rotate=Se(x.rotate),Ns(x.incrs)&&x.incrs.forEach(lt=>{!Us.has(lt)&&Us.set(lt,Sp(lt))}),x.incrs=Se(x.incrs||(U.distr==2?q_:X?p==1?$_:K_:rr)),x.splits=Se(x.splits||(X&&U.distr==1?Q:U.distr==3?Zh:U.distr==4?mx:px)),x.stroke=Se(x.stroke),x.grid.stroke=Se(x.grid.stroke),x.ticks.stroke=Se(x.ticks.stroke),x.border.stroke=Se(x.border.stroke);let j=x.values;x.values=Ns(j)&&!Ns(j[0])?Se(j):X?Ns(j)?jd(H,Kd(j,F)):Yd(j)?tx(H,j):j||W:j||dx,x.filter=Se(x.filter||(U.distr>=3&&U.log==10?xx:U.distr==3&&U.log==2?yx:vp)),x.font=dp(x.font),x.labelFont=dp(x.labelFont),x._size=x.size(i,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Wi[T]=!0,x._el=vi(n_,h))}}function os(x,T,D,U){let[X,j,lt,gt]=D,Tt=T%2,Ut=0;return Tt==0&&(gt||j)&&(Ut=T==0&&!X||T==2&&!lt?xn(ep.size/3):0),Tt==1&&(X||lt)&&(Ut=T==1&&!j||T==3&&!gt?xn(sp.size/2):0),Ut}let Co=i.padding=(n.padding||[os,os,os,os]).map(x=>Se(Ee(x,os))),Ci=i._padding=Co.map((x,T)=>x(i,T,Wi,0)),tn,on=null,an=null,Xi=s==1?y[0].idxs:null,ni=null,As=!1;function Po(x,T){if(t=x??[],i.data=i._data=t,s==2){tn=0;for(let D=1;D<y.length;D++)tn+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ni=t[0],tn=ni.length;let D=t;if(O==2){D=t.slice();let U=D[0]=Array(tn);for(let X=0;X<tn;X++)U[X]=X}i._data=t=D}if(de(!0),En("setData"),O==2&&(wt=!0),T!==!1){let D=P;D.auto(i,As)?Io():Ps(A,D.min,D.max),it=it||nt.left>=0,_t=!0,Nn()}}i.setData=Po;function Io(){As=!0;let x,T;s==1&&(tn>0?(on=Xi[0]=0,an=Xi[1]=tn-1,x=t[0][on],T=t[0][an],O==2?(x=on,T=an):x==T&&(O==3?[x,T]=ol(x,x,P.log,!1):O==4?[x,T]=iu(x,x,P.log,!1):P.time?T=x+xn(86400/p):[x,T]=il(x,T,su,!0))):(on=Xi[0]=x=null,an=Xi[1]=T=null)),Ps(A,x,T)}let br,Rs,wr,E,G,et,J,K,Rt,Lt;function Ct(x,T,D,U,X,j){x??=Pd,D??=ou,U??="butt",X??=Pd,j??="round",x!=br&&(f.strokeStyle=br=x),X!=Rs&&(f.fillStyle=Rs=X),T!=wr&&(f.lineWidth=wr=T),j!=G&&(f.lineJoin=G=j),U!=et&&(f.lineCap=et=U),D!=E&&f.setLineDash(E=D)}function Dt(x,T,D,U){T!=Rs&&(f.fillStyle=Rs=T),x!=J&&(f.font=J=x),D!=K&&(f.textAlign=K=D),U!=Rt&&(f.textBaseline=Rt=U)}function Ht(x,T,D,U,X=0){if(U.length>0&&x.auto(i,As)&&(T==null||T.min==null)){let j=Ee(on,0),lt=Ee(an,U.length-1),gt=D.min==null?x_(U,j,lt,X,x.distr==3):[D.min,D.max];x.min=Ui(x.min,D.min=gt[0]),x.max=qn(x.max,D.max=gt[1])}}let le={min:null,max:null};function _e(){for(let U in v){let X=v[U];k[U]==null&&(X.min==null||k[A]!=null&&X.auto(i,As))&&(k[U]=le)}for(let U in v){let X=v[U];k[U]==null&&X.from!=null&&k[X.from]!=null&&(k[U]=le)}k[A]!=null&&de(!0);let x={};for(let U in k){let X=k[U];if(X!=null){let j=x[U]=kr(v[U],A_);if(X.min!=null)mn(j,X);else if(U!=A||s==2)if(tn==0&&j.from==null){let lt=j.range(i,null,null,U);j.min=lt[0],j.max=lt[1]}else j.min=Ve,j.max=-Ve}}if(tn>0){y.forEach((U,X)=>{if(s==1){let j=U.scale,lt=k[j];if(lt==null)return;let gt=x[j];if(X==0){let Tt=gt.range(i,gt.min,gt.max,j);gt.min=Tt[0],gt.max=Tt[1],on=Ni(gt.min,t[0]),an=Ni(gt.max,t[0]),an-on>1&&(t[0][on]<gt.min&&on++,t[0][an]>gt.max&&an--),U.min=ni[on],U.max=ni[an]}else U.show&&U.auto&&Ht(gt,lt,U,t[X],U.sorted);U.idxs[0]=on,U.idxs[1]=an}else if(X>0&&U.show&&U.auto){let[j,lt]=U.facets,gt=j.scale,Tt=lt.scale,[Ut,Ot]=t[X],zt=x[gt],ue=x[Tt];zt!=null&&Ht(zt,k[gt],j,Ut,j.sorted),ue!=null&&Ht(ue,k[Tt],lt,Ot,lt.sorted),U.min=lt.min,U.max=lt.max}});for(let U in x){let X=x[U],j=k[U];if(X.from==null&&(j==null||j.min==null)){let lt=X.range(i,X.min==Ve?null:X.min,X.max==-Ve?null:X.max,U);X.min=lt[0],X.max=lt[1]}}}for(let U in x){let X=x[U];if(X.from!=null){let j=x[X.from];if(j.min==null)X.min=X.max=null;else{let lt=X.range(i,j.min,j.max,U);X.min=lt[0],X.max=lt[1]}}}let T={},D=!1;for(let U in x){let X=x[U],j=v[U];if(j.min!=X.min||j.max!=X.max){j.min=X.min,j.max=X.max;let lt=j.distr;j._min=lt==3?hs(j.min):lt==4?kh(j.min,j.asinh):lt==100?j.fwd(j.min):j.min,j._max=lt==3?hs(j.max):lt==4?kh(j.max,j.asinh):lt==100?j.fwd(j.max):j.max,T[U]=D=!0}}if(D){y.forEach((U,X)=>{s==2?X>0&&T.y&&(U._paths=null):T[U.scale]&&(U._paths=null)});for(let U in T)wt=!0,En("setScale",U);dt&&nt.left>=0&&(it=_t=!0)}for(let U in k)k[U]=null}function Vt(x){let T=$h(on-1,0,tn-1),D=$h(an+1,0,tn-1);for(;x[T]==null&&T>0;)T--;for(;x[D]==null&&D<tn-1;)D++;return[T,D]}function xe(){if(tn>0){let x=y.some(T=>T._focus)&&Lt!=kt.alpha;x&&(f.globalAlpha=Lt=kt.alpha),y.forEach((T,D)=>{if(D>0&&T.show&&(Qe(D,!1),Qe(D,!0),T._paths==null)){let U=Lt;Lt!=T.alpha&&(f.globalAlpha=Lt=T.alpha);let X=s==2?[0,t[D][0].length-1]:Vt(t[D]);T._paths=T.paths(i,D,X[0],X[1]),Lt!=U&&(f.globalAlpha=Lt=U)}}),y.forEach((T,D)=>{if(D>0&&T.show){let U=Lt;Lt!=T.alpha&&(f.globalAlpha=Lt=T.alpha),T._paths!=null&&Oe(D,!1);{let X=T._paths!=null?T._paths.gaps:null,j=T.points.show(i,D,on,an,X),lt=T.points.filter(i,D,j,X);(j||lt)&&(T.points._paths=T.points.paths(i,D,on,an,lt),Oe(D,!0))}Lt!=U&&(f.globalAlpha=Lt=U),En("drawSeries",D)}}),x&&(f.globalAlpha=Lt=1)}}function Qe(x,T){let D=T?y[x].points:y[x];D._stroke=D.stroke(i,x),D._fill=D.fill(i,x)}function Oe(x,T){let D=T?y[x].points:y[x],{stroke:U,fill:X,clip:j,flags:lt,_stroke:gt=D._stroke,_fill:Tt=D._fill,_width:Ut=D.width}=D._paths;Ut=Ge(Ut*Pe,3);let Ot=null,zt=Ut%2/2;T&&Tt==null&&(Tt=Ut>0?"#fff":gt);let ue=D.pxAlign==1&&zt>0;if(ue&&f.translate(zt,zt),!T){let Ce=I-Ut/2,Te=b-Ut/2,ve=q+Ut,ee=ut+Ut;Ot=new Path2D,Ot.rect(Ce,Te,ve,ee)}T?Bt(gt,Ut,D.dash,D.cap,Tt,U,X,lt,j):Be(x,gt,Ut,D.dash,D.cap,Tt,U,X,lt,Ot,j),ue&&f.translate(-zt,-zt)}function Be(x,T,D,U,X,j,lt,gt,Tt,Ut,Ot){let zt=!1;Tt!=0&&C.forEach((ue,Ce)=>{if(ue.series[0]==x){let Te=y[ue.series[1]],ve=t[ue.series[1]],ee=(Te._paths||Go).band;Ns(ee)&&(ee=ue.dir==1?ee[0]:ee[1]);let Zt,$e=null;Te.show&&ee&&v_(ve,on,an)?($e=ue.fill(i,Ce)||j,Zt=Te._paths.clip):ee=null,Bt(T,D,U,X,$e,lt,gt,Tt,Ut,Ot,Zt,ee),zt=!0}}),zt||Bt(T,D,U,X,j,lt,gt,Tt,Ut,Ot)}let _n=Vr|Kh;function Bt(x,T,D,U,X,j,lt,gt,Tt,Ut,Ot,zt){Ct(x,T,D,U,X),(Tt||Ut||zt)&&(f.save(),Tt&&f.clip(Tt),Ut&&f.clip(Ut)),zt?(gt&_n)==_n?(f.clip(zt),Ot&&f.clip(Ot),Me(X,lt),ln(x,j,T)):gt&Kh?(Me(X,lt),f.clip(zt),ln(x,j,T)):gt&Vr&&(f.save(),f.clip(zt),Ot&&f.clip(Ot),Me(X,lt),f.restore(),ln(x,j,T)):(Me(X,lt),ln(x,j,T)),(Tt||Ut||zt)&&f.restore()}function ln(x,T,D){D>0&&(T instanceof Map?T.forEach((U,X)=>{f.strokeStyle=br=X,f.stroke(U)}):T!=null&&x&&f.stroke(T))}function Me(x,T){T instanceof Map?T.forEach((D,U)=>{f.fillStyle=Rs=U,f.fill(D)}):T!=null&&x&&f.fill(T)}function as(x,T,D,U){let X=w[x],j;if(U<=0)j=[0,0];else{let lt=X._space=X.space(i,x,T,D,U),gt=X._incrs=X.incrs(i,x,T,D,U,lt);j=Vx(T,D,gt,U,lt)}return X._found=j}function cn(x,T,D,U,X,j,lt,gt,Tt,Ut){let Ot=lt%2/2;M==1&&f.translate(Ot,Ot),Ct(gt,lt,Tt,Ut,gt),f.beginPath();let zt,ue,Ce,Te,ve=X+(U==0||U==3?-j:j);D==0?(ue=X,Te=ve):(zt=X,Ce=ve);for(let ee=0;ee<x.length;ee++)T[ee]!=null&&(D==0?zt=Ce=x[ee]:ue=Te=x[ee],f.moveTo(zt,ue),f.lineTo(Ce,Te));f.stroke(),M==1&&f.translate(-Ot,-Ot)}function Tr(x){let T=!0;return w.forEach((D,U)=>{if(!D.show)return;let X=v[D.scale];if(X.min==null){D._show&&(T=!1,D._show=!1,de(!1));return}else D._show||(T=!1,D._show=!0,de(!1));let j=D.side,lt=j%2,{min:gt,max:Tt}=X,[Ut,Ot]=as(U,gt,Tt,lt==0?B:Pt);if(Ot==0)return;let zt=X.distr==2,ue=D._splits=D.splits(i,U,gt,Tt,Ut,Ot,zt),Ce=X.distr==2?ue.map(Zt=>ni[Zt]):ue,Te=X.distr==2?ni[ue[1]]-ni[ue[0]]:Ut,ve=D._values=D.values(i,D.filter(i,Ce,U,Ot,Te),U,Ot,Te);D._rotate=j==2?D.rotate(i,ve,U,Ot):0;let ee=D._size;D._size=Mi(D.size(i,ve,U,x)),ee!=null&&D._size!=ee&&(T=!1)}),T}function qi(x){let T=!0;return Co.forEach((D,U)=>{let X=D(i,U,Wi,x);X!=Ci[U]&&(T=!1),Ci[U]=X}),T}function ls(){for(let x=0;x<w.length;x++){let T=w[x];if(!T.show||!T._show)continue;let D=T.side,U=D%2,X,j,lt=T.stroke(i,x),gt=D==0||D==3?-1:1,[Tt,Ut]=T._found;if(T.label!=null){let Hn=T.labelGap*gt,ri=xn((T._lpos+Hn)*Pe);Dt(T.labelFont[0],lt,"center",D==2?"top":Cd),f.save(),U==1?(X=j=0,f.translate(ri,xn(b+ut/2)),f.rotate((D==3?-el:el)/2)):(X=xn(I+q/2),j=ri);let er=xp(T.label)?T.label(i,x,Tt,Ut):T.label;f.fillText(er,X,j),f.restore()}if(Ut==0)continue;let Ot=v[T.scale],zt=U==0?q:ut,ue=U==0?I:b,Ce=T._splits,Te=Ot.distr==2?Ce.map(Hn=>ni[Hn]):Ce,ve=Ot.distr==2?ni[Ce[1]]-ni[Ce[0]]:Tt,ee=T.ticks,Zt=T.border,$e=ee.show?ee.size:0,nn=xn($e*Pe),An=xn((T.alignTo==2?T._size-$e-T.gap:T.gap)*Pe),ke=T._rotate*-el/180,sn=g(T._pos*Pe),ii=(nn+An)*gt,Gn=sn+ii;j=U==0?Gn:0,X=U==1?Gn:0;let _i=T.font[0],Pi=T.align==1?Ur:T.align==2?Oh:ke>0?Ur:ke<0?Oh:U==0?"center":D==3?Oh:Ur,Zi=ke||U==1?"middle":D==2?"top":Cd;Dt(_i,lt,Pi,Zi);let si=T.font[1]*T.lineGap,xi=Ce.map(Hn=>g(a(Hn,Ot,zt,ue))),Ii=T._values;for(let Hn=0;Hn<Ii.length;Hn++){let ri=Ii[Hn];if(ri!=null){U==0?X=xi[Hn]:j=xi[Hn],ri=""+ri;let er=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let Wn=0;Wn<er.length;Wn++){let dd=er[Wn];ke?(f.save(),f.translate(X,j+Wn*si),f.rotate(ke),f.fillText(dd,0,0),f.restore()):f.fillText(dd,X,j+Wn*si)}}}ee.show&&cn(xi,ee.filter(i,Te,x,Ut,ve),U,D,sn,nn,Ge(ee.width*Pe,3),ee.stroke(i,x),ee.dash,ee.cap);let Ji=T.grid;Ji.show&&cn(xi,Ji.filter(i,Te,x,Ut,ve),U,U==0?2:1,U==0?b:I,U==0?ut:q,Ge(Ji.width*Pe,3),Ji.stroke(i,x),Ji.dash,Ji.cap),Zt.show&&cn([sn],[1],U==0?1:0,U==0?1:2,U==1?b:I,U==1?ut:q,Ge(Zt.width*Pe,3),Zt.stroke(i,x),Zt.dash,Zt.cap)}En("drawAxes")}function de(x){y.forEach((T,D)=>{D>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(U=>{U.min=null,U.max=null})))})}let en=!1,Vn=!1,ze=[];function hn(){Vn=!1;for(let x=0;x<ze.length;x++)En(...ze[x]);ze.length=0}function Nn(){en||(N_(Zf),en=!0)}function Ha(x,T=!1){en=!0,Vn=T,x(i),Zf(),T&&ze.length>0&&queueMicrotask(hn)}i.batch=Ha;function Zf(){if(ot&&(_e(),ot=!1),wt&&(At(),wt=!1),vt){if(Ze(d,Ur,Ft),Ze(d,"top",Jt),Ze(d,Bo,B),Ze(d,zo,Pt),Ze(m,Ur,Ft),Ze(m,"top",Jt),Ze(m,Bo,B),Ze(m,zo,Pt),Ze(h,Bo,Le),Ze(h,zo,Re),u.width=xn(Le*Pe),u.height=xn(Re*Pe),w.forEach(({_el:x,_show:T,_size:D,_pos:U,side:X})=>{if(x!=null)if(T){let j=X===3||X===0?D:0,lt=X%2==1;Ze(x,lt?"left":"top",U-j),Ze(x,lt?"width":"height",D),Ze(x,lt?"top":"left",lt?Jt:Ft),Ze(x,lt?"height":"width",lt?Pt:B),qh(x,or)}else oi(x,or)}),br=Rs=wr=G=et=J=K=Rt=E=null,Lt=1,No(!0),Ft!=bt||Jt!=Fe||B!=Gt||Pt!=Kt){de(!1);let x=B/Gt,T=Pt/Kt;if(dt&&!it&&nt.left>=0){nt.left*=x,nt.top*=T,Er&&Ki(Er,xn(nt.left),0,B,Pt),Ar&&Ki(Ar,0,xn(nt.top),B,Pt);for(let D=0;D<fe.length;D++){let U=fe[D];U!=null&&(Xe[D]*=x,kn[D]*=T,Ki(U,Mi(Xe[D]),Mi(kn[D]),B,Pt))}}if(Ye.show&&!rt&&Ye.left>=0&&Ye.width>0){Ye.left*=x,Ye.width*=x,Ye.top*=T,Ye.height*=T;for(let D in Lh)Ze(Pr,D,Ye[D])}bt=Ft,Fe=Jt,Gt=B,Kt=Pt}En("setSize"),vt=!1}Le>0&&Re>0&&(f.clearRect(0,0,u.width,u.height),En("drawClear"),S.forEach(x=>x()),En("draw")),Ye.show&&rt&&(Wa(Ye),rt=!1),dt&&it&&(tr(null,!0,!1),it=!1),ht.show&&ht.live&&_t&&(Ph(),_t=!1),l||(l=!0,i.status=1,En("ready")),As=!1,en=!1}i.redraw=(x,T)=>{wt=T||!1,x!==!1?Ps(A,P.min,P.max):Nn()};function Ah(x,T){let D=v[x];if(D.from==null){if(tn==0){let U=D.range(i,T.min,T.max,x);T.min=U[0],T.max=U[1]}if(T.min>T.max){let U=T.min;T.min=T.max,T.max=U}if(tn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==A&&D.distr==2&&tn>0&&(T.min=Ni(T.min,t[0]),T.max=Ni(T.max,t[0]),T.min==T.max&&T.max++),k[x]=T,ot=!0,Nn()}}i.setScale=Ah;let Rh,Ch,Er,Ar,Jf,Kf,Rr,Cr,jf,Qf,qe,Ke,Cs=!1,Ln=nt.drag,wn=Ln.x,Tn=Ln.y;dt&&(nt.x&&(Rh=vi(s_,m)),nt.y&&(Ch=vi(r_,m)),P.ori==0?(Er=Rh,Ar=Ch):(Er=Ch,Ar=Rh),qe=nt.left,Ke=nt.top);let Ye=i.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Pr=Ye.show?vi(i_,Ye.over?m:d):null;function Wa(x,T){if(Ye.show){for(let D in x)Ye[D]=x[D],D in Lh&&Ze(Pr,D,x[D]);T!==!1&&En("setSelect")}}i.setSelect=Wa;function w0(x){if(y[x].show)Z&&qh(mt[x],or);else if(Z&&oi(mt[x],or),dt){let D=It?fe[0]:fe[x];D!=null&&Ki(D,-10,-10,B,Pt)}}function Ps(x,T,D){Ah(x,{min:T,max:D})}function Yi(x,T,D,U){T.focus!=null&&C0(x),T.show!=null&&y.forEach((X,j)=>{j>0&&(x==j||x==null)&&(X.show=T.show,w0(j),s==2?(Ps(X.facets[0].scale,null,null),Ps(X.facets[1].scale,null,null)):Ps(X.scale,null,null),Nn())}),D!==!1&&En("setSeries",x,T),U&&Uo("setSeries",i,x,T)}i.setSeries=Yi;function T0(x,T){mn(C[x],T)}function E0(x,T){x.fill=Se(x.fill||null),x.dir=Ee(x.dir,-1),T=T??C.length,C.splice(T,0,x)}function A0(x){x==null?C.length=0:C.splice(x,1)}i.addBand=E0,i.setBand=T0,i.delBand=A0;function R0(x,T){y[x].alpha=T,dt&&fe[x]!=null&&(fe[x].style.opacity=T),Z&&mt[x]&&(mt[x].style.opacity=T)}let cs,Is,Qs,Ir={focus:!0};function C0(x){if(x!=Qs){let T=x==null,D=kt.alpha!=1;y.forEach((U,X)=>{if(s==1||X>0){let j=T||X==0||X==x;U._focus=T?null:j,D&&R0(X,j?1:kt.alpha)}}),Qs=x,D&&Nn()}}Z&&oe&&ce(Dd,St,x=>{nt._lock||(re(x),Qs!=null&&Yi(null,Ir,!0,un.setSeries))});function $i(x,T,D){let U=v[T];D&&(x=x/Pe-(U.ori==1?Jt:Ft));let X=B;U.ori==1&&(X=Pt,x=X-x),U.dir==-1&&(x=X-x);let j=U._min,lt=U._max,gt=x/X,Tt=j+(lt-j)*gt,Ut=U.distr;return Ut==3?Br(10,Tt):Ut==4?S_(Tt,U.asinh):Ut==100?U.bwd(Tt):Tt}function P0(x,T){let D=$i(x,A,T);return Ni(D,t[0],on,an)}i.valToIdx=x=>Ni(x,t[0]),i.posToIdx=P0,i.posToVal=$i,i.valToPos=(x,T,D)=>v[T].ori==0?r(x,v[T],D?q:B,D?I:0):o(x,v[T],D?ut:Pt,D?b:0),i.setCursor=(x,T,D)=>{qe=x.left,Ke=x.top,tr(null,T,D)};function td(x,T){Ze(Pr,Ur,Ye.left=x),Ze(Pr,Bo,Ye.width=T)}function ed(x,T){Ze(Pr,"top",Ye.top=x),Ze(Pr,zo,Ye.height=T)}let Lo=P.ori==0?td:ed,Do=P.ori==1?td:ed;function I0(){if(Z&&ht.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&qt)continue;let T=ht.values[x],D=0;for(let U in T)yt[x][D++].firstChild.nodeValue=T[U]}}function Ph(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((D,U)=>{tt[U]=D}):E_(x.idx)||tt.fill(x.idx),ht.idx=tt[0]),Z&&ht.live){for(let D=0;D<y.length;D++)(D>0||s==1&&!qt)&&L0(D,tt[D]);I0()}_t=!1,T!==!1&&En("setLegend")}i.setLegend=Ph;function L0(x,T){let D=y[x],U=x==0&&O==2?ni:t[x],X;qt?X=D.values(i,x,T)??Yt:(X=D.value(i,T==null?null:U[T],x,T),X=X==null?Yt:{_:X}),ht.values[x]=X}function tr(x,T,D){jf=qe,Qf=Ke,[qe,Ke]=nt.move(i,qe,Ke),nt.left=qe,nt.top=Ke,dt&&(Er&&Ki(Er,xn(qe),0,B,Pt),Ar&&Ki(Ar,0,xn(Ke),B,Pt));let U,X=on>an;cs=Ve,Is=null;let j=P.ori==0?B:Pt,lt=P.ori==1?B:Pt;if(qe<0||tn==0||X){U=nt.idx=null;for(let gt=0;gt<y.length;gt++){let Tt=fe[gt];Tt!=null&&Ki(Tt,-10,-10,B,Pt)}oe&&Yi(null,Ir,!0,x==null&&un.setSeries),ht.live&&(tt.fill(U),_t=!0)}else{let gt,Tt,Ut;s==1&&(gt=P.ori==0?qe:Ke,Tt=$i(gt,A),U=nt.idx=Ni(Tt,t[0],on,an),Ut=V(t[0][U],P,j,0));let Ot=-10,zt=-10,ue=0,Ce=0,Te=!0,ve="",ee="";for(let Zt=s==2?1:0;Zt<y.length;Zt++){let $e=y[Zt],nn=tt[Zt],An=nn==null?null:s==1?t[Zt][nn]:t[Zt][1][nn],ke=nt.dataIdx(i,Zt,U,Tt),sn=ke==null?null:s==1?t[Zt][ke]:t[Zt][1][ke];if(_t=_t||sn!=An||ke!=nn,tt[Zt]=ke,Zt>0&&$e.show){let ii=ke==null?-10:ke==U?Ut:V(s==1?t[0][ke]:t[Zt][0][ke],P,j,0),Gn=sn==null?-10:L(sn,s==1?v[$e.scale]:v[$e.facets[1].scale],lt,0);if(oe&&sn!=null){let _i=P.ori==1?qe:Ke,Pi=yn(kt.dist(i,Zt,ke,Gn,_i));if(Pi<cs){let Zi=kt.bias;if(Zi!=0){let si=$i(_i,$e.scale),xi=sn>=0?1:-1,Ii=si>=0?1:-1;Ii==xi&&(Ii==1?Zi==1?sn>=si:sn<=si:Zi==1?sn<=si:sn>=si)&&(cs=Pi,Is=Zt)}else cs=Pi,Is=Zt}}if(_t||It){let _i,Pi;P.ori==0?(_i=ii,Pi=Gn):(_i=Gn,Pi=ii);let Zi,si,xi,Ii,Ji,Hn,ri=!0,er=ft.bbox;if(er!=null){ri=!1;let Wn=er(i,Zt);xi=Wn.left,Ii=Wn.top,Zi=Wn.width,si=Wn.height}else xi=_i,Ii=Pi,Zi=si=ft.size(i,Zt);if(Hn=ft.fill(i,Zt),Ji=ft.stroke(i,Zt),It)Zt==Is&&cs<=kt.prox&&(Ot=xi,zt=Ii,ue=Zi,Ce=si,Te=ri,ve=Hn,ee=Ji);else{let Wn=fe[Zt];Wn!=null&&(Xe[Zt]=xi,kn[Zt]=Ii,kd(Wn,Zi,si,ri),Bd(Wn,Hn,Ji),Ki(Wn,Mi(xi),Mi(Ii),B,Pt))}}}}if(It){let Zt=kt.prox,$e=Qs==null?cs<=Zt:cs>Zt||Is!=Qs;if(_t||$e){let nn=fe[0];nn!=null&&(Xe[0]=Ot,kn[0]=zt,kd(nn,ue,Ce,Te),Bd(nn,ve,ee),Ki(nn,Mi(Ot),Mi(zt),B,Pt))}}}if(Ye.show&&Cs)if(x!=null){let[gt,Tt]=un.scales,[Ut,Ot]=un.match,[zt,ue]=x.cursor.sync.scales,Ce=x.cursor.drag;if(wn=Ce._x,Tn=Ce._y,wn||Tn){let{left:Te,top:ve,width:ee,height:Zt}=x.select,$e=x.scales[zt].ori,nn=x.posToVal,An,ke,sn,ii,Gn,_i=gt!=null&&Ut(gt,zt),Pi=Tt!=null&&Ot(Tt,ue);_i&&wn?($e==0?(An=Te,ke=ee):(An=ve,ke=Zt),sn=v[gt],ii=V(nn(An,zt),sn,j,0),Gn=V(nn(An+ke,zt),sn,j,0),Lo(Ui(ii,Gn),yn(Gn-ii))):Lo(0,j),Pi&&Tn?($e==1?(An=Te,ke=ee):(An=ve,ke=Zt),sn=v[Tt],ii=L(nn(An,ue),sn,lt,0),Gn=L(nn(An+ke,ue),sn,lt,0),Do(Ui(ii,Gn),yn(Gn-ii))):Do(0,lt)}else Dh()}else{let gt=yn(jf-Jf),Tt=yn(Qf-Kf);if(P.ori==1){let ue=gt;gt=Tt,Tt=ue}wn=Ln.x&&gt>=Ln.dist,Tn=Ln.y&&Tt>=Ln.dist;let Ut=Ln.uni;Ut!=null?wn&&Tn&&(wn=gt>=Ut,Tn=Tt>=Ut,!wn&&!Tn&&(Tt>gt?Tn=!0:wn=!0)):Ln.x&&Ln.y&&(wn||Tn)&&(wn=Tn=!0);let Ot,zt;wn&&(P.ori==0?(Ot=Rr,zt=qe):(Ot=Cr,zt=Ke),Lo(Ui(Ot,zt),yn(zt-Ot)),Tn||Do(0,lt)),Tn&&(P.ori==1?(Ot=Rr,zt=qe):(Ot=Cr,zt=Ke),Do(Ui(Ot,zt),yn(zt-Ot)),wn||Lo(0,j)),!wn&&!Tn&&(Lo(0,0),Do(0,0))}if(Ln._x=wn,Ln._y=Tn,x==null){if(D){if(fd!=null){let[gt,Tt]=un.scales;un.values[0]=gt!=null?$i(P.ori==0?qe:Ke,gt):null,un.values[1]=Tt!=null?$i(P.ori==1?qe:Ke,Tt):null}Uo(Bh,i,qe,Ke,B,Pt,U)}if(oe){let gt=D&&un.setSeries,Tt=kt.prox;Qs==null?cs<=Tt&&Yi(Is,Ir,!0,gt):cs>Tt?Yi(null,Ir,!0,gt):Is!=Qs&&Yi(Is,Ir,!0,gt)}}_t&&(ht.idx=U,Ph()),T!==!1&&En("setCursor")}let Ls=null;Object.defineProperty(i,"rect",{get(){return Ls==null&&No(!1),Ls}});function No(x=!1){x?Ls=null:(Ls=m.getBoundingClientRect(),En("syncRect",Ls))}function nd(x,T,D,U,X,j,lt){nt._lock||Cs&&x!=null&&x.movementX==0&&x.movementY==0||(Ih(x,T,D,U,X,j,lt,!1,x!=null),x!=null?tr(null,!0,!0):tr(T,!0,!1))}function Ih(x,T,D,U,X,j,lt,gt,Tt){if(Ls==null&&No(!1),re(x),x!=null)D=x.clientX-Ls.left,U=x.clientY-Ls.top;else{if(D<0||U<0){qe=-10,Ke=-10;return}let[Ut,Ot]=un.scales,zt=T.cursor.sync,[ue,Ce]=zt.values,[Te,ve]=zt.scales,[ee,Zt]=un.match,$e=T.axes[0].side%2==1,nn=P.ori==0?B:Pt,An=P.ori==1?B:Pt,ke=$e?j:X,sn=$e?X:j,ii=$e?U:D,Gn=$e?D:U;if(Te!=null?D=ee(Ut,Te)?a(ue,v[Ut],nn,0):-10:D=nn*(ii/ke),ve!=null?U=Zt(Ot,ve)?a(Ce,v[Ot],An,0):-10:U=An*(Gn/sn),P.ori==1){let _i=D;D=U,U=_i}}Tt&&(T==null||T.cursor.event.type==Bh)&&((D<=1||D>=B-1)&&(D=sr(D,B)),(U<=1||U>=Pt-1)&&(U=sr(U,Pt))),gt?(Jf=D,Kf=U,[Rr,Cr]=nt.move(i,D,U)):(qe=D,Ke=U)}let Lh={width:0,height:0,left:0,top:0};function Dh(){Wa(Lh,!1)}let id,sd,rd,od;function ad(x,T,D,U,X,j,lt){Cs=!0,wn=Tn=Ln._x=Ln._y=!1,Ih(x,T,D,U,X,j,lt,!0,!1),x!=null&&(ce(zh,Wh,ld,!1),Uo(Id,i,Rr,Cr,B,Pt,null));let{left:gt,top:Tt,width:Ut,height:Ot}=Ye;id=gt,sd=Tt,rd=Ut,od=Ot}function ld(x,T,D,U,X,j,lt){Cs=Ln._x=Ln._y=!1,Ih(x,T,D,U,X,j,lt,!1,!0);let{left:gt,top:Tt,width:Ut,height:Ot}=Ye,zt=Ut>0||Ot>0,ue=id!=gt||sd!=Tt||rd!=Ut||od!=Ot;if(zt&&ue&&Wa(Ye),Ln.setScale&&zt&&ue){let Ce=gt,Te=Ut,ve=Tt,ee=Ot;if(P.ori==1&&(Ce=Tt,Te=Ot,ve=gt,ee=Ut),wn&&Ps(A,$i(Ce,A),$i(Ce+Te,A)),Tn)for(let Zt in v){let $e=v[Zt];Zt!=A&&$e.from==null&&$e.min!=Ve&&Ps(Zt,$i(ve+ee,Zt),$i(ve,Zt))}Dh()}else nt.lock&&(nt._lock=!nt._lock,tr(T,!0,x!=null));x!=null&&(He(zh,Wh),Uo(zh,i,qe,Ke,B,Pt,null))}function D0(x,T,D,U,X,j,lt){if(nt._lock)return;re(x);let gt=Cs;if(Cs){let Tt=!0,Ut=!0,Ot=10,zt,ue;P.ori==0?(zt=wn,ue=Tn):(zt=Tn,ue=wn),zt&&ue&&(Tt=qe<=Ot||qe>=B-Ot,Ut=Ke<=Ot||Ke>=Pt-Ot),zt&&Tt&&(qe=qe<Rr?0:B),ue&&Ut&&(Ke=Ke<Cr?0:Pt),tr(null,!0,!0),Cs=!1}qe=-10,Ke=-10,tt.fill(null),tr(null,!0,!0),gt&&(Cs=gt)}function cd(x,T,D,U,X,j,lt){nt._lock||(re(x),Io(),Dh(),x!=null&&Uo(Nd,i,qe,Ke,B,Pt,null))}function hd(){w.forEach(Gx),z(i.width,i.height,!0)}ar(nl,Or,hd);let Lr={};Lr.mousedown=ad,Lr.mousemove=nd,Lr.mouseup=ld,Lr.dblclick=cd,Lr.setSeries=(x,T,D,U)=>{let X=un.match[2];D=X(i,T,D),D!=-1&&Yi(D,U,!0,!1)},dt&&(ce(Id,m,ad),ce(Bh,m,nd),ce(Ld,m,x=>{re(x),No(!1)}),ce(Dd,m,D0),ce(Nd,m,cd),jh.add(i),i.syncRect=No);let Xa=i.hooks=n.hooks||{};function En(x,T,D){Vn?ze.push([x,T,D]):x in Xa&&Xa[x].forEach(U=>{U.call(null,i,T,D)})}(n.plugins||[]).forEach(x=>{for(let T in x.hooks)Xa[T]=(Xa[T]||[]).concat(x.hooks[T])});let ud=(x,T,D)=>D,un=mn({key:null,setSeries:!1,filters:{pub:Xd,sub:Xd},scales:[A,y[1]?y[1].scale:null],match:[qd,qd,ud],values:[null,null]},nt.sync);un.match.length==2&&un.match.push(ud),nt.sync=un;let fd=un.key,Nh=Gp(fd);function Uo(x,T,D,U,X,j,lt){un.filters.pub(x,T,D,U,X,j,lt)&&Nh.pub(x,T,D,U,X,j,lt)}Nh.sub(i);function N0(x,T,D,U,X,j,lt){un.filters.sub(x,T,D,U,X,j,lt)&&Lr[x](null,T,D,U,X,j,lt)}i.pub=N0;function U0(){Nh.unsub(i),jh.delete(i),we.clear(),Yh(nl,Or,hd),c.remove(),St?.remove(),En("destroy")}i.destroy=U0;function Uh(){En("init",n,t),Po(t||n.data,!1),k[A]?Ah(A,k[A]):Io(),rt=Ye.show&&(Ye.width>0||Ye.height>0),it=_t=!0,z(n.width,n.height)}return y.forEach(Sr),w.forEach(rs),e?e instanceof HTMLElement?(e.appendChild(c),Uh()):e(i,Uh):Uh(),i}Cn.assign=mn;Cn.fmtNum=ru;Cn.rangeNum=il;Cn.rangeLog=ol;Cn.rangeAsinh=iu;Cn.orient=cr;Cn.pxRatio=Pe;Cn.join=D_;Cn.fmtDate=au,Cn.tzDate=W_;Cn.sync=Gp;{Cn.addGap=Ex,Cn.clipGaps=cl;let n=Cn.paths={points:$p};n.linear=Jp,n.stepped=Cx,n.bars=Px,n.spline=Lx}function fs(n,t){let e=0,i=n.length;for(;e<i;){let s=e+i>>1;n[s]<t?e=s+1:i=s}return e}function mu(n,[t,e]){return[Math.max(fs(n,t)-1,0),Math.min(fs(n,e)+1,n.length)]}function dl(n,t,e){if(n.length===0||e<n[0]-1||e>n[n.length-1]+1)return NaN;let i=Math.min(Math.max(fs(n,e),1),n.length-1),s=n[i]-n[i-1],r=s>0?Math.min(Math.max((e-n[i-1])/s,0),1):0;return t[i-1]+r*(t[i]-t[i-1])}function tm(n,t,e){let[i,s]=[1/0,-1/0],[r,o]=mu(n,e);for(let a=r;a<o;a++)t[a]<i&&(i=t[a]),t[a]>s&&(s=t[a]);return[i,s]}var pu=(n,t)=>`${n.toFixed(1)} ${t.toFixed(1)}`;function em(n,t,e,i,s){let[r,o]=mu(n,e),a=o-r>2*Math.abs(s(e[1])-s(e[0])),l="",c="M",u=h=>{l+=c+pu(i(t[h]),s(n[h])),c="L"},f=r;for(;f<o;){if(!Number.isFinite(t[f])){c="M",f++;continue}if(!a){u(f++);continue}let h=Math.round(s(n[f])),[d,m,M]=[f,f,f];for(;M+1<o&&Math.round(s(n[M+1]))===h&&Number.isFinite(t[M+1]);)M++,t[M]<t[d]&&(d=M),t[M]>t[m]&&(m=M);for(let g of[...new Set([f,Math.min(d,m),Math.max(d,m),M])])u(g);f=M+1}return l}function pl(n,t,e,i,s,r){let[o,a]=mu(n,i),l=Math.max(Math.floor((a-o)/(2*Math.abs(r(i[1])-r(i[0]))+1)),1),c=[],u=[];for(let f=o;f<a;f+=l){let[h,d]=[1/0,-1/0];for(let m=f;m<Math.min(f+l,a);m++)t[m]<h&&(h=t[m]),e[m]>d&&(d=e[m]);h<=d&&(c.push(pu(s(d),r(n[f]))),u.push(pu(s(h),r(n[f]))))}return c.length>1?`M${c.join("L")}L${u.reverse().join("L")}Z`:""}function nm(n,t,e){let i=new Float32Array(t.length),[s,r,o]=[0,0,0];for(let a=0;a<t.length;a++){for(;r<t.length&&n[r]<=n[a]+e;)o+=t[r++];for(;n[s]<n[a]-e;)o-=t[s++];i[a]=o/(r-s)}return i}function ml(n,t,e){let i=new Float32Array(t.length),s=0;for(let r=0;r<t.length;r++){for(;n[s]<n[r]-e;)s++;let o=-1/0;for(let a=s;a<t.length&&n[a]<=n[r]+e;a++)o=Math.max(o,t[a]);i[r]=o}return i}var Hx=[{title:"Hook load",dimension:"force",columns:[["hook_load_N","hook load"]],soft:["tension_N",0]},{title:"Torque",dimension:"torque",columns:[["surface_torque_N_m","surface"],["friction_torque_N_m","friction"],["bit_torque_N_m","bit"]],soft:["torque_N_m",0]},{title:"Weight on bit",dimension:"force",columns:[["weight_on_bit_N","on bit"],["weight_on_bit_set_N","set"]]},{title:"Rotary speed",dimension:"rotary speed",columns:[["rotary_speed_rad_per_s","top"],["bit_rotary_speed_rad_per_s","bit"],["rotary_speed_set_rad_per_s","set"]]},{title:"Block velocity, down",dimension:"speed",columns:[["block_velocity_m_per_s","block"],["block_velocity_set_m_per_s","set"]]},{title:"Axial friction",dimension:"force",columns:[["axial_friction_N","along the string"]]},{title:"Neutral point and cut-off depth",dimension:"length",columns:[["neutral_point_m","neutral point"],["cutoff_depth_m","cut-off depth"]],points:!0,down:!0}],im=[["contact_force_N","Contact force of the node","force"],["tension_N","Effective tension","force"],["torque_N_m","Torque","torque"],["rotary_speed_rad_per_s","Rotary speed","rotary speed"],["bending_moment_N_m","Bending moment","torque"],["offset_high_m","Offset to the high side","diameter"],["offset_right_m","Offset to the right","diameter"]],Wx=Cn.sync("time");function sm(n){let t=ct("div",{class:"histories"}),e=[],i=!1;function s(p){let y=p.history,w=Hx.map(C=>({...C,columns:C.columns.filter(([A])=>y[A])})).filter(C=>C.columns.length).filter(C=>C.columns.some(([A])=>y[A].some(_=>_!==0))).map(C=>({...C,times:y.time_s,values:C.columns.map(([A])=>y[A])})),v=o(p);return v?[...w,v]:w}let r="contact_force_N";function o(p){let{frames:y,contact:w}=p;if(y?.channels[r]){let v=y.md_m.length,C=Wo(y.md_m,te.depth),[A,_,S]=im.find(([R])=>R===r),N=Float32Array.from(y.time_s,(R,P)=>y.channels[A][P*v+C]);return{title:`${_} at ${pn(y.md_m[C],"length",5)}`,dimension:S,columns:[[A,"node"]],times:y.time_s,values:[N],chooses:im.filter(([R])=>y.channels[R])}}if(w){let v=w.md_m.length,C=Wo(w.md_m,te.depth),A=Float32Array.from(w.time_s,(_,S)=>w.side_force[S*v+C]);return{title:`Side force around ${pn(w.md_m[C],"length",5)}`,dimension:"force per length",columns:[["side_force_N_per_m","side force"]],times:w.time_s,values:[A]}}return null}function a(){e.forEach(w=>w.destroy()),e=[];let p=Xn(n),y=p?s(p).map(w=>l(w,p)):[];t.replaceChildren(...y.map(w=>w.element));for(let{plot:w,body:v}of y)e.push(c(w,v,p))}function l(p,y){let w=ct("div",{class:"plot"}),v=Rn(p.dimension),C=ct("h3",{},p.points&&p.columns.length===1?p.columns[0][1].replace(/^./,A=>A.toUpperCase()):p.title,v&&ct("span",{class:"unit"},` ${v}`));return p.chooses&&C.append(ct("select",{class:"noprint","aria-label":"Quantity of the chosen node",onchange:A=>{r=A.target.value,a()}},p.chooses.map(([A,_])=>ct("option",{value:A,selected:A===r},_)))),{plot:p,body:w,element:ct("figure",{class:"card history"},C,w)}}function c(p,y,w){let v=u(p),C=[Array.from(p.times),...p.values.map(R=>xd(R,p.dimension))],A=p.columns.map(([,R],P)=>{let O=R==="set";return{label:R,stroke:O?rn("muted"):Fo([0,2,3][P]??P),width:O?1:1.4,dash:O?[5,4]:void 0,spanGaps:!!p.points,points:{show:!1},value:(V,L)=>L===null?"–":Un(L)}});v!==null&&(C.push(C[0].map(()=>v)),A.push({label:"soft string",stroke:Fo(1),width:1.4,dash:[7,4],points:{show:!1},value:(R,P)=>Un(P??NaN)}));let _={stroke:rn("muted"),grid:{stroke:rn("grid"),width:1},ticks:{show:!1},font:"11px system-ui, sans-serif"},S=te.times??[0,Math.max(w.history.time_s.at(-1),.001)],N=new Cn({width:Math.max(y.clientWidth,200),height:200,cursor:{sync:{key:Wx.key,scales:["x",null]},drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:{live:!0,markers:{width:0,fill:(R,P)=>R.series[P].stroke(R,P)}},scales:{x:{time:!1,min:S[0],max:S[1]},y:{dir:p.down?-1:1,range:(R,P,O)=>Xx(P,O,p.dimension)}},axes:[{..._,size:30,values:(R,P)=>P.map(O=>Ds(String(Number(O.toFixed(6))))),label:void 0},{..._,size:62,values:(R,P)=>P.map(O=>Ds(String(Number(O.toFixed(6)))))}],series:[{label:"time, s",value:(R,P)=>P===null?"–":P.toFixed(2)},...A],hooks:{setScale:[(R,P)=>P==="x"&&f(R)],drawClear:[R=>h(R,w)],draw:[R=>d(R,w)]}},C,y);return m(N),N}function u(p){let y=yi(n,"soft");if(!p.soft||!y)return null;let[w,v]=p.soft,C=y.profile[w]?.[v];return Number.isFinite(C)?De(C,p.dimension):null}function f(p){if(i||p.scales.x.min==null||e.length===0)return;i=!0;let{min:y,max:w}=p.scales.x,C=Xn(n).history.time_s.at(-1);for(let A of e)A!==p&&A.setScale("x",{min:y,max:w});dn({times:y<=1e-6&&w>=C-1e-6?null:[y,w]}),i=!1}function h(p,y){let{ctx:w,bbox:v}=p,C=p.valToPos(y.window_s,"x",!0),A=Math.min(Math.max(C,v.left),v.left+v.width);w.save(),w.fillStyle=rn("settling"),w.fillRect(v.left,v.top,A-v.left,v.height),w.restore()}function d(p,y){let{ctx:w,bbox:v}=p,C=devicePixelRatio,A=-1/0;w.save(),w.font=`${10*C}px system-ui, sans-serif`,w.textAlign="left",w.fillStyle=rn("muted"),w.strokeStyle=rn("muted"),w.setLineDash([2*C,3*C]);let _=te.moment===null?[]:[[te.moment,""]];for(let[S,N]of[...y.notes,..._]){let R=p.valToPos(S,"x",!0);if(R<v.left||R>v.left+v.width)continue;w.beginPath(),w.moveTo(R,v.top),w.lineTo(R,v.top+v.height),w.stroke();let P=w.measureText(N).width;N&&R>A&&R+P<v.left+v.width&&(w.fillText(N,R+3*C,v.top+11*C),A=R+P+8*C)}w.restore()}function m(p){let{over:y}=p,w=()=>Xn(n).history.time_s.at(-1),v=(C,A)=>{let _=Math.max(C,0),S=Math.min(A,w());S-_>.001&&p.setScale("x",{min:_,max:S})};y.addEventListener("wheel",C=>{if(!C.ctrlKey&&!C.metaKey)return;C.preventDefault();let A=p.posToVal(C.clientX-y.getBoundingClientRect().left,"x"),_=Math.exp(C.deltaY*.002);v(A+(p.scales.x.min-A)*_,A+(p.scales.x.max-A)*_)},{passive:!1}),y.addEventListener("mousedown",C=>{if(!C.shiftKey)return;C.stopImmediatePropagation();let A=C.clientX,{min:_,max:S}=p.scales.x,N=R=>{let P=(A-R.clientX)/y.clientWidth*(S-_),O=Math.min(Math.max(P,-_),w()-S);v(_+O,S+O)};addEventListener("mousemove",N),addEventListener("mouseup",()=>removeEventListener("mousemove",N),{once:!0})},{capture:!0}),y.addEventListener("dblclick",()=>p.setScale("x",{min:0,max:w()}))}fn("units operation depth",a),fn("times",()=>{if(i)return;let p=Xn(n);if(!p)return;let[y,w]=te.times??[0,p.history.time_s.at(-1)];i=!0;for(let v of e)v.setScale("x",{min:y,max:w});i=!1}),fn("moment",()=>e.forEach(p=>p.redraw(!1,!1)));let M=0;new ResizeObserver(()=>{if(t.clientWidth!==M){M=t.clientWidth;for(let p of e)p.setSize({width:Math.max(p.root.parentElement.clientWidth,200),height:200})}}).observe(t);let g=ct("p",{class:"hint noprint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics");return{element:ct("div",{},g,t),redraw:a}}function Xx(n,t,e){if(n===null||t===null)return[0,1];let i=.002*Math.max(Math.abs(n),Math.abs(t))||De(1,e),s=Math.max(t-n,i),r=(n+t)/2;return[r-.58*s,r+.58*s]}function Wo(n,t){let e=Math.min(Math.max(fs(n,t??0),1),n.length-1);return Math.abs(n[e]-t)<Math.abs(n[e-1]-t)?e:e-1}var rm=matchMedia("(prefers-color-scheme: dark)"),gu=!1,Fs=()=>gu,qx=()=>!gu&&(te.theme==="dark"||te.theme==="auto"&&rm.matches);function om(n){let t=()=>{document.documentElement.dataset.theme=qx()?"dark":"light"},e=()=>{t(),n()};rm.addEventListener("change",e);let i=s=>()=>{gu=s;for(let r of document.querySelectorAll("details.prints"))s?(r.dataset.was=r.open?"open":"",r.open=!0):r.open=r.dataset.was==="open";e()};return addEventListener("beforeprint",i(!0)),addEventListener("afterprint",i(!1)),t(),s=>{dn({theme:s}),e()}}function Si(n,t,e){let i=t-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],step:1};let s=i/Math.max(e,1),r=10**Math.floor(Math.log10(s)),o=[1,2,2.5,5,10].map(l=>l*r).find(l=>l>=s*.999),a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=t+o*1e-9;l++)a.push(l*o);return{values:a,step:o}}function bi(n,t){let e=Math.abs(n)<t*1e-6?0:n,i=0;for(;i<8&&Math.abs(t*10**i-Math.round(t*10**i))>1e-6;)i++;return Ds(e.toFixed(i))}function am(n,t,e,i){if(!(n<=t)||n===0&&t===0)return[0,i];(e||n>0&&n<.35*t)&&(n=Math.min(n,0)),(e||t<0&&t>.35*n)&&(t=Math.max(t,0));let r=.05*(t-n||Math.abs(t)*.2||1);return[n===0?0:n-r,t===0?0:t+r]}var gl=58,lm=96,_l=10,cm=34,_u=430,Yx=730;function $x(n,t){let e=n.filter(Number.isFinite).map(Math.abs).sort((i,s)=>i-s);return e[Math.floor(t*(e.length-1))]||1}function hm(n){let t="side_force",e=ct("canvas",{class:"map",role:"img","aria-label":"Contact over depth and time"}),i=ct("p",{class:"readout-line"}," "),s=ct("div",{class:"map-holder"},e),r=ct("div",{class:"tools noprint"},Dr("What the map shows",[["side_force","Side force, by side"],["contact_force","Contact force"]],t,d=>{t=d,a()}),ct("span",{class:"hint"},"follows the depths and times in view above; click to choose a depth and a time")),o=d=>({depths:te.depths??[0,d.contact.md_m.at(-1)],times:te.times??[d.contact.from_s,d.contact.time_s.at(-1)]});function a(){let d=Xn(n);if(!d?.contact)return;let m=Math.max(devicePixelRatio,2),M=Fs()?Yx:s.clientWidth||1200;e.width=M*m,e.height=_u*m,e.style.aspectRatio=`${M} / ${_u}`;let g=e.getContext("2d");g.scale(m,m),g.font="11px system-ui, sans-serif";let{depths:p,times:y}=o(d),w={left:gl,top:_l,width:M-gl-lm,height:_u-_l-cm},v=$x(Array.from(d.contact[t]),.985),C=t==="side_force",A=Za(C),_=S=>A(C?.5+.5*S/v:S/v);l(g,d,w,p,y,_),c(g,w,p,y,d),u(g,w,v,_)}function l(d,m,M,[g,p],[y,w],v){let{contact:C}=m,A=C.md_m.length,_=new ImageData(C.time_s.length,Math.round(M.height));for(let P=0;P<_.height;P++){let O=Wo(C.md_m,g+(P+.5)/_.height*(p-g));for(let V=0;V<_.width;V++){let[L,k,H]=v(C[t][V*A+O]||0);_.data.set([L,k,H,255],4*(P*_.width+V))}}let S=new OffscreenCanvas(_.width,_.height);S.getContext("2d").putImageData(_,0,0),d.save(),d.beginPath(),d.rect(M.left,M.top,M.width,M.height),d.clip(),d.imageSmoothingEnabled=!1;let N=P=>M.left+(P-y)/(w-y)*M.width,R=C.from_s;C.time_s.forEach((P,O)=>{d.drawImage(S,O,0,1,_.height,N(R),M.top,N(P)-N(R)+.5,M.height),R=P}),d.restore()}function c(d,m,[M,g],[p,y],w){let v=N=>m.top+(N-M)/(g-M)*m.height,C=N=>m.left+(N-p)/(y-p)*m.width;d.fillStyle=d.strokeStyle=rn("muted"),d.textBaseline="middle",d.textAlign="right";let A=Si(De(M,"length"),De(g,"length"),9);for(let N of A.values)d.fillText(bi(N,A.step),m.left-8,v(Li(N,"length")));d.textAlign="center",d.textBaseline="top";let _=Si(p,y,12);for(let N of _.values)d.fillText(bi(N,_.step),C(N),m.top+m.height+6);d.fillText("time, s",m.left+m.width/2,m.top+m.height+20),d.save(),d.translate(9,m.top+m.height/2),d.rotate(-Math.PI/2),d.fillText(`MD, ${Rn("length")}`,0,-4),d.restore(),d.strokeStyle=rn("frame"),d.strokeRect(m.left,m.top,m.width,m.height);let S=(N,R,P,O)=>{d.beginPath(),d.moveTo(N,R),d.lineTo(P,O),d.stroke()};d.strokeStyle=rn("text"),d.setLineDash([4,4]),w.window_s>p&&w.window_s<y&&(S(C(w.window_s),m.top,C(w.window_s),m.top+m.height),d.textAlign="left",d.fillStyle=rn("text"),d.fillText("window ▸",C(w.window_s)+4,m.top+4)),d.setLineDash([1,3]);for(let{kind:N,to_m:R}of n.hole)N==="casing"&&R>M&&R<g&&(S(m.left,v(R),m.left+m.width,v(R)),d.textAlign="left",d.fillStyle=rn("text"),d.fillText("shoe",m.left+4,v(R)-13));d.setLineDash([]),te.depth!==null&&te.depth>M&&te.depth<g&&S(m.left,v(te.depth),m.left+m.width,v(te.depth)),te.moment!==null&&te.moment>p&&te.moment<y&&S(C(te.moment),m.top,C(te.moment),m.top+m.height)}function u(d,m,M,g){let p=m.left+m.width+14,y=t==="side_force"?-M:0,w=120;for(let C=0;C<w;C++){let[A,_,S]=g(y+(C+.5)/w*(M-y));d.fillStyle=`rgb(${A} ${_} ${S})`,d.fillRect(p,m.top+m.height*(1-(C+1)/w),12,m.height/w+.6)}d.strokeStyle=rn("frame"),d.strokeRect(p,m.top,12,m.height);let v=Si(De(y,"force per length"),De(M,"force per length"),6);d.fillStyle=rn("muted"),d.textAlign="left",d.textBaseline="middle";for(let C of v.values){let A=(Li(C,"force per length")-y)/(M-y);d.fillText(bi(C,v.step),p+17,m.top+m.height*(1-A))}d.fillText(Rn("force per length"),p,m.top+m.height+12),t==="side_force"&&(d.save(),d.textAlign="center",d.translate(p+66,m.top+m.height*.25),d.rotate(-Math.PI/2),d.fillText("high side",0,0),d.restore(),d.save(),d.textAlign="center",d.translate(p+66,m.top+m.height*.75),d.rotate(-Math.PI/2),d.fillText("low side",0,0),d.restore())}function f(d){let m=Xn(n);if(!m?.contact)return null;let M=e.getBoundingClientRect(),{depths:g,times:p}=o(m),y=(d.clientX-M.left-gl)/(M.width-gl-lm),w=(d.clientY-M.top-_l)/(M.height-_l-cm);return y<0||y>1||w<0||w>1?null:{depth:g[0]+w*(g[1]-g[0]),moment:p[0]+y*(p[1]-p[0])}}e.addEventListener("pointermove",d=>{let m=f(d);if(dn({pointer:m?.depth??null}),!m)return void(i.textContent=" ");let{contact:M}=Xn(n),g=Math.min(Math.max(Array.from(M.time_s).findIndex(w=>w>=m.moment),0),M.time_s.length-1),p=M[t][g*M.md_m.length+Wo(M.md_m,m.depth)],y=t==="contact_force"||Math.abs(p)===0?"":p>0?", high side":", low side";i.textContent=`MD ${pn(m.depth,"length",5)}, ${Un(m.moment,4)} s: ${pn(Math.abs(p),"force per length",3)}${y}`}),e.addEventListener("pointerleave",()=>{dn({pointer:null}),i.textContent=" "}),e.addEventListener("click",d=>{let m=f(d);m&&dn(m)}),fn("units operation depths times depth moment",a);let h=0;return new ResizeObserver(()=>{s.clientWidth!==h&&(h=s.clientWidth,a())}).observe(s),{element:ct("div",{},r,s,i),redraw:a}}function um(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function Zx(n){if(n.f32!==void 0)return new Float32Array(um(n.f32));let[t,e,i]=n.i16,s=new Int16Array(um(t)),r=new Float32Array(s.length);for(let o=0;o<s.length;o++)r[o]=s[o]===-32768?NaN:e+i*s[o];return r}function xu(n){return Array.isArray(n)?n.map(xu):n===null||typeof n!="object"?n:typeof n.f32=="string"||Array.isArray(n.i16)?Zx(n):Object.fromEntries(Object.entries(n).map(([t,e])=>[t,xu(e)]))}function fm(){return xu(JSON.parse(document.getElementById("report").textContent))}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Ys={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},$s={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Wm=0,$u=1,Xm=2;var Aa=1,qm=2,So=3,Zs=0,jn=1,Ei=2,_r=0,bo=1,Zu=2,Ju=3,Ku=4,Ym=5;var xr=100,$m=101,Zm=102,Jm=103,Km=104,jm=200,Qm=201,tg=202,eg=203,ju=204,Qu=205,ng=206,ig=207,sg=208,rg=209,og=210,ag=211,lg=212,cg=213,hg=214,Xl=0,ql=1,Yl=2,co=3,$l=4,Zl=5,Jl=6,Kl=7,Ec=0,ug=1,fg=2,ns=0,tf=1,ef=2,nf=3,sf=4,rf=5,of=6,af=7;var lf=300,yr=301,wo=302,Ac=303,Rc=304,jl=1e3,Qi=1001,Ql=1002,In=1003,dg=1004;var Ra=1005;var Jn=1006,Cc=1007;var bs=1008;var ti=1009,cf=1010,hf=1011,To=1012,Pc=1013,ki=1014,Vi=1015,Gi=1016,Ic=1017,Lc=1018,vr=1020,uf=35902,ff=35899,df=1021,pf=1022,Hi=1023,vs=1026,ws=1027,mf=1028,Dc=1029,Js=1030,Nc=1031;var Uc=1033,Ca=33776,Pa=33777,Ia=33778,La=33779,Fc=35840,Oc=35841,Bc=35842,zc=35843,kc=36196,Vc=37492,Gc=37496,Hc=37488,Wc=37489,Da=37490,Xc=37491,qc=37808,Yc=37809,$c=37810,Zc=37811,Jc=37812,Kc=37813,jc=37814,Qc=37815,th=37816,eh=37817,nh=37818,ih=37819,sh=37820,rh=37821,oh=36492,ah=36494,lh=36495,ch=36283,hh=36284,Na=36285,uh=36286;var na=2300,tc=2301,Hl=2302,Vu=2303,Gu=2400,Hu=2401,Wu=2402;var pg=3200;var fh=0,mg=1,Ts="",ui="srgb",ia="srgb-linear",sa="linear",Ue="srgb";var Wl=7680;var gg=519,_g=512,xg=513,yg=514,gf=515,vg=516,Mg=517,_f=518,xf=519,yf=35044;var vf="300 es",Ti=2e3,ho=2001;function Jx(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Kx(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ra(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Sg(){let n=ra("canvas");return n.style.display="block",n}var dm={},uo=null;function oa(...n){let t="THREE."+n.shift();uo?uo("log",t,...n):console.log(t,...n)}function bg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Qt(...n){n=bg(n);let t="THREE."+n.shift();if(uo)uo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ae(...n){n=bg(n);let t="THREE."+n.shift();if(uo)uo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Qo(...n){let t=n.join(" ");t in dm||(dm[t]=!0,Qt(...n))}function wg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Tg={[Xl]:Xl,[Yl]:Jl,[$l]:$l,[co]:Zl,[ql]:ql,[Jl]:Yl,[Kl]:Kl,[Zl]:co},zi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],pm=1234567,ta=Math.PI/180,fo=180/Math.PI;function Ks(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]+"-"+Fn[t&255]+Fn[t>>8&255]+"-"+Fn[t>>16&15|64]+Fn[t>>24&255]+"-"+Fn[e&63|128]+Fn[e>>8&255]+"-"+Fn[e>>16&255]+Fn[e>>24&255]+Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]).toLowerCase()}function ye(n,t,e){return Math.max(t,Math.min(e,n))}function Mf(n,t){return(n%t+t)%t}function jx(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Qx(n,t,e){return n!==t?(e-n)/(t-n):0}function ea(n,t,e){return(1-e)*n+e*t}function ty(n,t,e,i){return ea(n,t,1-Math.exp(-e*i))}function ey(n,t=1){return t-Math.abs(Mf(n,t*2)-t)}function ny(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function iy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function sy(n,t){return n+Math.floor(Math.random()*(t-n+1))}function ry(n,t){return n+Math.random()*(t-n)}function oy(n){return n*(.5-Math.random())}function ay(n){n!==void 0&&(pm=n);let t=pm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function ly(n){return n*ta}function cy(n){return n*fo}function hy(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function uy(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Sf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function fy(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),f=r((t-i)/2),h=o((t-i)/2),d=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*d,a*u,a*c);break;default:Qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function dh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function bf(n,t){if(t.constructor===Float32Array)return n;let e=dh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function wf(n,t){if(t.constructor===Float32Array)return n;let e=dh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Tf={DEG2RAD:ta,RAD2DEG:fo,generateUUID:Ks,clamp:ye,euclideanModulo:Mf,mapLinear:jx,inverseLerp:Qx,lerp:ea,damp:ty,pingpong:ey,smoothstep:ny,smootherstep:iy,randInt:sy,randFloat:ry,randFloatSpread:oy,seededRandom:ay,degToRad:ly,radToDeg:cy,isPowerOfTwo:hy,ceilPowerOfTwo:uy,floorPowerOfTwo:Sf,setQuaternionFromProperEuler:fy,normalize:wf,denormalize:bf},jt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ye(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},di=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],m=r[o+2],M=r[o+3];if(f!==M||l!==h||c!==d||u!==m){let g=l*h+c*d+u*m+f*M;g<0&&(h=-h,d=-d,m=-m,M=-M,g=-g);let p=1-a;if(g<.9995){let y=Math.acos(g),w=Math.sin(y);p=Math.sin(p*y)/w,a=Math.sin(a*y)/w,l=l*p+h*a,c=c*p+d*a,u=u*p+m*a,f=f*p+M*a}else{l=l*p+h*a,c=c*p+d*a,u=u*p+m*a,f=f*p+M*a;let y=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=y,c*=y,u*=y,f*=y}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=f}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],m=r[o+3];return t[e]=a*m+u*f+l*d-c*h,t[e+1]=l*m+u*h+c*f-a*d,t[e+2]=c*m+u*d+a*h-l*f,t[e+3]=u*m-a*f-l*h-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*m,this._y=c*d*f-h*u*m,this._z=c*u*m+h*d*f,this._w=c*u*f-h*d*m;break;case"YXZ":this._x=h*u*f+c*d*m,this._y=c*d*f-h*u*m,this._z=c*u*m-h*d*f,this._w=c*u*f+h*d*m;break;case"ZXY":this._x=h*u*f-c*d*m,this._y=c*d*f+h*u*m,this._z=c*u*m+h*d*f,this._w=c*u*f-h*d*m;break;case"ZYX":this._x=h*u*f-c*d*m,this._y=c*d*f+h*u*m,this._z=c*u*m-h*d*f,this._w=c*u*f+h*d*m;break;case"YZX":this._x=h*u*f+c*d*m,this._y=c*d*f+h*u*m,this._z=c*u*m-h*d*f,this._w=c*u*f-h*d*m;break;case"XZY":this._x=h*u*f-c*d*m,this._y=c*d*f-h*u*m,this._z=c*u*m+h*d*f,this._w=c*u*f+h*d*m;break;default:Qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],f=e[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ye(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Y=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(mm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(mm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),f=2*(r*i-o*e);return this.x=e+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return yu.copy(this).projectOnVector(t),this.sub(yu)}reflect(t){return this.sub(yu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ye(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},yu=new Y,mm=new di,he=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],m=i[8],M=s[0],g=s[3],p=s[6],y=s[1],w=s[4],v=s[7],C=s[2],A=s[5],_=s[8];return r[0]=o*M+a*y+l*C,r[3]=o*g+a*w+l*A,r[6]=o*p+a*v+l*_,r[1]=c*M+u*y+f*C,r[4]=c*g+u*w+f*A,r[7]=c*p+u*v+f*_,r[2]=h*M+d*y+m*C,r[5]=h*g+d*w+m*A,r[8]=h*p+d*v+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,m=e*f+i*h+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/m;return t[0]=f*M,t[1]=(s*c-u*i)*M,t[2]=(a*i-s*o)*M,t[3]=h*M,t[4]=(u*e-s*l)*M,t[5]=(s*r-a*e)*M,t[6]=d*M,t[7]=(i*l-c*e)*M,t[8]=(o*e-i*r)*M,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Qo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(vu.makeScale(t,e)),this}rotate(t){return Qo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(vu.makeRotation(-t)),this}translate(t,e){return Qo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(vu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},vu=new he,gm=new he().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),_m=new he().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function dy(){let n={enabled:!0,workingColorSpace:ia,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ue&&(s.r=ys(s.r),s.g=ys(s.g),s.b=ys(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ue&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ts?sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ia]:{primaries:t,whitePoint:i,transfer:sa,toXYZ:gm,fromXYZ:_m,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:ui},outputColorSpaceConfig:{drawingBufferColorSpace:ui}},[ui]:{primaries:t,whitePoint:i,transfer:Ue,toXYZ:gm,fromXYZ:_m,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:ui}}}),n}var be=dy();function ys(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function lo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Xr,ec=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Xr===void 0&&(Xr=ra("canvas")),Xr.width=t.width,Xr.height=t.height;let s=Xr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Xr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ra("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ys(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ys(e[i]/255)*255):e[i]=ys(e[i]);return{data:e,width:t.width,height:t.height}}else return Qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},py=0,po=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:py++}),this.uuid=Ks(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Mu(s[o].image)):r.push(Mu(s[o]))}else r=Mu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Mu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?ec.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Qt("Texture: Unable to serialize Texture."),{})}var my=0,Su=new Y,Kn=class n extends zi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Qi,s=Qi,r=Jn,o=bs,a=Hi,l=ti,c=n.DEFAULT_ANISOTROPY,u=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:my++}),this.uuid=Ks(),this.name="",this.source=new po(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new jt(0,0),this.repeat=new jt(1,1),this.center=new jt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new he,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Su).x}get height(){return this.source.getSize(Su).y}get depth(){return this.source.getSize(Su).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==lf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case jl:t.x=t.x-Math.floor(t.x);break;case Qi:t.x=t.x<0?0:1;break;case Ql:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case jl:t.y=t.y-Math.floor(t.y);break;case Qi:t.y=t.y<0?0:1;break;case Ql:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=lf;Kn.DEFAULT_ANISOTROPY=1;var je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],m=l[9],M=l[2],g=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-M)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+M)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,v=(d+1)/2,C=(p+1)/2,A=(u+h)/4,_=(f+M)/4,S=(m+g)/4;return w>v&&w>C?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=A/i,r=_/i):v>C?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=A/s,r=S/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=_/r,s=S/r),this.set(i,s,r,e),this}let y=Math.sqrt((g-m)*(g-m)+(f-M)*(f-M)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-m)/y,this.y=(f-M)/y,this.z=(h-u)/y,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ye(this.x,t.x,e.x),this.y=ye(this.y,t.y,e.y),this.z=ye(this.z,t.z,e.z),this.w=ye(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ye(this.x,t,e),this.y=ye(this.y,t,e),this.z=ye(this.z,t,e),this.w=ye(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ye(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},nc=class extends zi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Kn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new po(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},pi=class extends nc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},aa=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var ic=class extends Kn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=Qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var We=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,f,h,d,m,M,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,f,h,d,m,M,g)}set(t,e,i,s,r,o,a,l,c,u,f,h,d,m,M,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=f,p[14]=h,p[3]=d,p[7]=m,p[11]=M,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/qr.setFromMatrixColumn(t,0).length(),r=1/qr.setFromMatrixColumn(t,1).length(),o=1/qr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let h=o*u,d=o*f,m=a*u,M=a*f;e[0]=l*u,e[4]=-l*f,e[8]=c,e[1]=d+m*c,e[5]=h-M*c,e[9]=-a*l,e[2]=M-h*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,d=l*f,m=c*u,M=c*f;e[0]=h+M*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*f,e[5]=o*u,e[9]=-a,e[2]=d*a-m,e[6]=M+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,d=l*f,m=c*u,M=c*f;e[0]=h-M*a,e[4]=-o*f,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*u,e[9]=M-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,d=o*f,m=a*u,M=a*f;e[0]=l*u,e[4]=m*c-d,e[8]=h*c+M,e[1]=l*f,e[5]=M*c+h,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,d=o*c,m=a*l,M=a*c;e[0]=l*u,e[4]=M-h*f,e[8]=m*f+d,e[1]=f,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*f+m,e[10]=h-M*f}else if(t.order==="XZY"){let h=o*l,d=o*c,m=a*l,M=a*c;e[0]=l*u,e[4]=-f,e[8]=c*u,e[1]=h*f+M,e[5]=o*u,e[9]=d*f-m,e[2]=m*f-d,e[6]=a*u,e[10]=M*f+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(gy,t,_y)}lookAt(t,e,i){let s=this.elements;return ci.subVectors(t,e),ci.lengthSq()===0&&(ci.z=1),ci.normalize(),Os.crossVectors(i,ci),Os.lengthSq()===0&&(Math.abs(i.z)===1?ci.x+=1e-4:ci.z+=1e-4,ci.normalize(),Os.crossVectors(i,ci)),Os.normalize(),xl.crossVectors(ci,Os),s[0]=Os.x,s[4]=xl.x,s[8]=ci.x,s[1]=Os.y,s[5]=xl.y,s[9]=ci.y,s[2]=Os.z,s[6]=xl.z,s[10]=ci.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],m=i[2],M=i[6],g=i[10],p=i[14],y=i[3],w=i[7],v=i[11],C=i[15],A=s[0],_=s[4],S=s[8],N=s[12],R=s[1],P=s[5],O=s[9],V=s[13],L=s[2],k=s[6],H=s[10],F=s[14],Q=s[3],W=s[7],$=s[11],tt=s[15];return r[0]=o*A+a*R+l*L+c*Q,r[4]=o*_+a*P+l*k+c*W,r[8]=o*S+a*O+l*H+c*$,r[12]=o*N+a*V+l*F+c*tt,r[1]=u*A+f*R+h*L+d*Q,r[5]=u*_+f*P+h*k+d*W,r[9]=u*S+f*O+h*H+d*$,r[13]=u*N+f*V+h*F+d*tt,r[2]=m*A+M*R+g*L+p*Q,r[6]=m*_+M*P+g*k+p*W,r[10]=m*S+M*O+g*H+p*$,r[14]=m*N+M*V+g*F+p*tt,r[3]=y*A+w*R+v*L+C*Q,r[7]=y*_+w*P+v*k+C*W,r[11]=y*S+w*O+v*H+C*$,r[15]=y*N+w*V+v*F+C*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],f=t[6],h=t[10],d=t[14],m=t[3],M=t[7],g=t[11],p=t[15],y=l*d-c*h,w=a*d-c*f,v=a*h-l*f,C=o*d-c*u,A=o*h-l*u,_=o*f-a*u;return e*(M*y-g*w+p*v)-i*(m*y-g*C+p*A)+s*(m*w-M*C+p*_)-r*(m*v-M*A+g*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],f=t[9],h=t[10],d=t[11],m=t[12],M=t[13],g=t[14],p=t[15],y=e*a-i*o,w=e*l-s*o,v=e*c-r*o,C=i*l-s*a,A=i*c-r*a,_=s*c-r*l,S=u*M-f*m,N=u*g-h*m,R=u*p-d*m,P=f*g-h*M,O=f*p-d*M,V=h*p-d*g,L=y*V-w*O+v*P+C*R-A*N+_*S;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let k=1/L;return t[0]=(a*V-l*O+c*P)*k,t[1]=(s*O-i*V-r*P)*k,t[2]=(M*_-g*A+p*C)*k,t[3]=(h*A-f*_-d*C)*k,t[4]=(l*R-o*V-c*N)*k,t[5]=(e*V-s*R+r*N)*k,t[6]=(g*v-m*_-p*w)*k,t[7]=(u*_-h*v+d*w)*k,t[8]=(o*O-a*R+c*S)*k,t[9]=(i*R-e*O-r*S)*k,t[10]=(m*A-M*v+p*y)*k,t[11]=(f*v-u*A-d*y)*k,t[12]=(a*N-o*P-l*S)*k,t[13]=(e*P-i*N+s*S)*k,t[14]=(M*w-m*C-g*y)*k,t[15]=(u*C-f*w+h*y)*k,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,m=r*f,M=o*u,g=o*f,p=a*f,y=l*c,w=l*u,v=l*f,C=i.x,A=i.y,_=i.z;return s[0]=(1-(M+p))*C,s[1]=(d+v)*C,s[2]=(m-w)*C,s[3]=0,s[4]=(d-v)*A,s[5]=(1-(h+p))*A,s[6]=(g+y)*A,s[7]=0,s[8]=(m+w)*_,s[9]=(g-y)*_,s[10]=(1-(h+M))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=qr.set(s[0],s[1],s[2]).length(),a=qr.set(s[4],s[5],s[6]).length(),l=qr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Fi.copy(this);let c=1/o,u=1/a,f=1/l;return Fi.elements[0]*=c,Fi.elements[1]*=c,Fi.elements[2]*=c,Fi.elements[4]*=u,Fi.elements[5]*=u,Fi.elements[6]*=u,Fi.elements[8]*=f,Fi.elements[9]*=f,Fi.elements[10]*=f,e.setFromRotationMatrix(Fi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Ti,l=!1){let c=this.elements,u=2*r/(e-t),f=2*r/(i-s),h=(e+t)/(e-t),d=(i+s)/(i-s),m,M;if(l)m=r/(o-r),M=o*r/(o-r);else if(a===Ti)m=-(o+r)/(o-r),M=-2*o*r/(o-r);else if(a===ho)m=-o/(o-r),M=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ti,l=!1){let c=this.elements,u=2/(e-t),f=2/(i-s),h=-(e+t)/(e-t),d=-(i+s)/(i-s),m,M;if(l)m=1/(o-r),M=o/(o-r);else if(a===Ti)m=-2/(o-r),M=-(o+r)/(o-r);else if(a===ho)m=-1/(o-r),M=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},qr=new Y,Fi=new We,gy=new Y(0,0,0),_y=new Y(1,1,1),Os=new Y,xl=new Y,ci=new Y,xm=new We,ym=new di,Ms=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ye(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ye(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ye(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return xm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(xm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ym.setFromEuler(this),this.setFromQuaternion(ym,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ms.DEFAULT_ORDER="XYZ";var la=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},xy=0,vm=new Y,Yr=new di,ds=new We,yl=new Y,Xo=new Y,yy=new Y,vy=new di,Mm=new Y(1,0,0),Sm=new Y(0,1,0),bm=new Y(0,0,1),wm={type:"added"},My={type:"removed"},$r={type:"childadded",child:null},bu={type:"childremoved",child:null},Dn=class n extends zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:xy++}),this.uuid=Ks(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new Y,e=new Ms,i=new di,s=new Y(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new We},normalMatrix:{value:new he}}),this.matrix=new We,this.matrixWorld=new We,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new la,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.multiply(Yr),this}rotateOnWorldAxis(t,e){return Yr.setFromAxisAngle(t,e),this.quaternion.premultiply(Yr),this}rotateX(t){return this.rotateOnAxis(Mm,t)}rotateY(t){return this.rotateOnAxis(Sm,t)}rotateZ(t){return this.rotateOnAxis(bm,t)}translateOnAxis(t,e){return vm.copy(t).applyQuaternion(this.quaternion),this.position.add(vm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Mm,t)}translateY(t){return this.translateOnAxis(Sm,t)}translateZ(t){return this.translateOnAxis(bm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?yl.copy(t):yl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Xo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(Xo,yl,this.up):ds.lookAt(yl,Xo,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Yr.setFromRotationMatrix(ds),this.quaternion.premultiply(Yr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ae("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(wm),$r.child=t,this.dispatchEvent($r),$r.child=null):ae("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(My),bu.child=t,this.dispatchEvent(bu),bu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(wm),$r.child=t,this.dispatchEvent($r),$r.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,t,yy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,vy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(t.shapes,f)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),f=o(t.shapes),h=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Dn.DEFAULT_UP=new Y(0,1,0);Dn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Dn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var pr=class extends Dn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Sy={type:"move"},mo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new pr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new pr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new pr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let M of t.hand.values()){let g=e.getJointPose(M,i),p=this._getHandJoint(c,M);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,m=.005;c.inputState.pinching&&h>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Sy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new pr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Eg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bs={h:0,s:0,l:0},vl={h:0,s:0,l:0};function wu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var pe=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ui){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,be.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=be.workingColorSpace){return this.r=t,this.g=e,this.b=i,be.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=be.workingColorSpace){if(t=Mf(t,1),e=ye(e,0,1),i=ye(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=wu(o,r,t+1/3),this.g=wu(o,r,t),this.b=wu(o,r,t-1/3)}return be.colorSpaceToWorking(this,s),this}setStyle(t,e=ui){function i(r){r!==void 0&&parseFloat(r)<1&&Qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ui){let i=Eg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ys(t.r),this.g=ys(t.g),this.b=ys(t.b),this}copyLinearToSRGB(t){return this.r=lo(t.r),this.g=lo(t.g),this.b=lo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ui){return be.workingToColorSpace(On.copy(this),t),Math.round(ye(On.r*255,0,255))*65536+Math.round(ye(On.g*255,0,255))*256+Math.round(ye(On.b*255,0,255))}getHexString(t=ui){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=be.workingColorSpace){be.workingToColorSpace(On.copy(this),e);let i=On.r,s=On.g,r=On.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=be.workingColorSpace){return be.workingToColorSpace(On.copy(this),e),t.r=On.r,t.g=On.g,t.b=On.b,t}getStyle(t=ui){be.workingToColorSpace(On.copy(this),t);let e=On.r,i=On.g,s=On.b;return t!==ui?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Bs),this.setHSL(Bs.h+t,Bs.s+e,Bs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Bs),t.getHSL(vl);let i=ea(Bs.h,vl.h,e),s=ea(Bs.s,vl.s,e),r=ea(Bs.l,vl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},On=new pe;pe.NAMES=Eg;var ca=class extends Dn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ms,this.environmentIntensity=1,this.environmentRotation=new Ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Oi=new Y,ps=new Y,Tu=new Y,ms=new Y,Zr=new Y,Jr=new Y,Tm=new Y,Eu=new Y,Au=new Y,Ru=new Y,Cu=new je,Pu=new je,Iu=new je,xs=class n{constructor(t=new Y,e=new Y,i=new Y){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Oi.subVectors(t,e),s.cross(Oi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Oi.subVectors(s,e),ps.subVectors(i,e),Tu.subVectors(t,e);let o=Oi.dot(Oi),a=Oi.dot(ps),l=Oi.dot(Tu),c=ps.dot(ps),u=ps.dot(Tu),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,m=(o*u-a*l)*h;return r.set(1-d-m,m,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ms)===null?!1:ms.x>=0&&ms.y>=0&&ms.x+ms.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ms.x),l.addScaledVector(o,ms.y),l.addScaledVector(a,ms.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Cu.setScalar(0),Pu.setScalar(0),Iu.setScalar(0),Cu.fromBufferAttribute(t,e),Pu.fromBufferAttribute(t,i),Iu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Cu,r.x),o.addScaledVector(Pu,r.y),o.addScaledVector(Iu,r.z),o}static isFrontFacing(t,e,i,s){return Oi.subVectors(i,e),ps.subVectors(t,e),Oi.cross(ps).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Oi.subVectors(this.c,this.b),ps.subVectors(this.a,this.b),Oi.cross(ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Zr.subVectors(s,i),Jr.subVectors(r,i),Eu.subVectors(t,i);let l=Zr.dot(Eu),c=Jr.dot(Eu);if(l<=0&&c<=0)return e.copy(i);Au.subVectors(t,s);let u=Zr.dot(Au),f=Jr.dot(Au);if(u>=0&&f<=u)return e.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Zr,o);Ru.subVectors(t,r);let d=Zr.dot(Ru),m=Jr.dot(Ru);if(m>=0&&d<=m)return e.copy(r);let M=d*c-l*m;if(M<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(Jr,a);let g=u*m-d*f;if(g<=0&&f-u>=0&&d-m>=0)return Tm.subVectors(r,s),a=(f-u)/(f-u+(d-m)),e.copy(s).addScaledVector(Tm,a);let p=1/(g+M+h);return o=M*p,a=h*p,e.copy(i).addScaledVector(Zr,o).addScaledVector(Jr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Gs=class{constructor(t=new Y(1/0,1/0,1/0),e=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Bi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Bi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Bi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Bi):Bi.fromBufferAttribute(r,o),Bi.applyMatrix4(t.matrixWorld),this.expandByPoint(Bi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Ml.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ml.copy(i.boundingBox)),Ml.applyMatrix4(t.matrixWorld),this.union(Ml)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Bi),Bi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qo),Sl.subVectors(this.max,qo),Kr.subVectors(t.a,qo),jr.subVectors(t.b,qo),Qr.subVectors(t.c,qo),zs.subVectors(jr,Kr),ks.subVectors(Qr,jr),hr.subVectors(Kr,Qr);let e=[0,-zs.z,zs.y,0,-ks.z,ks.y,0,-hr.z,hr.y,zs.z,0,-zs.x,ks.z,0,-ks.x,hr.z,0,-hr.x,-zs.y,zs.x,0,-ks.y,ks.x,0,-hr.y,hr.x,0];return!Lu(e,Kr,jr,Qr,Sl)||(e=[1,0,0,0,1,0,0,0,1],!Lu(e,Kr,jr,Qr,Sl))?!1:(bl.crossVectors(zs,ks),e=[bl.x,bl.y,bl.z],Lu(e,Kr,jr,Qr,Sl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Bi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Bi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(gs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),gs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),gs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),gs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),gs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),gs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),gs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),gs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(gs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},gs=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Bi=new Y,Ml=new Gs,Kr=new Y,jr=new Y,Qr=new Y,zs=new Y,ks=new Y,hr=new Y,qo=new Y,Sl=new Y,bl=new Y,ur=new Y;function Lu(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ur.fromArray(n,r);let a=s.x*Math.abs(ur.x)+s.y*Math.abs(ur.y)+s.z*Math.abs(ur.z),l=t.dot(ur),c=e.dot(ur),u=i.dot(ur);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var gn=new Y,wl=new jt,by=0,Zn=class extends zi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:by++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=yf,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=t!==void 0?dh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)wl.fromBufferAttribute(this,e),wl.applyMatrix3(t),this.setXY(e,wl.x,wl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.applyMatrix3(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.applyMatrix4(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.applyNormalMatrix(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)gn.fromBufferAttribute(this,e),gn.transformDirection(t),this.setXYZ(e,gn.x,gn.y,gn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):bf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):wf(t,this.array)}};var ha=class extends Zn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ua=class extends Zn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Bn=class extends Zn{constructor(t,e,i){super(new Float32Array(t),e,i)}},wy=new Gs,Yo=new Y,Du=new Y,mr=class{constructor(t=new Y,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):wy.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Yo.subVectors(t,this.center);let e=Yo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Yo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Du.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Yo.copy(t.center).add(Du)),this.expandByPoint(Yo.copy(t.center).sub(Du))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ty=0,wi=new We,Nu=new Dn,to=new Y,hi=new Gs,$o=new Gs,Pn=new Y,Qn=class n extends zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ty++}),this.uuid=Ks(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Jx(t)?ua:ha)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new he().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return wi.makeRotationFromQuaternion(t),this.applyMatrix4(wi),this}rotateX(t){return wi.makeRotationX(t),this.applyMatrix4(wi),this}rotateY(t){return wi.makeRotationY(t),this.applyMatrix4(wi),this}rotateZ(t){return wi.makeRotationZ(t),this.applyMatrix4(wi),this}translate(t,e,i){return wi.makeTranslation(t,e,i),this.applyMatrix4(wi),this}scale(t,e,i){return wi.makeScale(t,e,i),this.applyMatrix4(wi),this}lookAt(t){return Nu.lookAt(t),Nu.updateMatrix(),this.applyMatrix4(Nu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(to).negate(),this.translate(to.x,to.y,to.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Bn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Gs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ae("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];hi.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,hi.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,hi.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(hi.min),this.boundingBox.expandByPoint(hi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ae('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new mr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ae("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(t){let i=this.boundingSphere.center;if(hi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];$o.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(hi.min,$o.min),hi.expandByPoint(Pn),Pn.addVectors(hi.max,$o.max),hi.expandByPoint(Pn)):(hi.expandByPoint($o.min),hi.expandByPoint($o.max))}hi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Pn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Pn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Pn.fromBufferAttribute(a,c),l&&(to.fromBufferAttribute(t,c),Pn.add(to)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ae('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ae("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Zn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let N=0;N<i.count;N++)a[N]=new Y,l[N]=new Y;let u=new Y,f=new Y,h=new Y,d=new jt,m=new jt,M=new jt,g=new Y,p=new Y;function y(N,R,P){c[N]=c[R]=c[P]=1,u.fromBufferAttribute(i,N),f.fromBufferAttribute(i,R),h.fromBufferAttribute(i,P),d.fromBufferAttribute(r,N),m.fromBufferAttribute(r,R),M.fromBufferAttribute(r,P),f.sub(u),h.sub(u),m.sub(d),M.sub(d);let O=1/(m.x*M.y-M.x*m.y);isFinite(O)&&(g.copy(f).multiplyScalar(M.y).addScaledVector(h,-m.y).multiplyScalar(O),p.copy(h).multiplyScalar(m.x).addScaledVector(f,-M.x).multiplyScalar(O),a[N].add(g),a[R].add(g),a[P].add(g),l[N].add(p),l[R].add(p),l[P].add(p))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let N=0,R=w.length;N<R;++N){let P=w[N],O=P.start,V=P.count;for(let L=O,k=O+V;L<k;L+=3)y(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let v=new Y,C=new Y,A=new Y,_=new Y;function S(N){A.fromBufferAttribute(s,N),_.copy(A);let R=a[N];v.copy(R),v.sub(A.multiplyScalar(A.dot(R))).normalize(),C.crossVectors(_,R);let O=C.dot(l[N])<0?-1:1;o.setXYZW(N,v.x,v.y,v.z,O)}for(let N=0,R=i.count;N<R;++N)c[N]&&S(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Zn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,u=new Y,f=new Y;if(t)for(let h=0,d=t.count;h<d;h+=3){let m=t.getX(h+0),M=t.getX(h+1),g=t.getX(h+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,M),o.fromBufferAttribute(e,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,M),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(M,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=e.count;h<d;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Pn.fromBufferAttribute(t,e),Pn.normalize(),t.setXYZ(e,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,m=0;for(let M=0,g=l.length;M<g;M++){a.isInterleavedBufferAttribute?d=l[M]*a.data.stride+a.offset:d=l[M]*u;for(let p=0;p<u;p++)h[m++]=c[d++]}return new Zn(h,u,f)}if(this.index===null)return Qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=t(h,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},sc=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=yf,this.updateRanges=[],this.version=0,this.uuid=Ks()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Em(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Em(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Em(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Ks()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Yn=new Y,fa=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?dh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyMatrix4(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.applyNormalMatrix(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Yn.fromBufferAttribute(this,e),Yn.transformDirection(t),this.setXYZ(e,Yn.x,Yn.y,Yn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){oa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Zn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){oa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):bf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):wf(t,this.data.array)}},Uu=new Y,Ey=new Y,Ay=new he,fi=class{constructor(t=new Y(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Uu.subVectors(i,e).cross(Ey.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Uu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Ay.getNormalMatrix(t),s=this.coplanarPoint(Uu).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Ry=0,ts=class extends zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Ry++}),this.uuid=Ks(),this.name="",this.type="Material",this.blending=bo,this.side=Zs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ju,this.blendDst=Qu,this.blendEquation=xr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new pe(0,0,0),this.blendAlpha=0,this.depthFunc=co,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=gg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Wl,this.stencilZFail=Wl,this.stencilZPass=Wl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new pe().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new fi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new jt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new jt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},go=class extends ts{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new pe(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},eo,Zo=new Y,no=new Y,io=new Y,so=new jt,Jo=new jt,Ag=new We,Tl=new Y,Ko=new Y,El=new Y,Am=new jt,Fu=new jt,Rm=new jt,da=class extends Dn{constructor(t=new go){if(super(),this.isSprite=!0,this.type="Sprite",eo===void 0){eo=new Qn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new sc(e,5);eo.setIndex([0,1,2,0,2,3]),eo.setAttribute("position",new fa(i,3,0,!1)),eo.setAttribute("uv",new fa(i,2,3,!1))}this.geometry=eo,this.material=t,this.center=new jt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ae('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),no.setFromMatrixScale(this.matrixWorld),Ag.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),io.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&no.multiplyScalar(-io.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Al(Tl.set(-.5,-.5,0),io,o,no,s,r),Al(Ko.set(.5,-.5,0),io,o,no,s,r),Al(El.set(.5,.5,0),io,o,no,s,r),Am.set(0,0),Fu.set(1,0),Rm.set(1,1);let a=t.ray.intersectTriangle(Tl,Ko,El,!1,Zo);if(a===null&&(Al(Ko.set(-.5,.5,0),io,o,no,s,r),Fu.set(0,1),a=t.ray.intersectTriangle(Tl,El,Ko,!1,Zo),a===null))return;let l=t.ray.origin.distanceTo(Zo);l<t.near||l>t.far||e.push({distance:l,point:Zo.clone(),uv:xs.getInterpolation(Zo,Tl,Ko,El,Am,Fu,Rm,new jt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function Al(n,t,e,i,s,r){so.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Jo.x=r*so.x-s*so.y,Jo.y=s*so.x+r*so.y):Jo.copy(so),n.copy(t),n.x+=Jo.x,n.y+=Jo.y,n.applyMatrix4(Ag)}var _s=new Y,Ou=new Y,Rl=new Y,Cl=new Y,gr=class{constructor(t=new Y,e=new Y(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_s)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_s.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_s.copy(this.origin).addScaledVector(this.direction,e),_s.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Ou.copy(t).add(e).multiplyScalar(.5),Rl.copy(e).sub(t).normalize(),Cl.copy(this.origin).sub(Ou);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Rl),a=Cl.dot(this.direction),l=-Cl.dot(Rl),c=Cl.lengthSq(),u=Math.abs(1-o*o),f,h,d,m;if(u>0)if(f=o*l-a,h=o*a-l,m=r*u,f>=0)if(h>=-m)if(h<=m){let M=1/u;f*=M,h*=M,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-m?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=m?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ou).addScaledVector(Rl,h),d}intersectSphere(t,e){if(t.radius<0)return null;_s.subVectors(t.center,this.origin);let i=_s.dot(this.direction),s=_s.dot(_s)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(t.min.z-h.z)*f,l=(t.max.z-h.z)*f):(a=(t.max.z-h.z)*f,l=(t.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,_s)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=t.x-o.x,h=t.y-o.y,d=t.z-o.z,m=e.x-o.x,M=e.y-o.y,g=e.z-o.z,p=i.x-o.x,y=i.y-o.y,w=i.z-o.z,v=Math.abs(l),C=Math.abs(c),A=Math.abs(u),_,S,N,R,P,O,V,L,k,H,F,Q;if(v>=C&&v>=A?(N=l,O=f,k=m,Q=p,l>=0?(_=c,S=u,R=h,P=d,V=M,L=g,H=y,F=w):(_=u,S=c,R=d,P=h,V=g,L=M,H=w,F=y)):C>=A?(N=c,O=h,k=M,Q=y,c>=0?(_=u,S=l,R=d,P=f,V=g,L=m,H=w,F=p):(_=l,S=u,R=f,P=d,V=m,L=g,H=p,F=w)):(N=u,O=d,k=g,Q=w,u>=0?(_=l,S=c,R=f,P=h,V=m,L=M,H=p,F=y):(_=c,S=l,R=h,P=f,V=M,L=m,H=y,F=p)),N===0)return null;let W=_/N,$=S/N,tt=1/N,ht=R-W*O,nt=P-$*O,Z=V-W*k,dt=L-$*k,pt=H-W*Q,St=F-$*Q,xt=pt*dt-St*Z,Wt=ht*St-nt*pt,mt=Z*nt-dt*ht;if(s){if(xt<0||Wt<0||mt<0)return null}else if((xt<0||Wt<0||mt<0)&&(xt>0||Wt>0||mt>0))return null;let yt=xt+Wt+mt;if(yt===0)return null;let Xt=tt*(xt*O+Wt*k+mt*Q);return(yt>0?Xt<0:Xt>0)?null:this.at(Xt/yt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rc=class extends ts{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Ec,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Cm=new We,fr=new gr,Pl=new mr,Pm=new Y,Il=new Y,Ll=new Y,Dl=new Y,Bu=new Y,Nl=new Y,Im=new Y,Ul=new Y,mi=class extends Dn{constructor(t=new Qn,e=new rc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(Bu.fromBufferAttribute(f,t),o?Nl.addScaledVector(Bu,u):Nl.addScaledVector(Bu.sub(e),u))}e.add(Nl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Pl.copy(i.boundingSphere),Pl.applyMatrix4(r),fr.copy(t.ray).recast(t.near),!(Pl.containsPoint(fr.origin)===!1&&(fr.intersectSphere(Pl,Pm)===null||fr.origin.distanceToSquared(Pm)>(t.far-t.near)**2))&&(Cm.copy(r).invert(),fr.copy(t.ray).applyMatrix4(Cm),!(i.boundingBox!==null&&fr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,fr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,M=h.length;m<M;m++){let g=h[m],p=o[g.materialIndex],y=Math.max(g.start,d.start),w=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let v=y,C=w;v<C;v+=3){let A=a.getX(v),_=a.getX(v+1),S=a.getX(v+2);s=Fl(this,p,t,i,c,u,f,A,_,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),M=Math.min(a.count,d.start+d.count);for(let g=m,p=M;g<p;g+=3){let y=a.getX(g),w=a.getX(g+1),v=a.getX(g+2);s=Fl(this,o,t,i,c,u,f,y,w,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,M=h.length;m<M;m++){let g=h[m],p=o[g.materialIndex],y=Math.max(g.start,d.start),w=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let v=y,C=w;v<C;v+=3){let A=v,_=v+1,S=v+2;s=Fl(this,p,t,i,c,u,f,A,_,S),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),M=Math.min(l.count,d.start+d.count);for(let g=m,p=M;g<p;g+=3){let y=g,w=g+1,v=g+2;s=Fl(this,o,t,i,c,u,f,y,w,v),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Cy(n,t,e,i,s,r,o,a){let l;if(t.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Zs,a),l===null)return null;Ul.copy(a),Ul.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ul);return c<e.near||c>e.far?null:{distance:c,point:Ul.clone(),object:n}}function Fl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Il),n.getVertexPosition(l,Ll),n.getVertexPosition(c,Dl);let u=Cy(n,t,e,i,Il,Ll,Dl,Im);if(u){let f=new Y;xs.getBarycoord(Im,Il,Ll,Dl,f),s&&(u.uv=xs.getInterpolatedAttribute(s,a,l,c,f,new jt)),r&&(u.uv1=xs.getInterpolatedAttribute(r,a,l,c,f,new jt)),o&&(u.normal=xs.getInterpolatedAttribute(o,a,l,c,f,new Y),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new Y,materialIndex:0};xs.getNormal(Il,Ll,Dl,h.normal),u.face=h,u.barycoord=f}return u}var oc=class extends Kn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=In,u=In,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var dr=new mr,Py=new jt(.5,.5),Ol=new Y,Hs=class{constructor(t=new fi,e=new fi,i=new fi,s=new fi,r=new fi,o=new fi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ti,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],m=r[8],M=r[9],g=r[10],p=r[11],y=r[12],w=r[13],v=r[14],C=r[15];if(s[0].setComponents(c-o,d-u,p-m,C-y).normalize(),s[1].setComponents(c+o,d+u,p+m,C+y).normalize(),s[2].setComponents(c+a,d+f,p+M,C+w).normalize(),s[3].setComponents(c-a,d-f,p-M,C-w).normalize(),i)s[4].setComponents(l,h,g,v).normalize(),s[5].setComponents(c-l,d-h,p-g,C-v).normalize();else if(s[4].setComponents(c-l,d-h,p-g,C-v).normalize(),e===Ti)s[5].setComponents(c+l,d+h,p+g,C+v).normalize();else if(e===ho)s[5].setComponents(l,h,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(t){dr.center.set(0,0,0);let e=Py.distanceTo(t.center);return dr.radius=.7071067811865476+e,dr.applyMatrix4(t.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ol.x=s.normal.x>0?t.max.x:t.min.x,Ol.y=s.normal.y>0?t.max.y:t.min.y,Ol.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ol)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Lm=new We,ac=class n{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Lm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Hs),i[s].setFromProjectionMatrix(Lm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Hs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var _o=class extends ts{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new pe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},lc=new Y,cc=new Y,Dm=new We,jo=new gr,Bl=new mr,zu=new Y,Nm=new Y,hc=class extends Dn{constructor(t=new Qn,e=new _o){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)lc.fromBufferAttribute(e,s-1),cc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=lc.distanceTo(cc);t.setAttribute("lineDistance",new Bn(i,1))}else Qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Bl.copy(i.boundingSphere),Bl.applyMatrix4(s),Bl.radius+=r,t.ray.intersectsSphere(Bl)===!1)return;Dm.copy(s).invert(),jo.copy(t.ray).applyMatrix4(Dm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let M=d,g=m-1;M<g;M+=c){let p=u.getX(M),y=u.getX(M+1),w=zl(this,t,jo,l,p,y,M);w&&e.push(w)}if(this.isLineLoop){let M=u.getX(m-1),g=u.getX(d),p=zl(this,t,jo,l,M,g,m-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let M=d,g=m-1;M<g;M+=c){let p=zl(this,t,jo,l,M,M+1,M);p&&e.push(p)}if(this.isLineLoop){let M=zl(this,t,jo,l,m-1,d,m-1);M&&e.push(M)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function zl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),e.distanceSqToSegment(lc,cc,zu,Nm)>i)return;zu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(zu);if(!(c<t.near||c>t.far))return{distance:c,point:Nm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Um=new Y,Fm=new Y,pa=class extends hc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Um.fromBufferAttribute(e,s),Fm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Um.distanceTo(Fm);t.setAttribute("lineDistance",new Bn(i,1))}else Qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ma=class extends Kn{constructor(t=[],e=yr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ga=class extends Kn{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ss=class extends Kn{constructor(t,e,i=ki,s,r,o,a=In,l=In,c,u=vs,f=1){if(u!==vs&&u!==ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new po(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},_a=class extends Ss{constructor(t,e=ki,i=yr,s,r,o=In,a=In,l,c=vs){let u={width:t,height:t,depth:1},f=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},xa=class extends Kn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},xo=class n extends Qn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Bn(c,3)),this.setAttribute("normal",new Bn(u,3)),this.setAttribute("uv",new Bn(f,2));function m(M,g,p,y,w,v,C,A,_,S,N){let R=v/_,P=C/S,O=v/2,V=C/2,L=A/2,k=_+1,H=S+1,F=0,Q=0,W=new Y;for(let $=0;$<H;$++){let tt=$*P-V;for(let ht=0;ht<k;ht++){let nt=ht*R-O;W[M]=nt*y,W[g]=tt*w,W[p]=L,c.push(W.x,W.y,W.z),W[M]=0,W[g]=0,W[p]=A>0?1:-1,u.push(W.x,W.y,W.z),f.push(ht/_),f.push(1-$/S),F+=1}}for(let $=0;$<S;$++)for(let tt=0;tt<_;tt++){let ht=h+tt+k*$,nt=h+tt+k*($+1),Z=h+(tt+1)+k*($+1),dt=h+(tt+1)+k*$;l.push(ht,nt,dt),l.push(nt,Z,dt),Q+=6}a.addGroup(d,Q,N),d+=Q,h+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ya=class n extends Qn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=t/a,h=e/l,d=[],m=[],M=[],g=[];for(let p=0;p<u;p++){let y=p*h-o;for(let w=0;w<c;w++){let v=w*f-r;m.push(v,-y,0),M.push(0,0,1),g.push(w/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let y=0;y<a;y++){let w=y+c*p,v=y+c*(p+1),C=y+1+c*(p+1),A=y+1+c*p;d.push(w,v,A),d.push(v,C,A)}this.setIndex(d),this.setAttribute("position",new Bn(m,3)),this.setAttribute("normal",new Bn(M,3)),this.setAttribute("uv",new Bn(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function Mr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Om(s))s.isRenderTargetTexture?(Qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Om(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function zn(n){let t={};for(let e=0;e<n.length;e++){let i=Mr(n[e]);for(let s in i)t[s]=i[s]}return t}function Om(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Iy(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Ef(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:be.workingColorSpace}var Rg={clone:Mr,merge:zn},Ly=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Dy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,es=class extends ts{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ly,this.fragmentShader=Dy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Mr(t.uniforms),this.uniformsGroups=Iy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new pe().setHex(s.value);break;case"v2":this.uniforms[i].value=new jt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[i].value=new je().fromArray(s.value);break;case"m3":this.uniforms[i].value=new he().fromArray(s.value);break;case"m4":this.uniforms[i].value=new We().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},uc=class extends es{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var yo=class extends ts{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new pe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new pe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=fh,this.normalScale=new jt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Ec,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},fc=class extends ts{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=pg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},dc=class extends ts{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ro(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function kl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ws=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},pc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gu,endingEnd:Gu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hu:r=t,a=2*e-i;break;case Wu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Hu:o=t,l=2*i-e;break;case Wu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,m=(i-e)/(s-e),M=m*m,g=M*m,p=-h*g+2*h*M-h*m,y=(1+h)*g+(-1.5-2*h)*M+(-.5+h)*m+1,w=(-1-d)*g+(1.5+d)*M+.5*m,v=d*g-d*M;for(let C=0;C!==a;++C)r[C]=p*o[u+C]+y*o[c+C]+w*o[l+C]+v*o[f+C];return r}},mc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},gc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},_c=class extends Ws{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let m=(i-e)/(s-e),M=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*M+o[l+g]*m;return r}let h=a*2,d=t-1;for(let m=0;m!==a;++m){let M=o[c+m],g=o[l+m],p=d*h+m*2,y=f[p],w=f[p+1],v=t*h+m*2,C=u[v],A=u[v+1],_=Uy(i,e,y,C,s);r[m]=Cg(_,M,w,A,g)}return r}};function Cg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Ny(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Uy(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Cg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Ny(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var gi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ro(e,this.TimeBufferType),this.values=ro(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ro(t.times,Array),values:ro(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),kl(t.settings)&&(i.settings={inTangents:ro(t.settings.inTangents,Array),outTangents:ro(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new gc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new pc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new _c(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case na:e=this.InterpolantFactoryMethodDiscrete;break;case tc:e=this.InterpolantFactoryMethodLinear;break;case Hl:e=this.InterpolantFactoryMethodSmooth;break;case Vu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return na;case this.InterpolantFactoryMethodLinear:return tc;case this.InterpolantFactoryMethodSmooth:return Hl;case this.InterpolantFactoryMethodBezier:return Vu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;kl(this.settings)&&(Bm(this.settings.inTangents,t),Bm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;kl(this.settings)&&(zm(this.settings.inTangents,t),zm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ae("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ae("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ae("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ae("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Kx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ae("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Hl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let m=0;m!==i;++m){let M=e[f+m];if(M!==e[h+m]||M!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)e[h+d]=e[f+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,kl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Bm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function zm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=tc;var Xs=class extends gi{constructor(t,e,i){super(t,e,i)}};Xs.prototype.ValueTypeName="bool";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=na;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var xc=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};xc.prototype.ValueTypeName="color";var yc=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};yc.prototype.ValueTypeName="number";var vc=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)di.slerpFlat(r,0,o,c-a,o,c,l);return r}},va=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new vc(this.times,this.values,this.getValueSize(),t)}};va.prototype.ValueTypeName="quaternion";va.prototype.InterpolantFactoryMethodSmooth=void 0;var qs=class extends gi{constructor(t,e,i){super(t,e,i)}};qs.prototype.ValueTypeName="string";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=na;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Mc=class extends gi{constructor(t,e,i,s){super(t,e,i,s)}};Mc.prototype.ValueTypeName="vector";var Sc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],m=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Pg=new Sc,bc=class{constructor(t){this.manager=t!==void 0?t:Pg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};bc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ma=class extends Dn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new pe(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var ku=new We,km=new Y,Vm=new Y,wc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new jt(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new We,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Hs,this._frameExtents=new jt(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;km.setFromMatrixPosition(t.matrixWorld),e.position.copy(km),Vm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Vm),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){ku.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(ku,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===ho||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(ku)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Vl=new Y,Gl=new di,ji=new Y,Sa=class extends Dn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new We,this.projectionMatrix=new We,this.projectionMatrixInverse=new We,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Vl,Gl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,ji.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Vl,Gl,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Vl,Gl,ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Vs=new Y,Gm=new jt,Hm=new jt,$n=class extends Sa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=fo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ta*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return fo*2*Math.atan(Math.tan(ta*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Vs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Vs.x,Vs.y).multiplyScalar(-t/Vs.z),Vs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Vs.x,Vs.y).multiplyScalar(-t/Vs.z)}getViewSize(t,e){return this.getViewBounds(t,Gm,Hm),e.subVectors(Hm,Gm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ta*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ba=class extends Sa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Xu=class extends wc{constructor(){super(new ba(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wa=class extends Ma{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Dn.DEFAULT_UP),this.updateMatrix(),this.target=new Dn,this.shadow=new Xu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Ta=class extends Ma{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var oo=-90,ao=1,vo=class extends Dn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new $n(oo,ao,t,e);s.layers=this.layers,this.add(s);let r=new $n(oo,ao,t,e);r.layers=this.layers,this.add(r);let o=new $n(oo,ao,t,e);o.layers=this.layers,this.add(o);let a=new $n(oo,ao,t,e);a.layers=this.layers,this.add(a);let l=new $n(oo,ao,t,e);l.layers=this.layers,this.add(l);let c=new $n(oo,ao,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ti)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ho)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=t.getRenderTarget(),h=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let M=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=M,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(f,h,d),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Tc=class extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Af="\\[\\]\\.:\\/",Fy=new RegExp("["+Af+"]","g"),Rf="[^"+Af+"]",Oy="[^"+Af.replace("\\.","")+"]",By=/((?:WC+[\/:])*)/.source.replace("WC",Rf),zy=/(WCOD+)?/.source.replace("WCOD",Oy),ky=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Rf),Vy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Rf),Gy=new RegExp("^"+By+zy+ky+Vy+"$"),Hy=["material","materials","bones","map"],qu=class{constructor(t,e,i){let s=i||Je.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Je=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Fy,"")}static parseTrackName(t){let e=Gy.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Hy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ae("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ae("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ae("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ae("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ae("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ae("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ae("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ae("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ae("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ae("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Je.Composite=qu;Je.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Je.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Je.prototype.GetterByBindingType=[Je.prototype._getValue_direct,Je.prototype._getValue_array,Je.prototype._getValue_arrayElement,Je.prototype._getValue_toArray];Je.prototype.SetterByBindingTypeAndVersioning=[[Je.prototype._setValue_direct,Je.prototype._setValue_direct_setNeedsUpdate,Je.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_array,Je.prototype._setValue_array_setNeedsUpdate,Je.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_arrayElement,Je.prototype._setValue_arrayElement_setNeedsUpdate,Je.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Je.prototype._setValue_fromArray,Je.prototype._setValue_fromArray_setNeedsUpdate,Je.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Q1=new Float32Array(1);var Mo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ye(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ea=class extends zi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Cf(n,t,e,i){let s=Wy(i);switch(e){case df:return n*t;case mf:return n*t/s.components*s.byteLength;case Dc:return n*t/s.components*s.byteLength;case Js:return n*t*2/s.components*s.byteLength;case Nc:return n*t*2/s.components*s.byteLength;case pf:return n*t*3/s.components*s.byteLength;case Hi:return n*t*4/s.components*s.byteLength;case Uc:return n*t*4/s.components*s.byteLength;case Ca:case Pa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ia:case La:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Oc:case zc:return Math.max(n,16)*Math.max(t,8)/4;case Fc:case Bc:return Math.max(n,8)*Math.max(t,8)/2;case kc:case Vc:case Hc:case Wc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Gc:case Da:case Xc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case qc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Yc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case $c:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Zc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Kc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case jc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Qc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case th:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case eh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case nh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case ih:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case sh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case rh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case oh:case ah:case lh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case ch:case hh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Na:case uh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Wy(n){switch(n){case ti:case cf:return{byteLength:1,components:1};case To:case hf:case Gi:return{byteLength:2,components:1};case Ic:case Lc:return{byteLength:2,components:4};case ki:case Pc:case Vi:return{byteLength:4,components:1};case uf:case ff:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function jg(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function qy(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,m)=>d.start-m.start);let h=0;for(let d=1;d<f.length;d++){let m=f[h],M=f[d];M.start<=m.start+m.count+1?m.count=Math.max(m.count,M.start+M.count-m.start):(++h,f[h]=M)}f.length=h+1;for(let d=0,m=f.length;d<m;d++){let M=f[d];n.bufferSubData(c,M.start*u.BYTES_PER_ELEMENT,u,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Yy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,$y=`#ifdef USE_ALPHAHASH
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
#endif`,Zy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Jy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ky=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,jy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Qy=`#ifdef USE_AOMAP
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
#endif`,tv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ev=`#ifdef USE_BATCHING
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
#endif`,nv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,iv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,sv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,rv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ov=`#ifdef USE_IRIDESCENCE
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
#endif`,av=`#ifdef USE_BUMPMAP
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
#endif`,lv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,cv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,hv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,uv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,fv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,dv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,pv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,mv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,gv=`#define PI 3.141592653589793
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
} // validated`,_v=`vec3 transformedNormal = objectNormal;
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
#endif`,xv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,vv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Mv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Sv="gl_FragColor = linearToOutputTexel( gl_FragColor );",bv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,wv=`#ifdef USE_ENVMAP
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
#endif`,Tv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ev=`#ifdef USE_ENVMAP
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
#endif`,Av=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Rv=`#ifdef USE_ENVMAP
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
#endif`,Cv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Pv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Iv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Lv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Dv=`#ifdef USE_GRADIENTMAP
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
}`,Nv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Uv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Fv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ov=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Bv=`#ifdef USE_ENVMAP
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
#endif`,zv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,kv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Vv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Gv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Hv=`PhysicalMaterial material;
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
#endif`,Wv=`uniform sampler2D dfgLUT;
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
}`,Xv=`
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
#endif`,qv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Yv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,$v=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Zv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Jv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Kv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Qv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,tM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,eM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,nM=`#if defined( USE_POINTS_UV )
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
#endif`,iM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,sM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,rM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,oM=`#if defined( USE_MORPHCOLORS )
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
#endif`,aM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lM=`#ifdef USE_MORPHTARGETS
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
#endif`,cM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,uM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,fM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,mM=`#ifdef USE_NORMALMAP
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
#endif`,gM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,_M=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,xM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,vM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,MM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,SM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,bM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,wM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,TM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,EM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,AM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,RM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,CM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,PM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,IM=`float getShadowMask() {
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
}`,LM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,DM=`#ifdef USE_SKINNING
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
#endif`,NM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,UM=`#ifdef USE_SKINNING
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
#endif`,FM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,OM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,BM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,zM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,kM=`#ifdef USE_TRANSMISSION
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
#endif`,VM=`#ifdef USE_TRANSMISSION
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
#endif`,GM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,HM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,WM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,XM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,qM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,YM=`uniform sampler2D t2D;
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
}`,$M=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ZM=`uniform float backgroundBlurriness;
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
}`,JM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,KM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,jM=`#include <common>
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
}`,QM=`#if DEPTH_PACKING == 3200
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
}`,tS=`#define DISTANCE
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
}`,eS=`#define DISTANCE
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
}`,nS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,iS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sS=`uniform float scale;
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
}`,rS=`uniform vec3 diffuse;
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
}`,oS=`#include <common>
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
}`,aS=`uniform vec3 diffuse;
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
}`,lS=`#define LAMBERT
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
}`,cS=`#define LAMBERT
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
}`,hS=`#define MATCAP
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
}`,uS=`#define MATCAP
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
}`,fS=`#define NORMAL
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
}`,dS=`#define NORMAL
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
}`,pS=`#define PHONG
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
}`,mS=`#define PHONG
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
}`,gS=`#define STANDARD
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
}`,_S=`#define STANDARD
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
}`,xS=`#define TOON
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
}`,yS=`#define TOON
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
}`,vS=`uniform float size;
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
}`,MS=`uniform vec3 diffuse;
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
}`,SS=`#include <common>
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
}`,bS=`uniform vec3 color;
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
}`,wS=`uniform float rotation;
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
}`,TS=`uniform vec3 diffuse;
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
}`,me={alphahash_fragment:Yy,alphahash_pars_fragment:$y,alphamap_fragment:Zy,alphamap_pars_fragment:Jy,alphatest_fragment:Ky,alphatest_pars_fragment:jy,aomap_fragment:Qy,aomap_pars_fragment:tv,batching_pars_vertex:ev,batching_vertex:nv,begin_vertex:iv,beginnormal_vertex:sv,bsdfs:rv,iridescence_fragment:ov,bumpmap_pars_fragment:av,clipping_planes_fragment:lv,clipping_planes_pars_fragment:cv,clipping_planes_pars_vertex:hv,clipping_planes_vertex:uv,color_fragment:fv,color_pars_fragment:dv,color_pars_vertex:pv,color_vertex:mv,common:gv,defaultnormal_vertex:_v,displacementmap_pars_vertex:xv,displacementmap_vertex:yv,emissivemap_fragment:vv,emissivemap_pars_fragment:Mv,colorspace_fragment:Sv,colorspace_pars_fragment:bv,envmap_fragment:wv,envmap_common_pars_fragment:Tv,envmap_pars_fragment:Ev,envmap_pars_vertex:Av,envmap_physical_pars_fragment:Bv,envmap_vertex:Rv,fog_vertex:Cv,fog_pars_vertex:Pv,fog_fragment:Iv,fog_pars_fragment:Lv,gradientmap_pars_fragment:Dv,lightmap_pars_fragment:Nv,lights_lambert_fragment:Uv,lights_lambert_pars_fragment:Fv,lights_pars_begin:Ov,lights_toon_fragment:zv,lights_toon_pars_fragment:kv,lights_phong_fragment:Vv,lights_phong_pars_fragment:Gv,lights_physical_fragment:Hv,lights_physical_pars_fragment:Wv,lights_fragment_begin:Xv,lights_fragment_maps:qv,lights_fragment_end:Yv,lightprobes_pars_fragment:$v,logdepthbuf_fragment:Zv,logdepthbuf_pars_fragment:Jv,logdepthbuf_pars_vertex:Kv,logdepthbuf_vertex:jv,map_fragment:Qv,map_pars_fragment:tM,map_particle_fragment:eM,map_particle_pars_fragment:nM,metalnessmap_fragment:iM,metalnessmap_pars_fragment:sM,morphinstance_vertex:rM,morphcolor_vertex:oM,morphnormal_vertex:aM,morphtarget_pars_vertex:lM,morphtarget_vertex:cM,normal_fragment_begin:hM,normal_fragment_maps:uM,normal_pars_fragment:fM,normal_pars_vertex:dM,normal_vertex:pM,normalmap_pars_fragment:mM,clearcoat_normal_fragment_begin:gM,clearcoat_normal_fragment_maps:_M,clearcoat_pars_fragment:xM,iridescence_pars_fragment:yM,opaque_fragment:vM,packing:MM,premultiplied_alpha_fragment:SM,project_vertex:bM,dithering_fragment:wM,dithering_pars_fragment:TM,roughnessmap_fragment:EM,roughnessmap_pars_fragment:AM,shadowmap_pars_fragment:RM,shadowmap_pars_vertex:CM,shadowmap_vertex:PM,shadowmask_pars_fragment:IM,skinbase_vertex:LM,skinning_pars_vertex:DM,skinning_vertex:NM,skinnormal_vertex:UM,specularmap_fragment:FM,specularmap_pars_fragment:OM,tonemapping_fragment:BM,tonemapping_pars_fragment:zM,transmission_fragment:kM,transmission_pars_fragment:VM,uv_pars_fragment:GM,uv_pars_vertex:HM,uv_vertex:WM,worldpos_vertex:XM,background_vert:qM,background_frag:YM,backgroundCube_vert:$M,backgroundCube_frag:ZM,cube_vert:JM,cube_frag:KM,depth_vert:jM,depth_frag:QM,distance_vert:tS,distance_frag:eS,equirect_vert:nS,equirect_frag:iS,linedashed_vert:sS,linedashed_frag:rS,meshbasic_vert:oS,meshbasic_frag:aS,meshlambert_vert:lS,meshlambert_frag:cS,meshmatcap_vert:hS,meshmatcap_frag:uS,meshnormal_vert:fS,meshnormal_frag:dS,meshphong_vert:pS,meshphong_frag:mS,meshphysical_vert:gS,meshphysical_frag:_S,meshtoon_vert:xS,meshtoon_frag:yS,points_vert:vS,points_frag:MS,shadow_vert:SS,shadow_frag:bS,sprite_vert:wS,sprite_frag:TS},Nt={common:{diffuse:{value:new pe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new he}},envmap:{envMap:{value:null},envMapRotation:{value:new he},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new he}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new he}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new he},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new he},normalScale:{value:new jt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new he},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new he}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new he}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new he}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new pe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new pe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0},uvTransform:{value:new he}},sprite:{diffuse:{value:new pe(16777215)},opacity:{value:1},center:{value:new jt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new he},alphaMap:{value:null},alphaMapTransform:{value:new he},alphaTest:{value:0}}},ss={basic:{uniforms:zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:me.meshbasic_vert,fragmentShader:me.meshbasic_frag},lambert:{uniforms:zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)},envMapIntensity:{value:1}}]),vertexShader:me.meshlambert_vert,fragmentShader:me.meshlambert_frag},phong:{uniforms:zn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)},specular:{value:new pe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:me.meshphong_vert,fragmentShader:me.meshphong_frag},standard:{uniforms:zn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag},toon:{uniforms:zn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new pe(0)}}]),vertexShader:me.meshtoon_vert,fragmentShader:me.meshtoon_frag},matcap:{uniforms:zn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:me.meshmatcap_vert,fragmentShader:me.meshmatcap_frag},points:{uniforms:zn([Nt.points,Nt.fog]),vertexShader:me.points_vert,fragmentShader:me.points_frag},dashed:{uniforms:zn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:me.linedashed_vert,fragmentShader:me.linedashed_frag},depth:{uniforms:zn([Nt.common,Nt.displacementmap]),vertexShader:me.depth_vert,fragmentShader:me.depth_frag},normal:{uniforms:zn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:me.meshnormal_vert,fragmentShader:me.meshnormal_frag},sprite:{uniforms:zn([Nt.sprite,Nt.fog]),vertexShader:me.sprite_vert,fragmentShader:me.sprite_frag},background:{uniforms:{uvTransform:{value:new he},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:me.background_vert,fragmentShader:me.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new he}},vertexShader:me.backgroundCube_vert,fragmentShader:me.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:me.cube_vert,fragmentShader:me.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:me.equirect_vert,fragmentShader:me.equirect_frag},distance:{uniforms:zn([Nt.common,Nt.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:me.distance_vert,fragmentShader:me.distance_frag},shadow:{uniforms:zn([Nt.lights,Nt.fog,{color:{value:new pe(0)},opacity:{value:1}}]),vertexShader:me.shadow_vert,fragmentShader:me.shadow_frag}};ss.physical={uniforms:zn([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new he},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new he},clearcoatNormalScale:{value:new jt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new he},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new he},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new he},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new he},sheen:{value:0},sheenColor:{value:new pe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new he},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new he},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new he},transmissionSamplerSize:{value:new jt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new he},attenuationDistance:{value:0},attenuationColor:{value:new pe(0)},specularColor:{value:new pe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new he},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new he},anisotropyVector:{value:new jt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new he}}]),vertexShader:me.meshphysical_vert,fragmentShader:me.meshphysical_frag};var ph={r:0,b:0,g:0},ES=new We,Qg=new he;Qg.set(-1,0,0,0,1,0,0,0,1);function AS(n,t,e,i,s,r){let o=new pe(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(y){let w=y.isScene===!0?y.background:null;if(w&&w.isTexture){let v=y.backgroundBlurriness>0;w=t.get(w,v)}return w}function m(y){let w=!1,v=d(y);v===null?g(o,a):v&&v.isColor&&(g(v,1),w=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function M(y,w){let v=d(w);v&&v.isCubeTexture?(c===void 0&&(c=new mi(new xo(1,1,1),new es({name:"BackgroundCubeMaterial",uniforms:Mr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ES.makeRotationFromEuler(w.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Qg),c.material.toneMapped=be.getTransfer(v.colorSpace)!==Ue,(u!==v||f!==v.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,f=v.version,h=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new mi(new ya(2,2),new es({name:"BackgroundMaterial",uniforms:Mr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:Zs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=be.getTransfer(v.colorSpace)!==Ue,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||f!==v.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,f=v.version,h=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function g(y,w){y.getRGB(ph,Ef(n)),e.buffers.color.setClear(ph.r,ph.g,ph.b,w,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,w=1){o.set(y),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:m,addToRenderList:M,dispose:p}}function RS(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(P,O,V,L,k){let H=!1,F=f(P,L,V,O);r!==F&&(r=F,c(r.object)),H=d(P,L,V,k),H&&m(P,L,V,k),k!==null&&t.update(k,n.ELEMENT_ARRAY_BUFFER),(H||o)&&(o=!1,v(P,O,V,L),k!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(k).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function u(P){return n.deleteVertexArray(P)}function f(P,O,V,L){let k=L.wireframe===!0,H=i[O.id];H===void 0&&(H={},i[O.id]=H);let F=P.isInstancedMesh===!0?P.id:0,Q=H[F];Q===void 0&&(Q={},H[F]=Q);let W=Q[V.id];W===void 0&&(W={},Q[V.id]=W);let $=W[k];return $===void 0&&($=h(l()),W[k]=$),$}function h(P){let O=[],V=[],L=[];for(let k=0;k<e;k++)O[k]=0,V[k]=0,L[k]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:V,attributeDivisors:L,object:P,attributes:{},index:null}}function d(P,O,V,L){let k=r.attributes,H=O.attributes,F=0,Q=V.getAttributes();for(let W in Q)if(Q[W].location>=0){let tt=k[W],ht=H[W];if(ht===void 0&&(W==="instanceMatrix"&&P.instanceMatrix&&(ht=P.instanceMatrix),W==="instanceColor"&&P.instanceColor&&(ht=P.instanceColor)),tt===void 0||tt.attribute!==ht||ht&&tt.data!==ht.data)return!0;F++}return r.attributesNum!==F||r.index!==L}function m(P,O,V,L){let k={},H=O.attributes,F=0,Q=V.getAttributes();for(let W in Q)if(Q[W].location>=0){let tt=H[W];tt===void 0&&(W==="instanceMatrix"&&P.instanceMatrix&&(tt=P.instanceMatrix),W==="instanceColor"&&P.instanceColor&&(tt=P.instanceColor));let ht={};ht.attribute=tt,tt&&tt.data&&(ht.data=tt.data),k[W]=ht,F++}r.attributes=k,r.attributesNum=F,r.index=L}function M(){let P=r.newAttributes;for(let O=0,V=P.length;O<V;O++)P[O]=0}function g(P){p(P,0)}function p(P,O){let V=r.newAttributes,L=r.enabledAttributes,k=r.attributeDivisors;V[P]=1,L[P]===0&&(n.enableVertexAttribArray(P),L[P]=1),k[P]!==O&&(n.vertexAttribDivisor(P,O),k[P]=O)}function y(){let P=r.newAttributes,O=r.enabledAttributes;for(let V=0,L=O.length;V<L;V++)O[V]!==P[V]&&(n.disableVertexAttribArray(V),O[V]=0)}function w(P,O,V,L,k,H,F){F===!0?n.vertexAttribIPointer(P,O,V,k,H):n.vertexAttribPointer(P,O,V,L,k,H)}function v(P,O,V,L){M();let k=L.attributes,H=V.getAttributes(),F=O.defaultAttributeValues;for(let Q in H){let W=H[Q];if(W.location>=0){let $=k[Q];if($===void 0&&(Q==="instanceMatrix"&&P.instanceMatrix&&($=P.instanceMatrix),Q==="instanceColor"&&P.instanceColor&&($=P.instanceColor)),$!==void 0){let tt=$.normalized,ht=$.itemSize,nt=t.get($);if(nt===void 0)continue;let Z=nt.buffer,dt=nt.type,pt=nt.bytesPerElement,St=dt===n.INT||dt===n.UNSIGNED_INT||$.gpuType===Pc;if($.isInterleavedBufferAttribute){let xt=$.data,Wt=xt.isInterleavedBuffer===!0?xt.stride:xt.itemSize,mt=$.offset;if(xt.isInstancedInterleavedBuffer||xt.isInstancedBufferAttribute){for(let yt=0;yt<W.locationSize;yt++)p(W.location+yt,xt.meshPerAttribute);P.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=xt.meshPerAttribute*xt.count)}else for(let yt=0;yt<W.locationSize;yt++)g(W.location+yt);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let yt=0;yt<W.locationSize;yt++)w(W.location+yt,ht/W.locationSize,dt,tt,Wt*pt,(mt+ht/W.locationSize*yt)*pt,St)}else{if($.isInstancedBufferAttribute){for(let xt=0;xt<W.locationSize;xt++)p(W.location+xt,$.meshPerAttribute);P.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let xt=0;xt<W.locationSize;xt++)g(W.location+xt);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let xt=0;xt<W.locationSize;xt++)w(W.location+xt,ht/W.locationSize,dt,tt,ht*pt,ht/W.locationSize*xt*pt,St)}}else if(F!==void 0){let tt=F[Q];if(tt!==void 0)switch(tt.length){case 2:n.vertexAttrib2fv(W.location,tt);break;case 3:n.vertexAttrib3fv(W.location,tt);break;case 4:n.vertexAttrib4fv(W.location,tt);break;default:n.vertexAttrib1fv(W.location,tt)}}}}y()}function C(){N();for(let P in i){let O=i[P];for(let V in O){let L=O[V];for(let k in L){let H=L[k];for(let F in H)u(H[F].object),delete H[F];delete L[k]}}delete i[P]}}function A(P){if(i[P.id]===void 0)return;let O=i[P.id];for(let V in O){let L=O[V];for(let k in L){let H=L[k];for(let F in H)u(H[F].object),delete H[F];delete L[k]}}delete i[P.id]}function _(P){for(let O in i){let V=i[O];for(let L in V){let k=V[L];if(k[P.id]===void 0)continue;let H=k[P.id];for(let F in H)u(H[F].object),delete H[F];delete k[P.id]}}}function S(P){for(let O in i){let V=i[O],L=P.isInstancedMesh===!0?P.id:0,k=V[L];if(k!==void 0){for(let H in k){let F=k[H];for(let Q in F)u(F[Q].object),delete F[Q];delete k[H]}delete V[L],Object.keys(V).length===0&&delete i[O]}}}function N(){R(),o=!0,r!==s&&(r=s,c(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:R,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:S,releaseStatesOfProgram:_,initAttributes:M,enableAttribute:g,disableUnusedAttributes:y}}function CS(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function PS(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Hi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let S=_===Gi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ti&&_!==Vi&&!S&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Qt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:m,maxTextureSize:M,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:y,maxVaryings:w,maxFragmentUniforms:v,maxSamples:C,samples:A}}function IS(n){let t=this,e=null,i=0,s=!1,r=!1,o=new fi,a=new he,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){e=u(f,h,0)},this.setState=function(f,h,d){let m=f.clippingPlanes,M=f.clipIntersection,g=f.clipShadows,p=n.get(f);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let y=r?0:i,w=y*4,v=p.clippingState||null;l.value=v,v=u(m,h,w,d);for(let C=0;C!==w;++C)v[C]=e[C];p.clippingState=v,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(f,h,d,m){let M=f!==null?f.length:0,g=null;if(M!==0){if(g=l.value,m!==!0||g===null){let p=d+M*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<p)&&(g=new Float32Array(p));for(let w=0,v=d;w!==M;++w,v+=4)o.copy(f[w]).applyMatrix4(y,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=M,t.numIntersection=0,g}}var Oa=class extends pi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ma(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new xo(5,5,5),r=new es({name:"CubemapFromEquirect",uniforms:Mr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:_r});r.uniforms.tEquirect.value=e;let o=new mi(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=Jn),new vo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Ig=256,LS=3,DS=20,t0=256,e0=16,NS=3,US=new Y,FS=new pe,gh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new vo(1,10,null),this._boxMesh=new mi(new xo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=US}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,M=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,M===null&&(t.background=l.getClearColor(FS));let g=new vo(i,s,u);return g.position.copy(a),g.update(l,t),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=m,t.background=M,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ng(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Dg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Ig,Sf(t))}_fromTexture(t,e){t.mapping===yr||t.mapping===wo?this._setSize(t.image.length===0?Ig:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Lg(t,!1,!1),i=Math.log2(t)-LS;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Lg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===yr||t.mapping===wo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ng()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Dg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=OS(),this._integrationMaterial=BS());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/e0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-NS)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(t0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=zS());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Lg(n,t,e){return new Oa(n,{minFilter:bs,generateMipmaps:t,type:Gi,colorSpace:ia,depthBuffer:e})}function Ba(n,t,e){return new es({name:n,uniforms:t,vertexShader:me.cube_vert,fragmentShader:e,side:jn,blending:_r,depthTest:!1,depthWrite:!1})}function OS(){return Ba("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${t0}u

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
	`)}function BS(){return Ba("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:e0}},`

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
	`)}function zS(){return Ba("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${DS}
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
	`)}function Dg(){return Ba("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ng(){return Ba("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function kS(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===Ac||d===Rc)if(t.has(h)){let m=t.get(h).texture;return a(m,h.mapping)}else{let m=h.image;if(m&&m.height>0){let M=new Oa(m.height);return M.fromEquirectangularTexture(n,h),t.set(h,M),h.addEventListener("dispose",c),a(M.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,m=d===Ac||d===Rc,M=d===yr||d===wo;if(m||M){let g=e.get(h),p=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return i===null&&(i=new gh(n)),g=m?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return m&&y&&y.height>0||M&&y&&l(y)?(i===null&&(i=new gh(n)),g=m?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,e.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===Ac?h.mapping=yr:d===Rc&&(h.mapping=wo),h}function l(h){let d=0,m=6;for(let M=0;M<m;M++)h[M]!==void 0&&d++;return d===m}function c(h){let d=h.target;d.removeEventListener("dispose",c);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function f(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function VS(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Qo("WebGLRenderer: "+i+" extension not supported."),s}}}function GS(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let M=r.get(m);M&&(t.remove(M),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,M){return s[M.id]!==void 0||(M.addEventListener("dispose",a),s[M.id]=new WeakRef(M),o.register(M,M.id,M),e.memory.geometries++),M}function u(m){let M=m.attributes;for(let g in M)t.update(M[g],n.ARRAY_BUFFER)}function f(m){let M=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let y=M!==null?M.array.length:g.array.length/3-1,w=g.count>=65535?ua:ha,v=new w(Math.ceil(y/3)*6,1),C=v.array;if(M!==null){let _=M.array;p=M.version;for(let S=0,N=0;S<y;S+=3){let R=_[S+0],P=_[S+1],O=_[S+2];C[N++]=R,C[N++]=P,C[N++]=P,C[N++]=O,C[N++]=O,C[N++]=R}}else{p=g.version;for(let _=0,S=0;_<y;_+=3){let N=_+0,R=_+1,P=_+2;C[S++]=N,C[S++]=R,C[S++]=R,C[S++]=P,C[S++]=P,C[S++]=N}}v.version=p;let A=r.get(m);A&&t.remove(A),r.set(m,v)}function h(m){let M=r.get(m);if(M){let g=m.index;g!==null&&M.version<g.version&&f(m)}else f(m);return r.get(m)}function d(){for(let m in s){let M=s[m].deref();M!==void 0&&l(M)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function HS(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),e.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),e.update(h,i,d))}function u(f,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let M=0;for(let g=0;g<d;g++)M+=h[g];e.update(M,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function WS(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ae("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function XS(n,t,e){let i=new WeakMap,s=new je;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let N=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",N)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],w=0;d===!0&&(w=1),m===!0&&(w=2),M===!0&&(w=3);let v=a.attributes.position.count*w,C=1;v>t.maxTextureSize&&(C=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let A=new Float32Array(v*C*4*f),_=new aa(A,v,C,f);_.type=Vi,_.needsUpdate=!0;let S=w*4;for(let R=0;R<f;R++){let P=g[R],O=p[R],V=y[R],L=v*C*4*R;for(let k=0;k<P.count;k++){let H=k*S;d===!0&&(s.fromBufferAttribute(P,k),A[L+H+0]=s.x,A[L+H+1]=s.y,A[L+H+2]=s.z,A[L+H+3]=0),m===!0&&(s.fromBufferAttribute(O,k),A[L+H+4]=s.x,A[L+H+5]=s.y,A[L+H+6]=s.z,A[L+H+7]=0),M===!0&&(s.fromBufferAttribute(V,k),A[L+H+8]=s.x,A[L+H+9]=s.y,A[L+H+10]=s.z,A[L+H+11]=V.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new jt(v,C)},i.set(a,h),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let M=0;M<c.length;M++)d+=c[M];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function qS(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=t.get(c,f);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var YS={[tf]:"LINEAR_TONE_MAPPING",[ef]:"REINHARD_TONE_MAPPING",[nf]:"CINEON_TONE_MAPPING",[sf]:"ACES_FILMIC_TONE_MAPPING",[of]:"AGX_TONE_MAPPING",[af]:"NEUTRAL_TONE_MAPPING",[rf]:"CUSTOM_TONE_MAPPING"};function $S(n,t,e,i,s,r){let o=new pi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Qn;u.setAttribute("position",new Bn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Bn([0,2,0,0,2,0],2));let f=new uc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new mi(u,f),d=new ba(-1,1,1,-1,0,1),m=null,M=null,g=!1,p,y=null,w=[],v=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let _=0;_<w.length;_++){let S=w[_];S.setSize&&S.setSize(C,A)}},this.setEffects=function(C){w=C,v=w.length>0&&w[0].isRenderPass===!0;let A=o.width,_=o.height;w.length>0&&a===null&&(a=new pi(A,_,{type:Gi,depthBuffer:!1,stencilBuffer:!1}),l=new pi(A,_,{type:Gi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&w.some(N=>N.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Ss(A,_),r===!0&&(c.format=ws,c.type=vr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let N=0;N<w.length;N++){let R=w[N];R.setSize&&R.setSize(A,_),S&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(C,A){if(g||C.toneMapping===ns&&w.length===0)return!1;if(y=A,A!==null){let _=A.width,S=A.height;(o.width!==_||o.height!==S)&&this.setSize(_,S)}return v===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=ns,!0},this.hasRenderPass=function(){return v},this.end=function(C,A){C.toneMapping=p,g=!0;let _=o,S=a;for(let N=0;N<w.length;N++){let R=w[N];R.enabled!==!1&&(R.render(C,S,_,A),R.needsSwap!==!1&&(_=S,S=S===a?l:a))}if(m!==C.outputColorSpace||M!==C.toneMapping){m=C.outputColorSpace,M=C.toneMapping,f.defines={},be.getTransfer(m)===Ue&&(f.defines.SRGB_TRANSFER="");let N=YS[M];N&&(f.defines[N]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(y),C.render(h,d),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var n0=new Kn,i0=new Ss(1,1),s0=new _a(1),r0=new aa,o0=new ic,a0=new ma,Ug=[],Fg=[],Og=new Float32Array(16),Bg=new Float32Array(9),zg=new Float32Array(4);function Ao(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Ug[s];if(r===void 0&&(r=new Float32Array(s),Ug[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function vn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Mn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function xh(n,t){let e=Fg[t];e===void 0&&(e=new Int32Array(t),Fg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function ZS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function JS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2fv(this.addr,t),Mn(e,t)}}function KS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vn(e,t))return;n.uniform3fv(this.addr,t),Mn(e,t)}}function jS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4fv(this.addr,t),Mn(e,t)}}function QS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Mn(e,t)}else{if(vn(e,i))return;zg.set(i),n.uniformMatrix2fv(this.addr,!1,zg),Mn(e,i)}}function tb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Mn(e,t)}else{if(vn(e,i))return;Bg.set(i),n.uniformMatrix3fv(this.addr,!1,Bg),Mn(e,i)}}function eb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Mn(e,t)}else{if(vn(e,i))return;Og.set(i),n.uniformMatrix4fv(this.addr,!1,Og),Mn(e,i)}}function nb(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function ib(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2iv(this.addr,t),Mn(e,t)}}function sb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;n.uniform3iv(this.addr,t),Mn(e,t)}}function rb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4iv(this.addr,t),Mn(e,t)}}function ob(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function ab(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2uiv(this.addr,t),Mn(e,t)}}function lb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;n.uniform3uiv(this.addr,t),Mn(e,t)}}function cb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4uiv(this.addr,t),Mn(e,t)}}function yh(n){return n.version===0&&(n.compareFunction=xf,n.needsUpdate=!0),n}function hb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=yh(i0):r=n0,e.setTexture2D(t||r,s)}function ub(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||o0,s)}function fb(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=yh(s0):r=a0,e.setTextureCube(t||r,s)}function db(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||r0,s)}function pb(n){switch(n){case 5126:return ZS;case 35664:return JS;case 35665:return KS;case 35666:return jS;case 35674:return QS;case 35675:return tb;case 35676:return eb;case 5124:case 35670:return nb;case 35667:case 35671:return ib;case 35668:case 35672:return sb;case 35669:case 35673:return rb;case 5125:return ob;case 36294:return ab;case 36295:return lb;case 36296:return cb;case 35678:case 36198:case 36298:case 36306:case 35682:return hb;case 35679:case 36299:case 36307:return ub;case 35680:case 36300:case 36308:case 36293:return fb;case 36289:case 36303:case 36311:case 36292:return db}}function mb(n,t){n.uniform1fv(this.addr,t)}function gb(n,t){let e=Ao(t,this.size,2);n.uniform2fv(this.addr,e)}function _b(n,t){let e=Ao(t,this.size,3);n.uniform3fv(this.addr,e)}function xb(n,t){let e=Ao(t,this.size,4);n.uniform4fv(this.addr,e)}function yb(n,t){let e=Ao(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function vb(n,t){let e=Ao(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Mb(n,t){let e=Ao(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Sb(n,t){n.uniform1iv(this.addr,t)}function bb(n,t){n.uniform2iv(this.addr,t)}function wb(n,t){n.uniform3iv(this.addr,t)}function Tb(n,t){n.uniform4iv(this.addr,t)}function Eb(n,t){n.uniform1uiv(this.addr,t)}function Ab(n,t){n.uniform2uiv(this.addr,t)}function Rb(n,t){n.uniform3uiv(this.addr,t)}function Cb(n,t){n.uniform4uiv(this.addr,t)}function Pb(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=yh(i0):o=n0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Ib(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||o0,r[o])}function Lb(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=yh(s0):o=a0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Db(n,t,e){let i=this.cache,s=t.length,r=xh(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),Mn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||r0,r[o])}function Nb(n){switch(n){case 5126:return mb;case 35664:return gb;case 35665:return _b;case 35666:return xb;case 35674:return yb;case 35675:return vb;case 35676:return Mb;case 5124:case 35670:return Sb;case 35667:case 35671:return bb;case 35668:case 35672:return wb;case 35669:case 35673:return Tb;case 5125:return Eb;case 36294:return Ab;case 36295:return Rb;case 36296:return Cb;case 35678:case 36198:case 36298:case 36306:case 35682:return Pb;case 35679:case 36299:case 36307:return Ib;case 35680:case 36300:case 36308:case 36293:return Lb;case 36289:case 36303:case 36311:case 36292:return Db}}var Lf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=pb(e.type)}},Df=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Nb(e.type)}},Nf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Pf=/(\w+)(\])?(\[|\.)?/g;function kg(n,t){n.seq.push(t),n.map[t.id]=t}function Ub(n,t,e){let i=n.name,s=i.length;for(Pf.lastIndex=0;;){let r=Pf.exec(i),o=Pf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){kg(e,c===void 0?new Lf(a,n,t):new Df(a,n,t));break}else{let f=e.map[a];f===void 0&&(f=new Nf(a),kg(e,f)),e=f}}}var Eo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Ub(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Vg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var Fb=37297,Ob=0;function Bb(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Gg=new he;function zb(n){be._getMatrix(Gg,be.workingColorSpace,n);let t=`mat3( ${Gg.elements.map(e=>e.toFixed(4))} )`;switch(be.getTransfer(n)){case sa:return[t,"LinearTransferOETF"];case Ue:return[t,"sRGBTransferOETF"];default:return Qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Hg(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Bb(n.getShaderSource(t),a)}else return r}function kb(n,t){let e=zb(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Vb={[tf]:"Linear",[ef]:"Reinhard",[nf]:"Cineon",[sf]:"ACESFilmic",[of]:"AgX",[af]:"Neutral",[rf]:"Custom"};function Gb(n,t){let e=Vb[t];return e===void 0?(Qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var mh=new Y;function Hb(){be.getLuminanceCoefficients(mh);let n=mh.x.toFixed(4),t=mh.y.toFixed(4),e=mh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Wb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function Xb(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function qb(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Fa(n){return n!==""}function Wg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Xg(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Yb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Uf(n){return n.replace(Yb,$b)}function $b(n,t){let e=me[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Uf(e)}var Zb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function qg(n){return n.replace(Zb,Jb)}function Jb(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Yg(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var Kb={[Aa]:"SHADOWMAP_TYPE_PCF",[So]:"SHADOWMAP_TYPE_VSM"};function jb(n){return Kb[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Qb={[wo]:"ENVMAP_MODE_REFRACTION"};function tw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Qb[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ew={[Ec]:"ENVMAP_BLENDING_MULTIPLY",[ug]:"ENVMAP_BLENDING_MIX",[fg]:"ENVMAP_BLENDING_ADD"};function nw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":ew[n.combine]||"ENVMAP_BLENDING_NONE"}function iw(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=jb(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=tw(e),f=nw(e),h=Wb(e),d=Xb(r),m=s.createProgram(),M,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(M=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Fa).join(`
`),M.length>0&&(M+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Fa).join(`
`),g.length>0&&(g+=`
`)):(M=[Yg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),g=[Yg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ns?"#define TONE_MAPPING":"",e.toneMapping!==ns?me.tonemapping_pars_fragment:"",e.toneMapping!==ns?Gb("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",me.colorspace_pars_fragment,kb("linearToOutputTexel",e.outputColorSpace),Hb(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Fa).join(`
`)),o=Uf(o),o=Wg(o,e),o=Xg(o,e),a=Uf(a),a=Wg(a,e),a=Xg(a,e),o=qg(o),a=qg(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,M=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,g=["#define varying in",e.glslVersion===vf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===vf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=p+M+o,w=p+g+a,v=Vg(s,s.VERTEX_SHADER,y),C=Vg(s,s.FRAGMENT_SHADER,w);s.attachShader(m,v),s.attachShader(m,C),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(R){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(m)||"",O=s.getShaderInfoLog(v)||"",V=s.getShaderInfoLog(C)||"",L=P.trim(),k=O.trim(),H=V.trim(),F=!0,Q=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(F=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,v,C);else{let W=Hg(s,v,"vertex"),$=Hg(s,C,"fragment");ae("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+L+`
`+W+`
`+$)}else L!==""?Qt("WebGLProgram: Program Info Log:",L):(k===""||H==="")&&(Q=!1);Q&&(R.diagnostics={runnable:F,programLog:L,vertexShader:{log:k,prefix:M},fragmentShader:{log:H,prefix:g}})}s.deleteShader(v),s.deleteShader(C),_=new Eo(s,m),S=qb(s,m)}let _;this.getUniforms=function(){return _===void 0&&A(this),_};let S;this.getAttributes=function(){return S===void 0&&A(this),S};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(m,Fb)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Ob++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=v,this.fragmentShader=C,this}var sw=0,Ff=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Of(t),e.set(t,i)),i}},Of=class{constructor(t){this.id=sw++,this.code=t,this.usedTimes=0}};function rw(n){return n===Js||n===Da||n===Na}function ow(n,t,e,i,s,r){let o=new la,a=new Ff,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,S,N,R,P,O){let V=R.fog,L=P.geometry,k=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?R.environment:null,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,F=t.get(_.envMap||k,H),Q=h[_.type],W=i.precision;_.precision!==null&&(W=i.getMaxPrecision(_.precision),W!==_.precision&&Qt("WebGLProgram.getParameters:",_.precision,"not supported, using",W,"instead."));let $=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,tt=$!==void 0?$.length:0,ht=0;L.morphAttributes.position!==void 0&&(ht=1),L.morphAttributes.normal!==void 0&&(ht=2),L.morphAttributes.color!==void 0&&(ht=3);let nt,Z,dt,pt;if(Q){let It=ss[Q];nt=It.vertexShader,Z=It.fragmentShader}else{nt=_.vertexShader,Z=_.fragmentShader;let It=a.getVertexShaderStage(_),fe=a.getFragmentShaderStage(_);a.update(_,It,fe),dt=It.id,pt=fe.id}let St=n.getRenderTarget(),xt=n.state.buffers.depth.getReversed(),Wt=P.isInstancedMesh===!0,mt=P.isBatchedMesh===!0,yt=!!_.map,Xt=!!_.matcap,qt=!!F,Yt=qt&&F.isPMREMTexture===!0,ie=!!_.aoMap,se=!!_.lightMap,Ae=!!_.bumpMap&&_.wireframe===!1,ge=!!_.normalMap,we=!!_.displacementMap,ce=!!_.emissiveMap,He=!!_.metalnessMap,Le=!!_.roughnessMap,Re=_.anisotropy>0,B=_.clearcoat>0,Pt=_.diffuseRoughness>0,Ft=_.dispersion>0,Jt=_.retroreflectivity>0,bt=_.iridescence>0,Fe=_.sheen>0,Gt=_.transmission>0,Kt=Re&&!!_.anisotropyMap,I=B&&!!_.clearcoatMap,b=B&&!!_.clearcoatNormalMap,q=B&&!!_.clearcoatRoughnessMap,ut=Pt&&!!_.diffuseRoughnessMap,ot=bt&&!!_.iridescenceMap,vt=bt&&!!_.iridescenceThicknessMap,wt=Fe&&!!_.sheenColorMap,it=Fe&&!!_.sheenRoughnessMap,rt=!!_.specularMap,_t=!!_.specularColorMap,z=!!_.specularIntensityMap,at=Gt&&!!_.transmissionMap,st=Gt&&!!_.thicknessMap,At=!!_.gradientMap,Mt=!!_.alphaMap,Et=_.alphaTest>0,$t=!!_.alphaHash,re=!!_.extensions,ft=ns;_.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ft=n.toneMapping);let kt=Yt?F.isCompressedCubeTexture?F.image[0].mipmaps:F.mipmaps:null,oe={shaderID:Q,shaderType:_.type,shaderName:_.name,vertexShader:nt,fragmentShader:Z,defines:_.defines,customVertexShaderID:dt,customFragmentShaderID:pt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:W,batching:mt,batchingColor:mt&&P._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&P.instanceColor!==null,instancingMorph:Wt&&P.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:be.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:yt,matcap:Xt,envMap:qt,envMapMode:qt&&F.mapping,envMapPMREM:Yt,envMapMaxLod:Yt?kt.length-1:null,envMapSize:Yt?kt[0].width:null,aoMap:ie,lightMap:se,bumpMap:Ae,normalMap:ge,displacementMap:we,emissiveMap:ce,normalMapObjectSpace:ge&&_.normalMapType===mg,normalMapTangentSpace:ge&&_.normalMapType===fh,packedNormalMap:ge&&_.normalMapType===fh&&rw(_.normalMap.format),metalnessMap:He,roughnessMap:Le,anisotropy:Re,anisotropyMap:Kt,clearcoat:B,clearcoatMap:I,clearcoatNormalMap:b,clearcoatRoughnessMap:q,diffuseRoughness:Pt,diffuseRoughnessMap:ut,dispersion:Ft,retroreflection:Jt,iridescence:bt,iridescenceMap:ot,iridescenceThicknessMap:vt,sheen:Fe,sheenColorMap:wt,sheenRoughnessMap:it,specularMap:rt,specularColorMap:_t,specularIntensityMap:z,transmission:Gt,transmissionMap:at,thicknessMap:st,gradientMap:At,opaque:_.transparent===!1&&_.blending===bo&&_.alphaToCoverage===!1,alphaMap:Mt,alphaTest:Et,alphaHash:$t,combine:_.combine,mapUv:yt&&d(_.map.channel),aoMapUv:ie&&d(_.aoMap.channel),lightMapUv:se&&d(_.lightMap.channel),bumpMapUv:Ae&&d(_.bumpMap.channel),normalMapUv:ge&&d(_.normalMap.channel),displacementMapUv:we&&d(_.displacementMap.channel),emissiveMapUv:ce&&d(_.emissiveMap.channel),metalnessMapUv:He&&d(_.metalnessMap.channel),roughnessMapUv:Le&&d(_.roughnessMap.channel),anisotropyMapUv:Kt&&d(_.anisotropyMap.channel),clearcoatMapUv:I&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:b&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:wt&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&d(_.sheenRoughnessMap.channel),specularMapUv:rt&&d(_.specularMap.channel),specularColorMapUv:_t&&d(_.specularColorMap.channel),specularIntensityMapUv:z&&d(_.specularIntensityMap.channel),transmissionMapUv:at&&d(_.transmissionMap.channel),thicknessMapUv:st&&d(_.thicknessMap.channel),alphaMapUv:Mt&&d(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(ge||Re),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!L.attributes.uv&&(yt||Mt),fog:!!V,useFog:_.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&ge===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:xt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:ht,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:O.filter(It=>It.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:ft,decodeVideoTexture:yt&&_.map.isVideoTexture===!0&&be.getTransfer(_.map.colorSpace)===Ue,decodeVideoTextureEmissive:ce&&_.emissiveMap.isVideoTexture===!0&&be.getTransfer(_.emissiveMap.colorSpace)===Ue,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ei,flipSided:_.side===jn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:re&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(re&&_.extensions.multiDraw===!0||mt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return oe.vertexUv1s=l.has(1),oe.vertexUv2s=l.has(2),oe.vertexUv3s=l.has(3),l.clear(),oe}function M(_){let S=[];if(_.shaderID?S.push(_.shaderID):(S.push(_.customVertexShaderID),S.push(_.customFragmentShaderID)),_.defines!==void 0)for(let N in _.defines)S.push(N),S.push(_.defines[N]);return _.isRawShaderMaterial===!1&&(g(S,_),p(S,_),S.push(n.outputColorSpace)),S.push(_.customProgramCacheKey),S.join()}function g(_,S){_.push(S.precision),_.push(S.outputColorSpace),_.push(S.envMapMode),_.push(S.envMapPMREM),_.push(S.envMapMaxLod),_.push(S.envMapSize),_.push(S.mapUv),_.push(S.alphaMapUv),_.push(S.lightMapUv),_.push(S.aoMapUv),_.push(S.bumpMapUv),_.push(S.normalMapUv),_.push(S.displacementMapUv),_.push(S.emissiveMapUv),_.push(S.metalnessMapUv),_.push(S.roughnessMapUv),_.push(S.anisotropyMapUv),_.push(S.clearcoatMapUv),_.push(S.clearcoatNormalMapUv),_.push(S.clearcoatRoughnessMapUv),_.push(S.diffuseRoughnessMapUv),_.push(S.iridescenceMapUv),_.push(S.iridescenceThicknessMapUv),_.push(S.sheenColorMapUv),_.push(S.sheenRoughnessMapUv),_.push(S.specularMapUv),_.push(S.specularColorMapUv),_.push(S.specularIntensityMapUv),_.push(S.transmissionMapUv),_.push(S.thicknessMapUv),_.push(S.combine),_.push(S.fogExp2),_.push(S.sizeAttenuation),_.push(S.morphTargetsCount),_.push(S.numSunLights),_.push(S.numDirLights),_.push(S.numPointLights),_.push(S.numSpotLights),_.push(S.numSpotLightMaps),_.push(S.numHemiLights),_.push(S.numRectAreaLights),_.push(S.numSunLightShadows),_.push(S.numDirLightShadows),_.push(S.numPointLightShadows),_.push(S.numSpotLightShadows),_.push(S.numSpotLightShadowsWithMaps),_.push(S.numLightProbes),_.push(S.numLightProbeGrids),_.push(S.shadowMapType),_.push(S.toneMapping),_.push(S.numClippingPlanes),_.push(S.numClipIntersection),_.push(S.depthPacking)}function p(_,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let S=h[_.type],N;if(S){let R=ss[S];N=Rg.clone(R.uniforms)}else N=_.uniforms;return N}function w(_,S){let N=u.get(S);return N!==void 0?++N.usedTimes:(N=new iw(n,S,_,s),c.push(N),u.set(S,N)),N}function v(_){if(--_.usedTimes===0){let S=c.indexOf(_);c[S]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:M,getUniforms:y,acquireProgram:w,releaseProgram:v,releaseShaderCache:C,programs:c,dispose:A}}function aw(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function lw(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function $g(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Zg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,m,M,g,p){let y=n[t];return y===void 0?(y={id:h.id,object:h,geometry:d,material:m,materialVariant:o(h),groupOrder:M,renderOrder:h.renderOrder,z:g,group:p},n[t]=y):(y.id=h.id,y.object=h,y.geometry=d,y.material=m,y.materialVariant=o(h),y.groupOrder=M,y.renderOrder=h.renderOrder,y.z=g,y.group=p),t++,y}function l(h,d,m,M,g,p,y){y.reversedDepth===!0&&(g=-g);let w=a(h,d,m,M,g,p);m.transmission>0?i.push(w):m.transparent===!0?s.push(w):e.push(w)}function c(h,d,m,M,g,p){let y=a(h,d,m,M,g,p);m.transmission>0?i.unshift(y):m.transparent===!0?s.unshift(y):e.unshift(y)}function u(h,d){e.length>1&&e.sort(h||lw),i.length>1&&i.sort(d||$g),s.length>1&&s.sort(d||$g)}function f(){for(let h=t,d=n.length;h<d;h++){let m=n[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function cw(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Zg,n.set(i,[o])):s>=r.length?(o=new Zg,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function hw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new Y,color:new pe};break;case"SpotLight":e={position:new Y,direction:new Y,color:new pe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new Y,color:new pe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new Y,skyColor:new pe,groundColor:new pe};break;case"RectAreaLight":e={color:new pe,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return n[t.id]=e,e}}}function uw(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new jt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var fw=0;function dw(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function pw(n){let t=new hw,e=uw(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Y);let s=new Y,r=new We,o=new We;function a(c){let u=0,f=0,h=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let d=0,m=0,M=0,g=0,p=0,y=0,w=0,v=0,C=0,A=0,_=0,S=0,N=0,R=0;c.sort(dw);for(let O=0,V=c.length;O<V;O++){let L=c[O],k=L.color,H=L.intensity,F=L.distance,Q=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Js?Q=L.shadow.map.texture:Q=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=k.r*H,f+=k.g*H,h+=k.b*H;else if(L.isLightProbe){for(let W=0;W<9;W++)i.probe[W].addScaledVector(L.sh.coefficients[W],H);R++}else if(L.isSunLight){let W=t.get(L);if(W.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let $=L.shadow,tt=e.get(L);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize.copy($.mapSize).multiply($.getFrameExtents()),i.sunShadow[m]=tt,i.sunShadowMap[m]=Q;let ht=$.getViewportCount();for(let nt=0;nt<ht;nt++)i.sunShadowMatrix[M+nt]=$.getMatrix(nt),i.sunShadowCascade[M+nt]=$._cascadeData[nt];M+=ht,m++}i.sun[d]=W,d++}else if(L.isDirectionalLight){let W=t.get(L);if(W.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let $=L.shadow,tt=e.get(L);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize=$.mapSize,i.directionalShadow[g]=tt,i.directionalShadowMap[g]=Q,i.directionalShadowMatrix[g]=L.shadow.matrix,C++}i.directional[g]=W,g++}else if(L.isSpotLight){let W=t.get(L);W.position.setFromMatrixPosition(L.matrixWorld),W.color.copy(k).multiplyScalar(H),W.distance=F,W.coneCos=Math.cos(L.angle),W.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),W.decay=L.decay,i.spot[y]=W;let $=L.shadow;if(L.map&&(i.spotLightMap[S]=L.map,S++,$.updateMatrices(L),L.castShadow&&N++),i.spotLightMatrix[y]=$.matrix,L.castShadow){let tt=e.get(L);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize=$.mapSize,i.spotShadow[y]=tt,i.spotShadowMap[y]=Q,_++}y++}else if(L.isRectAreaLight){let W=t.get(L);W.color.copy(k).multiplyScalar(H),W.halfWidth.set(L.width*.5,0,0),W.halfHeight.set(0,L.height*.5,0),i.rectArea[w]=W,w++}else if(L.isPointLight){let W=t.get(L);if(W.color.copy(L.color).multiplyScalar(L.intensity),W.distance=L.distance,W.decay=L.decay,L.castShadow){let $=L.shadow,tt=e.get(L);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize=$.mapSize,tt.shadowCameraNear=$.camera.near,tt.shadowCameraFar=$.camera.far,i.pointShadow[p]=tt,i.pointShadowMap[p]=Q,i.pointShadowMatrix[p]=L.shadow.matrix,A++}i.point[p]=W,p++}else if(L.isHemisphereLight){let W=t.get(L);W.skyColor.copy(L.color).multiplyScalar(H),W.groundColor.copy(L.groundColor).multiplyScalar(H),i.hemi[v]=W,v++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Nt.LTC_FLOAT_1,i.rectAreaLTC2=Nt.LTC_FLOAT_2):(i.rectAreaLTC1=Nt.LTC_HALF_1,i.rectAreaLTC2=Nt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let P=i.hash;(P.sunLength!==d||P.directionalLength!==g||P.pointLength!==p||P.spotLength!==y||P.rectAreaLength!==w||P.hemiLength!==v||P.numSunShadows!==m||P.numDirectionalShadows!==C||P.numPointShadows!==A||P.numSpotShadows!==_||P.numSpotMaps!==S||P.numLightProbes!==R)&&(i.sun.length=d,i.directional.length=g,i.spot.length=y,i.rectArea.length=w,i.point.length=p,i.hemi.length=v,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=M,i.sunShadowCascade.length=M,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+S-N,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=N,i.numLightProbes=R,P.sunLength=d,P.directionalLength=g,P.pointLength=p,P.spotLength=y,P.rectAreaLength=w,P.hemiLength=v,P.numSunShadows=m,P.numDirectionalShadows=C,P.numPointShadows=A,P.numSpotShadows=_,P.numSpotMaps=S,P.numLightProbes=R,i.version=fw++)}function l(c,u){let f=0,h=0,d=0,m=0,M=0,g=0,p=u.matrixWorldInverse;for(let y=0,w=c.length;y<w;y++){let v=c[y];if(v.isSunLight){let C=i.sun[f];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(p),f++}else if(v.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),h++}else if(v.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),m++}else if(v.isRectAreaLight){let C=i.rectArea[M];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(v.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(v.width*.5,0,0),C.halfHeight.set(0,v.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),M++}else if(v.isPointLight){let C=i.point[d];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),d++}else if(v.isHemisphereLight){let C=i.hemi[g];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:i}}function Jg(n){let t=new pw(n),e=[],i=[],s=[];function r(f){u.camera=f,e.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):e.push(f)}function a(f){i.push(f)}function l(){t.setup(e),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){t.setupView(e,f)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function mw(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Jg(n),t.set(s,[a])):r>=o.length?(a=new Jg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var gw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,_w=`uniform sampler2D shadow_pass;
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
}`,xw=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],yw=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],Kg=new We,Ua=new Y,If=new Y;function vw(n,t,e){let i=new Hs,s=new jt,r=new jt,o=new je,a=new fc,l=new dc,c={},u=e.maxTextureSize,f={[Zs]:jn,[jn]:Zs,[Ei]:Ei},h=new es({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new jt},radius:{value:4}},vertexShader:gw,fragmentShader:_w}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let m=new Qn;m.setAttribute("position",new Zn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new mi(m,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Aa;let p=this.type;this.render=function(A,_,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===qm&&(Qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Aa);let N=n.getRenderTarget(),R=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),O=n.state;O.setBlending(_r),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let V=p!==this.type;V&&_.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(k=>k.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,k=A.length;L<k;L++){let H=A[L],F=H.shadow;if(F===void 0){Qt("WebGLShadowMap:",H,"has no shadow.");continue}if(F.autoUpdate===!1&&F.needsUpdate===!1)continue;s.copy(F.mapSize);let Q=F.getFrameExtents();s.multiply(Q),r.copy(F.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Q.x),s.x=r.x*Q.x,F.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Q.y),s.y=r.y*Q.y,F.mapSize.y=r.y));let W=n.state.buffers.depth.getReversed();if(F.camera._reversedDepth=W,F.map===null||V===!0){if(F.map!==null&&(F.map.depthTexture!==null&&(F.map.depthTexture.dispose(),F.map.depthTexture=null),F.map.dispose()),this.type===So){if(H.isPointLight){Qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}F.map=new pi(s.x,s.y,{format:Js,type:Gi,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),F.map.texture.name=H.name+".shadowMap",F.map.depthTexture=new Ss(s.x,s.y,Vi),F.map.depthTexture.name=H.name+".shadowMapDepth",F.map.depthTexture.format=vs,F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=In,F.map.depthTexture.magFilter=In}else H.isPointLight?(F.map=new Oa(s.x),F.map.depthTexture=new _a(s.x,ki)):(F.map=new pi(s.x,s.y),F.map.depthTexture=new Ss(s.x,s.y,ki)),F.map.depthTexture.name=H.name+".shadowMap",F.map.depthTexture.format=vs,this.type===Aa?(F.map.depthTexture.compareFunction=W?_f:gf,F.map.depthTexture.minFilter=Jn,F.map.depthTexture.magFilter=Jn):(F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=In,F.map.depthTexture.magFilter=In);F.camera.updateProjectionMatrix()}F.map.isWebGLCubeRenderTarget!==!0&&(F.map.width!==s.x||F.map.height!==s.y)&&F.map.setSize(s.x,s.y);let $=F.map.isWebGLCubeRenderTarget?6:F.getViewportCount();H.isPointLight!==!0&&F.updateMatrices(H,S);let tt=(F.camera.layers.mask&4294967294)!==0?F.camera.layers:S.layers;for(let ht=0;ht<$;ht++){let nt=F.getCamera(ht);if(H.isPointLight){let Z=F.camera,dt=F.matrix,pt=H.distance||Z.far;pt!==Z.far&&(Z.far=pt,Z.updateProjectionMatrix()),Ua.setFromMatrixPosition(H.matrixWorld),Z.position.copy(Ua),If.copy(Z.position),If.add(xw[ht]),Z.up.copy(yw[ht]),Z.lookAt(If),Z.updateMatrixWorld(),dt.makeTranslation(-Ua.x,-Ua.y,-Ua.z),Kg.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),F._frustum.setFromProjectionMatrix(Kg,Z.coordinateSystem,Z.reversedDepth)}if(F.map.isWebGLCubeRenderTarget)n.setRenderTarget(F.map,ht),n.clear();else{ht===0&&(n.setRenderTarget(F.map),n.clear());let Z=F.getViewport(ht);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),O.viewport(o)}i=F.getFrustum(ht),v(_,S,nt,H,tt,this.type)}F.isPointLightShadow!==!0&&this.type===So&&y(F,S),F.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(N,R,P)};function y(A,_){let S=t.update(M);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new pi(s.x,s.y,{format:Js,type:Gi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(_,null,S,h,M,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(_,null,S,d,M,null)}function w(A,_,S,N){let R=null,P=S.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(P!==void 0)R=P;else if(R=S.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=R.uuid,V=_.uuid,L=c[O];L===void 0&&(L={},c[O]=L);let k=L[V];k===void 0&&(k=R.clone(),L[V]=k,_.addEventListener("dispose",C)),R=k}if(R.visible=_.visible,R.wireframe=_.wireframe,N===So?R.side=_.shadowSide!==null?_.shadowSide:_.side:R.side=_.shadowSide!==null?_.shadowSide:f[_.side],R.alphaMap=_.alphaMap,R.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,R.map=_.map,R.clipShadows=_.clipShadows,R.clippingPlanes=_.clippingPlanes,R.clipIntersection=_.clipIntersection,R.displacementMap=_.displacementMap,R.displacementScale=_.displacementScale,R.displacementBias=_.displacementBias,R.wireframeLinewidth=_.wireframeLinewidth,R.linewidth=_.linewidth,S.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let O=n.properties.get(R);O.light=S}return R}function v(A,_,S,N,R,P){if(A.visible===!1)return;if(A.layers.test(R)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&P===So)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,A.matrixWorld);let L=t.update(A),k=A.material;if(Array.isArray(k)){let H=L.groups;for(let F=0,Q=H.length;F<Q;F++){let W=H[F],$=k[W.materialIndex];if($&&$.visible){let tt=w(A,$,N,P);A.onBeforeShadow(n,A,_,S,L,tt,W),n.renderBufferDirect(S,null,L,tt,A,W),A.onAfterShadow(n,A,_,S,L,tt,W)}}}else if(k.visible){let H=w(A,k,N,P);A.onBeforeShadow(n,A,_,S,L,H,null),n.renderBufferDirect(S,null,L,H,A,null),A.onAfterShadow(n,A,_,S,L,H,null)}}let V=A.children;for(let L=0,k=V.length;L<k;L++)v(V[L],_,S,N,R,P)}function C(A){A.target.removeEventListener("dispose",C);for(let S in c){let N=c[S],R=A.target.uuid;R in N&&(N[R].dispose(),delete N[R])}}}function Mw(n,t){function e(){let z=!1,at=new je,st=null,At=new je(0,0,0,0);return{setMask:function(Mt){st!==Mt&&!z&&(n.colorMask(Mt,Mt,Mt,Mt),st=Mt)},setLocked:function(Mt){z=Mt},setClear:function(Mt,Et,$t,re,ft){ft===!0&&(Mt*=re,Et*=re,$t*=re),at.set(Mt,Et,$t,re),At.equals(at)===!1&&(n.clearColor(Mt,Et,$t,re),At.copy(at))},reset:function(){z=!1,st=null,At.set(-1,0,0,0)}}}function i(){let z=!1,at=!1,st=null,At=null,Mt=null;return{setReversed:function(Et){if(at!==Et){let $t=t.get("EXT_clip_control");Et?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),at=Et;let re=Mt;Mt=null,this.setClear(re)}},getReversed:function(){return at},setTest:function(Et){Et?xt(n.DEPTH_TEST):Wt(n.DEPTH_TEST)},setMask:function(Et){st!==Et&&!z&&(n.depthMask(Et),st=Et)},setFunc:function(Et){if(at&&(Et=Tg[Et]),At!==Et){switch(Et){case Xl:n.depthFunc(n.NEVER);break;case ql:n.depthFunc(n.ALWAYS);break;case Yl:n.depthFunc(n.LESS);break;case co:n.depthFunc(n.LEQUAL);break;case $l:n.depthFunc(n.EQUAL);break;case Zl:n.depthFunc(n.GEQUAL);break;case Jl:n.depthFunc(n.GREATER);break;case Kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=Et}},setLocked:function(Et){z=Et},setClear:function(Et){Mt!==Et&&(Mt=Et,at&&(Et=1-Et),n.clearDepth(Et))},reset:function(){z=!1,st=null,At=null,Mt=null,at=!1}}}function s(){let z=!1,at=null,st=null,At=null,Mt=null,Et=null,$t=null,re=null,ft=null;return{setTest:function(kt){z||(kt?xt(n.STENCIL_TEST):Wt(n.STENCIL_TEST))},setMask:function(kt){at!==kt&&!z&&(n.stencilMask(kt),at=kt)},setFunc:function(kt,oe,It){(st!==kt||At!==oe||Mt!==It)&&(n.stencilFunc(kt,oe,It),st=kt,At=oe,Mt=It)},setOp:function(kt,oe,It){(Et!==kt||$t!==oe||re!==It)&&(n.stencilOp(kt,oe,It),Et=kt,$t=oe,re=It)},setLocked:function(kt){z=kt},setClear:function(kt){ft!==kt&&(n.clearStencil(kt),ft=kt)},reset:function(){z=!1,at=null,st=null,At=null,Mt=null,Et=null,$t=null,re=null,ft=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,m=[],M=null,g=!1,p=null,y=null,w=null,v=null,C=null,A=null,_=null,S=new pe(0,0,0),N=0,R=!1,P=null,O=null,V=null,L=null,k=null,H=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),F=!1,Q=0,W=n.getParameter(n.VERSION);W.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(W)[1]),F=Q>=1):W.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(W)[1]),F=Q>=2);let $=null,tt={},ht=n.getParameter(n.SCISSOR_BOX),nt=n.getParameter(n.VIEWPORT),Z=new je().fromArray(ht),dt=new je().fromArray(nt);function pt(z,at,st,At){let Mt=new Uint8Array(4),Et=n.createTexture();n.bindTexture(z,Et),n.texParameteri(z,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(z,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $t=0;$t<st;$t++)z===n.TEXTURE_3D||z===n.TEXTURE_2D_ARRAY?n.texImage3D(at,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,Mt):n.texImage2D(at+$t,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,Mt);return Et}let St={};St[n.TEXTURE_2D]=pt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=pt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=pt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=pt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xt(n.DEPTH_TEST),o.setFunc(co),Ae(!1),ge($u),xt(n.CULL_FACE),ie(_r);function xt(z){u[z]!==!0&&(n.enable(z),u[z]=!0)}function Wt(z){u[z]!==!1&&(n.disable(z),u[z]=!1)}function mt(z,at){return h[z]!==at?(n.bindFramebuffer(z,at),h[z]=at,z===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=at),z===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=at),!0):!1}function yt(z,at){let st=m,At=!1;if(z){st=d.get(at),st===void 0&&(st=[],d.set(at,st));let Mt=z.textures;if(st.length!==Mt.length||st[0]!==n.COLOR_ATTACHMENT0){for(let Et=0,$t=Mt.length;Et<$t;Et++)st[Et]=n.COLOR_ATTACHMENT0+Et;st.length=Mt.length,At=!0}}else st[0]!==n.BACK&&(st[0]=n.BACK,At=!0);At&&n.drawBuffers(st)}function Xt(z){return M!==z?(n.useProgram(z),M=z,!0):!1}let qt={[xr]:n.FUNC_ADD,[$m]:n.FUNC_SUBTRACT,[Zm]:n.FUNC_REVERSE_SUBTRACT};qt[Jm]=n.MIN,qt[Km]=n.MAX;let Yt={[jm]:n.ZERO,[Qm]:n.ONE,[tg]:n.SRC_COLOR,[ju]:n.SRC_ALPHA,[og]:n.SRC_ALPHA_SATURATE,[sg]:n.DST_COLOR,[ng]:n.DST_ALPHA,[eg]:n.ONE_MINUS_SRC_COLOR,[Qu]:n.ONE_MINUS_SRC_ALPHA,[rg]:n.ONE_MINUS_DST_COLOR,[ig]:n.ONE_MINUS_DST_ALPHA,[ag]:n.CONSTANT_COLOR,[lg]:n.ONE_MINUS_CONSTANT_COLOR,[cg]:n.CONSTANT_ALPHA,[hg]:n.ONE_MINUS_CONSTANT_ALPHA};function ie(z,at,st,At,Mt,Et,$t,re,ft,kt){if(z===_r){g===!0&&(Wt(n.BLEND),g=!1);return}if(g===!1&&(xt(n.BLEND),g=!0),z!==Ym){if(z!==p||kt!==R){if((y!==xr||C!==xr)&&(n.blendEquation(n.FUNC_ADD),y=xr,C=xr),kt)switch(z){case bo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Zu:n.blendFunc(n.ONE,n.ONE);break;case Ju:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ku:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ae("WebGLState: Invalid blending: ",z);break}else switch(z){case bo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Zu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ju:ae("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ku:ae("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ae("WebGLState: Invalid blending: ",z);break}w=null,v=null,A=null,_=null,S.set(0,0,0),N=0,p=z,R=kt}return}Mt=Mt||at,Et=Et||st,$t=$t||At,(at!==y||Mt!==C)&&(n.blendEquationSeparate(qt[at],qt[Mt]),y=at,C=Mt),(st!==w||At!==v||Et!==A||$t!==_)&&(n.blendFuncSeparate(Yt[st],Yt[At],Yt[Et],Yt[$t]),w=st,v=At,A=Et,_=$t),(re.equals(S)===!1||ft!==N)&&(n.blendColor(re.r,re.g,re.b,ft),S.copy(re),N=ft),p=z,R=!1}function se(z,at){z.side===Ei?Wt(n.CULL_FACE):xt(n.CULL_FACE);let st=z.side===jn;at&&(st=!st),Ae(st),z.blending===bo&&z.transparent===!1?ie(_r):ie(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let At=z.stencilWrite;a.setTest(At),At&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),ce(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?xt(n.SAMPLE_ALPHA_TO_COVERAGE):Wt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Ae(z){P!==z&&(z?n.frontFace(n.CW):n.frontFace(n.CCW),P=z)}function ge(z){z!==Wm?(xt(n.CULL_FACE),z!==O&&(z===$u?n.cullFace(n.BACK):z===Xm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Wt(n.CULL_FACE),O=z}function we(z){z!==V&&(F&&n.lineWidth(z),V=z)}function ce(z,at,st){z?(xt(n.POLYGON_OFFSET_FILL),(L!==at||k!==st)&&(L=at,k=st,o.getReversed()&&(at=-at,st=-st),n.polygonOffset(at,st))):Wt(n.POLYGON_OFFSET_FILL)}function He(z){z?xt(n.SCISSOR_TEST):Wt(n.SCISSOR_TEST)}function Le(z){z===void 0&&(z=n.TEXTURE0+H-1),$!==z&&(n.activeTexture(z),$=z)}function Re(z,at,st){st===void 0&&($===null?st=n.TEXTURE0+H-1:st=$);let At=tt[st];At===void 0&&(At={type:void 0,texture:void 0},tt[st]=At),(At.type!==z||At.texture!==at)&&($!==st&&(n.activeTexture(st),$=st),n.bindTexture(z,at||St[z]),At.type=z,At.texture=at)}function B(){let z=tt[$];z!==void 0&&z.type!==void 0&&(n.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(z){ae("WebGLState:",z)}}function Ft(){try{n.compressedTexImage3D(...arguments)}catch(z){ae("WebGLState:",z)}}function Jt(){try{n.texSubImage2D(...arguments)}catch(z){ae("WebGLState:",z)}}function bt(){try{n.texSubImage3D(...arguments)}catch(z){ae("WebGLState:",z)}}function Fe(){try{n.compressedTexSubImage2D(...arguments)}catch(z){ae("WebGLState:",z)}}function Gt(){try{n.compressedTexSubImage3D(...arguments)}catch(z){ae("WebGLState:",z)}}function Kt(){try{n.texStorage2D(...arguments)}catch(z){ae("WebGLState:",z)}}function I(){try{n.texStorage3D(...arguments)}catch(z){ae("WebGLState:",z)}}function b(){try{n.texImage2D(...arguments)}catch(z){ae("WebGLState:",z)}}function q(){try{n.texImage3D(...arguments)}catch(z){ae("WebGLState:",z)}}function ut(z){return f[z]!==void 0?f[z]:n.getParameter(z)}function ot(z,at){f[z]!==at&&(n.pixelStorei(z,at),f[z]=at)}function vt(z){Z.equals(z)===!1&&(n.scissor(z.x,z.y,z.z,z.w),Z.copy(z))}function wt(z){dt.equals(z)===!1&&(n.viewport(z.x,z.y,z.z,z.w),dt.copy(z))}function it(z,at){let st=c.get(at);st===void 0&&(st=new WeakMap,c.set(at,st));let At=st.get(z);At===void 0&&(At=n.getUniformBlockIndex(at,z.name),n.uniformBlockBinding(at,At,At),st.set(z,At))}function rt(z,at,st){let Mt=c.get(at).get(z);l[Mt]!==st&&(n.bindBufferBase(n.UNIFORM_BUFFER,Mt,st),l[Mt]=st)}function _t(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},$=null,tt={},h={},l={},d=new WeakMap,m=[],M=null,g=!1,p=null,y=null,w=null,v=null,C=null,A=null,_=null,S=new pe(0,0,0),N=0,R=!1,P=null,O=null,V=null,L=null,k=null,Z.set(0,0,n.canvas.width,n.canvas.height),dt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xt,disable:Wt,bindFramebuffer:mt,drawBuffers:yt,useProgram:Xt,setBlending:ie,setMaterial:se,setFlipSided:Ae,setCullFace:ge,setLineWidth:we,setPolygonOffset:ce,setScissorTest:He,activeTexture:Le,bindTexture:Re,unbindTexture:B,compressedTexImage2D:Pt,compressedTexImage3D:Ft,texImage2D:b,texImage3D:q,pixelStorei:ot,getParameter:ut,updateUBOMapping:it,uniformBlockBinding:rt,texStorage2D:Kt,texStorage3D:I,texSubImage2D:Jt,texSubImage3D:bt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:Gt,scissor:vt,viewport:wt,reset:_t}}function Sw(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new jt,u=new WeakMap,f=new Set,h,d=new WeakMap,m=new Set,M=new FinalizationRegistry(I=>m.delete(I)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(I,b){return g?new OffscreenCanvas(I,b):ra("canvas")}function y(I,b,q){let ut=1,ot=Kt(I);if((ot.width>q||ot.height>q)&&(ut=q/Math.max(ot.width,ot.height)),ut<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let vt=Math.floor(ut*ot.width),wt=Math.floor(ut*ot.height);h===void 0&&(h=p(vt,wt));let it=b?p(vt,wt):h;return it.width=vt,it.height=wt,it.getContext("2d").drawImage(I,0,0,vt,wt),Qt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+vt+"x"+wt+")."),it}else return"data"in I&&Qt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),I;return I}function w(I){return I.generateMipmaps}function v(I){n.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?n.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(I,b,q,ut,ot,vt=!1){if(I!==null){if(n[I]!==void 0)return n[I];Qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let wt;ut&&(wt=t.get("EXT_texture_norm16"),wt||Qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=b;if(b===n.RED&&(q===n.FLOAT&&(it=n.R32F),q===n.HALF_FLOAT&&(it=n.R16F),q===n.UNSIGNED_BYTE&&(it=n.R8),q===n.UNSIGNED_SHORT&&wt&&(it=wt.R16_EXT),q===n.SHORT&&wt&&(it=wt.R16_SNORM_EXT)),b===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.R8UI),q===n.UNSIGNED_SHORT&&(it=n.R16UI),q===n.UNSIGNED_INT&&(it=n.R32UI),q===n.BYTE&&(it=n.R8I),q===n.SHORT&&(it=n.R16I),q===n.INT&&(it=n.R32I)),b===n.RG&&(q===n.FLOAT&&(it=n.RG32F),q===n.HALF_FLOAT&&(it=n.RG16F),q===n.UNSIGNED_BYTE&&(it=n.RG8),q===n.UNSIGNED_SHORT&&wt&&(it=wt.RG16_EXT),q===n.SHORT&&wt&&(it=wt.RG16_SNORM_EXT)),b===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.RG8UI),q===n.UNSIGNED_SHORT&&(it=n.RG16UI),q===n.UNSIGNED_INT&&(it=n.RG32UI),q===n.BYTE&&(it=n.RG8I),q===n.SHORT&&(it=n.RG16I),q===n.INT&&(it=n.RG32I)),b===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.RGB8UI),q===n.UNSIGNED_SHORT&&(it=n.RGB16UI),q===n.UNSIGNED_INT&&(it=n.RGB32UI),q===n.BYTE&&(it=n.RGB8I),q===n.SHORT&&(it=n.RGB16I),q===n.INT&&(it=n.RGB32I)),b===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),q===n.UNSIGNED_INT&&(it=n.RGBA32UI),q===n.BYTE&&(it=n.RGBA8I),q===n.SHORT&&(it=n.RGBA16I),q===n.INT&&(it=n.RGBA32I)),b===n.RGB&&(q===n.UNSIGNED_SHORT&&wt&&(it=wt.RGB16_EXT),q===n.SHORT&&wt&&(it=wt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),b===n.RGBA){let rt=vt?sa:be.getTransfer(ot);q===n.FLOAT&&(it=n.RGBA32F),q===n.HALF_FLOAT&&(it=n.RGBA16F),q===n.UNSIGNED_BYTE&&(it=rt===Ue?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&wt&&(it=wt.RGBA16_EXT),q===n.SHORT&&wt&&(it=wt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(I,b){let q;return I?b===null||b===ki||b===vr?q=n.DEPTH24_STENCIL8:b===Vi?q=n.DEPTH32F_STENCIL8:b===To&&(q=n.DEPTH24_STENCIL8,Qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===ki||b===vr?q=n.DEPTH_COMPONENT24:b===Vi?q=n.DEPTH_COMPONENT32F:b===To&&(q=n.DEPTH_COMPONENT16),q}function S(I,b){return w(I)===!0||I.isFramebufferTexture&&I.minFilter!==In&&I.minFilter!==Jn?Math.log2(Math.max(b.width,b.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?b.mipmaps.length:1}function N(I){let b=new WeakRef(I);i.get(I).__ref=b,m.add(b),M.register(I,b,b)}function R(I){let b=i.get(I).__ref;b!==void 0&&(m.delete(b),M.unregister(b))}function P(I){V(I.target)}function O(I){L(I.target)}function V(I){I.removeEventListener("dispose",P),R(I),H(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&f.delete(I)}function L(I){I.removeEventListener("dispose",O),R(I),Q(I)}function k(){for(let I of m){let b=I.deref();b!==void 0&&(b.isRenderTarget===!0?L(b):V(b))}m.clear(),f.clear()}function H(I){let b=i.get(I);if(b.__webglInit===void 0)return;let q=I.source,ut=d.get(q);if(ut){let ot=ut[b.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&F(I),Object.keys(ut).length===0&&d.delete(q)}i.remove(I)}function F(I){let b=i.get(I);n.deleteTexture(b.__webglTexture);let q=I.source,ut=d.get(q);delete ut[b.__cacheKey],o.memory.textures--}function Q(I){let b=i.get(I);b.__depthDisposeCallback&&b.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&V(q),I.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(b.__webglFramebuffer[ot]))for(let vt=0;vt<b.__webglFramebuffer[ot].length;vt++)n.deleteFramebuffer(b.__webglFramebuffer[ot][vt]);else n.deleteFramebuffer(b.__webglFramebuffer[ot]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[ot])}else{if(Array.isArray(b.__webglFramebuffer))for(let ot=0;ot<b.__webglFramebuffer.length;ot++)n.deleteFramebuffer(b.__webglFramebuffer[ot]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let ot=0;ot<b.__webglColorRenderbuffer.length;ot++)b.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[ot]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ut=I.textures;for(let ot=0,vt=ut.length;ot<vt;ot++){let wt=i.get(ut[ot]);wt.__webglTexture&&(n.deleteTexture(wt.__webglTexture),o.memory.textures--),i.remove(ut[ot])}i.remove(I)}let W=0;function $(){W=0}function tt(){return W}function ht(I){W=I}function nt(){let I=W;return I>=s.maxTextures&&Qt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),W+=1,I}function Z(I){let b=[];return b.push(I.wrapS),b.push(I.wrapT),b.push(I.wrapR||0),b.push(I.magFilter),b.push(I.minFilter),b.push(I.anisotropy),b.push(I.internalFormat),b.push(I.format),b.push(I.type),b.push(I.generateMipmaps),b.push(I.mipmapsAutoUpdate),b.push(I.premultiplyAlpha),b.push(I.flipY),b.push(I.unpackAlignment),b.push(I.colorSpace),b.join()}function dt(I,b){let q=i.get(I);if(I.isVideoTexture&&Fe(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let ut=I.image;if(ut===null)Qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Qt("WebGLRenderer: Texture marked for update but image is incomplete");else{se(q,I,b);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+b)}function pt(I,b){let q=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){se(q,I,b);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+b)}function St(I,b){let q=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){se(q,I,b);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+b)}function xt(I,b){let q=i.get(I);if(I.version>0&&q.__version!==I.version){Ae(q,I,b);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+b)}let Wt={[jl]:n.REPEAT,[Qi]:n.CLAMP_TO_EDGE,[Ql]:n.MIRRORED_REPEAT},mt={[In]:n.NEAREST,[dg]:n.NEAREST_MIPMAP_NEAREST,[Ra]:n.NEAREST_MIPMAP_LINEAR,[Jn]:n.LINEAR,[Cc]:n.LINEAR_MIPMAP_NEAREST,[bs]:n.LINEAR_MIPMAP_LINEAR},yt={[_g]:n.NEVER,[xf]:n.ALWAYS,[xg]:n.LESS,[gf]:n.LEQUAL,[yg]:n.EQUAL,[_f]:n.GEQUAL,[vg]:n.GREATER,[Mg]:n.NOTEQUAL};function Xt(I,b){if(b.type===Vi&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Jn||b.magFilter===Cc||b.magFilter===Ra||b.magFilter===bs||b.minFilter===Jn||b.minFilter===Cc||b.minFilter===Ra||b.minFilter===bs)&&Qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(I,n.TEXTURE_WRAP_S,Wt[b.wrapS]),n.texParameteri(I,n.TEXTURE_WRAP_T,Wt[b.wrapT]),(I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY)&&n.texParameteri(I,n.TEXTURE_WRAP_R,Wt[b.wrapR]),n.texParameteri(I,n.TEXTURE_MAG_FILTER,mt[b.magFilter]),n.texParameteri(I,n.TEXTURE_MIN_FILTER,mt[b.minFilter]),b.compareFunction&&(n.texParameteri(I,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(I,n.TEXTURE_COMPARE_FUNC,yt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===In||b.minFilter!==Ra&&b.minFilter!==bs||b.type===Vi&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function qt(I,b){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,b.addEventListener("dispose",P),N(b));let ut=b.source,ot=d.get(ut);ot===void 0&&(ot={},d.set(ut,ot));let vt=Z(b);if(vt!==I.__cacheKey){ot[vt]===void 0&&(ot[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ot[vt].usedTimes++;let wt=ot[I.__cacheKey];wt!==void 0&&(ot[I.__cacheKey].usedTimes--,wt.usedTimes===0&&F(b)),I.__cacheKey=vt,I.__webglTexture=ot[vt].texture}return q}function Yt(I,b,q){return Math.floor(Math.floor(I/q)/b)}function ie(I,b,q,ut){let vt=I.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,b.width,b.height,q,ut,b.data);else{vt.sort((z,at)=>z.start-at.start);let wt=0;for(let z=1;z<vt.length;z++){let at=vt[wt],st=vt[z],At=at.start+at.count,Mt=Yt(st.start,b.width,4),Et=Yt(at.start,b.width,4);st.start<=At+1&&Mt===Et&&Yt(st.start+st.count-1,b.width,4)===Mt?at.count=Math.max(at.count,st.start+st.count-at.start):(++wt,vt[wt]=st)}vt.length=wt+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),rt=e.getParameter(n.UNPACK_SKIP_PIXELS),_t=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,b.width);for(let z=0,at=vt.length;z<at;z++){let st=vt[z],At=Math.floor(st.start/4),Mt=Math.ceil(st.count/4),Et=At%b.width,$t=Math.floor(At/b.width),re=Mt,ft=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Et),e.pixelStorei(n.UNPACK_SKIP_ROWS,$t),e.texSubImage2D(n.TEXTURE_2D,0,Et,$t,re,ft,q,ut,b.data)}I.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(n.UNPACK_SKIP_ROWS,_t)}}function se(I,b,q){let ut=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ut=n.TEXTURE_3D);let ot=qt(I,b),vt=b.source;e.bindTexture(ut,I.__webglTexture,n.TEXTURE0+q);let wt=i.get(vt);if(vt.version!==wt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ft=be.getPrimaries(be.workingColorSpace),kt=b.colorSpace===Ts?null:be.getPrimaries(b.colorSpace),oe=b.colorSpace===Ts||ft===kt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,oe)}e.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment);let rt=y(b.image,!1,s.maxTextureSize);rt=Gt(b,rt);let _t=r.convert(b.format,b.colorSpace),z=r.convert(b.type),at=A(b.internalFormat,_t,z,b.normalized,b.colorSpace,b.isVideoTexture);Xt(ut,b);let st,At=b.mipmaps,Mt=b.isVideoTexture!==!0,Et=wt.__version===void 0||ot===!0,$t=vt.dataReady,re=S(b,rt);if(b.isDepthTexture)at=_(b.format===ws,b.type),Et&&(Mt?e.texStorage2D(n.TEXTURE_2D,1,at,rt.width,rt.height):e.texImage2D(n.TEXTURE_2D,0,at,rt.width,rt.height,0,_t,z,null));else if(b.isDataTexture)if(At.length>0){Mt&&Et&&e.texStorage2D(n.TEXTURE_2D,re,at,At[0].width,At[0].height);for(let ft=0,kt=At.length;ft<kt;ft++)st=At[ft],Mt?$t&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,st.width,st.height,_t,z,st.data):e.texImage2D(n.TEXTURE_2D,ft,at,st.width,st.height,0,_t,z,st.data);b.generateMipmaps=!1}else Mt?(Et&&e.texStorage2D(n.TEXTURE_2D,re,at,rt.width,rt.height),$t&&ie(b,rt,_t,z)):e.texImage2D(n.TEXTURE_2D,0,at,rt.width,rt.height,0,_t,z,rt.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){Mt&&Et&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,at,At[0].width,At[0].height,rt.depth);for(let ft=0,kt=At.length;ft<kt;ft++)if(st=At[ft],b.format!==Hi)if(_t!==null)if(Mt){if($t)if(b.layerUpdates.size>0){let oe=Cf(st.width,st.height,b.format,b.type);for(let It of b.layerUpdates){let fe=st.data.subarray(It*oe/st.data.BYTES_PER_ELEMENT,(It+1)*oe/st.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,It,st.width,st.height,1,_t,fe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,0,st.width,st.height,rt.depth,_t,st.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ft,at,st.width,st.height,rt.depth,0,st.data,0,0);else Qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Mt?$t&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ft,0,0,0,st.width,st.height,rt.depth,_t,z,st.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ft,at,st.width,st.height,rt.depth,0,_t,z,st.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{Mt&&Et&&e.texStorage2D(n.TEXTURE_2D,re,at,At[0].width,At[0].height);for(let ft=0,kt=At.length;ft<kt;ft++)st=At[ft],b.format!==Hi?_t!==null?Mt?$t&&e.compressedTexSubImage2D(n.TEXTURE_2D,ft,0,0,st.width,st.height,_t,st.data):e.compressedTexImage2D(n.TEXTURE_2D,ft,at,st.width,st.height,0,st.data):Qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Mt?$t&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,st.width,st.height,_t,z,st.data):e.texImage2D(n.TEXTURE_2D,ft,at,st.width,st.height,0,_t,z,st.data)}else if(b.isDataArrayTexture)if(Mt){if(Et&&e.texStorage3D(n.TEXTURE_2D_ARRAY,re,at,rt.width,rt.height,rt.depth),$t)if(b.layerUpdates.size>0){let ft=Cf(rt.width,rt.height,b.format,b.type);for(let kt of b.layerUpdates){let oe=rt.data.subarray(kt*ft/rt.data.BYTES_PER_ELEMENT,(kt+1)*ft/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,kt,rt.width,rt.height,1,_t,z,oe)}b.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,_t,z,rt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,at,rt.width,rt.height,rt.depth,0,_t,z,rt.data);else if(b.isData3DTexture)Mt?(Et&&e.texStorage3D(n.TEXTURE_3D,re,at,rt.width,rt.height,rt.depth),$t&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,_t,z,rt.data)):e.texImage3D(n.TEXTURE_3D,0,at,rt.width,rt.height,rt.depth,0,_t,z,rt.data);else if(b.isFramebufferTexture){if(Et)if(Mt)e.texStorage2D(n.TEXTURE_2D,re,at,rt.width,rt.height);else{let ft=rt.width,kt=rt.height;for(let oe=0;oe<re;oe++)e.texImage2D(n.TEXTURE_2D,oe,at,ft,kt,0,_t,z,null),ft>>=1,kt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in n){let ft=n.canvas;if(ft.hasAttribute("layoutsubtree")||ft.setAttribute("layoutsubtree","true"),rt.parentNode!==ft){ft.appendChild(rt),f.add(b),ft.onpaint=kt=>{let oe=kt.changedElements;for(let It of f)oe.includes(It.image)&&(It.needsUpdate=!0)},ft.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,rt);else{let oe=n.RGBA,It=n.RGBA,fe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,oe,It,fe,rt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(Mt&&Et){let ft=Kt(At[0]);e.texStorage2D(n.TEXTURE_2D,re,at,ft.width,ft.height)}for(let ft=0,kt=At.length;ft<kt;ft++)st=At[ft],Mt?$t&&e.texSubImage2D(n.TEXTURE_2D,ft,0,0,_t,z,st):e.texImage2D(n.TEXTURE_2D,ft,at,_t,z,st);b.generateMipmaps=!1}else if(Mt){if(Et){let ft=Kt(rt);e.texStorage2D(n.TEXTURE_2D,re,at,ft.width,ft.height)}$t&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,_t,z,rt)}else e.texImage2D(n.TEXTURE_2D,0,at,_t,z,rt);w(b)&&b.mipmapsAutoUpdate===!0&&v(ut),wt.__version=vt.version,b.onUpdate&&b.onUpdate(b)}I.__version=b.version}function Ae(I,b,q){if(b.image.length!==6)return;let ut=qt(I,b),ot=b.source;e.bindTexture(n.TEXTURE_CUBE_MAP,I.__webglTexture,n.TEXTURE0+q);let vt=i.get(ot);if(ot.version!==vt.__version||ut===!0){e.activeTexture(n.TEXTURE0+q);let wt=be.getPrimaries(be.workingColorSpace),it=b.colorSpace===Ts?null:be.getPrimaries(b.colorSpace),rt=b.colorSpace===Ts||wt===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,rt);let _t=b.isCompressedTexture||b.image[0].isCompressedTexture,z=b.image[0]&&b.image[0].isDataTexture,at=[];for(let It=0;It<6;It++)!_t&&!z?at[It]=y(b.image[It],!0,s.maxCubemapSize):at[It]=z?b.image[It].image:b.image[It],at[It]=Gt(b,at[It]);let st=at[0],At=r.convert(b.format,b.colorSpace),Mt=r.convert(b.type),Et=A(b.internalFormat,At,Mt,b.normalized,b.colorSpace),$t=b.isVideoTexture!==!0,re=vt.__version===void 0||ut===!0,ft=ot.dataReady,kt=S(b,st);Xt(n.TEXTURE_CUBE_MAP,b);let oe;if(b.isDepthTexture){if(Et=_(b.format===ws,b.type),re)if($t)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Et,st.width,st.height);else for(let It=0;It<6;It++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Et,st.width,st.height,0,At,Mt,null)}else if(_t){$t&&re&&e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,Et,st.width,st.height);for(let It=0;It<6;It++){oe=at[It].mipmaps;for(let fe=0;fe<oe.length;fe++){let Xe=oe[fe];b.format!==Hi?At!==null?$t?ft&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,Xe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,Et,Xe.width,Xe.height,0,Xe.data):Qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,0,0,Xe.width,Xe.height,At,Mt,Xe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe,Et,Xe.width,Xe.height,0,At,Mt,Xe.data)}}}else{if(oe=b.mipmaps,$t&&re){oe.length>0&&kt++;let It=Kt(at[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,kt,Et,It.width,It.height)}for(let It=0;It<6;It++)if(z){$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,at[It].width,at[It].height,At,Mt,at[It].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Et,at[It].width,at[It].height,0,At,Mt,at[It].data);for(let fe=0;fe<oe.length;fe++){let kn=oe[fe].image[It].image;$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,kn.width,kn.height,At,Mt,kn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,Et,kn.width,kn.height,0,At,Mt,kn.data)}}else{$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,0,0,At,Mt,at[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,0,Et,At,Mt,at[It]);for(let fe=0;fe<oe.length;fe++){let Xe=oe[fe];$t?ft&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,0,0,At,Mt,Xe.image[It]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+It,fe+1,Et,At,Mt,Xe.image[It])}}}w(b)&&b.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),vt.__version=ot.version,b.onUpdate&&b.onUpdate(b)}I.__version=b.version}function ge(I,b,q,ut,ot,vt){let wt=r.convert(q.format,q.colorSpace),it=r.convert(q.type),rt=A(q.internalFormat,wt,it,q.normalized,q.colorSpace),_t=i.get(b),z=i.get(q);if(z.__renderTarget=b,!_t.__hasExternalTextures){let at=Math.max(1,b.width>>vt),st=Math.max(1,b.height>>vt);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,vt,rt,at,st,b.depth,0,wt,it,null):e.texImage2D(ot,vt,rt,at,st,0,wt,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,I),bt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,ot,z.__webglTexture,0,Jt(b)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,ot,z.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function we(I,b,q){if(n.bindRenderbuffer(n.RENDERBUFFER,I),b.depthBuffer){let ut=b.depthTexture,ot=ut&&ut.isDepthTexture?ut.type:null,vt=_(b.stencilBuffer,ot),wt=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;bt(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Jt(b),vt,b.width,b.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Jt(b),vt,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,vt,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,wt,n.RENDERBUFFER,I)}else{let ut=b.textures;for(let ot=0;ot<ut.length;ot++){let vt=ut[ot],wt=r.convert(vt.format,vt.colorSpace),it=r.convert(vt.type),rt=A(vt.internalFormat,wt,it,vt.normalized,vt.colorSpace);bt(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Jt(b),rt,b.width,b.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Jt(b),rt,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,rt,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ce(I,b,q){let ut=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,I),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(b.depthTexture);ot.__renderTarget=b;let vt=ut?b.depthTexture.image[0]:b.depthTexture.image;(!ot.__webglTexture||vt.width!==b.width||vt.height!==b.height)&&(vt.width=b.width,vt.height=b.height,b.depthTexture.needsUpdate=!0),ut?xt(b.depthTexture,0):dt(b.depthTexture,0);let wt=ot.__webglTexture,it=Jt(b),rt=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,_t=b.depthTexture.format===ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(b.depthTexture.format===vs)bt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,rt,wt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,_t,rt,wt,0);else if(b.depthTexture.format===ws)bt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,_t,rt,wt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,_t,rt,wt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function He(I){let b=i.get(I),q=I.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==I.depthTexture){let ut=I.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ut){let ot=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ut.removeEventListener("dispose",ot)};ut.addEventListener("dispose",ot),b.__depthDisposeCallback=ot}b.__boundDepthTexture=ut}if(I.depthTexture&&!b.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)ce(b.__webglFramebuffer[ut],I,ut);else I.texture.mipmaps.length>0?ce(b.__webglFramebuffer[0],I,0):ce(b.__webglFramebuffer,I,0);else if(q){b.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[ut]),b.__webglDepthbuffer[ut]===void 0)b.__webglDepthbuffer[ut]=n.createRenderbuffer(),we(b.__webglDepthbuffer[ut],I,!1);else{let ot=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=b.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,vt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),we(b.__webglDepthbuffer,I,!1);else{let ot=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Le(I,b,q){let ut=i.get(I);b!==void 0&&ge(ut.__webglFramebuffer,I,I.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&He(I)}function Re(I){let b=I.texture,q=i.get(I),ut=i.get(b);I.addEventListener("dispose",O),N(I);let ot=I.textures,vt=I.isWebGLCubeRenderTarget===!0,wt=ot.length>1;if(wt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=b.version,o.memory.textures++),vt){q.__webglFramebuffer=[];for(let it=0;it<6;it++)if(b.mipmaps.length>0){q.__webglFramebuffer[it]=[];for(let rt=0;rt<b.mipmaps.length;rt++)q.__webglFramebuffer[it][rt]=n.createFramebuffer()}else q.__webglFramebuffer[it]=n.createFramebuffer()}else{if(b.mipmaps.length>0){q.__webglFramebuffer=[];for(let it=0;it<b.mipmaps.length;it++)q.__webglFramebuffer[it]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(wt)for(let it=0,rt=ot.length;it<rt;it++){let _t=i.get(ot[it]);_t.__webglTexture===void 0&&(_t.__webglTexture=n.createTexture(),o.memory.textures++)}if(I.samples>0&&bt(I)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let it=0;it<ot.length;it++){let rt=ot[it];q.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[it]);let _t=r.convert(rt.format,rt.colorSpace),z=r.convert(rt.type),at=A(rt.internalFormat,_t,z,rt.normalized,rt.colorSpace,I.isXRRenderTarget===!0),st=Jt(I);n.renderbufferStorageMultisample(n.RENDERBUFFER,st,at,I.width,I.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,q.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),we(q.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),Xt(n.TEXTURE_CUBE_MAP,b);for(let it=0;it<6;it++)if(b.mipmaps.length>0)for(let rt=0;rt<b.mipmaps.length;rt++)ge(q.__webglFramebuffer[it][rt],I,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,rt);else ge(q.__webglFramebuffer[it],I,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);w(b)?v(n.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(wt){for(let it=0,rt=ot.length;it<rt;it++){let _t=ot[it],z=i.get(_t),at=n.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(at=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(at,z.__webglTexture),Xt(at,_t),ge(q.__webglFramebuffer,I,_t,n.COLOR_ATTACHMENT0+it,at,0),w(_t)&&v(at)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(it=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,ut.__webglTexture),Xt(it,b),b.mipmaps.length>0)for(let rt=0;rt<b.mipmaps.length;rt++)ge(q.__webglFramebuffer[rt],I,b,n.COLOR_ATTACHMENT0,it,rt);else ge(q.__webglFramebuffer,I,b,n.COLOR_ATTACHMENT0,it,0);w(b)?v(it):b.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&He(I)}function B(I){let b=I.textures;for(let q=0,ut=b.length;q<ut;q++){let ot=b[q];if(w(ot)&&ot.mipmapsAutoUpdate===!0){let vt=C(I),wt=i.get(ot).__webglTexture;e.bindTexture(vt,wt),v(vt),e.unbindTexture()}}}let Pt=[];function Ft(I){if(I.samples>0){if(bt(I)===!1){let b=I.textures,q=I.width,ut=I.height,ot=n.COLOR_BUFFER_BIT,vt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,wt=i.get(I),it=b.length>1;if(it)for(let _t=0;_t<b.length;_t++)e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,wt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglFramebuffer);for(let _t=0;_t<b.length;_t++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,wt.__webglColorRenderbuffer[_t]);let z=i.get(b[_t]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,z,0)}n.blitFramebuffer(0,0,q,ut,0,0,q,ut,ot,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+_t),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Pt.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let _t=0;_t<b.length;_t++){e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,wt.__webglColorRenderbuffer[_t]);let z=i.get(b[_t]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,wt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,z,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,wt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let b=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function Jt(I){return Math.min(s.maxSamples,I.samples)}function bt(I){let b=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Fe(I){let b=o.render.frame;u.get(I)!==b&&(u.set(I,b),I.update())}function Gt(I,b){let q=I.colorSpace,ut=I.format,ot=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==ia&&q!==Ts&&(be.getTransfer(q)===Ue?(ut!==Hi||ot!==ti)&&Qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ae("WebGLTextures: Unsupported texture color space:",q)),b}function Kt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=nt,this.resetTextureUnits=$,this.getTextureUnits=tt,this.setTextureUnits=ht,this.setTexture2D=dt,this.setTexture2DArray=pt,this.setTexture3D=St,this.setTextureCube=xt,this.rebindTextures=Le,this.setupRenderTarget=Re,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ft,this.setupDepthRenderbuffer=He,this.setupFrameBufferTexture=ge,this.useMultisampledRTT=bt,this.dispose=k}function bw(n,t){function e(i,s=Ts){let r,o=be.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===Ic)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Lc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===uf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ff)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===cf)return n.BYTE;if(i===hf)return n.SHORT;if(i===To)return n.UNSIGNED_SHORT;if(i===Pc)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===Gi)return n.HALF_FLOAT;if(i===df)return n.ALPHA;if(i===pf)return n.RGB;if(i===Hi)return n.RGBA;if(i===vs)return n.DEPTH_COMPONENT;if(i===ws)return n.DEPTH_STENCIL;if(i===mf)return n.RED;if(i===Dc)return n.RED_INTEGER;if(i===Js)return n.RG;if(i===Nc)return n.RG_INTEGER;if(i===Uc)return n.RGBA_INTEGER;if(i===Ca||i===Pa||i===Ia||i===La)if(o===Ue)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ca)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ca)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===La)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Fc||i===Oc||i===Bc||i===zc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Fc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Oc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Bc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===zc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===kc||i===Vc||i===Gc||i===Hc||i===Wc||i===Da||i===Xc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===kc||i===Vc)return o===Ue?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Gc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Hc)return r.COMPRESSED_R11_EAC;if(i===Wc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Da)return r.COMPRESSED_RG11_EAC;if(i===Xc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===qc||i===Yc||i===$c||i===Zc||i===Jc||i===Kc||i===jc||i===Qc||i===th||i===eh||i===nh||i===ih||i===sh||i===rh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===qc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Yc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===$c)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Zc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Jc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Kc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===jc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Qc)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===th)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===eh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===nh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ih)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===sh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===rh)return o===Ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===oh||i===ah||i===lh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===oh)return o===Ue?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===ah)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===lh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ch||i===hh||i===Na||i===uh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===ch)return r.COMPRESSED_RED_RGTC1_EXT;if(i===hh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Na)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===uh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===vr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var ww=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Tw=`
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

}`,Bf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new xa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new es({vertexShader:ww,fragmentShader:Tw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new mi(new ya(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},zf=class extends zi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,m=null,M=typeof XRWebGLBinding<"u",g=new Bf,p={},y=e.getContextAttributes(),w=null,v=null,C=[],A=[],_=new jt,S=null,N=null,R=new $n;R.viewport=new je;let P=new $n;P.viewport=new je;let O=[R,P],V=new Tc,L=null,k=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let dt=C[Z];return dt===void 0&&(dt=new mo,C[Z]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(Z){let dt=C[Z];return dt===void 0&&(dt=new mo,C[Z]=dt),dt.getGripSpace()},this.getHand=function(Z){let dt=C[Z];return dt===void 0&&(dt=new mo,C[Z]=dt),dt.getHandSpace()};function H(Z){let dt=A.indexOf(Z.inputSource);if(dt===-1)return;let pt=C[dt];pt!==void 0&&(pt.update(Z.inputSource,Z.frame,c||o),pt.dispatchEvent({type:Z.type,data:Z.inputSource}))}function F(){s.removeEventListener("select",H),s.removeEventListener("selectstart",H),s.removeEventListener("selectend",H),s.removeEventListener("squeeze",H),s.removeEventListener("squeezestart",H),s.removeEventListener("squeezeend",H),s.removeEventListener("end",F),s.removeEventListener("inputsourceschange",Q);for(let Z=0;Z<C.length;Z++){let dt=A[Z];dt!==null&&(A[Z]=null,C[Z].disconnect(dt))}L=null,k=null,g.reset();for(let Z in p)delete p[Z];if(t.setRenderTarget(w),d=null,h=null,f=null,s=null,v=null,nt.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(_.width,_.height,!1),N!==null){let Z=N.camera;Z.fov=N.fov,Z.zoom=N.zoom,Z.updateProjectionMatrix(),N=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&Qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,i.isPresenting===!0&&Qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&M&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",H),s.addEventListener("selectstart",H),s.addEventListener("selectend",H),s.addEventListener("squeeze",H),s.addEventListener("squeezestart",H),s.addEventListener("squeezeend",H),s.addEventListener("end",F),s.addEventListener("inputsourceschange",Q),y.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(_),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let pt=null,St=null,xt=null;y.depth&&(xt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,pt=y.stencil?ws:vs,St=y.stencil?vr:ki);let Wt={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Wt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),v=new pi(h.textureWidth,h.textureHeight,{format:Hi,type:ti,depthTexture:new Ss(h.textureWidth,h.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,pt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let pt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,pt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),v=new pi(d.framebufferWidth,d.framebufferHeight,{format:Hi,type:ti,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),nt.setContext(s),nt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function Q(Z){for(let dt=0;dt<Z.removed.length;dt++){let pt=Z.removed[dt],St=A.indexOf(pt);St>=0&&(A[St]=null,C[St].disconnect(pt))}for(let dt=0;dt<Z.added.length;dt++){let pt=Z.added[dt],St=A.indexOf(pt);if(St===-1){for(let Wt=0;Wt<C.length;Wt++)if(Wt>=A.length){A.push(pt),St=Wt;break}else if(A[Wt]===null){A[Wt]=pt,St=Wt;break}if(St===-1)break}let xt=C[St];xt&&xt.connect(pt)}}function W(Z,dt){dt===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(dt.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let dt=Z.near,pt=Z.far;g.texture!==null&&(g.depthNear>0&&(dt=g.depthNear),g.depthFar>0&&(pt=g.depthFar)),V.near=P.near=R.near=dt,V.far=P.far=R.far=pt,(L!==V.near||k!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),L=V.near,k=V.far),V.layers.mask=Z.layers.mask|6,R.layers.mask=V.layers.mask&-5,P.layers.mask=V.layers.mask&-3;let St=Z.parent,xt=V.cameras;W(V,St);for(let Wt=0;Wt<xt.length;Wt++)W(xt[Wt],St);V.projectionMatrix.copy(R.projectionMatrix),V.projectionMatrixInverse.copy(R.projectionMatrixInverse),N===null&&Z.isPerspectiveCamera&&(N={camera:Z,fov:Z.fov,zoom:Z.zoom}),$(Z,V,St)};function $(Z,dt,pt){pt===null?Z.matrix.copy(dt.matrixWorld):(Z.matrix.copy(pt.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(dt.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(dt.projectionMatrix),Z.projectionMatrixInverse.copy(dt.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=fo*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(Z){l=Z,h!==null&&(h.fixedFoveation=Z),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Z)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(Z){return p[Z]};let tt=null;function ht(Z,dt){if(u=dt.getViewerPose(c||o),m=dt,u!==null){let pt=u.views;d!==null&&(t.setRenderTargetFramebuffer(v,d.framebuffer),t.setRenderTarget(v));let St=!1;pt.length!==V.cameras.length&&(V.cameras.length=0,St=!0);for(let yt=0;yt<pt.length;yt++){let Xt=pt[yt],qt=null;if(d!==null)qt=d.getViewport(Xt);else{let ie=f.getViewSubImage(h,Xt);qt=ie.viewport,yt===0&&(t.setRenderTargetTextures(v,ie.colorTexture,ie.depthStencilTexture),t.setRenderTarget(v))}let Yt=O[yt];Yt===void 0&&(Yt=new $n,Yt.layers.enable(yt),Yt.viewport=new je,O[yt]=Yt),Yt.matrix.fromArray(Xt.transform.matrix),Yt.matrix.decompose(Yt.position,Yt.quaternion,Yt.scale),Yt.projectionMatrix.fromArray(Xt.projectionMatrix),Yt.projectionMatrixInverse.copy(Yt.projectionMatrix).invert(),Yt.viewport.set(qt.x,qt.y,qt.width,qt.height),yt===0&&(V.matrix.copy(Yt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),St===!0&&V.cameras.push(Yt)}let xt=s.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){f=i.getBinding();let yt=f.getDepthInformation(pt[0]);yt&&yt.isValid&&yt.texture&&g.init(yt,s.renderState)}if(xt&&xt.includes("camera-access")&&M){t.state.unbindTexture(),f=i.getBinding();for(let yt=0;yt<pt.length;yt++){let Xt=pt[yt].camera;if(Xt){let qt=p[Xt];qt||(qt=new xa,p[Xt]=qt);let Yt=f.getCameraImage(Xt);qt.sourceTexture=Yt}}}}for(let pt=0;pt<C.length;pt++){let St=A[pt],xt=C[pt];St!==null&&xt!==void 0&&xt.update(St,dt,c||o)}tt&&tt(Z,dt),dt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:dt}),m=null}let nt=new jg;nt.setAnimationLoop(ht),this.setAnimationLoop=function(Z){tt=Z},this.dispose=function(){}}},Ew=new We,l0=new he;l0.set(-1,0,0,0,1,0,0,0,1);function Aw(n,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,Ef(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,y,w,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),f(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),h(g,p),p.isMeshPhysicalMaterial&&d(g,p,v)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),M(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,y,w):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===jn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===jn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let y=t.get(p),w=y.envMap,v=y.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(Ew.makeRotationFromEuler(v)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(l0),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,y,w){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*y,g.scale.value=w*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function f(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function h(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,y){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===jn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function M(g,p){let y=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Rw(n,t,e,i){let s={},r={};function o(y,w){let v=w.program;i.uniformBlockBinding(y,v,s[y.id])}function a(y,w){let v=s[y.id];v===void 0&&(m(y),v=l(y),s[y.id]=v,y.addEventListener("dispose",g));let C=w.program;i.updateUBOMapping(y,C);let A=t.render.frame;r[y.id]!==A&&(c(y),r[y.id]=A)}function l(y){let w=n.createBuffer(),v=y.__size,C=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,v,C),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(y){let w=s[y.id],v=y.uniforms,C=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let A=0,_=v.length;A<_;A++){let S=v[A];if(Array.isArray(S))for(let N=0,R=S.length;N<R;N++)u(S[N],A,N,C);else u(S,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(y,w,v,C){if(h(y,w,v,C)===!0){let A=y.__offset,_=y.value;if(Array.isArray(_)){let S=0;for(let N=0;N<_.length;N++){let R=_[N],P=M(R,!0);f(R,y.__data,S),S+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,y.__data)}}function f(y,w,v){typeof y=="number"||typeof y=="boolean"?w[v]=y:y.isMatrix3?(w[v]=y.elements[0],w[v+1]=y.elements[1],w[v+2]=y.elements[2],w[v+3]=0,w[v+4]=y.elements[3],w[v+5]=y.elements[4],w[v+6]=y.elements[5],w[v+7]=0,w[v+8]=y.elements[6],w[v+9]=y.elements[7],w[v+10]=y.elements[8],w[v+11]=0):ArrayBuffer.isView(y)?w.set(y.subarray(0,w.length-v),v):y.toArray(w,v)}function h(y,w,v,C){let A=y.value,_=w+"_"+v;if(Array.isArray(A)){C[_]===void 0&&(C[_]=[]);let S=C[_],N=!1;for(let R=0;R<A.length;R++)d(A[R],S,R)===!0&&(N=!0);return N}return d(A,C,_)}function d(y,w,v){if(w[v]===void 0)return typeof y=="number"||typeof y=="boolean"?w[v]=y:ArrayBuffer.isView(y)?w[v]=y.slice():w[v]=y.clone(),!0;{let C=w[v];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return w[v]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function m(y){let w=y.uniforms,v=0,C=16;for(let _=0,S=w.length;_<S;_++){let N=Array.isArray(w[_])?w[_]:[w[_]];for(let R=0,P=N.length;R<P;R++){let O=N[R],V=Array.isArray(O.value)?O.value:[O.value],L=Array.isArray(w[_])||Array.isArray(O.value),k=v;for(let F=0,Q=V.length;F<Q;F++){let W=V[F],$=M(W,L),tt=v%C,ht=tt%$.boundary,nt=tt+ht;v+=ht,nt!==0&&C-nt<$.storage&&(v+=C-nt),F===0&&(k=v),v+=$.storage}let H=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new H((v-k)/Float32Array.BYTES_PER_ELEMENT),O.__offset=k}}let A=v%C;return A>0&&(v+=C-A),y.__size=v,y.__cache={},this}function M(y,w){let v={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(v.boundary=4,v.storage=4):y.isVector2?(v.boundary=8,v.storage=8):y.isVector3||y.isColor?(v.boundary=16,v.storage=12):y.isVector4?(v.boundary=16,v.storage=16):y.isMatrix3?(v.boundary=16,v.storage=48):y.isMatrix4?(v.boundary=16,v.storage=64):y.isTexture?Qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(v.boundary=16,v.storage=y.byteLength):Qt("WebGLRenderer: Unsupported uniform value type.",y),w===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(y){let w=y.target;w.removeEventListener("dispose",g),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:p}}var Cw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function Pw(){return is===null&&(is=new oc(Cw,16,16,Js,Gi),is.name="DFG_LUT",is.minFilter=Jn,is.magFilter=Jn,is.wrapS=Qi,is.wrapT=Qi,is.generateMipmaps=!1,is.needsUpdate=!0),is}var _h=class{constructor(t={}){let{canvas:e=Sg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=ti}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let M=d,g=new Set([Uc,Nc,Dc]),p=new Set([ti,ki,To,vr,Ic,Lc]),y=new Uint32Array(4),w=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},C=null,A=null,_=[],S=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,P=!1,O=null,V=null,L=null,k=null;this._outputColorSpace=ui;let H=0,F=0,Q=null,W=-1,$=null,tt=new je,ht=new je,nt=null,Z=new pe(0),dt=0,pt=e.width,St=e.height,xt=1,Wt=null,mt=null,yt=new je(0,0,pt,St),Xt=new je(0,0,pt,St),qt=!1,Yt=new Hs,ie=new ac,se=!1,Ae=!1,ge=new We,we=new Y,ce=new je,He={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Le=!1;function Re(){return Q===null?xt:1}let B=i;function Pt(E,G){return e.getContext(E,G)}let Ft,Jt,bt,Fe,Gt,Kt,I,b,q,ut,ot,vt,wt,it,rt,_t,z,at,st,At,Mt,Et,$t;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",oe,!1),e.addEventListener("webglcontextcreationerror",It,!1),B===null){let G="webgl2";if(B=Pt(G,E),B===null)throw Pt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}re()}catch(E){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",It,!1),ae("WebGLRenderer: "+E.message),E}function re(){Ft=new VS(B),Ft.init(),Mt=new bw(B,Ft),Jt=new PS(B,Ft,t,Mt),bt=new Mw(B,Ft),Jt.reversedDepthBuffer&&h&&bt.buffers.depth.setReversed(!0),V=B.createFramebuffer(),L=B.createFramebuffer(),k=B.createFramebuffer(),Fe=new WS(B),Gt=new aw,Kt=new Sw(B,Ft,bt,Gt,Jt,Mt,Fe),I=new kS(R),b=new qy(B),Et=new RS(B,b),q=new GS(B,b,Fe,Et),ut=new qS(B,q,b,Et,Fe),at=new XS(B,Jt,Kt),rt=new IS(Gt),ot=new ow(R,I,Ft,Jt,Et,rt),vt=new Aw(R,Gt),wt=new cw,it=new mw(Ft),z=new AS(R,I,bt,ut,m,l),_t=new vw(R,ut,Jt),$t=new Rw(B,Fe,Jt,bt),st=new CS(B,Ft,Fe),At=new HS(B,Ft,Fe),Fe.programs=ot.programs,R.capabilities=Jt,R.extensions=Ft,R.properties=Gt,R.renderLists=wt,R.shadowMap=_t,R.state=bt,R.info=Fe}M!==ti&&(N=new $S(M,e.width,e.height,a,s,r));let ft=new zf(R,B);this.xr=ft,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=Ft.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ft.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return xt},this.setPixelRatio=function(E){E!==void 0&&(xt=E,this.setSize(pt,St,!1))},this.getSize=function(E){return E.set(pt,St)},this.setSize=function(E,G,et=!0){if(ft.isPresenting){Qt("WebGLRenderer: Can't change size while VR device is presenting.");return}pt=E,St=G,e.width=Math.floor(E*xt),e.height=Math.floor(G*xt),et===!0&&(e.style.width=E+"px",e.style.height=G+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,E,G)},this.getDrawingBufferSize=function(E){return E.set(pt*xt,St*xt).floor()},this.setDrawingBufferSize=function(E,G,et){pt=E,St=G,xt=et,e.width=Math.floor(E*et),e.height=Math.floor(G*et),this.setViewport(0,0,E,G)},this.setEffects=function(E){if(M===ti){ae("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let G=0;G<E.length;G++)if(E[G].isOutputPass===!0){Qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(tt)},this.getViewport=function(E){return E.copy(yt)},this.setViewport=function(E,G,et,J){E.isVector4?yt.set(E.x,E.y,E.z,E.w):yt.set(E,G,et,J),bt.viewport(tt.copy(yt).multiplyScalar(Re()).round())},this.getScissor=function(E){return E.copy(Xt)},this.setScissor=function(E,G,et,J){E.isVector4?Xt.set(E.x,E.y,E.z,E.w):Xt.set(E,G,et,J),bt.scissor(ht.copy(Xt).multiplyScalar(Re()).round())},this.getScissorTest=function(){return qt},this.setScissorTest=function(E){bt.setScissorTest(qt=E)},this.setOpaqueSort=function(E){Wt=E},this.setTransparentSort=function(E){mt=E},this.getClearColor=function(E){return E.copy(z.getClearColor())},this.setClearColor=function(){z.setClearColor(...arguments)},this.getClearAlpha=function(){return z.getClearAlpha()},this.setClearAlpha=function(){z.setClearAlpha(...arguments)},this.clear=function(E=!0,G=!0,et=!0){let J=0;if(E){let K=!1;if(Q!==null){let Rt=Q.texture.format;K=g.has(Rt)}if(K){let Rt=Q.texture.type,Lt=p.has(Rt),Ct=z.getClearColor(),Dt=z.getClearAlpha(),Ht=Ct.r,le=Ct.g,_e=Ct.b;Lt?(y[0]=Ht,y[1]=le,y[2]=_e,y[3]=Dt,B.clearBufferuiv(B.COLOR,0,y)):(w[0]=Ht,w[1]=le,w[2]=_e,w[3]=Dt,B.clearBufferiv(B.COLOR,0,w))}else J|=B.COLOR_BUFFER_BIT}G&&(J|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),et&&(J|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&B.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),O=E},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",oe,!1),e.removeEventListener("webglcontextcreationerror",It,!1),z.dispose(),wt.dispose(),it.dispose(),Kt.dispose(),Gt.dispose(),I.dispose(),ut.dispose(),q.dispose(),Et.dispose(),$t.dispose(),ot.dispose(),ft.dispose(),ft.removeEventListener("sessionstart",Ga),ft.removeEventListener("sessionend",Wi),rs.stop()};function kt(E){E.preventDefault(),oa("WebGLRenderer: Context Lost."),P=!0}function oe(){oa("WebGLRenderer: Context Restored."),P=!1;let E=Fe.autoReset,G=_t.enabled,et=_t.autoUpdate,J=_t.needsUpdate,K=_t.type;re(),Fe.autoReset=E,_t.enabled=G,_t.autoUpdate=et,_t.needsUpdate=J,_t.type=K}function It(E){ae("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function fe(E){let G=E.target;G.removeEventListener("dispose",fe),Xe(G)}function Xe(E){kn(E),Gt.remove(E)}function kn(E){let G=Gt.get(E).programs;G!==void 0&&(G.forEach(function(et){ot.releaseProgram(et)}),E.isShaderMaterial&&ot.releaseShaderCache(E))}this.renderBufferDirect=function(E,G,et,J,K,Rt){G===null&&(G=He);let Lt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ct=Io(E,G,et,J,K);bt.setMaterial(J,Lt);let Dt=et.index,Ht=1;if(J.wireframe===!0){if(Dt=q.getWireframeAttribute(et),Dt===void 0)return;Ht=2}let le=et.drawRange,_e=et.attributes.position,Vt=le.start*Ht,xe=(le.start+le.count)*Ht;Rt!==null&&(Vt=Math.max(Vt,Rt.start*Ht),xe=Math.min(xe,(Rt.start+Rt.count)*Ht)),Dt!==null?(Vt=Math.max(Vt,0),xe=Math.min(xe,Dt.count)):_e!=null&&(Vt=Math.max(Vt,0),xe=Math.min(xe,_e.count));let Qe=xe-Vt;if(Qe<0||Qe===1/0)return;Et.setup(K,J,Ct,et,Dt);let Oe,Be=st;if(Dt!==null&&(Oe=b.get(Dt),Be=At,Be.setIndex(Oe)),K.isMesh)J.wireframe===!0?(bt.setLineWidth(J.wireframeLinewidth*Re()),Be.setMode(B.LINES)):Be.setMode(B.TRIANGLES);else if(K.isLine){let _n=J.linewidth;_n===void 0&&(_n=1),bt.setLineWidth(_n*Re()),K.isLineSegments?Be.setMode(B.LINES):K.isLineLoop?Be.setMode(B.LINE_LOOP):Be.setMode(B.LINE_STRIP)}else K.isPoints?Be.setMode(B.POINTS):K.isSprite&&Be.setMode(B.TRIANGLES);if(K.isBatchedMesh)if(Ft.get("WEBGL_multi_draw"))Be.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let _n=K._multiDrawStarts,Bt=K._multiDrawCounts,ln=K._multiDrawCount,Me=Dt?b.get(Dt).bytesPerElement:1,as=Gt.get(J).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)as.setValue(B,"_gl_DrawID",cn),Be.render(_n[cn]/Me,Bt[cn])}else if(K.isInstancedMesh)Be.renderInstances(Vt,Qe,K.count);else if(et.isInstancedBufferGeometry){let _n=et._maxInstanceCount!==void 0?et._maxInstanceCount:1/0,Bt=Math.min(et.instanceCount,_n);Be.renderInstances(Vt,Qe,Bt)}else Be.render(Vt,Qe)};function Ro(E,G,et,J){O!==null&&E.isNodeMaterial&&O.setObject(J,E),se===!0&&rt.setState(E,et,!1),E.transparent===!0&&E.side===Ei&&E.forceSinglePass===!1?(E.side=jn,E.needsUpdate=!0,Xi(E,G,J),E.side=Zs,E.needsUpdate=!0,Xi(E,G,J),E.side=Ei):Xi(E,G,J)}this.compile=function(E,G,et=null){et===null&&(et=E),O!==null&&O.renderStart(E,G,et),A=it.get(et),A.init(G),S.push(A),et.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),E!==et&&E.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(A.pushLight(K),K.castShadow&&A.pushShadow(K))}),A.setupLights(),O!==null&&O.updateLights(A.state.lightsArray),Ae=this.localClippingEnabled,se=rt.init(this.clippingPlanes,Ae),se===!0&&rt.setGlobalState(this.clippingPlanes,G),O!==null&&_t.render(A.state.shadowsArray,et,G);let J=new Set;return E.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Rt=K.material;if(Rt)if(Array.isArray(Rt))for(let Lt=0;Lt<Rt.length;Lt++){let Ct=Rt[Lt];Ro(Ct,et,G,K),J.add(Ct)}else Ro(Rt,et,G,K),J.add(Rt)}),A=S.pop(),O!==null&&O.renderEnd(),J},this.compileAsync=function(E,G,et=null){let J=this.compile(E,G,et);return new Promise(K=>{function Rt(){if(J.forEach(function(Lt){let Dt=Gt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&J.delete(Lt)}),J.size===0){K(E);return}setTimeout(Rt,10)}Ft.get("KHR_parallel_shader_compile")!==null?Rt():setTimeout(Rt,10)})};let Sr=null;function Eh(E){Sr&&Sr(E)}function Ga(){rs.stop()}function Wi(){rs.start()}let rs=new jg;rs.setAnimationLoop(Eh),typeof self<"u"&&rs.setContext(self),this.setAnimationLoop=function(E){Sr=E,ft.setAnimationLoop(E),E===null?rs.stop():rs.start()},ft.addEventListener("sessionstart",Ga),ft.addEventListener("sessionend",Wi),this.render=function(E,G){if(G!==void 0&&G.isCamera!==!0){ae("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(E,G);let et=ft.enabled===!0&&ft.isPresenting===!0,J=N!==null&&(Q===null||et)&&N.begin(R,Q);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ft.enabled===!0&&ft.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(ft.cameraAutoUpdate===!0&&ft.updateCamera(G),G=ft.getCamera()),E.isScene===!0&&E.onBeforeRender(R,E,G,Q),A=it.get(E,S.length),A.init(G),A.state.textureUnits=Kt.getTextureUnits(),S.push(A),ge.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?ie.setFromArrayCamera(G):Yt.setFromProjectionMatrix(ge,Ti,G.reversedDepth),Ae=this.localClippingEnabled,se=rt.init(this.clippingPlanes,Ae),C=wt.get(E,_.length),C.init(),_.push(C),this.info.render.frame++,ft.enabled===!0&&ft.isPresenting===!0){let Lt=R.xr.getDepthSensingMesh();Lt!==null&&os(Lt,G,-1/0,R.sortObjects)}os(E,G,0,R.sortObjects),C.finish(),O!==null&&O.updateLights(A.state.lightsArray),R.sortObjects===!0&&C.sort(Wt,mt),Le=ft.enabled===!1||ft.isPresenting===!1||ft.hasDepthSensing()===!1,Le&&z.addToRenderList(C,E),this.info.autoReset===!0&&this.info.reset(),se===!0&&rt.beginShadows();let K=A.state.shadowsArray;if(_t.render(K,E,G),se===!0&&rt.endShadows(),(J&&N.hasRenderPass())===!1){let Lt=C.opaque,Ct=C.transmissive;if(A.setupLights(),G.isArrayCamera){let Dt=G.cameras;if(Ct.length>0)for(let Ht=0,le=Dt.length;Ht<le;Ht++){let _e=Dt[Ht];Ci(Lt,Ct,E,_e)}Le&&z.render(E);for(let Ht=0,le=Dt.length;Ht<le;Ht++){let _e=Dt[Ht];Co(C,E,_e,_e.viewport)}}else Ct.length>0&&Ci(Lt,Ct,E,G),Le&&z.render(E),Co(C,E,G)}Q!==null&&F===0&&(Kt.updateMultisampleRenderTarget(Q),Kt.updateRenderTargetMipmap(Q)),J&&N.end(R),E.isScene===!0&&E.onAfterRender(R,E,G),Et.resetDefaultState(),W=-1,$=null,S.pop(),S.length>0?(A=S[S.length-1],Kt.setTextureUnits(A.state.textureUnits),se===!0&&rt.setGlobalState(R.clippingPlanes,A.state.camera)):A=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,O!==null&&O.renderEnd()};function os(E,G,et,J){if(E.visible===!1)return;if(E.layers.test(G.layers)){if(E.isGroup)et=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(G);else if(E.isLight)A.pushLight(E),E.castShadow&&A.pushShadow(E);else if(E.isSprite){let Lt=G.isArrayCamera?ie:Yt;if(!E.frustumCulled||E.intersectsFrustum(Lt)){J&&ce.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ge);let Ct=ut.update(E),Dt=E.material;Dt.visible&&C.push(E,Ct,Dt,et,ce.z,null,G)}}else if(E.isMesh||E.isLine||E.isPoints){let Lt=G.isArrayCamera?ie:Yt;if(!E.frustumCulled||E.intersectsFrustum(Lt)){let Ct=ut.update(E),Dt=E.material;if(J&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),ce.copy(E.boundingSphere.center)):(Ct.boundingSphere===null&&Ct.computeBoundingSphere(),ce.copy(Ct.boundingSphere.center)),ce.applyMatrix4(E.matrixWorld).applyMatrix4(ge)),Array.isArray(Dt)){let Ht=Ct.groups;for(let le=0,_e=Ht.length;le<_e;le++){let Vt=Ht[le],xe=Dt[Vt.materialIndex];xe&&xe.visible&&C.push(E,Ct,xe,et,ce.z,Vt,G)}}else Dt.visible&&C.push(E,Ct,Dt,et,ce.z,null,G)}}}let Rt=E.children;for(let Lt=0,Ct=Rt.length;Lt<Ct;Lt++)os(Rt[Lt],G,et,J)}function Co(E,G,et,J){let{opaque:K,transmissive:Rt,transparent:Lt}=E;A.setupLightsView(et),se===!0&&rt.setGlobalState(R.clippingPlanes,et),J&&bt.viewport(tt.copy(J)),K.length>0&&tn(K,G,et),Rt.length>0&&tn(Rt,G,et),Lt.length>0&&tn(Lt,G,et),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function Ci(E,G,et,J){if((et.isScene===!0?et.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[J.id]===void 0){let Vt=Ft.has("EXT_color_buffer_half_float")||Ft.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[J.id]=new pi(1,1,{generateMipmaps:!0,type:Vt?Gi:ti,minFilter:bs,samples:Math.max(4,Jt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:be.workingColorSpace})}let Rt=A.state.transmissionRenderTarget[J.id],Lt=J.viewport||tt;Rt.setSize(Lt.z*R.transmissionResolutionScale,Lt.w*R.transmissionResolutionScale);let Ct=R.getRenderTarget(),Dt=R.getActiveCubeFace(),Ht=R.getActiveMipmapLevel();R.setRenderTarget(Rt),R.getClearColor(Z),dt=R.getClearAlpha(),dt<1&&R.setClearColor(16777215,.5),R.clear(),Le&&z.render(et);let le=R.toneMapping;R.toneMapping=ns;let _e=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),A.setupLightsView(J),se===!0&&rt.setGlobalState(R.clippingPlanes,J),tn(E,et,J),Kt.updateMultisampleRenderTarget(Rt),Kt.updateRenderTargetMipmap(Rt),Ft.has("WEBGL_multisampled_render_to_texture")===!1){let Vt=!1;for(let xe=0,Qe=G.length;xe<Qe;xe++){let Oe=G[xe],{object:Be,geometry:_n,material:Bt,group:ln}=Oe;if(Bt.side===Ei&&Be.layers.test(J.layers)){let Me=Bt.side;Bt.side=jn,Bt.needsUpdate=!0,on(Be,et,J,_n,Bt,ln),Bt.side=Me,Bt.needsUpdate=!0,Vt=!0}}Vt===!0&&(Kt.updateMultisampleRenderTarget(Rt),Kt.updateRenderTargetMipmap(Rt))}R.setRenderTarget(Ct,Dt,Ht),R.setClearColor(Z,dt),_e!==void 0&&(J.viewport=_e),R.toneMapping=le}function tn(E,G,et){let J=G.isScene===!0?G.overrideMaterial:null;for(let K=0,Rt=E.length;K<Rt;K++){let Lt=E[K],{object:Ct,geometry:Dt,group:Ht}=Lt,le=Lt.material;le.allowOverride===!0&&J!==null&&(le=J),Ct.layers.test(et.layers)&&on(Ct,G,et,Dt,le,Ht)}}function on(E,G,et,J,K,Rt){O!==null&&K.isNodeMaterial&&O.setObject(E,K),E.onBeforeRender(R,G,et,J,K,Rt),E.modelViewMatrix.multiplyMatrices(et.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),K.onBeforeRender(R,G,et,J,E,Rt),K.transparent===!0&&K.side===Ei&&K.forceSinglePass===!1?(K.side=jn,K.needsUpdate=!0,R.renderBufferDirect(et,G,J,K,E,Rt),K.side=Zs,K.needsUpdate=!0,R.renderBufferDirect(et,G,J,K,E,Rt),K.side=Ei):R.renderBufferDirect(et,G,J,K,E,Rt),E.onAfterRender(R,G,et,J,K,Rt)}function an(E){let G=0;for(let et of E)et.texture!==null&&G++;return G}function Xi(E,G,et){G.isScene!==!0&&(G=He);let J=Gt.get(E),K=A.state.lights,Rt=A.state.shadowsArray,Lt=K.state.version,Ct=ot.getParameters(E,K.state,Rt,G,et,A.state.lightProbeGridArray),Dt=ot.getProgramCacheKey(Ct),Ht=J.programs;J.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?G.environment:null,J.fog=G.fog;let le=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;J.envMap=I.get(E.envMap||J.environment,le),J.envMapRotation=J.environment!==null&&E.envMap===null?G.environmentRotation:E.envMapRotation,Ht===void 0&&(E.addEventListener("dispose",fe),Ht=new Map,J.programs=Ht,J.programVariants=new Map);let _e=Ht.get(Dt);if(_e!==void 0){if(J.currentProgram===_e&&J.lightsStateVersion===Lt)return Po(E,Ct),_e}else Ct.uniforms=ot.getUniforms(E),O!==null&&E.isNodeMaterial&&O.build(E,et,Ct),E.onBeforeCompile(Ct,R),_e=ot.acquireProgram(Ct,Dt),Ht.set(Dt,_e),J.uniforms=Ct.uniforms;let Vt=J.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Vt.clippingPlanes=rt.uniform),Po(E,Ct),J.needsLights=Rs(E),J.lightsStateVersion=Lt,J.needsLights&&(Vt.ambientLightColor.value=K.state.ambient,Vt.lightProbe.value=K.state.probe,Vt.sunLights.value=K.state.sun,Vt.sunLightShadows.value=K.state.sunShadow,Vt.directionalLights.value=K.state.directional,Vt.directionalLightShadows.value=K.state.directionalShadow,Vt.spotLights.value=K.state.spot,Vt.spotLightShadows.value=K.state.spotShadow,Vt.rectAreaLights.value=K.state.rectArea,Vt.ltc_1.value=K.state.rectAreaLTC1,Vt.ltc_2.value=K.state.rectAreaLTC2,Vt.pointLights.value=K.state.point,Vt.pointLightShadows.value=K.state.pointShadow,Vt.hemisphereLights.value=K.state.hemi,Vt.sunShadowMatrix.value=K.state.sunShadowMatrix,Vt.sunShadowCascade.value=K.state.sunShadowCascade,Vt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Vt.spotLightMatrix.value=K.state.spotLightMatrix,Vt.spotLightMap.value=K.state.spotLightMap,Vt.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=an(A.state.lightProbeGridArray),J.currentProgram=_e,J.uniformsList=null,_e}function ni(E,G,et,J,K){let Rt=Gt.get(E),Lt=Rt.currentProgram.id+","+J+","+K,Ct=Rt.programVariants.get(Lt);return Ct===void 0?(Ct=Xi(E,G,et),Rt.programVariants.set(Lt,Ct)):(Rt.currentProgram=Ct,Rt.uniformsList=null,Rt.outputColorSpace=J,Rt.toneMapping=K),Ct}function As(E){if(E.uniformsList===null){let G=E.currentProgram.getUniforms();E.uniformsList=Eo.seqWithValue(G.seq,E.uniforms)}return E.uniformsList}function Po(E,G){let et=Gt.get(E);et.outputColorSpace=G.outputColorSpace,et.batching=G.batching,et.batchingColor=G.batchingColor,et.instancing=G.instancing,et.instancingColor=G.instancingColor,et.instancingMorph=G.instancingMorph,et.skinning=G.skinning,et.morphTargets=G.morphTargets,et.morphNormals=G.morphNormals,et.morphColors=G.morphColors,et.morphTargetsCount=G.morphTargetsCount,et.numClippingPlanes=G.numClippingPlanes,et.numIntersection=G.numClipIntersection,et.vertexAlphas=G.vertexAlphas,et.vertexTangents=G.vertexTangents,et.toneMapping=G.toneMapping}function Io(E,G,et,J,K){G.isScene!==!0&&(G=He),Kt.resetTextureUnits();let Rt=G.fog,Lt=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?G.environment:null,Ct=Q===null?R.outputColorSpace:Q.isXRRenderTarget===!0?Q.texture.colorSpace:be.workingColorSpace,Dt=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Ht=I.get(J.envMap||Lt,Dt),le=J.vertexColors===!0&&!!et.attributes.color&&et.attributes.color.itemSize===4,_e=!!et.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Vt=!!et.morphAttributes.position,xe=!!et.morphAttributes.normal,Qe=!!et.morphAttributes.color,Oe=ns;J.toneMapped&&(Q===null||Q.isXRRenderTarget===!0)&&(Oe=R.toneMapping);let Be=et.morphAttributes.position||et.morphAttributes.normal||et.morphAttributes.color,_n=Be!==void 0?Be.length:0,Bt=Gt.get(J),ln=A.state.lights;if(se===!0&&(Ae===!0||E!==$)){let ze=E===$&&J.id===W;rt.setState(J,E,ze)}let Me=!1,as=!1;J.version===Bt.__version?Bt.needsLights&&Bt.lightsStateVersion!==ln.state.version||K.isBatchedMesh&&Bt.batching===!1||!K.isBatchedMesh&&Bt.batching===!0||K.isBatchedMesh&&Bt.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Bt.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Bt.instancing===!1||!K.isInstancedMesh&&Bt.instancing===!0||K.isSkinnedMesh&&Bt.skinning===!1||!K.isSkinnedMesh&&Bt.skinning===!0||K.isInstancedMesh&&Bt.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Bt.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Bt.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Bt.instancingMorph===!1&&K.morphTexture!==null||Bt.envMap!==Ht||J.fog===!0&&Bt.fog!==Rt||Bt.numClippingPlanes!==void 0&&(Bt.numClippingPlanes!==rt.numPlanes||Bt.numIntersection!==rt.numIntersection)||Bt.vertexAlphas!==le||Bt.vertexTangents!==_e||Bt.morphTargets!==Vt||Bt.morphNormals!==xe||Bt.morphColors!==Qe||Bt.morphTargetsCount!==_n||Bt.numLightProbeGrids!==an(A.state.lightProbeGridArray)?Me=!0:(Bt.outputColorSpace!==Ct||Bt.toneMapping!==Oe)&&(as=!0):(Me=!0,Bt.__version=J.version);let cn=Bt.currentProgram;(Me===!0||as===!0)&&(cn=as===!0?ni(J,G,K,Ct,Oe):Xi(J,G,K),O&&J.isNodeMaterial&&O.onUpdateProgram(J,cn,Bt));let Tr=!1,qi=!1,ls=!1,de=cn.getUniforms(),en=Bt.uniforms;if(bt.useProgram(cn.program)&&(Tr=!0,qi=!0,ls=!0),J.id!==W&&(W=J.id,qi=!0),Tr||$!==E){bt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),de.setValue(B,"projectionMatrix",E.projectionMatrix),de.setValue(B,"viewMatrix",E.matrixWorldInverse);let hn=de.map.cameraPosition;hn!==void 0&&hn.setValue(B,we.setFromMatrixPosition(E.matrixWorld)),Jt.logarithmicDepthBuffer&&de.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&de.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),$!==E&&($=E,qi=!0,ls=!0)}if(Bt.needsLights&&(ln.state.sunShadowMap.length>0&&de.setValue(B,"sunShadowMap",ln.state.sunShadowMap,Kt),ln.state.directionalShadowMap.length>0&&de.setValue(B,"directionalShadowMap",ln.state.directionalShadowMap,Kt),ln.state.spotShadowMap.length>0&&de.setValue(B,"spotShadowMap",ln.state.spotShadowMap,Kt),ln.state.pointShadowMap.length>0&&de.setValue(B,"pointShadowMap",ln.state.pointShadowMap,Kt)),K.isSkinnedMesh){de.setOptional(B,K,"bindMatrix"),de.setOptional(B,K,"bindMatrixInverse");let ze=K.skeleton;ze&&(ze.boneTexture===null&&ze.computeBoneTexture(),de.setValue(B,"boneTexture",ze.boneTexture,Kt))}K.isBatchedMesh&&(de.setOptional(B,K,"batchingTexture"),de.setValue(B,"batchingTexture",K._matricesTexture,Kt),de.setOptional(B,K,"batchingIdTexture"),de.setValue(B,"batchingIdTexture",K._indirectTexture,Kt),de.setOptional(B,K,"batchingColorTexture"),K._colorsTexture!==null&&de.setValue(B,"batchingColorTexture",K._colorsTexture,Kt));let Vn=et.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&at.update(K,et,cn),(qi||Bt.receiveShadow!==K.receiveShadow)&&(Bt.receiveShadow=K.receiveShadow,de.setValue(B,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&G.environment!==null&&(en.envMapIntensity.value=G.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=Pw()),qi){if(de.setValue(B,"toneMappingExposure",R.toneMappingExposure),Bt.needsLights&&br(en,ls),Rt&&J.fog===!0&&vt.refreshFogUniforms(en,Rt),vt.refreshMaterialUniforms(en,J,xt,St,A.state.transmissionRenderTarget[E.id]),Bt.needsLights&&Bt.numLightProbeGrids>0){let ze=v,hn=0;for(let Nn of A.state.lightProbeGridArray)Nn.texture!==null&&(ze.textures[hn]=Nn.texture,ze.min[hn]=Nn.boundingBox.min,ze.max[hn]=Nn.boundingBox.max,ze.resolution[hn]=Nn.resolution,hn++);for(let Nn in ze)ze[Nn].length=hn;en.probesSH.value=ze.textures,en.probesMin.value=ze.min,en.probesMax.value=ze.max,en.probesResolution.value=ze.resolution}Eo.upload(B,As(Bt),en,Kt)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Eo.upload(B,As(Bt),en,Kt),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&de.setValue(B,"center",K.center),de.setValue(B,"modelViewMatrix",K.modelViewMatrix),de.setValue(B,"normalMatrix",K.normalMatrix),de.setValue(B,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let ze=J.uniformsGroups;for(let hn=0,Nn=ze.length;hn<Nn;hn++){let Ha=ze[hn];$t.update(Ha,cn),$t.bind(Ha,cn)}}return cn}function br(E,G){E.ambientLightColor.needsUpdate=G,E.lightProbe.needsUpdate=G,E.sunLights.needsUpdate=G,E.sunLightShadows.needsUpdate=G,E.directionalLights.needsUpdate=G,E.directionalLightShadows.needsUpdate=G,E.pointLights.needsUpdate=G,E.pointLightShadows.needsUpdate=G,E.spotLights.needsUpdate=G,E.spotLightShadows.needsUpdate=G,E.rectAreaLights.needsUpdate=G,E.hemisphereLights.needsUpdate=G}function Rs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return H},this.getActiveMipmapLevel=function(){return F},this.getRenderTarget=function(){return Q},this.setRenderTargetTextures=function(E,G,et){let J=Gt.get(E);J.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Gt.get(E.texture).__webglTexture=G,Gt.get(E.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:et,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,G){let et=Gt.get(E);et.__webglFramebuffer=G,et.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(E,G=0,et=0){Q=E,H=G,F=et;let J=null,K=!1,Rt=!1;if(E){let Ct=Gt.get(E);if(Ct.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(B.FRAMEBUFFER,Ct.__webglFramebuffer),tt.copy(E.viewport),ht.copy(E.scissor),nt=E.scissorTest,bt.viewport(tt),bt.scissor(ht),bt.setScissorTest(nt),W=-1;return}else if(Ct.__webglFramebuffer===void 0)Kt.setupRenderTarget(E);else if(Ct.__hasExternalTextures)Kt.rebindTextures(E,Gt.get(E.texture).__webglTexture,Gt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let le=E.depthTexture;if(Ct.__boundDepthTexture!==le){if(le!==null&&Gt.has(le)&&(E.width!==le.image.width||E.height!==le.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(E)}}let Dt=E.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(Rt=!0);let Ht=Gt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ht[G])?J=Ht[G][et]:J=Ht[G],K=!0):E.samples>0&&Kt.useMultisampledRTT(E)===!1?J=Gt.get(E).__webglMultisampledFramebuffer:Array.isArray(Ht)?J=Ht[et]:J=Ht,tt.copy(E.viewport),ht.copy(E.scissor),nt=E.scissorTest}else tt.copy(yt).multiplyScalar(xt).floor(),ht.copy(Xt).multiplyScalar(xt).floor(),nt=qt;if(et!==0&&(J=V),bt.bindFramebuffer(B.FRAMEBUFFER,J)&&bt.drawBuffers(E,J),bt.viewport(tt),bt.scissor(ht),bt.setScissorTest(nt),K){let Ct=Gt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+G,Ct.__webglTexture,et)}else if(Rt){let Ct=G;for(let Dt=0;Dt<E.textures.length;Dt++){let Ht=Gt.get(E.textures[Dt]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Dt,Ht.__webglTexture,et,Ct)}}else if(E!==null&&et!==0){let Ct=Gt.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ct.__webglTexture,et)}W=-1};function wr(E){let G=Gt.get(E);return(G.__readFormat!==E.format||G.__readType!==E.type)&&(G.__readFormat=E.format,G.__readType=E.type,G.__formatReadable=Jt.textureFormatReadable(E.format),G.__typeReadable=Jt.textureTypeReadable(E.type)),G}this.readRenderTargetPixels=function(E,G,et,J,K,Rt,Lt,Ct=0){if(!(E&&E.isWebGLRenderTarget)){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){bt.bindFramebuffer(B.FRAMEBUFFER,Dt);try{let Ht=E.textures[Ct],le=Ht.format,_e=Ht.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ct);let Vt=wr(Ht);if(Vt.__formatReadable===!1){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Vt.__typeReadable===!1){ae("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=E.width-J&&et>=0&&et<=E.height-K&&B.readPixels(G,et,J,K,Mt.convert(le),Mt.convert(_e),Rt)}finally{let Ht=Q!==null?Gt.get(Q).__webglFramebuffer:null;bt.bindFramebuffer(B.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(E,G,et,J,K,Rt,Lt,Ct=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(G>=0&&G<=E.width-J&&et>=0&&et<=E.height-K){bt.bindFramebuffer(B.FRAMEBUFFER,Dt);let Ht=E.textures[Ct],le=Ht.format,_e=Ht.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ct);let Vt=wr(Ht);if(Vt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Vt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xe=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,xe),B.bufferData(B.PIXEL_PACK_BUFFER,Rt.byteLength,B.STREAM_READ),B.readPixels(G,et,J,K,Mt.convert(le),Mt.convert(_e),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Qe=Q!==null?Gt.get(Q).__webglFramebuffer:null;bt.bindFramebuffer(B.FRAMEBUFFER,Qe);let Oe=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await wg(B,Oe,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,xe),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Rt),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(xe),B.deleteSync(Oe),Rt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,G=null,et=0){let J=Math.pow(2,-et),K=Math.floor(E.image.width*J),Rt=Math.floor(E.image.height*J),Lt=G!==null?G.x:0,Ct=G!==null?G.y:0;Kt.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,et,0,0,Lt,Ct,K,Rt),bt.unbindTexture()},this.copyTextureToTexture=function(E,G,et=null,J=null,K=0,Rt=0){let Lt,Ct,Dt,Ht,le,_e,Vt,xe,Qe,Oe=E.isCompressedTexture?E.mipmaps[Rt]:E.image;if(et!==null)Lt=et.max.x-et.min.x,Ct=et.max.y-et.min.y,Dt=et.isBox3?et.max.z-et.min.z:1,Ht=et.min.x,le=et.min.y,_e=et.isBox3?et.min.z:0;else{let de=Math.pow(2,-K);Lt=Math.floor(Oe.width*de),Ct=Math.floor(Oe.height*de),E.isDataArrayTexture?Dt=Oe.depth:E.isData3DTexture?Dt=Math.floor(Oe.depth*de):Dt=1,Ht=0,le=0,_e=0}J!==null?(Vt=J.x,xe=J.y,Qe=J.z):(Vt=0,xe=0,Qe=0);let Be=Mt.convert(G.format),_n=Mt.convert(G.type),Bt;G.isData3DTexture?(Kt.setTexture3D(G,0),Bt=B.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Kt.setTexture2DArray(G,0),Bt=B.TEXTURE_2D_ARRAY):(Kt.setTexture2D(G,0),Bt=B.TEXTURE_2D),bt.activeTexture(B.TEXTURE0),bt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,G.flipY),bt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),bt.pixelStorei(B.UNPACK_ALIGNMENT,G.unpackAlignment);let ln=bt.getParameter(B.UNPACK_ROW_LENGTH),Me=bt.getParameter(B.UNPACK_IMAGE_HEIGHT),as=bt.getParameter(B.UNPACK_SKIP_PIXELS),cn=bt.getParameter(B.UNPACK_SKIP_ROWS),Tr=bt.getParameter(B.UNPACK_SKIP_IMAGES);bt.pixelStorei(B.UNPACK_ROW_LENGTH,Oe.width),bt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Oe.height),bt.pixelStorei(B.UNPACK_SKIP_PIXELS,Ht),bt.pixelStorei(B.UNPACK_SKIP_ROWS,le),bt.pixelStorei(B.UNPACK_SKIP_IMAGES,_e);let qi=E.isDataArrayTexture||E.isData3DTexture,ls=G.isDataArrayTexture||G.isData3DTexture;if(E.isDepthTexture){let de=Gt.get(E),en=Gt.get(G),Vn=Gt.get(de.__renderTarget),ze=Gt.get(en.__renderTarget);bt.bindFramebuffer(B.READ_FRAMEBUFFER,Vn.__webglFramebuffer),bt.bindFramebuffer(B.DRAW_FRAMEBUFFER,ze.__webglFramebuffer);for(let hn=0;hn<Dt;hn++)qi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Gt.get(E).__webglTexture,K,_e+hn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Gt.get(G).__webglTexture,Rt,Qe+hn)),B.blitFramebuffer(Ht,le,Ht+Lt,le+Ct,Vt,xe,Vt+Lt,xe+Ct,B.DEPTH_BUFFER_BIT,B.NEAREST);bt.bindFramebuffer(B.READ_FRAMEBUFFER,null),bt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(K!==0||E.isRenderTargetTexture||Gt.has(E)){let de=Gt.get(E),en=Gt.get(G);bt.bindFramebuffer(B.READ_FRAMEBUFFER,L),bt.bindFramebuffer(B.DRAW_FRAMEBUFFER,k);for(let Vn=0;Vn<Dt;Vn++)qi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,de.__webglTexture,K,_e+Vn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,de.__webglTexture,K),ls?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,en.__webglTexture,Rt,Qe+Vn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,en.__webglTexture,Rt),K!==0?B.blitFramebuffer(Ht,le,Ht+Lt,le+Ct,Vt,xe,Vt+Lt,xe+Ct,B.COLOR_BUFFER_BIT,B.NEAREST):ls?B.copyTexSubImage3D(Bt,Rt,Vt,xe,Qe+Vn,Ht,le,Lt,Ct):B.copyTexSubImage2D(Bt,Rt,Vt,xe,Ht,le,Lt,Ct);bt.bindFramebuffer(B.READ_FRAMEBUFFER,null),bt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ls?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Bt,Rt,Vt,xe,Qe,Lt,Ct,Dt,Be,_n,Oe.data):G.isCompressedArrayTexture?B.compressedTexSubImage3D(Bt,Rt,Vt,xe,Qe,Lt,Ct,Dt,Be,Oe.data):B.texSubImage3D(Bt,Rt,Vt,xe,Qe,Lt,Ct,Dt,Be,_n,Oe):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Rt,Vt,xe,Lt,Ct,Be,_n,Oe.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Rt,Vt,xe,Oe.width,Oe.height,Be,Oe.data):B.texSubImage2D(B.TEXTURE_2D,Rt,Vt,xe,Lt,Ct,Be,_n,Oe);bt.pixelStorei(B.UNPACK_ROW_LENGTH,ln),bt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Me),bt.pixelStorei(B.UNPACK_SKIP_PIXELS,as),bt.pixelStorei(B.UNPACK_SKIP_ROWS,cn),bt.pixelStorei(B.UNPACK_SKIP_IMAGES,Tr),Rt===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&B.generateMipmap(Bt),bt.unbindTexture()},this.initRenderTarget=function(E){Gt.get(E).__webglFramebuffer===void 0&&Kt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Kt.setTextureCube(E,0):E.isData3DTexture?Kt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Kt.setTexture2DArray(E,0):Kt.setTexture2D(E,0),bt.unbindTexture()},this.resetState=function(){H=0,F=0,Q=null,bt.reset(),Et.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=be._getDrawingBufferColorSpace(t),e.unpackColorSpace=be._getUnpackColorSpace()}};var c0={type:"change"},Vf={type:"start"},u0={type:"end"},vh=new gr,h0=new fi,Iw=Math.cos(70*Tf.DEG2RAD),Sn=new Y,ei=2*Math.PI,Ie={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},kf=1e-6,Mh=class extends Ea{constructor(t,e=null){super(t,e),this.state=Ie.NONE,this.target=new Y,this.cursor=new Y,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ys.ROTATE,MIDDLE:Ys.DOLLY,RIGHT:Ys.PAN},this.touches={ONE:$s.ROTATE,TWO:$s.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Y,this._lastQuaternion=new di,this._lastTargetPosition=new Y,this._quat=new di().setFromUnitVectors(t.up,new Y(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Mo,this._sphericalDelta=new Mo,this._scale=1,this._panOffset=new Y,this._rotateStart=new jt,this._rotateEnd=new jt,this._rotateDelta=new jt,this._panStart=new jt,this._panEnd=new jt,this._panDelta=new jt,this._dollyStart=new jt,this._dollyEnd=new jt,this._dollyDelta=new jt,this._dollyDirection=new Y,this._mouse=new jt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Dw.bind(this),this._onPointerDown=Lw.bind(this),this._onPointerUp=Nw.bind(this),this._onContextMenu=Vw.bind(this),this._onMouseWheel=Ow.bind(this),this._onKeyDown=Bw.bind(this),this._onTouchStart=zw.bind(this),this._onTouchMove=kw.bind(this),this._onMouseDown=Uw.bind(this),this._onMouseMove=Fw.bind(this),this._interceptControlDown=Gw.bind(this),this._interceptControlUp=Hw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ie.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(c0),this.update(),this.state=Ie.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===Ie.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Y(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Y(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(vh.origin.copy(this.object.position),vh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(vh.direction))<Iw?this.object.lookAt(this.target):(h0.setFromNormalAndCoplanarPoint(this.object.up,this.target),vh.intersectPlane(h0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>kf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>kf||this._lastTargetPosition.distanceToSquared(this.target)>kf?(this.dispatchEvent(c0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new jt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function Lw(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Dw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function Nw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(u0),this.state=Ie.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function Uw(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ys.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ie.DOLLY;break;case Ys.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ie.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ie.ROTATE}break;case Ys.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ie.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ie.PAN}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(Vf)}function Fw(n){switch(this.state){case Ie.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ie.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ie.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Ow(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ie.NONE||(n.preventDefault(),this.dispatchEvent(Vf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(u0))}function Bw(n){this.enabled!==!1&&this._handleKeyDown(n)}function zw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case $s.ROTATE:if(this.enableRotate===!1){this.state=Ie.NONE;break}this._handleTouchStartRotate(n),this.state=Ie.TOUCH_ROTATE;break;case $s.PAN:if(this.enablePan===!1){this.state=Ie.NONE;break}this._handleTouchStartPan(n),this.state=Ie.TOUCH_PAN;break;default:this.state=Ie.NONE}break;case 2:switch(this.touches.TWO){case $s.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ie.TOUCH_DOLLY_PAN;break;case $s.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ie.TOUCH_DOLLY_ROTATE;break;default:this.state=Ie.NONE}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(Vf)}function kw(n){switch(this._trackPointer(n),this.state){case Ie.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ie.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ie.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ie.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ie.NONE}}function Vw(n){this.enabled!==!1&&n.preventDefault()}function Gw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Hw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Sh=class{constructor(t){this.well=t}at(t,e){let{md_m:i,north_m:s,east_m:r,tvd_m:o,high:a}=this.well,l=Math.min(Math.max(fs(i,t),1),i.length-1),c=(t-i[l-1])/(i[l]-i[l-1]||1),u=d=>d[l-1]+c*(d[l]-d[l-1]);e.place=[u(r),-u(o),-u(s)],e.high=Gf([u(a[1]),-u(a[2]),-u(a[0])]);let f=[r,o,s].map(d=>d[l]-d[l-1]),h=Gf([f[0],-f[1],-f[2]]);return e.right=Gf(Ww(h,e.high)),e}},Gf=n=>{let t=Math.hypot(...n)||1;return n.map(e=>e/t)},Ww=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],za=class extends Qn{constructor(t,e){super(),this.rings=t,this.sides=e;let i=t*e;this.setAttribute("position",new Zn(new Float32Array(3*i),3)),this.setAttribute("normal",new Zn(new Float32Array(3*i),3)),this.setAttribute("color",new Zn(new Float32Array(3*i).fill(1),3));let s=[];for(let r=0;r+1<t;r++)for(let o=0;o<e;o++){let[a,l]=[r*e+o,r*e+(o+1)%e];s.push(a,l,a+e,l,l+e,a+e)}this.setIndex(s),this.turns=Array.from({length:e},(r,o)=>[Math.cos(2*Math.PI*o/e),Math.sin(2*Math.PI*o/e)])}ring(t,e,i,s,r){let{position:o,normal:a}=this.attributes;for(let l=0;l<this.sides;l++){let[c,u]=this.turns[l],f=3*(t*this.sides+l);for(let h=0;h<3;h++){let d=c*i[h]+u*s[h];a.array[f+h]=d,o.array[f+h]=e[h]+r*d}}}paint(t,e,i,s){let{color:r}=this.attributes;for(let o=0;o<this.sides;o++)r.array.set([e,i,s],3*(t*this.sides+o))}changed(){for(let t of Object.values(this.attributes))t.needsUpdate=!0;this.computeBoundingSphere()}};var Xw=[["side_force_N_per_m","Side force, by side","force per length",!0],["contact_force_N","Contact force of the node","force",!0],["tension_N","Effective tension","force",!1],["torque_N_m","Torque","torque",!1],["bending_moment_N_m","Bending moment","torque",!1],["rotary_speed_rad_per_s","Rotary speed","rotary speed",!1],["von_mises_stress_max_Pa","Largest von Mises stress","pressure",!1],["contact_fraction","Share of time in contact","percent",!1]];function qw(n,t){let{profile:e}=t,i=e.md_m,s=e.lateral_offset_m??Yw(n,e),r=$w(e);return{depths:i,high:s.map((o,a)=>-o*Math.cos(r[a])),right:s.map((o,a)=>o*Math.sin(r[a])),values:o=>e[o],has:o=>!!e[o]&&o!=="contact_force_N"}}function Yw(n,t){return t.md_m.map(e=>{let i=o=>e>=o.from_m&&e<=o.to_m,s=n.hole.find(i),r=n.string.find(i);return s&&r?(s.diameter_m-r.contact_od_m)/2:0})}function $w(n){let t=[];for(let s=0;s<n.md_m.length;s++){let r=n.climb_rad?.[s];Number.isFinite(r)?t.push([n.md_m[s],Math.cos(r),Math.sin(r)]):!n.climb_rad&&n.side_force_N_per_m[s]!==0&&t.push([n.md_m[s],n.side_force_N_per_m[s]>0?-1:1,0])}if(t.length===0)return n.md_m.map(()=>0);let e=[0,1,2].map(s=>Float32Array.from(t,r=>r[s])),i=(s,r)=>{let o=dl(e[0],r,Math.min(Math.max(s,e[0][0]),e[0].at(-1)));return Number.isFinite(o)?o:0};return n.md_m.map(s=>Math.atan2(i(s,e[2]),i(s,e[1])))}function Zw(n,t){let e=n.md_m.length,i=s=>n.channels[s].subarray(t*e,(t+1)*e);return{depths:n.md_m.map(s=>s+n.moved_m[t]),high:i("offset_high_m"),right:i("offset_right_m"),values:i,has:s=>!!n.channels[s]}}function f0(n,t,e){return t?.frames&&e!==null?Zw(t.frames,e):qw(n,yi(n,"dynamic")??yi(n,"soft"))}var d0=n=>Xw.filter(([t])=>n.has(t));function p0(n,t,e,i,s){let r=t?.frames&&e!==null?t.frames.channels[i]:n.values(i),o=Array.from(r).filter(Number.isFinite).sort((u,f)=>u-f);if(o.length===0)return[0,1];let a=u=>o[Math.round(u*(o.length-1))];if(s){let u=Math.max(Math.abs(a(.01)),Math.abs(a(.99)))||1;return[-u,u]}let[l,c]=[a(.002),a(.998)];return l<c?[l,c]:[l-.5*Math.abs(l||1),c+.5*Math.abs(c||1)]}function m0(n,t){let e=Math.min(Math.max(fs(n.time_s,t),1),n.time_s.length-1);return e<1?0:t-n.time_s[e-1]<n.time_s[e]-t?e-1:e}function bh(n,t,e,i="text",s=.5){let r=ct("canvas",{}),o=r.getContext("2d"),a="600 44px system-ui, sans-serif";o.font=a,r.width=Math.ceil(o.measureText(n).width)+8,r.height=56,o.font=a,o.textBaseline="middle",o.fillStyle=rn(i),o.fillText(n,4,30);let l=new da(new go({map:new ga(r),depthTest:!1,transparent:!0}));return l.position.set(...t),l.center.set(s,.5),l.scale.set(e*r.width/r.height,e,1),l.renderOrder=3,l}function Hf(n,[t,e]){let i=new Y(1/0,1/0,1/0),s=i.clone().negate();for(let o=0;o<=100;o++){let a=new Y(...n.at(t+(e-t)*o/100,{}).place);i.min(a),s.max(a)}let r=.22*s.clone().sub(i).length();for(let o of["x","y","z"]){let l=Math.max(r-(s[o]-i[o]),0)/2+(o==="y"?0:.03*r);i[o]-=l,s[o]+=l}return{low:i,high:s}}function Wf({low:n,high:t},[e,,i]){let[s,r]=e>=0?[n.x,t.x]:[t.x,n.x],[o,a]=i>=0?[n.z,t.z]:[t.z,n.z];return[[s,o],[r,o],[s,a]]}function g0(n,t,e,i){let s=Hf(n,t),{low:r,high:o}=s,[a,l,c]=Wf(s,i),u=o.clone().sub(r).length(),f=Rn("length"),h=Si(De(t[0],"length"),De(t[1],"length"),8),d=h.values.map(w=>{let{place:v,high:C}=n.at(Li(w,"length"),{}),A=e+.012*u;return bh(`${bi(w,h.step)} ${f}`,v.map((_,S)=>_+A*C[S]),.021*u,"text",0)}),m=[],M=(w,v)=>m.push(...w,...v),g=Si(De(-o.y,"length"),De(-r.y,"length"),5),p=g.values.map(w=>{let v=-Li(w,"length"),C=([A,_])=>[A,v,_];return M(C(a),C(l)),M(C(a),C(c)),bh(`TVD ${bi(w,g.step)} ${f}`,C(c),.019*u,"muted",1.06)});for(let[w,v]of[a,l,c])M([w,r.y,v],[w,o.y,v]);let y=new Qn;return y.setAttribute("position",new Bn(m,3)),[new pa(y,new _o({color:rn("frame"),transparent:!0,opacity:.35})),...d,...p,bh("N",[(r.x+o.x)/2,o.y,r.z-.04*u],.024*u),bh("E",[o.x+.04*u,o.y,(r.z+o.z)/2],.024*u)]}var Xf=520,Jw=10;function _0(n){let t=ct("canvas",{class:"space",role:"img","aria-label":"The well in space, the string in it"}),e;try{e=new _h({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0})}catch{return{element:ct("p",{class:"warning"},"This view needs WebGL, which this browser does not give."),redraw:()=>{}}}let i=new Sh(n.well),s=new ca,r=new $n(38,1,1,1e5),o=new Mh(r,t);o.enableDamping=!1,o.enableZoom=!1;let a=new wa(16777215,2.2);s.add(new Ta(16777215,1.6),a);let l=n.well.md_m.at(-1),c=Math.max(...n.hole.map(mt=>mt.diameter_m),.1),u=Kw(.03*l/c),f=null,h=null,d=null,m=[],M=ct("canvas",{class:"space-paper"}),g=ct("div",{class:"space-holder"},t,M),p=ct("div",{class:"colour-key"}),y=ct("output",{}),w=ct("input",{type:"range",min:0,step:1,"aria-label":"Moment",oninput:()=>{let mt=Xn(n);dn({moment:mt.frames.time_s[Number(w.value)]})}}),v=ct("button",{type:"button",onclick:()=>d?V():O()},"Play"),C=ct("button",{type:"button",onclick:()=>{V(),dn({moment:null})}},"Mean"),A=ct("div",{class:"moments"},v,C,w,y),_=ct("output",{}),S=ct("input",{type:"range",min:0,max:3.7,step:.01,value:Math.log10(u),"aria-label":"Exaggeration across the hole",oninput:()=>{u=10**Number(S.value),Q()}}),N=ct("span",{}),R=[["Whole well",()=>Z(.3)],["From the side",()=>Z(.02)],["From above",()=>[.001,1,.001]]].map(([mt,yt])=>ct("button",{type:"button",onclick:()=>dt(yt())},mt)),P=ct("div",{class:"tools noprint"},N,ct("label",{},"Across × ",S,_),R,ct("span",{class:"hint"},"drag to turn, right-drag to move, Ctrl + wheel to go nearer; shows the depths in view above"));t.addEventListener("wheel",mt=>{if(!mt.ctrlKey&&!mt.metaKey)return;mt.preventDefault();let yt=r.position.clone().sub(o.target).multiplyScalar(Math.exp(mt.deltaY*.002));r.position.copy(o.target).add(yt),pt()},{passive:!1}),o.addEventListener("change",pt);function O(){v.textContent="Stop",d=setInterval(()=>{let{frames:mt}=Xn(n),yt=(Number(w.value)+1)%mt.time_s.length;dn({moment:mt.time_s[yt]})},80)}function V(){clearInterval(d),d=null,v.textContent="Play"}let L=()=>te.depths??[n.well.md_m[0],l];function k([mt,yt]){let Xt=Array.from(n.well.md_m).filter(ie=>ie>mt&&ie<yt),qt=(yt-mt)/300;return[...Array.from({length:301},(ie,se)=>mt+se*qt),...Xt].sort((ie,se)=>ie-se)}function H(){for(let mt of m)s.remove(mt),mt.geometry?.dispose(),mt.material.map?.dispose(),mt.material.dispose();m=[]}function F(mt){return m.push(mt),s.add(mt),mt}function Q(){H();let[mt,yt]=L(),Xt={};for(let qt of n.hole){let Yt=[Math.max(qt.from_m,mt),Math.min(qt.to_m,yt)];if(Yt[1]<=Yt[0])continue;let ie=k(Yt),se=new za(ie.length,28);ie.forEach((we,ce)=>{i.at(we,Xt),se.ring(ce,Xt.place,Xt.high,Xt.right,qt.diameter_m/2*u)}),se.changed();let Ae=qt.kind==="casing",ge=new yo({color:rn(Ae?"casing":"rock"),transparent:!0,opacity:Ae?.16:.26,side:Ei,depthWrite:!1});F(new mi(se,ge)).renderOrder=2}g0(i,[mt,yt],c/2*u,Z(.3)).forEach(F),tt(),_.textContent=` ${Un(u,2)}`,pt()}let W=null,$=null;function tt(){let mt=Xn(n);h=mt?.frames&&te.moment!==null?m0(mt.frames,te.moment):null;let yt=f0(n,mt,h),Xt=d0(yt);Xt.some(([Ft])=>Ft===f)||(f=Xt[0][0]);let[,qt,Yt,ie]=Xt.find(([Ft])=>Ft===f);N.replaceChildren(md("Colour: ",Xt.map(([Ft,Jt])=>[Ft,Jt]),f,Ft=>{f=Ft,tt(),pt()}));let[se,Ae]=L(),ge=Array.from(yt.depths,(Ft,Jt)=>[Ft,Jt]).filter(([Ft])=>Ft>=se-1&&Ft<=Ae+1);(!W||$.geometry!==W||W.rings!==ge.length)&&($&&(s.remove($),m=m.filter(Ft=>Ft!==$),$.geometry.dispose(),$.material.dispose()),W=new za(Math.max(ge.length,2),Jw),$=F(new mi(W,new yo({vertexColors:!0})))),m.includes($)||F($);let we=yt.values(f),ce=p0(yt,mt,h,f,ie),He=Za(ie),Le=Ft=>He((Ft-ce[0])/(ce[1]-ce[0])).map(Jt=>Jt/255),Re={},B=new pe,Pt=n.string;ge.forEach(([Ft,Jt],bt)=>{i.at(Math.min(Ft,l),Re);let[Fe,Gt]=[yt.high[Jt]*u||0,yt.right[Jt]*u||0],Kt=Re.place.map((ot,vt)=>ot+Fe*Re.high[vt]+Gt*Re.right[vt]),I=Pt.find(ot=>Ft<=ot.to_m)??Pt.at(-1);W.ring(bt,Kt,Re.high,Re.right,(I?.od_m??.12)/2*u);let[b,q,ut]=Number.isFinite(we[Jt])?Le(we[Jt]):[.5,.5,.5];B.setRGB(b,q,ut,"srgb"),W.paint(bt,B.r,B.g,B.b)}),W.changed(),ht(qt,Yt,ce,ie,He),A.hidden=!mt?.frames,mt?.frames&&(w.max=mt.frames.time_s.length-1,h!==null&&(w.value=h),C.disabled=h===null,y.textContent=h===null?"mean of the window":`${mt.frames.time_s[h].toFixed(2)} s`)}function ht(mt,yt,Xt,qt,Yt){let ie=Array.from({length:21},(we,ce)=>`rgb(${Yt(ce/20).join(" ")}) ${ce*5}%`),se=Xt.map(we=>De(we,yt)),{values:Ae,step:ge}=Si(se[0],se[1],4);p.replaceChildren(ct("span",{},`${mt}${Rn(yt)?`, ${Rn(yt)}`:""}${qt?" (low side −, high side +)":""}, ${ir(te.operation)}`),ct("div",{class:"ramp",style:`background:linear-gradient(to right, ${ie.join(",")})`}),ct("div",{class:"ramp-ticks"},Ae.map(we=>ct("span",{style:`left:${(we-se[0])/(se[1]-se[0])*100}%`},bi(we,ge)))))}function nt(){let[mt,yt]=L();return Array.from({length:41},(Xt,qt)=>i.at(mt+(yt-mt)*qt/40,{}).place)}function Z(mt){let[yt,Xt]=L().map(Ae=>i.at(Ae,{}).place),[qt,Yt]=[Xt[0]-yt[0],Xt[2]-yt[2]],ie=Math.hypot(qt,Yt);if(ie<.001)return[.6,mt,.8];let se=qt-Yt<0?-1:1;return[-Yt/ie*se,mt,qt/ie*se]}function dt(mt){let{low:yt,high:Xt}=Hf(i,L()),qt=yt.clone().add(Xt).multiplyScalar(.5);o.target.copy(qt);let Yt=t.clientWidth/Xf,ie=new Y(...mt).normalize(),se=new Y(0,1,0).cross(ie).normalize(),Ae=ie.clone().cross(se),ge=Math.tan(r.fov*Math.PI/360),we=0,ce=Wf({low:yt,high:Xt},Z(.3)).flatMap(([He,Le])=>[yt.y,Xt.y].map(Re=>[He,Re,Le]));for(let He of[...ce,...nt()]){let Le=new Y(...He).sub(qt),Re=Math.max(Math.abs(Le.dot(se))/(ge*Yt*.86),Math.abs(Le.dot(Ae))/(ge*.93));we=Math.max(we,Re+Le.dot(ie))}r.position.copy(qt).addScaledVector(ie,we),r.near=we/200,r.far=we*20,r.updateProjectionMatrix(),o.update(),pt()}function pt(){a.position.copy(r.position),a.target.position.copy(o.target),a.target.updateMatrixWorld(),e.render(s,r),Fs()&&([M.width,M.height]=[t.width,t.height],M.getContext("2d").drawImage(t,0,0))}function St(){let mt=g.clientWidth||1200;e.setPixelRatio(Math.min(devicePixelRatio*(devicePixelRatio<1.5?1.5:1),2.5)),e.setSize(mt,Xf,!1),r.aspect=mt/Xf,r.updateProjectionMatrix()}function xt(){St(),Q(),dt(Z(.3))}fn("units operation",()=>{V(),Q()}),fn("depths",()=>{Q(),dt(r.position.clone().sub(o.target).toArray())}),fn("moment",()=>{tt(),pt()});let Wt=0;return new ResizeObserver(()=>{g.clientWidth!==Wt&&(Wt=g.clientWidth,St(),pt())}).observe(g),{element:ct("div",{},P,g,A,p),redraw:xt}}function Kw(n){let t=10**Math.floor(Math.log10(Math.max(n,1)));return[5,2,1].map(e=>e*t).find(e=>e<=Math.max(n,1))??1}var x0=n=>n.kind==="casing"?"casing":"open hole";function y0(n,t){let e=r=>t>=r.from_m&&t<=r.to_m,i=n.hole.find(e),s=n.string.find(e);return[i&&`${x0(i)} ${pn(i.diameter_m,"diameter")}`,s&&`${s.name} ${pn(s.od_m,"diameter")}`].filter(Boolean)}function v0(n,{left:t,width:e,top:i,height:s},[r,o],a){let l=t+e/2,c=Math.max(...n.hole.map(m=>m.diameter_m),...n.string.map(m=>m.contact_od_m)),u=m=>(e-22)/2*(m/c),f=ne("g",{"clip-path":"inset(0)"}),h=m=>Math.min(Math.max(a(m),i-12),i+s+12);for(let m of n.hole){if(m.to_m<r||m.from_m>o)continue;let[M,g,p]=[h(m.from_m),h(m.to_m),u(m.diameter_m)],y=ne("title",{},`${x0(m)} ${pn(m.diameter_m,"diameter")}, ${pn(m.from_m,"length",5)} to ${pn(m.to_m,"length",5)}, friction ${m.friction}`);f.append(ne("rect",{x:l-p,y:M,width:2*p,height:Math.max(g-M,0),class:m.kind==="casing"?"bore":"rock"},y));for(let w of[-1,1]){let v=l+w*p;f.append(ne("line",{x1:v,x2:v,y1:M,y2:g,class:m.kind==="casing"?"casing":"wall"})),m.kind==="casing"&&m.to_m<o&&f.append(ne("path",{d:`M${v} ${g}h${w*8}L${v} ${g-9}Z`,class:"shoe"}))}}let d=n.string.at(-1);for(let m of n.string){if(m.to_m<r||m.from_m>o)continue;let[M,g,p]=[h(m.from_m),h(m.to_m),Math.max(u(m.od_m),1.5)],y=ne("title",{},`${m.name}, OD ${pn(m.od_m,"diameter")}, ${pn(m.from_m,"length",5)} to ${pn(m.to_m,"length",5)}`),w=/drill pipe/i.test(m.name)&&!/heavy/i.test(m.name)?"pipe":"tool",v=m===d?ne("path",{d:`M${l-p} ${Math.min(M,g-5)}h${2*p}v${Math.max(g-M,5)*.5}L${l} ${g+3}L${l-p} ${g-Math.max(g-M,5)*.5}Z`,class:"bit"}):ne("rect",{x:l-p,y:M,width:2*p,height:Math.max(g-M,.7),class:w});v.append(y),f.append(v)}return f}var wh=6,jw=400,Qw=[{title:"Effective tension",dimension:"force",column:"tension_N",band:["tension_p05_N","tension_p95_N"],zero:!0},{title:"Torque",dimension:"torque",column:"torque_N_m",band:["torque_p05_N_m","torque_p95_N_m"]},{title:"Side force",dimension:"force per length",column:"side_force_N_per_m",sides:!0},{title:"In contact",dimension:"percent",column:"contact_fraction",touches:!0,range:[0,1.04],classes:!0},{title:"Bending moment",dimension:"torque",column:"bending_moment_N_m",band:["bending_moment_p05_N_m","bending_moment_p95_N_m"],swings:!0},{title:"Wear work, hole",dimension:"work per length",column:"wear_work_J_per_m",from:"wear"},{title:"Inclination",dimension:"angle",column:"inclination_rad",from:"well",zero:!0},{title:"Dogleg severity",dimension:"dogleg severity",column:"dogleg_rad_per_m",from:"well",zero:!0}],t1=730,Ai=54,ka=88,Va=14,Es=82,e1=20;function n1(n,t){if(t.from==="well"){let e=n.well[t.column];return e.length?[{depths:n.well.md_m,values:e,well:!0}]:[]}return n.solved.flatMap(e=>{let i=t.from==="wear"?e.wear:e.profile,s=i[t.column];if(!s)return[];let r=i.md_m,[o,a]=(t.band??[]).map(c=>i[c]),l={solved:e,depths:r,values:s,low:o,high:a};return t.touches&&(l.values=ml(r,s,wh)),t.swings&&(l.far={values:nm(r,s,wh),low:o&&ml(r,o.map(c=>-c),wh).map(c=>-c),high:a&&ml(r,a,wh)}),[l]})}function M0(n){let t=Qw.map(S=>({...S,curves:n1(n,S)})).filter(S=>S.curves.length),i=[0,Math.max(n.well.md_m.at(-1)??0,...n.solved.map(S=>S.profile.md_m?.at(-1)??0))],s=()=>te.depths??i,r=ct("div",{class:"tracks"}),o=[],a=["from","to"].map((S,N)=>ct("input",{type:"number","aria-label":`Depths in view, ${S}`,step:"any",onchange:R=>{let P=[...s()];P[N]=Li(Number(R.target.value),"length"),f(P)}})),l=ct("span",{}),c=ct("button",{type:"button",onclick:()=>f(i)},"All depths"),u=ct("div",{class:"tools noprint"},ct("label",{},"Depths from ",a[0]),ct("label",{},"to ",a[1]),l,c,ct("span",{class:"hint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all"));function f([S,N]){let[R,P]=[Math.max(Math.min(S,N),i[0]),Math.min(Math.max(S,N),i[1])];P-R>=2&&dn({depths:R<=i[0]&&P>=i[1]?null:[R,P]})}function h(){let S=Fs()?t1:r.clientWidth||1360,R=Math.max(Math.floor((S-Ai-ka-Va)/(126+Va)),1),P=Math.ceil(t.length/Math.min(R,t.length)),O=Math.ceil(t.length/P),V=P===1?640:Fs()?370:500;o=Array.from({length:P},(H,F)=>d(t.slice(F*O,(F+1)*O),S,O,V)),r.replaceChildren(...o.map(H=>H.picture));let[L,k]=s();a[0].value=De(L,"length").toFixed(1),a[1].value=De(k,"length").toFixed(1),l.textContent=Rn("length"),c.disabled=te.depths===null,w()}function d(S,N,R,P){let[O,V]=s(),L=xt=>Es+(xt-O)/(V-O)*P,k=Es+P+e1,H=ne("svg",{viewBox:`0 0 ${N} ${k}`,width:N,height:k,role:"img","aria-label":S.map(xt=>xt.title).join(", ")}),F=Ai+ka+Va,Q=(N-F-Va*(R-1)-2)/R;m(H,[O,V],L,N,F);let W={left:Ai,width:ka,top:Es,height:P},$=ne("svg",{x:0,y:Es-10,width:N,height:P+18,viewBox:`0 ${Es-10} ${N} ${P+18}`});$.append(v0(n,W,[O,V],L)),H.append($,ne("text",{x:Ai+ka/2,y:16,class:"title middle"},"Hole, string"));let tt=S.map((xt,Wt)=>{let mt={left:F+Wt*(Q+Va),width:Q,top:Es,height:P};return{track:xt,text:M(H,xt,mt,[O,V],L)}}),ht=ne("line",{x1:Ai,x2:N,class:"cursor",visibility:"hidden"}),nt=ne("line",{x1:Ai,x2:N,class:"chosen",visibility:"hidden"}),Z=ne("text",{x:2,class:"flag",visibility:"hidden"}),dt=ne("g",{class:"readout"}),pt=ne("rect",{x:Ai,width:N-Ai,class:"drag",visibility:"hidden"}),St=ne("rect",{x:Ai,y:Es,width:N-Ai,height:P,class:"cover"});return H.append(pt,nt,ht,Z,dt,St),y(St,pt,H,P,k,N),{picture:H,y:L,readouts:tt,cursor:ht,chosenLine:nt,flag:Z,what:dt}}function m(S,[N,R],P,O,V){let{values:L,step:k}=Si(De(N,"length"),De(R,"length"),12);for(let H of L){let F=P(Li(H,"length"));S.append(ne("line",{x1:V,x2:O,y1:F,y2:F,class:"grid"}),ne("text",{x:Ai-8,y:F+4,class:"tick end"},bi(H,k)))}S.append(ne("text",{x:0,y:16,class:"title"},"MD"),ne("text",{x:0,y:31,class:"unit"},Rn("length")))}function M(S,N,R,[P,O],V){let L=[P,O],k=O-P>jw,H=N.curves.map(nt=>k&&nt.far?{...nt,...nt.far}:nt),F=N.range;if(!F){let nt=H.flatMap(Z=>[Z.values,Z.low,Z.high].filter(Boolean).map(dt=>tm(Z.depths,dt,L)));F=am(Math.min(...nt.map(Z=>Z[0])),Math.max(...nt.map(Z=>Z[1])),N.zero||N.sides,Li(1,N.dimension))}let Q=nt=>R.left+(nt-F[0])/(F[1]-F[0])*R.width,W=ne("svg",{x:R.left,y:R.top,width:R.width,height:R.height,viewBox:`${R.left} ${R.top} ${R.width} ${R.height}`}),$=Si(De(F[0],N.dimension),De(F[1],N.dimension),R.width/44);for(let nt of $.values){let Z=Q(Li(nt,N.dimension)),dt=Z<R.left+8?"start":Z>R.left+R.width-8?"end":"middle";S.append(ne("line",{x1:Z,x2:Z,y1:R.top,y2:R.top+R.height,class:nt===0?"zero":"grid"}),ne("text",{x:Z,y:R.top-7,class:`tick ${dt}`},bi(nt,$.step)))}for(let nt of n.hole.filter(Z=>Z.kind==="casing"&&Z.to_m>P&&Z.to_m<O))W.append(ne("line",{x1:R.left,x2:R.left+R.width,y1:V(nt.to_m),y2:V(nt.to_m),class:"shoe-depth"}));N.sides&&g(W,N,L,Q,V);for(let nt of H){let{colour:Z,dashed:dt}=nt.well?{colour:"var(--text)",dashed:!1}:Ka(n,nt.solved),pt=!nt.well&&Nr(n).length>1&&nt.solved.operation!==te.operation;nt.low&&nt.high&&W.append(ne("path",{d:pl(nt.depths,nt.low,nt.high,L,Q,V),fill:Z,class:pt?"band faint":"band"})),W.append(ne("path",{d:em(nt.depths,nt.values,L,Q,V),stroke:Z,class:`curve${dt?" dashed":""}${pt?" faint":""}`}))}N.classes&&p(W,N,R,L,V);let tt=R.left+R.width/2;S.append(W,ne("rect",{x:R.left,y:R.top,width:R.width,height:R.height,class:"frame"}),ne("text",{x:tt,y:16,class:"title middle"},N.title),ne("text",{x:tt,y:31,class:"unit middle"},Rn(N.dimension))),N.sides&&S.append(ne("text",{x:R.left,y:R.top+R.height+14,class:"side low"},"◂ low side"),ne("text",{x:R.left+R.width,y:R.top+R.height+14,class:"side high end"},"high side ▸")),N.swings&&k&&S.append(ne("text",{x:R.left,y:R.top+R.height+14,class:"side"},"joint to joint")),N.classes&&S.append(ne("text",{x:R.left,y:R.top+R.height+14,class:"side"},"▌ always ",ne("tspan",{class:"sometimes"},"▌")," at times"));let ht=ne("text",{x:tt,y:48,class:"readout middle"});return S.append(ht),ht}function g(S,N,R,P,O){let V=yi(n,"dynamic")??yi(n,"soft"),L=N.curves.find(F=>F.solved===V);if(!L)return;let k=new Float32Array(L.values.length),H=F=>L.values.map(Q=>F(Q)?Q:0);S.append(ne("path",{d:pl(L.depths,k,H(F=>F>0),R,P,O),class:"high-side"}),ne("path",{d:pl(L.depths,H(F=>F<0),k,R,P,O),class:"low-side"}))}function p(S,N,R,P,O){let V=yi(n,"dynamic"),L=N.curves.find(W=>W.solved===V);if(!L)return;let k=W=>W<.01?0:W<=.99?1:2,H=0,{depths:F,values:Q}=L;for(let W=1;W<=Q.length;W++){if(W<Q.length&&k(Q[W])===k(Q[H]))continue;let $=k(Q[H]),[tt,ht]=[O(F[H]),O(F[Math.min(W,Q.length-1)])];$>0&&ht>R.top&&tt<R.top+R.height&&S.append(ne("rect",{x:R.left,y:tt,width:6,height:Math.max(ht-tt,.7),class:$===2?"always":"sometimes"})),H=W}}function y(S,N,R,P,O,V){let L=H=>{let F=R.getBoundingClientRect(),Q=(H.clientY-F.top)/F.height*O,[W,$]=s();return W+(Q-Es)/P*($-W)},k=null;S.addEventListener("pointerdown",H=>{H.button===0&&(k={depth:L(H),y:H.clientY,view:s(),moves:H.shiftKey},S.setPointerCapture(H.pointerId))}),S.addEventListener("pointermove",H=>{let F=L(H);if(k?.moves){let Q=R.getBoundingClientRect(),W=(k.y-H.clientY)/Q.height*(O/P)*(k.view[1]-k.view[0]),$=Math.min(Math.max(W,i[0]-k.view[0]),i[1]-k.view[1]);f(k.view.map(tt=>tt+$))}else if(k&&Math.abs(H.clientY-k.y)>4){let[Q,W]=s(),$=ht=>Es+(ht-Q)/(W-Q)*P,tt=[$(k.depth),$(F)].sort((ht,nt)=>ht-nt);N.setAttribute("y",tt[0]),N.setAttribute("height",tt[1]-tt[0]),N.setAttribute("visibility","visible")}dn({pointer:F})}),S.addEventListener("pointerup",H=>{if(!k)return;let{depth:F,y:Q,moves:W}=k;k=null,N.setAttribute("visibility","hidden"),!W&&(Math.abs(H.clientY-Q)>4?f([F,L(H)]):dn({depth:Math.min(Math.max(F,i[0]),i[1])}))}),S.addEventListener("pointerleave",()=>dn({pointer:null})),S.addEventListener("dblclick",()=>f(i)),S.addEventListener("wheel",H=>{if(!H.ctrlKey&&!H.metaKey)return;H.preventDefault();let F=L(H),Q=Math.exp(H.deltaY*.002);f(s().map(W=>F+(W-F)*Q))},{passive:!1})}function w(){let[S,N]=s();for(let{y:R,readouts:P,cursor:O,chosenLine:V,flag:L,what:k}of o){let H=(Q,W)=>{let $=W!==null&&W>=S&&W<=N;if(Q.setAttribute("visibility",$?"visible":"hidden"),$)for(let tt of["y1","y2"])Q.setAttribute(tt,R(W));return $};H(V,te.depth);let F=H(O,te.pointer);L.setAttribute("visibility",F?"visible":"hidden"),L.setAttribute("y",F?R(te.pointer)+4:0),L.textContent=F?Un(De(te.pointer,"length"),5):"",k.replaceChildren(...(F?y0(n,te.pointer):[]).map((Q,W)=>ne("text",{x:Ai+ka/2,y:34+13*W,class:"readout middle small"},Q.length>24?`${Q.slice(0,23)}…`:Q)));for(let{track:Q,text:W}of P)W.replaceChildren(...F?v(Q):[])}}function v(S){return S.curves.filter(R=>R.well||R.solved.operation===te.operation).map((R,P)=>{let O=dl(R.depths,R.values,te.pointer),V=R.well?"var(--text)":Ka(n,R.solved).colour;return ne("tspan",{fill:V,dx:P?6:0},Number.isFinite(O)?Un(De(O,S.dimension)):"–")})}function C(){let S=n.solved.map(P=>{let{colour:O,dashed:V}=Ka(n,P);return ct("span",{class:"key"},ne("svg",{width:26,height:10},ne("line",{x1:1,x2:25,y1:5,y2:5,stroke:O,class:`curve${V?" dashed":""}`})),Td(n,P))}),N=n.runs.length?[ct("span",{class:"key"},ne("svg",{width:26,height:10},ne("rect",{width:26,height:10,fill:"var(--line-0)",class:"band"})),"5–95 % of the time")]:[],R=["high","low"].map(P=>ct("span",{class:"key"},ne("svg",{width:14,height:10},ne("rect",{width:14,height:10,class:`${P}-side`})),`on the ${P} side`));return[...S,...N,...R]}let A=ct("div",{class:"legend"}),_=()=>{A.replaceChildren(...C()),h()};return fn("units depths operation",_),fn("pointer depth",w),new ResizeObserver(()=>!Fs()&&r.clientWidth!==Number(o[0]?.picture.getAttribute("width"))&&h()).observe(r),{element:ct("div",{},A,u,r),redraw:_,full:i}}var bn=fm();_d(bn.dimensions);var Yf=Nr(bn),i1=bn.runs.at(-1);Object.assign(te,{units:bn.units,operation:i1?.operation??Yf.at(-1),depth:(bn.well.md_m.at(-1)??0)/2});var Ri={answers:Ad(bn),tracks:M0(bn)};bn.runs.length&&(Ri.history=sm(bn),Ri.contact=hm(bn));bn.well.md_m.length>1&&(Ri.scene=_0(bn));var js=(n,t,...e)=>ct("section",{id:n},ct("h2",{},t),e),qf=n=>bn.sheets.filter(t=>t.place===n).map(bd);function s1(n){let t=n.history.time_s.length,e=t<n.samples?`${n.samples} samples are drawn as ${t}, the smallest and the largest of each few: peaks keep their height`:`all ${n.samples} samples are drawn`,{frames:i}=n,s=i&&(i.time_s.length<i.kept?`; ${i.time_s.length} of ${i.kept} frames`:`; all ${i.kept} frames`),r=i&&i.md_m.length<i.nodes?`, ${i.md_m.length} of ${i.nodes} nodes`:"";return`${ir(n.operation)}: ${e}${s??""}${r}.`}var Th=document.getElementById("page"),S0=Yf.length>1?Dr("Operation",Yf.map(n=>[n,ir(n)]),te.operation,n=>dn({operation:n,times:null,moment:null})):null,r1=om(()=>Object.values(Ri).forEach(n=>n.redraw()));Th.append(ct("header",{},ct("div",{class:"title-line"},ct("h1",{},bn.title),ct("div",{class:"controls noprint"},Dr("Units",[["si","SI"],["metric","Metric"],["field","US field"]],te.units,n=>dn({units:n})),Dr("Colours",[["auto","Auto"],["light","Light"],["dark","Dark"]],te.theme,r1),ct("button",{type:"button",onclick:()=>print()},"Print"))),Ed(bn)),js("answer","Answer",S0&&ct("div",{class:"operations"},S0),Ri.answers.element),js("tracks","Along the hole",Ri.tracks.element));var $f=[];Ri.history&&$f.push(js("history","In time",Ri.history.element),js("contact","Contact over depth and time",Ri.contact.element));Th.append(...$f);Ri.scene&&Th.append(js("scene","In space",Ri.scene.element));Th.append(js("results","All numbers",qf("results")),...bn.runs.length?[js("numerics","Numerics",qf("numerics"))]:[],js("inputs","Inputs, defaults included",qf("inputs")),ct("footer",{},ct("p",{},`Made by ${bn.program}. The tables beside this file hold every digit; this page holds what can be seen. `,bn.runs.map(s1).join(" ")),ct("details",{},ct("summary",{},"Plots by uPlot, 3D by three.js: their licences (MIT)"),ct("pre",{},document.getElementById("licences").content.textContent))));var b0=()=>$f.forEach(n=>n.toggleAttribute("hidden",!Xn(bn)));fn("operation",b0);b0();Object.values(Ri).forEach(n=>n.redraw());document.documentElement.dataset.ready="";})();

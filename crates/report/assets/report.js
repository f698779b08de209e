(()=>{var p_="http://www.w3.org/2000/svg";function Fd(n,t,e){for(let[i,s]of Object.entries(t??{}))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):n.setAttribute(i,s===!0?"":s));for(let i of e.flat(3))i!=null&&n.append(i);return n}function et(n,t,...e){return Fd(document.createElement(n),t,e)}function Qt(n,t,...e){return Fd(document.createElementNS(p_,n),t,e)}function ir(n,t,e,i){let s=t.map(([r,o])=>et("button",{type:"button","aria-pressed":String(r===e),"data-value":r,onclick:a=>{for(let l of s)l.setAttribute("aria-pressed",String(l===a.currentTarget));i(r)}},o));return et("div",{class:"choice",role:"group","aria-label":n},s)}function el(n,t,e,i){return et("label",{class:"select"},n,et("select",{onchange:s=>i(s.target.value)},t.map(([s,r])=>et("option",{value:s,selected:s===e},r))))}var nl=new Map,qt={units:"si",theme:"auto",operation:null,depths:null,times:null,depth:null,moment:null,pointer:null};function Oe(n,t){for(let e of n.split(" "))nl.has(e)||nl.set(e,[]),nl.get(e).push(t)}function an(n){let t=new Set;for(let[e,i]of Object.entries(n))if(!Object.is(qt[e],i)){qt[e]=i;for(let s of nl.get(e)??[])t.add(s)}for(let e of t)e()}var m_=["si","metric","field"],Od={};function Bd(n){Od=n}function il(n){return Od[n]?.[m_.indexOf(qt.units)]??{symbol:"",factor:1}}var Be=n=>il(n).symbol,_e=(n,t)=>n/il(t).factor,Jn=(n,t)=>n*il(t).factor;function sl(n,t){let e=il(t).factor;return Array.from(n,i=>Number.isFinite(i)?i/e:null)}function On(n,t=4){if(!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.abs(n);if(e>=1e9||e<1e-4){let[r,o]=n.toExponential(t-1).split("e");return`${zd(String(Number(r)))}·10${g_(Number(o))}`}let i=Math.floor(Math.log10(e))+1,s=Math.min(Math.max(t-i,0),6);return sr(n.toFixed(s))}function g_(n){let t={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};return[...String(n)].map(e=>t[e]).join("")}var zd=n=>n.replace("-","−");function sr(n){let[t,e]=n.split("."),i=t.replace("-","").length>4?t.replace(/\B(?=(\d{3})+$)/g," "):t;return zd(e===void 0?i:`${i}.${e}`)}function Ho(n,t=6){let e=On(n,t);return/\.\d*0$/.test(e)?e.replace(/\.?0+$/,""):e}function ke(n,t,e=4,i=On){let s=Be(t),r=i(_e(n,t),e);return s===""?r:`${r} ${s}`}var Vd=n=>Number.isInteger(n)&&Math.abs(n)<1e12?sr(String(n)):Ho(n);function rr(n,t){return n===null||n===""?"–":typeof n=="string"?n:typeof n=="number"?Vd(n):n.values?__(n):ke(n.value,n.dimension,t??6,t?On:Ho)}function __({values:n,dimension:t}){return`${n.map(i=>Ho(_e(i,t))).join(", ")} ${Be(t)}`.trim()}function Gd(n){return n?.value===void 0?rr(n):Ho(_e(n.value,n.dimension))}function Hd(n,t,e){if(n===null||typeof n!="object")return rr(n);let i=o=>Math.abs(o)<1e-6*t?0:o,s=i(_e(n.value,n.dimension)),r=n.dimension==="ratio"&&Number.isInteger(s)?Vd(s):On(s,e);return n.std===void 0?r:`${r} ± ${On(i(_e(n.std,n.dimension)),2)}`}function Wd(n){let t=new Set(n.filter(e=>e!==null&&typeof e=="object").map(e=>e.dimension));return t.size===1?[...t][0]:null}var Xd=n=>n&&Be(n)!==""?et("span",{class:"unit"},` ${Be(n)}`):null,qd=n=>typeof n=="string",Yd=n=>Math.max(0,...n.map(t=>t?.dimension?Math.abs(_e(t.value,t.dimension)):0));function x_(n){return n.rows.map(([t,...e])=>et("tr",{},et("th",{scope:"row"},t,Xd(Wd(e))),e.map(i=>et("td",{class:"number"},Hd(i,Yd(e),5)))))}function y_(n){let t=({value:s,dimension:r,std:o})=>{let a=_e(s,r);return o===void 0&&Math.abs(a-Math.round(a))<=1e-9*Math.abs(a)},e=n.filter(s=>s?.dimension),i=Yd(e);return e.every(t)?Gd:s=>Hd(s,i,4)}function kd(n,t){let e=(n.rows[0]??[]).map((i,s)=>t(n.rows.map(r=>r[s])));return n.rows.map(i=>et("tr",{},i.map((s,r)=>et("td",{class:qd(s)?null:"number"},e[r](s)))))}function v_(n){return n.rows.map(([t,e])=>et("tr",{},et("th",{scope:"row"},t),et("td",{},rr(e))))}function Wo(n){let t=et("tbody",{}),e=et("thead",{}),i=n.place==="cases",s=n.place!=="inputs"&&!i,r=()=>s?x_(n):i?kd(n,y_):n.heads.length?kd(n,()=>Gd):v_(n),o=()=>{t.replaceChildren(...r());let c=f=>s?null:Xd(Wd(n.rows.map(d=>d[f])));n.heads.length&&e.replaceChildren(et("tr",{},n.heads.map((f,d)=>{let h=i&&n.rows.every(u=>qd(u[d]));return et("th",{scope:"col",class:h?"words":null},f,c(d))})))};Oe("units",o),o();let a=et("div",{class:"scrolls"},et("table",{class:n.heads.length?"grid":"keys"},e,t));if(s||i)return et("div",{class:i?"sheet cases":"sheet"},et("h3",{},n.title),a);let l=n.rows.length>24;return et("details",{class:`sheet prints${n.heads.length>4?" wide":""}${l?" long":""}`,open:!l},et("summary",{},n.title,l?` (${n.rows.length} rows)`:""),a)}var Ue=n=>getComputedStyle(document.documentElement).getPropertyValue(`--${n}`).trim(),or=n=>Ue(`line-${n%7}`);function M_(n){let t=parseInt(n.slice(1),16);return[t>>16,t>>8&255,t&255]}var S_=Array.from({length:10},(n,t)=>`amount-${t}`),b_=["low-side-strong","low-side","middle","high-side","high-side-strong"];function w_(n,t){let e=t*(n.length-1),i=Math.min(Math.floor(e),n.length-2),s=e-i;return n[i].map((r,o)=>r+s*(n[i+1][o]-r))}var iu=512;function zr(n){let t=(n?b_:S_).map(i=>M_(Ue(i))),e=Array.from({length:iu+1},(i,s)=>w_(t,s/iu));return i=>e[Math.round(Math.min(Math.max(i,0),1)*iu)]}var ar=n=>n.replaceAll("_"," "),rl=n=>n==="soft"?"soft string":"dynamics",kr=n=>[...new Set(n.solved.map(t=>t.operation))];function ol(n,t){let e=kr(n),i=t.model==="soft",s=new Set(n.solved.map(o=>o.model)).size>1,r=e.indexOf(t.operation);return{colour:or(e.length===1&&s&&i?1:r),dashed:s&&i}}function $d(n,t){return kr(n).length===1?rl(t.model):new Set(n.solved.map(i=>i.model)).size===1?ar(t.operation):`${ar(t.operation)}, ${rl(t.model)}`}var bi=(n,t)=>n.solved.find(e=>e.operation===qt.operation&&e.model===t),In=n=>n.runs.find(t=>t.operation===qt.operation);function al(n){let t=et("dl",{class:"asked"}),e=()=>t.replaceChildren(...n.asked.map(({label:i,value:s})=>et("div",{},et("dt",{},i),et("dd",{},rr(s)))));return Oe("units",e),e(),t}function T_(n){return n>1?["over","over the limit"]:n>.8?["near","near the limit"]:["within","within the limit"]}function E_(n,t){let e=n.value?.dimension,i=[et("h3",{},n.label),et("p",{class:"number"},rr(n.value,e==="ratio"||e==="percent"?3:4))];n.worst!==null&&e&&i.push(et("p",{class:"note"},`mean; at most ${ke(n.worst,e)}`)),t?.value?.dimension===e&&e&&i.push(et("p",{class:"note"},`soft string ${rr(t.value,4)}`));let s=n.worst??n.value?.value;if(n.limit!==null&&Number.isFinite(s)){let r=s/n.limit,[o,a]=T_(r);i.push(et("div",{class:`limit ${o}`},et("div",{class:"bar"},et("div",{class:"used",style:`width:${Math.min(Math.max(r,0),1)*100}%`})),et("p",{class:"note"},et("strong",{},`${Math.round(r*100)} %, ${a}`),et("br"),`${n.limit_label} ${e==="percent"||e==="ratio"?"":ke(n.limit,e)}`)))}else i.push(et("p",{class:"note"},n.limit_label));return et("div",{class:"card answer"},i)}function Zd(n){let t=et("div",{}),e=()=>{let i=bi(n,"dynamic"),s=bi(n,"soft"),r=i??s,o=l=>i&&s?.answers.find(c=>c.label===l.label),a=[i,s].filter(l=>l?.message).map(l=>et("p",{class:"warning"},`${rl(l.model)}: ${l.message}`));t.replaceChildren(...a,et("div",{class:"answers"},r.answers.map(l=>E_(l,o(l)))))};return Oe("units operation",e),{element:t,redraw:e}}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ap=0,Du=1,Rp=2;var Ea=1,Cp=2,go=3,es=0,ni=1,si=2,gr=0,_o=1,Nu=2,Uu=3,Fu=4,Pp=5;var _r=100,Ip=101,Lp=102,Dp=103,Np=104,Up=200,Fp=201,Op=202,Bp=203,Ou=204,Bu=205,zp=206,kp=207,Vp=208,Gp=209,Hp=210,Wp=211,Xp=212,qp=213,Yp=214,Ul=0,Fl=1,Ol=2,ro=3,Bl=4,zl=5,kl=6,Vl=7,gc=0,$p=1,Zp=2,ns=0,zu=1,ku=2,Vu=3,Gu=4,Hu=5,Wu=6,Xu=7;var qu=300,xr=301,xo=302,_c=303,xc=304,Gl=1e3,Ki=1001,Hl=1002,Dn=1003,Jp=1004;var Aa=1005;var ti=1006,yc=1007;var ws=1008;var ri=1009,Yu=1010,$u=1011,yo=1012,vc=1013,Fi=1014,Oi=1015,Bi=1016,Mc=1017,Sc=1018,yr=1020,Zu=35902,Ju=35899,Ku=1021,ju=1022,zi=1023,vs=1026,Ts=1027,Qu=1028,bc=1029,$s=1030,wc=1031;var Tc=1033,Ra=33776,Ca=33777,Pa=33778,Ia=33779,Ec=35840,Ac=35841,Rc=35842,Cc=35843,Pc=36196,Ic=37492,Lc=37496,Dc=37488,Nc=37489,La=37490,Uc=37491,Fc=37808,Oc=37809,Bc=37810,zc=37811,kc=37812,Vc=37813,Gc=37814,Hc=37815,Wc=37816,Xc=37817,qc=37818,Yc=37819,$c=37820,Zc=37821,Jc=36492,Kc=36494,jc=36495,Qc=36283,th=36284,Da=36285,eh=36286;var na=2300,Wl=2301,Dl=2302,Eu=2303,Au=2400,Ru=2401,Cu=2402;var Kp=3200;var nh=0,jp=1,Es="",di="srgb",ia="srgb-linear",sa="linear",Ce="srgb";var Nl=7680;var Qp=519,tm=512,em=513,nm=514,tf=515,im=516,sm=517,ef=518,nf=519,sf=35044;var rf="300 es",Ti=2e3,oo=2001;function A_(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function R_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ra(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function rm(){let n=ra("canvas");return n.style.display="block",n}var Jd={},ao=null;function oa(...n){let t="THREE."+n.shift();ao?ao("log",t,...n):console.log(t,...n)}function om(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Zt(...n){n=om(n);let t="THREE."+n.shift();if(ao)ao("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ne(...n){n=om(n);let t="THREE."+n.shift();if(ao)ao("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Qo(...n){let t=n.join(" ");t in Jd||(Jd[t]=!0,Zt(...n))}function am(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var lm={[Ul]:Ul,[Ol]:kl,[Bl]:Bl,[ro]:zl,[Fl]:Fl,[kl]:Ol,[Vl]:Vl,[zl]:ro},Ui=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Kd=1234567,ta=Math.PI/180,lo=180/Math.PI;function Zs(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]+"-"+Vn[t&255]+Vn[t>>8&255]+"-"+Vn[t>>16&15|64]+Vn[t>>24&255]+"-"+Vn[e&63|128]+Vn[e>>8&255]+"-"+Vn[e>>16&255]+Vn[e>>24&255]+Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]).toLowerCase()}function me(n,t,e){return Math.max(t,Math.min(e,n))}function of(n,t){return(n%t+t)%t}function C_(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function P_(n,t,e){return n!==t?(e-n)/(t-n):0}function ea(n,t,e){return(1-e)*n+e*t}function I_(n,t,e,i){return ea(n,t,1-Math.exp(-e*i))}function L_(n,t=1){return t-Math.abs(of(n,t*2)-t)}function D_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function N_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function U_(n,t){return n+Math.floor(Math.random()*(t-n+1))}function F_(n,t){return n+Math.random()*(t-n)}function O_(n){return n*(.5-Math.random())}function B_(n){n!==void 0&&(Kd=n);let t=Kd+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function z_(n){return n*ta}function k_(n){return n*lo}function V_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function G_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function af(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function H_(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),f=o((t+i)/2),d=r((t-i)/2),h=o((t-i)/2),u=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*f,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*f,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*f,a*c);break;case"XZX":n.set(a*f,l*p,l*u,a*c);break;case"YXY":n.set(l*u,a*f,l*p,a*c);break;case"ZYZ":n.set(l*p,l*u,a*f,a*c);break;default:Zt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ih(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function lf(n,t){if(t.constructor===Float32Array)return n;let e=ih(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function cf(n,t){if(t.constructor===Float32Array)return n;let e=ih(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var hf={DEG2RAD:ta,RAD2DEG:lo,generateUUID:Zs,clamp:me,euclideanModulo:of,mapLinear:C_,inverseLerp:P_,lerp:ea,damp:I_,pingpong:L_,smoothstep:D_,smootherstep:N_,randInt:U_,randFloat:F_,randFloatSpread:O_,seededRandom:B_,degToRad:z_,radToDeg:k_,isPowerOfTwo:V_,ceilPowerOfTwo:G_,floorPowerOfTwo:af,setQuaternionFromProperEuler:H_,normalize:cf,denormalize:lf},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(me(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},mi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],f=i[s+2],d=i[s+3],h=r[o+0],u=r[o+1],p=r[o+2],x=r[o+3];if(d!==x||l!==h||c!==u||f!==p){let m=l*h+c*u+f*p+d*x;m<0&&(h=-h,u=-u,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),b=Math.sin(v);g=Math.sin(g*v)/b,a=Math.sin(a*v)/b,l=l*g+h*a,c=c*g+u*a,f=f*g+p*a,d=d*g+x*a}else{l=l*g+h*a,c=c*g+u*a,f=f*g+p*a,d=d*g+x*a;let v=1/Math.sqrt(l*l+c*c+f*f+d*d);l*=v,c*=v,f*=v,d*=v}}t[e]=l,t[e+1]=c,t[e+2]=f,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],f=i[s+3],d=r[o],h=r[o+1],u=r[o+2],p=r[o+3];return t[e]=a*p+f*d+l*u-c*h,t[e+1]=l*p+f*h+c*d-a*u,t[e+2]=c*p+f*u+a*h-l*d,t[e+3]=f*p-a*d-l*h-c*u,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),f=a(s/2),d=a(r/2),h=l(i/2),u=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*f*d+c*u*p,this._y=c*u*d-h*f*p,this._z=c*f*p+h*u*d,this._w=c*f*d-h*u*p;break;case"YXZ":this._x=h*f*d+c*u*p,this._y=c*u*d-h*f*p,this._z=c*f*p-h*u*d,this._w=c*f*d+h*u*p;break;case"ZXY":this._x=h*f*d-c*u*p,this._y=c*u*d+h*f*p,this._z=c*f*p+h*u*d,this._w=c*f*d-h*u*p;break;case"ZYX":this._x=h*f*d-c*u*p,this._y=c*u*d+h*f*p,this._z=c*f*p-h*u*d,this._w=c*f*d+h*u*p;break;case"YZX":this._x=h*f*d+c*u*p,this._y=c*u*d+h*f*p,this._z=c*f*p-h*u*d,this._w=c*f*d-h*u*p;break;case"XZY":this._x=h*f*d-c*u*p,this._y=c*u*d-h*f*p,this._z=c*f*p+h*u*d,this._w=c*f*d+h*u*p;break;default:Zt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],f=e[6],d=e[10],h=i+a+d;if(h>0){let u=.5/Math.sqrt(h+1);this._w=.25/u,this._x=(f-l)*u,this._y=(r-c)*u,this._z=(o-s)*u}else if(i>a&&i>d){let u=2*Math.sqrt(1+i-a-d);this._w=(f-l)/u,this._x=.25*u,this._y=(s+o)/u,this._z=(r+c)/u}else if(a>d){let u=2*Math.sqrt(1+a-i-d);this._w=(r-c)/u,this._x=(s+o)/u,this._y=.25*u,this._z=(l+f)/u}else{let u=2*Math.sqrt(1+d-i-a);this._w=(o-s)/u,this._x=(r+c)/u,this._y=(l+f)/u,this._z=.25*u}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(me(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,f=e._w;return this._x=i*f+o*a+s*c-r*l,this._y=s*f+o*l+r*a-i*c,this._z=r*f+o*c+i*l-s*a,this._w=o*f-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),f=Math.sin(c);l=Math.sin(l*c)/f,e=Math.sin(e*c)/f,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(jd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(jd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),f=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*f,this.y=i+l*f+a*c-r*d,this.z=s+l*d+r*f-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this.z=me(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this.z=me(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return su.copy(this).projectOnVector(t),this.sub(su)}reflect(t){return this.sub(su.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(me(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},su=new q,jd=new mi,se=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let f=this.elements;return f[0]=t,f[1]=s,f[2]=a,f[3]=e,f[4]=r,f[5]=l,f[6]=i,f[7]=o,f[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],f=i[4],d=i[7],h=i[2],u=i[5],p=i[8],x=s[0],m=s[3],g=s[6],v=s[1],b=s[4],S=s[7],E=s[2],T=s[5],_=s[8];return r[0]=o*x+a*v+l*E,r[3]=o*m+a*b+l*T,r[6]=o*g+a*S+l*_,r[1]=c*x+f*v+d*E,r[4]=c*m+f*b+d*T,r[7]=c*g+f*S+d*_,r[2]=h*x+u*v+p*E,r[5]=h*m+u*b+p*T,r[8]=h*g+u*S+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8];return e*o*f-e*a*c-i*r*f+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],d=f*o-a*c,h=a*l-f*r,u=c*r-o*l,p=e*d+i*h+s*u;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=d*x,t[1]=(s*c-f*i)*x,t[2]=(a*i-s*o)*x,t[3]=h*x,t[4]=(f*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=u*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Qo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ru.makeScale(t,e)),this}rotate(t){return Qo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ru.makeRotation(-t)),this}translate(t,e){return Qo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ru.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},ru=new se,Qd=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),tp=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function W_(){let n={enabled:!0,workingColorSpace:ia,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ce&&(s.r=ys(s.r),s.g=ys(s.g),s.b=ys(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(s.r=so(s.r),s.g=so(s.g),s.b=so(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ia]:{primaries:t,whitePoint:i,transfer:sa,toXYZ:Qd,fromXYZ:tp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:t,whitePoint:i,transfer:Ce,toXYZ:Qd,fromXYZ:tp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:di}}}),n}var ve=W_();function ys(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function so(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vr,Xl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Vr===void 0&&(Vr=ra("canvas")),Vr.width=t.width,Vr.height=t.height;let s=Vr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Vr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ra("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ys(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ys(e[i]/255)*255):e[i]=ys(e[i]);return{data:e,width:t.width,height:t.height}}else return Zt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},X_=0,co=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:X_++}),this.uuid=Zs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ou(s[o].image)):r.push(ou(s[o]))}else r=ou(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ou(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Xl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Zt("Texture: Unable to serialize Texture."),{})}var q_=0,au=new q,ei=class n extends Ui{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Ki,s=Ki,r=ti,o=ws,a=zi,l=ri,c=n.DEFAULT_ANISOTROPY,f=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:q_++}),this.uuid=Zs(),this.name="",this.source=new co(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=f,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(au).x}get height(){return this.source.getSize(au).y}get depth(){return this.source.getSize(au).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Zt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Zt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==qu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Gl:t.x=t.x-Math.floor(t.x);break;case Ki:t.x=t.x<0?0:1;break;case Hl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Gl:t.y=t.y-Math.floor(t.y);break;case Ki:t.y=t.y<0?0:1;break;case Hl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=qu;ei.DEFAULT_ANISOTROPY=1;var je=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],f=l[4],d=l[8],h=l[1],u=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(f-h)<.01&&Math.abs(d-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(f+h)<.1&&Math.abs(d+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+u+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,S=(u+1)/2,E=(g+1)/2,T=(f+h)/4,_=(d+x)/4,M=(p+m)/4;return b>S&&b>E?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=T/i,r=_/i):S>E?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=T/s,r=M/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=_/r,s=M/r),this.set(i,s,r,e),this}let v=Math.sqrt((m-p)*(m-p)+(d-x)*(d-x)+(h-f)*(h-f));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(d-x)/v,this.z=(h-f)/v,this.w=Math.acos((c+u+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this.z=me(this.z,t.z,e.z),this.w=me(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this.z=me(this.z,t,e),this.w=me(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ql=class extends Ui{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ti,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new je(0,0,t,e),this.scissorTest=!1,this.viewport=new je(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ti,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new co(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},gi=class extends ql{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},aa=class extends ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=Ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Yl=class extends ei{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=Ki,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var He=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,f,d,h,u,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,f,d,h,u,p,x,m)}set(t,e,i,s,r,o,a,l,c,f,d,h,u,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=f,g[10]=d,g[14]=h,g[3]=u,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Gr.setFromMatrixColumn(t,0).length(),r=1/Gr.setFromMatrixColumn(t,1).length(),o=1/Gr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),f=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let h=o*f,u=o*d,p=a*f,x=a*d;e[0]=l*f,e[4]=-l*d,e[8]=c,e[1]=u+p*c,e[5]=h-x*c,e[9]=-a*l,e[2]=x-h*c,e[6]=p+u*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*f,u=l*d,p=c*f,x=c*d;e[0]=h+x*a,e[4]=p*a-u,e[8]=o*c,e[1]=o*d,e[5]=o*f,e[9]=-a,e[2]=u*a-p,e[6]=x+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*f,u=l*d,p=c*f,x=c*d;e[0]=h-x*a,e[4]=-o*d,e[8]=p+u*a,e[1]=u+p*a,e[5]=o*f,e[9]=x-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*f,u=o*d,p=a*f,x=a*d;e[0]=l*f,e[4]=p*c-u,e[8]=h*c+x,e[1]=l*d,e[5]=x*c+h,e[9]=u*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,u=o*c,p=a*l,x=a*c;e[0]=l*f,e[4]=x-h*d,e[8]=p*d+u,e[1]=d,e[5]=o*f,e[9]=-a*f,e[2]=-c*f,e[6]=u*d+p,e[10]=h-x*d}else if(t.order==="XZY"){let h=o*l,u=o*c,p=a*l,x=a*c;e[0]=l*f,e[4]=-d,e[8]=c*f,e[1]=h*d+x,e[5]=o*f,e[9]=u*d-p,e[2]=p*d-u,e[6]=a*f,e[10]=x*d+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Y_,t,$_)}lookAt(t,e,i){let s=this.elements;return ui.subVectors(t,e),ui.lengthSq()===0&&(ui.z=1),ui.normalize(),Fs.crossVectors(i,ui),Fs.lengthSq()===0&&(Math.abs(i.z)===1?ui.x+=1e-4:ui.z+=1e-4,ui.normalize(),Fs.crossVectors(i,ui)),Fs.normalize(),ll.crossVectors(ui,Fs),s[0]=Fs.x,s[4]=ll.x,s[8]=ui.x,s[1]=Fs.y,s[5]=ll.y,s[9]=ui.y,s[2]=Fs.z,s[6]=ll.z,s[10]=ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],f=i[1],d=i[5],h=i[9],u=i[13],p=i[2],x=i[6],m=i[10],g=i[14],v=i[3],b=i[7],S=i[11],E=i[15],T=s[0],_=s[4],M=s[8],C=s[12],I=s[1],P=s[5],O=s[9],B=s[13],N=s[2],G=s[6],V=s[10],F=s[14],j=s[3],X=s[7],$=s[11],tt=s[15];return r[0]=o*T+a*I+l*N+c*j,r[4]=o*_+a*P+l*G+c*X,r[8]=o*M+a*O+l*V+c*$,r[12]=o*C+a*B+l*F+c*tt,r[1]=f*T+d*I+h*N+u*j,r[5]=f*_+d*P+h*G+u*X,r[9]=f*M+d*O+h*V+u*$,r[13]=f*C+d*B+h*F+u*tt,r[2]=p*T+x*I+m*N+g*j,r[6]=p*_+x*P+m*G+g*X,r[10]=p*M+x*O+m*V+g*$,r[14]=p*C+x*B+m*F+g*tt,r[3]=v*T+b*I+S*N+E*j,r[7]=v*_+b*P+S*G+E*X,r[11]=v*M+b*O+S*V+E*$,r[15]=v*C+b*B+S*F+E*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],f=t[2],d=t[6],h=t[10],u=t[14],p=t[3],x=t[7],m=t[11],g=t[15],v=l*u-c*h,b=a*u-c*d,S=a*h-l*d,E=o*u-c*f,T=o*h-l*f,_=o*d-a*f;return e*(x*v-m*b+g*S)-i*(p*v-m*E+g*T)+s*(p*b-x*E+g*_)-r*(p*S-x*T+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],f=t[10];return e*(o*f-a*c)-i*(r*f-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],f=t[8],d=t[9],h=t[10],u=t[11],p=t[12],x=t[13],m=t[14],g=t[15],v=e*a-i*o,b=e*l-s*o,S=e*c-r*o,E=i*l-s*a,T=i*c-r*a,_=s*c-r*l,M=f*x-d*p,C=f*m-h*p,I=f*g-u*p,P=d*m-h*x,O=d*g-u*x,B=h*g-u*m,N=v*B-b*O+S*P+E*I-T*C+_*M;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/N;return t[0]=(a*B-l*O+c*P)*G,t[1]=(s*O-i*B-r*P)*G,t[2]=(x*_-m*T+g*E)*G,t[3]=(h*T-d*_-u*E)*G,t[4]=(l*I-o*B-c*C)*G,t[5]=(e*B-s*I+r*C)*G,t[6]=(m*S-p*_-g*b)*G,t[7]=(f*_-h*S+u*b)*G,t[8]=(o*O-a*I+c*M)*G,t[9]=(i*I-e*O-r*M)*G,t[10]=(p*T-x*S+g*v)*G,t[11]=(d*S-f*T-u*v)*G,t[12]=(a*C-o*P-l*M)*G,t[13]=(e*P-i*C+s*M)*G,t[14]=(x*b-p*E-m*v)*G,t[15]=(f*E-d*b+h*v)*G,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,f=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,f*a+i,f*l-s*o,0,c*l-s*a,f*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,f=o+o,d=a+a,h=r*c,u=r*f,p=r*d,x=o*f,m=o*d,g=a*d,v=l*c,b=l*f,S=l*d,E=i.x,T=i.y,_=i.z;return s[0]=(1-(x+g))*E,s[1]=(u+S)*E,s[2]=(p-b)*E,s[3]=0,s[4]=(u-S)*T,s[5]=(1-(h+g))*T,s[6]=(m+v)*T,s[7]=0,s[8]=(p+b)*_,s[9]=(m-v)*_,s[10]=(1-(h+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Gr.set(s[0],s[1],s[2]).length(),a=Gr.set(s[4],s[5],s[6]).length(),l=Gr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Li.copy(this);let c=1/o,f=1/a,d=1/l;return Li.elements[0]*=c,Li.elements[1]*=c,Li.elements[2]*=c,Li.elements[4]*=f,Li.elements[5]*=f,Li.elements[6]*=f,Li.elements[8]*=d,Li.elements[9]*=d,Li.elements[10]*=d,e.setFromRotationMatrix(Li),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Ti,l=!1){let c=this.elements,f=2*r/(e-t),d=2*r/(i-s),h=(e+t)/(e-t),u=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Ti)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===oo)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=u,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ti,l=!1){let c=this.elements,f=2/(e-t),d=2/(i-s),h=-(e+t)/(e-t),u=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Ti)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===oo)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=f,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=u,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Gr=new q,Li=new He,Y_=new q(0,0,0),$_=new q(1,1,1),Fs=new q,ll=new q,ui=new q,ep=new He,np=new mi,Ms=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],f=s[9],d=s[2],h=s[6],u=s[10];switch(e){case"XYZ":this._y=Math.asin(me(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-f,u),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-me(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(a,u),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(me(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,u),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-me(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,u),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(me(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-f,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,u));break;case"XZY":this._z=Math.asin(-me(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-f,u),this._y=0);break;default:Zt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return ep.makeRotationFromQuaternion(t),this.setFromRotationMatrix(ep,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return np.setFromEuler(this),this.setFromQuaternion(np,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ms.DEFAULT_ORDER="XYZ";var la=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Z_=0,ip=new q,Hr=new mi,ds=new He,cl=new q,Xo=new q,J_=new q,K_=new mi,sp=new q(1,0,0),rp=new q(0,1,0),op=new q(0,0,1),ap={type:"added"},j_={type:"removed"},Wr={type:"childadded",child:null},lu={type:"childremoved",child:null},Bn=class n extends Ui{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Z_++}),this.uuid=Zs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new q,e=new Ms,i=new mi,s=new q(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new He},normalMatrix:{value:new se}}),this.matrix=new He,this.matrixWorld=new He,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new la,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Hr.setFromAxisAngle(t,e),this.quaternion.multiply(Hr),this}rotateOnWorldAxis(t,e){return Hr.setFromAxisAngle(t,e),this.quaternion.premultiply(Hr),this}rotateX(t){return this.rotateOnAxis(sp,t)}rotateY(t){return this.rotateOnAxis(rp,t)}rotateZ(t){return this.rotateOnAxis(op,t)}translateOnAxis(t,e){return ip.copy(t).applyQuaternion(this.quaternion),this.position.add(ip.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(sp,t)}translateY(t){return this.translateOnAxis(rp,t)}translateZ(t){return this.translateOnAxis(op,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?cl.copy(t):cl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Xo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(Xo,cl,this.up):ds.lookAt(cl,Xo,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Hr.setFromRotationMatrix(ds),this.quaternion.premultiply(Hr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ne("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(ap),Wr.child=t,this.dispatchEvent(Wr),Wr.child=null):ne("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(j_),lu.child=t,this.dispatchEvent(lu),lu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(ap),Wr.child=t,this.dispatchEvent(Wr),Wr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,t,J_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,K_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,f=l.length;c<f;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),f=o(t.images),d=o(t.shapes),h=o(t.skeletons),u=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),f.length>0&&(i.images=f),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),u.length>0&&(i.animations=u),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let f=a[c];delete f.metadata,l.push(f)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Bn.DEFAULT_UP=new q(0,1,0);Bn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Bn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var fr=class extends Bn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Q_={type:"move"},ho=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new fr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new fr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new fr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let f=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=f.position.distanceTo(d.position),u=.02,p=.005;c.inputState.pinching&&h>u+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=u-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Q_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new fr;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},cm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Os={h:0,s:0,l:0},hl={h:0,s:0,l:0};function cu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ce=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=di){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=i,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ve.workingColorSpace){if(t=of(t,1),e=me(e,0,1),i=me(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=cu(o,r,t+1/3),this.g=cu(o,r,t),this.b=cu(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=di){function i(r){r!==void 0&&parseFloat(r)<1&&Zt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Zt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Zt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=di){let i=cm[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Zt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ys(t.r),this.g=ys(t.g),this.b=ys(t.b),this}copyLinearToSRGB(t){return this.r=so(t.r),this.g=so(t.g),this.b=so(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=di){return ve.workingToColorSpace(Gn.copy(this),t),Math.round(me(Gn.r*255,0,255))*65536+Math.round(me(Gn.g*255,0,255))*256+Math.round(me(Gn.b*255,0,255))}getHexString(t=di){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(Gn.copy(this),e);let i=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,f=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=f<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=f,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(Gn.copy(this),e),t.r=Gn.r,t.g=Gn.g,t.b=Gn.b,t}getStyle(t=di){ve.workingToColorSpace(Gn.copy(this),t);let e=Gn.r,i=Gn.g,s=Gn.b;return t!==di?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Os),this.setHSL(Os.h+t,Os.s+e,Os.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Os),t.getHSL(hl);let i=ea(Os.h,hl.h,e),s=ea(Os.s,hl.s,e),r=ea(Os.l,hl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new ce;ce.NAMES=cm;var ca=class extends Bn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ms,this.environmentIntensity=1,this.environmentRotation=new Ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Di=new q,ps=new q,hu=new q,ms=new q,Xr=new q,qr=new q,lp=new q,uu=new q,fu=new q,du=new q,pu=new je,mu=new je,gu=new je,xs=class n{constructor(t=new q,e=new q,i=new q){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Di.subVectors(t,e),s.cross(Di);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Di.subVectors(s,e),ps.subVectors(i,e),hu.subVectors(t,e);let o=Di.dot(Di),a=Di.dot(ps),l=Di.dot(hu),c=ps.dot(ps),f=ps.dot(hu),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,u=(c*l-a*f)*h,p=(o*f-a*l)*h;return r.set(1-u-p,p,u)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ms)===null?!1:ms.x>=0&&ms.y>=0&&ms.x+ms.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ms.x),l.addScaledVector(o,ms.y),l.addScaledVector(a,ms.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return pu.setScalar(0),mu.setScalar(0),gu.setScalar(0),pu.fromBufferAttribute(t,e),mu.fromBufferAttribute(t,i),gu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(pu,r.x),o.addScaledVector(mu,r.y),o.addScaledVector(gu,r.z),o}static isFrontFacing(t,e,i,s){return Di.subVectors(i,e),ps.subVectors(t,e),Di.cross(ps).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Di.subVectors(this.c,this.b),ps.subVectors(this.a,this.b),Di.cross(ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Xr.subVectors(s,i),qr.subVectors(r,i),uu.subVectors(t,i);let l=Xr.dot(uu),c=qr.dot(uu);if(l<=0&&c<=0)return e.copy(i);fu.subVectors(t,s);let f=Xr.dot(fu),d=qr.dot(fu);if(f>=0&&d<=f)return e.copy(s);let h=l*d-f*c;if(h<=0&&l>=0&&f<=0&&l-f>0)return o=l/(l-f),e.copy(i).addScaledVector(Xr,o);du.subVectors(t,r);let u=Xr.dot(du),p=qr.dot(du);if(p>=0&&u<=p)return e.copy(r);let x=u*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(qr,a);let m=f*p-u*d;if(m<=0&&d-f>=0&&u-p>=0)return lp.subVectors(r,s),a=(d-f)/(d-f+(u-p)),e.copy(s).addScaledVector(lp,a);let g=1/(m+x+h);return o=x*g,a=h*g,e.copy(i).addScaledVector(Xr,o).addScaledVector(qr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ji=class{constructor(t=new q(1/0,1/0,1/0),e=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ni.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ni.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ni.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(t.matrixWorld),this.expandByPoint(Ni);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ul.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ul.copy(i.boundingBox)),ul.applyMatrix4(t.matrixWorld),this.union(ul)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ni),Ni.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qo),fl.subVectors(this.max,qo),Yr.subVectors(t.a,qo),$r.subVectors(t.b,qo),Zr.subVectors(t.c,qo),Bs.subVectors($r,Yr),zs.subVectors(Zr,$r),lr.subVectors(Yr,Zr);let e=[0,-Bs.z,Bs.y,0,-zs.z,zs.y,0,-lr.z,lr.y,Bs.z,0,-Bs.x,zs.z,0,-zs.x,lr.z,0,-lr.x,-Bs.y,Bs.x,0,-zs.y,zs.x,0,-lr.y,lr.x,0];return!_u(e,Yr,$r,Zr,fl)||(e=[1,0,0,0,1,0,0,0,1],!_u(e,Yr,$r,Zr,fl))?!1:(dl.crossVectors(Bs,zs),e=[dl.x,dl.y,dl.z],_u(e,Yr,$r,Zr,fl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ni).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ni).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(gs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),gs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),gs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),gs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),gs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),gs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),gs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),gs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(gs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},gs=[new q,new q,new q,new q,new q,new q,new q,new q],Ni=new q,ul=new ji,Yr=new q,$r=new q,Zr=new q,Bs=new q,zs=new q,lr=new q,qo=new q,fl=new q,dl=new q,cr=new q;function _u(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){cr.fromArray(n,r);let a=s.x*Math.abs(cr.x)+s.y*Math.abs(cr.y)+s.z*Math.abs(cr.z),l=t.dot(cr),c=e.dot(cr),f=i.dot(cr);if(Math.max(-Math.max(l,c,f),Math.min(l,c,f))>a)return!1}return!0}var _n=new q,pl=new Yt,tx=0,Qn=class extends Ui{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tx++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=sf,this.updateRanges=[],this.gpuType=Oi,this.version=0,this._normalizationScale=t!==void 0?ih(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)pl.fromBufferAttribute(this,e),pl.applyMatrix3(t),this.setXY(e,pl.x,pl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix3(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyMatrix4(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.applyNormalMatrix(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)_n.fromBufferAttribute(this,e),_n.transformDirection(t),this.setXYZ(e,_n.x,_n.y,_n.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):lf(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):cf(t,this.array)}};var ha=class extends Qn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ua=class extends Qn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var un=class extends Qn{constructor(t,e,i){super(new Float32Array(t),e,i)}},ex=new ji,Yo=new q,xu=new q,dr=class{constructor(t=new q,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):ex.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Yo.subVectors(t,this.center);let e=Yo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Yo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(xu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Yo.copy(t.center).add(xu)),this.expandByPoint(Yo.copy(t.center).sub(xu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},nx=0,wi=new He,yu=new Bn,Jr=new q,fi=new ji,$o=new ji,Ln=new q,Nn=class n extends Ui{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:nx++}),this.uuid=Zs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(A_(t)?ua:ha)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new se().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return wi.makeRotationFromQuaternion(t),this.applyMatrix4(wi),this}rotateX(t){return wi.makeRotationX(t),this.applyMatrix4(wi),this}rotateY(t){return wi.makeRotationY(t),this.applyMatrix4(wi),this}rotateZ(t){return wi.makeRotationZ(t),this.applyMatrix4(wi),this}translate(t,e,i){return wi.makeTranslation(t,e,i),this.applyMatrix4(wi),this}scale(t,e,i){return wi.makeScale(t,e,i),this.applyMatrix4(wi),this}lookAt(t){return yu.lookAt(t),yu.updateMatrix(),this.applyMatrix4(yu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jr).negate(),this.translate(Jr.x,Jr.y,Jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new un(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Zt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ji);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ne('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new dr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(t){let i=this.boundingSphere.center;if(fi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];$o.setFromBufferAttribute(a),this.morphTargetsRelative?(Ln.addVectors(fi.min,$o.min),fi.expandByPoint(Ln),Ln.addVectors(fi.max,$o.max),fi.expandByPoint(Ln)):(fi.expandByPoint($o.min),fi.expandByPoint($o.max))}fi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ln.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ln));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,f=a.count;c<f;c++)Ln.fromBufferAttribute(a,c),l&&(Jr.fromBufferAttribute(t,c),Ln.add(Jr)),s=Math.max(s,i.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ne('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ne("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Qn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let C=0;C<i.count;C++)a[C]=new q,l[C]=new q;let f=new q,d=new q,h=new q,u=new Yt,p=new Yt,x=new Yt,m=new q,g=new q;function v(C,I,P){c[C]=c[I]=c[P]=1,f.fromBufferAttribute(i,C),d.fromBufferAttribute(i,I),h.fromBufferAttribute(i,P),u.fromBufferAttribute(r,C),p.fromBufferAttribute(r,I),x.fromBufferAttribute(r,P),d.sub(f),h.sub(f),p.sub(u),x.sub(u);let O=1/(p.x*x.y-x.x*p.y);isFinite(O)&&(m.copy(d).multiplyScalar(x.y).addScaledVector(h,-p.y).multiplyScalar(O),g.copy(h).multiplyScalar(p.x).addScaledVector(d,-x.x).multiplyScalar(O),a[C].add(m),a[I].add(m),a[P].add(m),l[C].add(g),l[I].add(g),l[P].add(g))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let C=0,I=b.length;C<I;++C){let P=b[C],O=P.start,B=P.count;for(let N=O,G=O+B;N<G;N+=3)v(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let S=new q,E=new q,T=new q,_=new q;function M(C){T.fromBufferAttribute(s,C),_.copy(T);let I=a[C];S.copy(I),S.sub(T.multiplyScalar(T.dot(I))).normalize(),E.crossVectors(_,I);let O=E.dot(l[C])<0?-1:1;o.setXYZW(C,S.x,S.y,S.z,O)}for(let C=0,I=i.count;C<I;++C)c[C]&&M(C);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Qn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,u=i.count;h<u;h++)i.setXYZ(h,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,f=new q,d=new q;if(t)for(let h=0,u=t.count;h<u;h+=3){let p=t.getX(h+0),x=t.getX(h+1),m=t.getX(h+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),f.subVectors(o,r),d.subVectors(s,r),f.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(f),l.add(f),c.add(f),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,u=e.count;h<u;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),f.subVectors(o,r),d.subVectors(s,r),f.cross(d),i.setXYZ(h+0,f.x,f.y,f.z),i.setXYZ(h+1,f.x,f.y,f.z),i.setXYZ(h+2,f.x,f.y,f.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ln.fromBufferAttribute(t,e),Ln.normalize(),t.setXYZ(e,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function t(a,l){let c=a.array,f=a.itemSize,d=a.normalized,h=new c.constructor(l.length*f),u=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?u=l[x]*a.data.stride+a.offset:u=l[x]*f;for(let g=0;g<f;g++)h[p++]=c[u++]}return new Qn(h,f,d)}if(this.index===null)return Zt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let f=0,d=c.length;f<d;f++){let h=c[f],u=t(h,i);l.push(u)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],f=[];for(let d=0,h=c.length;d<h;d++){let u=c[d];f.push(u.toJSON(t.data))}f.length>0&&(s[l]=f,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let f=s[c];this.setAttribute(c,f.clone(e))}let r=t.morphAttributes;for(let c in r){let f=[],d=r[c];for(let h=0,u=d.length;h<u;h++)f.push(d[h].clone(e));this.morphAttributes[c]=f}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,f=o.length;c<f;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},$l=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=sf,this.updateRanges=[],this.version=0,this.uuid=Zs()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=cp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=cp(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function cp(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Zs()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var Kn=new q,fa=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?ih(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Kn.fromBufferAttribute(this,e),Kn.applyMatrix4(t),this.setXYZ(e,Kn.x,Kn.y,Kn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Kn.fromBufferAttribute(this,e),Kn.applyNormalMatrix(t),this.setXYZ(e,Kn.x,Kn.y,Kn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Kn.fromBufferAttribute(this,e),Kn.transformDirection(t),this.setXYZ(e,Kn.x,Kn.y,Kn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){oa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Qn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){oa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):lf(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):cf(t,this.data.array)}},vu=new q,ix=new q,sx=new se,pi=class{constructor(t=new q(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=vu.subVectors(i,e).cross(ix.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(vu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||sx.getNormalMatrix(t),s=this.coplanarPoint(vu).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},rx=0,Qi=class extends Ui{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:rx++}),this.uuid=Zs(),this.name="",this.type="Material",this.blending=_o,this.side=es,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ou,this.blendDst=Bu,this.blendEquation=_r,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ce(0,0,0),this.blendAlpha=0,this.depthFunc=ro,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Qp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Nl,this.stencilZFail=Nl,this.stencilZPass=Nl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Zt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Zt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ce().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new pi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},uo=class extends Qi{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ce(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Kr,Zo=new q,jr=new q,Qr=new q,to=new Yt,Jo=new Yt,hm=new He,ml=new q,Ko=new q,gl=new q,hp=new Yt,Mu=new Yt,up=new Yt,da=class extends Bn{constructor(t=new uo){if(super(),this.isSprite=!0,this.type="Sprite",Kr===void 0){Kr=new Nn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new $l(e,5);Kr.setIndex([0,1,2,0,2,3]),Kr.setAttribute("position",new fa(i,3,0,!1)),Kr.setAttribute("uv",new fa(i,2,3,!1))}this.geometry=Kr,this.material=t,this.center=new Yt(.5,.5),this.count=1}intersectsFrustum(t){return t.intersectsSprite(this)}raycast(t,e){t.camera===null&&ne('Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),jr.setFromMatrixScale(this.matrixWorld),hm.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Qr.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&jr.multiplyScalar(-Qr.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;_l(ml.set(-.5,-.5,0),Qr,o,jr,s,r),_l(Ko.set(.5,-.5,0),Qr,o,jr,s,r),_l(gl.set(.5,.5,0),Qr,o,jr,s,r),hp.set(0,0),Mu.set(1,0),up.set(1,1);let a=t.ray.intersectTriangle(ml,Ko,gl,!1,Zo);if(a===null&&(_l(Ko.set(-.5,.5,0),Qr,o,jr,s,r),Mu.set(0,1),a=t.ray.intersectTriangle(ml,gl,Ko,!1,Zo),a===null))return;let l=t.ray.origin.distanceTo(Zo);l<t.near||l>t.far||e.push({distance:l,point:Zo.clone(),uv:xs.getInterpolation(Zo,ml,Ko,gl,hp,Mu,up,new Yt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}toJSON(t){let e=super.toJSON(t);return e.object.center=this.center.toArray(),e}};function _l(n,t,e,i,s,r){to.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(Jo.x=r*to.x-s*to.y,Jo.y=s*to.x+r*to.y):Jo.copy(to),n.copy(t),n.x+=Jo.x,n.y+=Jo.y,n.applyMatrix4(hm)}var _s=new q,Su=new q,xl=new q,yl=new q,pr=class{constructor(t=new q,e=new q(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,_s)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=_s.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(_s.copy(this.origin).addScaledVector(this.direction,e),_s.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Su.copy(t).add(e).multiplyScalar(.5),xl.copy(e).sub(t).normalize(),yl.copy(this.origin).sub(Su);let r=t.distanceTo(e)*.5,o=-this.direction.dot(xl),a=yl.dot(this.direction),l=-yl.dot(xl),c=yl.lengthSq(),f=Math.abs(1-o*o),d,h,u,p;if(f>0)if(d=o*l-a,h=o*a-l,p=r*f,d>=0)if(h>=-p)if(h<=p){let x=1/f;d*=x,h*=x,u=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),u=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),u=-d*d+h*(h+2*l)+c;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),u=-d*d+h*(h+2*l)+c):h<=p?(d=0,h=Math.min(Math.max(-r,-l),r),u=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),u=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),u=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Su).addScaledVector(xl,h),u}intersectSphere(t,e){if(t.radius<0)return null;_s.subVectors(t.center,this.origin);let i=_s.dot(this.direction),s=_s.dot(_s)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,f=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),f>=0?(r=(t.min.y-h.y)*f,o=(t.max.y-h.y)*f):(r=(t.max.y-h.y)*f,o=(t.min.y-h.y)*f),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-h.z)*d,l=(t.max.z-h.z)*d):(a=(t.max.z-h.z)*d,l=(t.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,_s)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,f=a.z,d=t.x-o.x,h=t.y-o.y,u=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=i.x-o.x,v=i.y-o.y,b=i.z-o.z,S=Math.abs(l),E=Math.abs(c),T=Math.abs(f),_,M,C,I,P,O,B,N,G,V,F,j;if(S>=E&&S>=T?(C=l,O=d,G=p,j=g,l>=0?(_=c,M=f,I=h,P=u,B=x,N=m,V=v,F=b):(_=f,M=c,I=u,P=h,B=m,N=x,V=b,F=v)):E>=T?(C=c,O=h,G=x,j=v,c>=0?(_=f,M=l,I=u,P=d,B=m,N=p,V=b,F=g):(_=l,M=f,I=d,P=u,B=p,N=m,V=g,F=b)):(C=f,O=u,G=m,j=b,f>=0?(_=l,M=c,I=d,P=h,B=p,N=x,V=g,F=v):(_=c,M=l,I=h,P=d,B=x,N=p,V=v,F=g)),C===0)return null;let X=_/C,$=M/C,tt=1/C,it=I-X*O,st=P-$*O,Q=B-X*G,dt=N-$*G,pt=V-X*j,_t=F-$*j,yt=pt*dt-_t*Q,Ft=it*_t-st*pt,Kt=Q*st-dt*it;if(s){if(yt<0||Ft<0||Kt<0)return null}else if((yt<0||Ft<0||Kt<0)&&(yt>0||Ft>0||Kt>0))return null;let Vt=yt+Ft+Kt;if(Vt===0)return null;let he=tt*(yt*O+Ft*G+Kt*j);return(Vt>0?he<0:he>0)?null:this.at(he/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Zl=class extends Qi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=gc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},fp=new He,hr=new pr,vl=new dr,dp=new q,Ml=new q,Sl=new q,bl=new q,bu=new q,wl=new q,pp=new q,Tl=new q,Hn=class extends Bn{constructor(t=new Nn,e=new Zl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){wl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let f=a[l],d=r[l];f!==0&&(bu.fromBufferAttribute(d,t),o?wl.addScaledVector(bu,f):wl.addScaledVector(bu.sub(e),f))}e.add(wl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),vl.copy(i.boundingSphere),vl.applyMatrix4(r),hr.copy(t.ray).recast(t.near),!(vl.containsPoint(hr.origin)===!1&&(hr.intersectSphere(vl,dp)===null||hr.origin.distanceToSquared(dp)>(t.far-t.near)**2))&&(fp.copy(r).invert(),hr.copy(t.ray).applyMatrix4(fp),!(i.boundingBox!==null&&hr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,hr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,f=r.attributes.uv1,d=r.attributes.normal,h=r.groups,u=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=h.length;p<x;p++){let m=h[p],g=o[m.materialIndex],v=Math.max(m.start,u.start),b=Math.min(a.count,Math.min(m.start+m.count,u.start+u.count));for(let S=v,E=b;S<E;S+=3){let T=a.getX(S),_=a.getX(S+1),M=a.getX(S+2);s=El(this,g,t,i,c,f,d,T,_,M),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,u.start),x=Math.min(a.count,u.start+u.count);for(let m=p,g=x;m<g;m+=3){let v=a.getX(m),b=a.getX(m+1),S=a.getX(m+2);s=El(this,o,t,i,c,f,d,v,b,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=h.length;p<x;p++){let m=h[p],g=o[m.materialIndex],v=Math.max(m.start,u.start),b=Math.min(l.count,Math.min(m.start+m.count,u.start+u.count));for(let S=v,E=b;S<E;S+=3){let T=S,_=S+1,M=S+2;s=El(this,g,t,i,c,f,d,T,_,M),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,u.start),x=Math.min(l.count,u.start+u.count);for(let m=p,g=x;m<g;m+=3){let v=m,b=m+1,S=m+2;s=El(this,o,t,i,c,f,d,v,b,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function ox(n,t,e,i,s,r,o,a){let l;if(t.side===ni?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===es,a),l===null)return null;Tl.copy(a),Tl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Tl);return c<e.near||c>e.far?null:{distance:c,point:Tl.clone(),object:n}}function El(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Ml),n.getVertexPosition(l,Sl),n.getVertexPosition(c,bl);let f=ox(n,t,e,i,Ml,Sl,bl,pp);if(f){let d=new q;xs.getBarycoord(pp,Ml,Sl,bl,d),s&&(f.uv=xs.getInterpolatedAttribute(s,a,l,c,d,new Yt)),r&&(f.uv1=xs.getInterpolatedAttribute(r,a,l,c,d,new Yt)),o&&(f.normal=xs.getInterpolatedAttribute(o,a,l,c,d,new q),f.normal.dot(i.direction)>0&&f.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new q,materialIndex:0};xs.getNormal(Ml,Sl,bl,h.normal),f.face=h,f.barycoord=d}return f}var Jl=class extends ei{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Dn,f=Dn,d,h){super(null,o,a,l,c,f,s,r,d,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ur=new dr,ax=new Yt(.5,.5),Al=new q,Vs=class{constructor(t=new pi,e=new pi,i=new pi,s=new pi,r=new pi,o=new pi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ti,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],f=r[4],d=r[5],h=r[6],u=r[7],p=r[8],x=r[9],m=r[10],g=r[11],v=r[12],b=r[13],S=r[14],E=r[15];if(s[0].setComponents(c-o,u-f,g-p,E-v).normalize(),s[1].setComponents(c+o,u+f,g+p,E+v).normalize(),s[2].setComponents(c+a,u+d,g+x,E+b).normalize(),s[3].setComponents(c-a,u-d,g-x,E-b).normalize(),i)s[4].setComponents(l,h,m,S).normalize(),s[5].setComponents(c-l,u-h,g-m,E-S).normalize();else if(s[4].setComponents(c-l,u-h,g-m,E-S).normalize(),e===Ti)s[5].setComponents(c+l,u+h,g+m,E+S).normalize();else if(e===oo)s[5].setComponents(l,h,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ur.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ur.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ur)}intersectsSprite(t){ur.center.set(0,0,0);let e=ax.distanceTo(t.center);return ur.radius=.7071067811865476+e,ur.applyMatrix4(t.matrixWorld),this.intersectsSphere(ur)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Al.x=s.normal.x>0?t.max.x:t.min.x,Al.y=s.normal.y>0?t.max.y:t.min.y,Al.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Al)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},mp=new He,Kl=class n{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];mp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Vs),i[s].setFromProjectionMatrix(mp,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Vs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Gs=class extends Qi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ce(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},jl=new q,Ql=new q,gp=new He,jo=new pr,Rl=new dr,wu=new q,_p=new q,tc=class extends Bn{constructor(t=new Nn,e=new Gs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)jl.fromBufferAttribute(e,s-1),Ql.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=jl.distanceTo(Ql);t.setAttribute("lineDistance",new un(i,1))}else Zt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Rl.copy(i.boundingSphere),Rl.applyMatrix4(s),Rl.radius+=r,t.ray.intersectsSphere(Rl)===!1)return;gp.copy(s).invert(),jo.copy(t.ray).applyMatrix4(gp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,f=i.index,h=i.attributes.position;if(f!==null){let u=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let x=u,m=p-1;x<m;x+=c){let g=f.getX(x),v=f.getX(x+1),b=Cl(this,t,jo,l,g,v,x);b&&e.push(b)}if(this.isLineLoop){let x=f.getX(p-1),m=f.getX(u),g=Cl(this,t,jo,l,x,m,p-1);g&&e.push(g)}}else{let u=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=u,m=p-1;x<m;x+=c){let g=Cl(this,t,jo,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=Cl(this,t,jo,l,p-1,u,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Cl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(jl.fromBufferAttribute(a,s),Ql.fromBufferAttribute(a,r),e.distanceSqToSegment(jl,Ql,wu,_p)>i)return;wu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(wu);if(!(c<t.near||c>t.far))return{distance:c,point:_p.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var xp=new q,yp=new q,mr=class extends tc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)xp.fromBufferAttribute(e,s),yp.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+xp.distanceTo(yp);t.setAttribute("lineDistance",new un(i,1))}else Zt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var pa=class extends ei{constructor(t=[],e=xr,i,s,r,o,a,l,c,f){super(t,e,i,s,r,o,a,l,c,f),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ma=class extends ei{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ss=class extends ei{constructor(t,e,i=Fi,s,r,o,a=Dn,l=Dn,c,f=vs,d=1){if(f!==vs&&f!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:d};super(h,s,r,o,a,l,f,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new co(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ga=class extends Ss{constructor(t,e=Fi,i=xr,s,r,o=Dn,a=Dn,l,c=vs){let f={width:t,height:t,depth:1},d=[f,f,f,f,f,f];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},_a=class extends ei{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},fo=class n extends Nn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],f=[],d=[],h=0,u=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new un(c,3)),this.setAttribute("normal",new un(f,3)),this.setAttribute("uv",new un(d,2));function p(x,m,g,v,b,S,E,T,_,M,C){let I=S/_,P=E/M,O=S/2,B=E/2,N=T/2,G=_+1,V=M+1,F=0,j=0,X=new q;for(let $=0;$<V;$++){let tt=$*P-B;for(let it=0;it<G;it++){let st=it*I-O;X[x]=st*v,X[m]=tt*b,X[g]=N,c.push(X.x,X.y,X.z),X[x]=0,X[m]=0,X[g]=T>0?1:-1,f.push(X.x,X.y,X.z),d.push(it/_),d.push(1-$/M),F+=1}}for(let $=0;$<M;$++)for(let tt=0;tt<_;tt++){let it=h+tt+G*$,st=h+tt+G*($+1),Q=h+(tt+1)+G*($+1),dt=h+(tt+1)+G*$;l.push(it,st,dt),l.push(st,Q,dt),j+=6}a.addGroup(u,j,C),u+=j,h+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var xa=class n extends Nn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,f=l+1,d=t/a,h=e/l,u=[],p=[],x=[],m=[];for(let g=0;g<f;g++){let v=g*h-o;for(let b=0;b<c;b++){let S=b*d-r;p.push(S,-v,0),x.push(0,0,1),m.push(b/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let b=v+c*g,S=v+c*(g+1),E=v+1+c*(g+1),T=v+1+c*g;u.push(b,S,T),u.push(S,E,T)}this.setIndex(u),this.setAttribute("position",new un(p,3)),this.setAttribute("normal",new un(x,3)),this.setAttribute("uv",new un(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function vr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(vp(s))s.isRenderTargetTexture?(Zt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(vp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Wn(n){let t={};for(let e=0;e<n.length;e++){let i=vr(n[e]);for(let s in i)t[s]=i[s]}return t}function vp(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function lx(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function uf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var um={clone:vr,merge:Wn},cx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ts=class extends Qi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=cx,this.fragmentShader=hx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=vr(t.uniforms),this.uniformsGroups=lx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ce().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new q().fromArray(s.value);break;case"v4":this.uniforms[i].value=new je().fromArray(s.value);break;case"m3":this.uniforms[i].value=new se().fromArray(s.value);break;case"m4":this.uniforms[i].value=new He().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ec=class extends ts{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var bs=class extends Qi{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ce(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ce(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=nh,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=gc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},nc=class extends Qi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Kp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ic=class extends Qi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function eo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Pl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Hs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},sc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Au,endingEnd:Au}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ru:r=t,a=2*e-i;break;case Cu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Ru:o=t,l=2*i-e;break;case Cu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,f=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*f,this._offsetNext=o*f}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,u=this._weightNext,p=(i-e)/(s-e),x=p*p,m=x*p,g=-h*m+2*h*x-h*p,v=(1+h)*m+(-1.5-2*h)*x+(-.5+h)*p+1,b=(-1-u)*m+(1.5+u)*x+.5*p,S=u*m-u*x;for(let E=0;E!==a;++E)r[E]=g*o[f+E]+v*o[c+E]+b*o[l+E]+S*o[d+E];return r}},rc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=(i-e)/(s-e),d=1-f;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*f;return r}},oc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ac=class extends Hs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,f=this.inTangents,d=this.outTangents;if(!f||!d){let p=(i-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let h=a*2,u=t-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=u*h+p*2,v=d[g],b=d[g+1],S=t*h+p*2,E=f[S],T=f[S+1],_=fx(i,e,v,E,s);r[p]=fm(_,x,b,T,m)}return r}};function fm(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function ux(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function fx(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=fm(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=ux(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var _i=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=eo(e,this.TimeBufferType),this.values=eo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:eo(t.times,Array),values:eo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Pl(t.settings)&&(i.settings={inTangents:eo(t.settings.inTangents,Array),outTangents:eo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new oc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new rc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new sc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new ac(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case na:e=this.InterpolantFactoryMethodDiscrete;break;case Wl:e=this.InterpolantFactoryMethodLinear;break;case Dl:e=this.InterpolantFactoryMethodSmooth;break;case Eu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Zt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return na;case this.InterpolantFactoryMethodLinear:return Wl;case this.InterpolantFactoryMethodSmooth:return Dl;case this.InterpolantFactoryMethodBezier:return Eu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Pl(this.settings)&&(Mp(this.settings.inTangents,t),Mp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Pl(this.settings)&&(Sp(this.settings.inTangents,t),Sp(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ne("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ne("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ne("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ne("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&R_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ne("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Dl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],f=t[a+1];if(c!==f&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,h=d-i,u=d+i;for(let p=0;p!==i;++p){let x=e[d+p];if(x!==e[h+p]||x!==e[u+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,h=o*i;for(let u=0;u!==i;++u)e[h+u]=e[d+u]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Pl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Mp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Sp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}_i.prototype.ValueTypeName="";_i.prototype.TimeBufferType=Float32Array;_i.prototype.ValueBufferType=Float32Array;_i.prototype.DefaultInterpolation=Wl;var Ws=class extends _i{constructor(t,e,i){super(t,e,i)}};Ws.prototype.ValueTypeName="bool";Ws.prototype.ValueBufferType=Array;Ws.prototype.DefaultInterpolation=na;Ws.prototype.InterpolantFactoryMethodLinear=void 0;Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var lc=class extends _i{constructor(t,e,i,s){super(t,e,i,s)}};lc.prototype.ValueTypeName="color";var cc=class extends _i{constructor(t,e,i,s){super(t,e,i,s)}};cc.prototype.ValueTypeName="number";var hc=class extends Hs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let f=c+a;c!==f;c+=4)mi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ya=class extends _i{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new hc(this.times,this.values,this.getValueSize(),t)}};ya.prototype.ValueTypeName="quaternion";ya.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends _i{constructor(t,e,i){super(t,e,i)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=na;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var uc=class extends _i{constructor(t,e,i,s){super(t,e,i,s)}};uc.prototype.ValueTypeName="vector";var fc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(f){a++,r===!1&&s.onStart!==void 0&&s.onStart(f,o,a),r=!0},this.itemEnd=function(f){o++,s.onProgress!==void 0&&s.onProgress(f,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(f){s.onError!==void 0&&s.onError(f)},this.resolveURL=function(f){return f=f.normalize("NFC"),l?l(f):f},this.setURLModifier=function(f){return l=f,this},this.addHandler=function(f,d){return c.push(f,d),this},this.removeHandler=function(f){let d=c.indexOf(f);return d!==-1&&c.splice(d,2),this},this.getHandler=function(f){for(let d=0,h=c.length;d<h;d+=2){let u=c[d],p=c[d+1];if(u.global&&(u.lastIndex=0),u.test(f))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},dm=new fc,dc=class{constructor(t){this.manager=t!==void 0?t:dm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};dc.DEFAULT_MATERIAL_NAME="__DEFAULT";var va=class extends Bn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ce(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Tu=new He,bp=new q,wp=new q,pc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=ri,this.map=null,this.mapPass=null,this.matrix=new He,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Vs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new je(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;bp.setFromMatrixPosition(t.matrixWorld),e.position.copy(bp),wp.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(wp),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Tu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Tu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===oo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Tu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Il=new q,Ll=new mi,Ji=new q,Ma=class extends Bn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new He,this.projectionMatrix=new He,this.projectionMatrixInverse=new He,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Il,Ll,Ji),Ji.x===1&&Ji.y===1&&Ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Il,Ll,Ji.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Il,Ll,Ji),Ji.x===1&&Ji.y===1&&Ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Il,Ll,Ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ks=new q,Tp=new Yt,Ep=new Yt,jn=class extends Ma{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=lo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ta*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return lo*2*Math.atan(Math.tan(ta*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ks.x,ks.y).multiplyScalar(-t/ks.z),ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ks.x,ks.y).multiplyScalar(-t/ks.z)}getViewSize(t,e){return this.getViewBounds(t,Tp,Ep),e.subVectors(Ep,Tp)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ta*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Sa=class extends Ma{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,f=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=f*this.view.offsetY,l=a-f*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Pu=class extends pc{constructor(){super(new Sa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ba=class extends va{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Bn.DEFAULT_UP),this.updateMatrix(),this.target=new Bn,this.shadow=new Pu}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},wa=class extends va{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var no=-90,io=1,po=class extends Bn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(no,io,t,e);s.layers=this.layers,this.add(s);let r=new jn(no,io,t,e);r.layers=this.layers,this.add(r);let o=new jn(no,io,t,e);o.layers=this.layers,this.add(o);let a=new jn(no,io,t,e);a.layers=this.layers,this.add(a);let l=new jn(no,io,t,e);l.layers=this.layers,this.add(l);let c=new jn(no,io,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ti)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===oo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,f]=this.children,d=t.getRenderTarget(),h=t.getActiveCubeFace(),u=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,f),t.setRenderTarget(d,h,u),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},mc=class extends jn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var ff="\\[\\]\\.:\\/",dx=new RegExp("["+ff+"]","g"),df="[^"+ff+"]",px="[^"+ff.replace("\\.","")+"]",mx=/((?:WC+[\/:])*)/.source.replace("WC",df),gx=/(WCOD+)?/.source.replace("WCOD",px),_x=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",df),xx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",df),yx=new RegExp("^"+mx+gx+_x+xx+"$"),vx=["material","materials","bones","map"],Iu=class{constructor(t,e,i){let s=i||$e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},$e=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(dx,"")}static parseTrackName(t){let e=yx.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);vx.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Zt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ne("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ne("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let f=0;f<t.length;f++)if(t[f].name===c){c=f;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ne("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ne("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ne("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ne("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$e.Composite=Iu;$e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$e.prototype.GetterByBindingType=[$e.prototype._getValue_direct,$e.prototype._getValue_array,$e.prototype._getValue_arrayElement,$e.prototype._getValue_toArray];$e.prototype.SetterByBindingTypeAndVersioning=[[$e.prototype._setValue_direct,$e.prototype._setValue_direct_setNeedsUpdate,$e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_array,$e.prototype._setValue_array_setNeedsUpdate,$e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_arrayElement,$e.prototype._setValue_arrayElement_setNeedsUpdate,$e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_fromArray,$e.prototype._setValue_fromArray_setNeedsUpdate,$e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var pT=new Float32Array(1);var mo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=me(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(me(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Lu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Ta=class extends Ui{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function pf(n,t,e,i){let s=Mx(i);switch(e){case Ku:return n*t;case Qu:return n*t/s.components*s.byteLength;case bc:return n*t/s.components*s.byteLength;case $s:return n*t*2/s.components*s.byteLength;case wc:return n*t*2/s.components*s.byteLength;case ju:return n*t*3/s.components*s.byteLength;case zi:return n*t*4/s.components*s.byteLength;case Tc:return n*t*4/s.components*s.byteLength;case Ra:case Ca:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Pa:case Ia:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ac:case Cc:return Math.max(n,16)*Math.max(t,8)/4;case Ec:case Rc:return Math.max(n,8)*Math.max(t,8)/2;case Pc:case Ic:case Dc:case Nc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Lc:case La:case Uc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Fc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Oc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Bc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case zc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case kc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Vc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Gc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Hc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Wc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Xc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case qc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Yc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case $c:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Zc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Jc:case Kc:case jc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Qc:case th:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Da:case eh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Mx(n){switch(n){case ri:case Yu:return{byteLength:1,components:1};case yo:case $u:case Bi:return{byteLength:2,components:1};case Mc:case Sc:return{byteLength:2,components:4};case Fi:case vc:case Oi:return{byteLength:4,components:1};case Zu:case Ju:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Zt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Um(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function bx(n){let t=new WeakMap;function e(a,l){let c=a.array,f=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,f),a.onUploadCallback();let u;if(c instanceof Float32Array)u=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)u=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?u=n.HALF_FLOAT:u=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)u=n.SHORT;else if(c instanceof Uint32Array)u=n.UNSIGNED_INT;else if(c instanceof Int32Array)u=n.INT;else if(c instanceof Int8Array)u=n.BYTE;else if(c instanceof Uint8Array)u=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)u=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:u,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let f=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,f);else{d.sort((u,p)=>u.start-p.start);let h=0;for(let u=1;u<d.length;u++){let p=d[h],x=d[u];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++h,d[h]=x)}d.length=h+1;for(let u=0,p=d.length;u<p;u++){let x=d[u];n.bufferSubData(c,x.start*f.BYTES_PER_ELEMENT,f,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let f=t.get(a);(!f||f.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var wx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Tx=`#ifdef USE_ALPHAHASH
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
#endif`,Ex=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ax=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Rx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Cx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Px=`#ifdef USE_AOMAP
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
#endif`,Ix=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Lx=`#ifdef USE_BATCHING
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
#endif`,Dx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Nx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ux=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Fx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ox=`#ifdef USE_IRIDESCENCE
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
#endif`,Bx=`#ifdef USE_BUMPMAP
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
#endif`,zx=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,kx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Vx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Gx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Hx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Wx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Xx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,qx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Yx=`#define PI 3.141592653589793
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
} // validated`,$x=`vec3 transformedNormal = objectNormal;
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
#endif`,Zx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Jx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Kx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,jx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Qx="gl_FragColor = linearToOutputTexel( gl_FragColor );",ty=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ey=`#ifdef USE_ENVMAP
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
#endif`,ny=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,iy=`#ifdef USE_ENVMAP
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
#endif`,sy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ry=`#ifdef USE_ENVMAP
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
#endif`,oy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ay=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ly=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,cy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,hy=`#ifdef USE_GRADIENTMAP
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
}`,uy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,fy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,dy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,py=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,my=`#ifdef USE_ENVMAP
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
#endif`,gy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,_y=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,xy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,yy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,vy=`PhysicalMaterial material;
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
#endif`,My=`uniform sampler2D dfgLUT;
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
}`,Sy=`
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
#endif`,by=`#if defined( RE_IndirectDiffuse )
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
#endif`,wy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ty=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Ey=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ay=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ry=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Cy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Py=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Iy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Ly=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Dy=`#if defined( USE_POINTS_UV )
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
#endif`,Ny=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Uy=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Fy=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Oy=`#if defined( USE_MORPHCOLORS )
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
#endif`,By=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,zy=`#ifdef USE_MORPHTARGETS
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
#endif`,ky=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Vy=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Gy=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Hy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Wy=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Xy=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,qy=`#ifdef USE_NORMALMAP
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
#endif`,Yy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,$y=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Zy=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Jy=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Ky=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,jy=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Qy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,tv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ev=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,nv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,iv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,sv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,rv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ov=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,av=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,lv=`float getShadowMask() {
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
}`,cv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,hv=`#ifdef USE_SKINNING
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
#endif`,uv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,fv=`#ifdef USE_SKINNING
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
#endif`,dv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,pv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,mv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,gv=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,_v=`#ifdef USE_TRANSMISSION
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
#endif`,xv=`#ifdef USE_TRANSMISSION
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
#endif`,yv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Mv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Sv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,wv=`uniform sampler2D t2D;
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
}`,Tv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ev=`uniform float backgroundBlurriness;
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
}`,Av=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Rv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Cv=`#include <common>
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
}`,Pv=`#if DEPTH_PACKING == 3200
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
}`,Iv=`#define DISTANCE
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
}`,Lv=`#define DISTANCE
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
}`,Dv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Nv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Uv=`uniform float scale;
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
}`,Fv=`uniform vec3 diffuse;
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
}`,Ov=`#include <common>
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
}`,Bv=`uniform vec3 diffuse;
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
}`,zv=`#define LAMBERT
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
}`,kv=`#define LAMBERT
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
}`,Vv=`#define MATCAP
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
}`,Gv=`#define MATCAP
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
}`,Hv=`#define NORMAL
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
}`,Wv=`#define NORMAL
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
}`,Xv=`#define PHONG
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
}`,qv=`#define PHONG
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
}`,Yv=`#define STANDARD
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
}`,$v=`#define STANDARD
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
}`,Zv=`#define TOON
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
}`,Jv=`#define TOON
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
}`,Kv=`uniform float size;
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
}`,jv=`uniform vec3 diffuse;
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
}`,Qv=`#include <common>
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
}`,tM=`uniform vec3 color;
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
}`,eM=`uniform float rotation;
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
}`,nM=`uniform vec3 diffuse;
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
}`,fe={alphahash_fragment:wx,alphahash_pars_fragment:Tx,alphamap_fragment:Ex,alphamap_pars_fragment:Ax,alphatest_fragment:Rx,alphatest_pars_fragment:Cx,aomap_fragment:Px,aomap_pars_fragment:Ix,batching_pars_vertex:Lx,batching_vertex:Dx,begin_vertex:Nx,beginnormal_vertex:Ux,bsdfs:Fx,iridescence_fragment:Ox,bumpmap_pars_fragment:Bx,clipping_planes_fragment:zx,clipping_planes_pars_fragment:kx,clipping_planes_pars_vertex:Vx,clipping_planes_vertex:Gx,color_fragment:Hx,color_pars_fragment:Wx,color_pars_vertex:Xx,color_vertex:qx,common:Yx,defaultnormal_vertex:$x,displacementmap_pars_vertex:Zx,displacementmap_vertex:Jx,emissivemap_fragment:Kx,emissivemap_pars_fragment:jx,colorspace_fragment:Qx,colorspace_pars_fragment:ty,envmap_fragment:ey,envmap_common_pars_fragment:ny,envmap_pars_fragment:iy,envmap_pars_vertex:sy,envmap_physical_pars_fragment:my,envmap_vertex:ry,fog_vertex:oy,fog_pars_vertex:ay,fog_fragment:ly,fog_pars_fragment:cy,gradientmap_pars_fragment:hy,lightmap_pars_fragment:uy,lights_lambert_fragment:fy,lights_lambert_pars_fragment:dy,lights_pars_begin:py,lights_toon_fragment:gy,lights_toon_pars_fragment:_y,lights_phong_fragment:xy,lights_phong_pars_fragment:yy,lights_physical_fragment:vy,lights_physical_pars_fragment:My,lights_fragment_begin:Sy,lights_fragment_maps:by,lights_fragment_end:wy,lightprobes_pars_fragment:Ty,logdepthbuf_fragment:Ey,logdepthbuf_pars_fragment:Ay,logdepthbuf_pars_vertex:Ry,logdepthbuf_vertex:Cy,map_fragment:Py,map_pars_fragment:Iy,map_particle_fragment:Ly,map_particle_pars_fragment:Dy,metalnessmap_fragment:Ny,metalnessmap_pars_fragment:Uy,morphinstance_vertex:Fy,morphcolor_vertex:Oy,morphnormal_vertex:By,morphtarget_pars_vertex:zy,morphtarget_vertex:ky,normal_fragment_begin:Vy,normal_fragment_maps:Gy,normal_pars_fragment:Hy,normal_pars_vertex:Wy,normal_vertex:Xy,normalmap_pars_fragment:qy,clearcoat_normal_fragment_begin:Yy,clearcoat_normal_fragment_maps:$y,clearcoat_pars_fragment:Zy,iridescence_pars_fragment:Jy,opaque_fragment:Ky,packing:jy,premultiplied_alpha_fragment:Qy,project_vertex:tv,dithering_fragment:ev,dithering_pars_fragment:nv,roughnessmap_fragment:iv,roughnessmap_pars_fragment:sv,shadowmap_pars_fragment:rv,shadowmap_pars_vertex:ov,shadowmap_vertex:av,shadowmask_pars_fragment:lv,skinbase_vertex:cv,skinning_pars_vertex:hv,skinning_vertex:uv,skinnormal_vertex:fv,specularmap_fragment:dv,specularmap_pars_fragment:pv,tonemapping_fragment:mv,tonemapping_pars_fragment:gv,transmission_fragment:_v,transmission_pars_fragment:xv,uv_pars_fragment:yv,uv_pars_vertex:vv,uv_vertex:Mv,worldpos_vertex:Sv,background_vert:bv,background_frag:wv,backgroundCube_vert:Tv,backgroundCube_frag:Ev,cube_vert:Av,cube_frag:Rv,depth_vert:Cv,depth_frag:Pv,distance_vert:Iv,distance_frag:Lv,equirect_vert:Dv,equirect_frag:Nv,linedashed_vert:Uv,linedashed_frag:Fv,meshbasic_vert:Ov,meshbasic_frag:Bv,meshlambert_vert:zv,meshlambert_frag:kv,meshmatcap_vert:Vv,meshmatcap_frag:Gv,meshnormal_vert:Hv,meshnormal_frag:Wv,meshphong_vert:Xv,meshphong_frag:qv,meshphysical_vert:Yv,meshphysical_frag:$v,meshtoon_vert:Zv,meshtoon_frag:Jv,points_vert:Kv,points_frag:jv,shadow_vert:Qv,shadow_frag:tM,sprite_vert:eM,sprite_frag:nM},Lt={common:{diffuse:{value:new ce(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ce(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ce(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new ce(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},ss={basic:{uniforms:Wn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:Wn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new ce(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:Wn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new ce(0)},specular:{value:new ce(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:Wn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new ce(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:Wn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new ce(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:Wn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:Wn([Lt.points,Lt.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:Wn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:Wn([Lt.common,Lt.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:Wn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:Wn([Lt.sprite,Lt.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:Wn([Lt.common,Lt.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:Wn([Lt.lights,Lt.fog,{color:{value:new ce(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};ss.physical={uniforms:Wn([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new ce(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new ce(0)},specularColor:{value:new ce(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var sh={r:0,b:0,g:0},iM=new He,Fm=new se;Fm.set(-1,0,0,0,1,0,0,0,1);function sM(n,t,e,i,s,r){let o=new ce(0),a=s===!0?0:1,l,c,f=null,d=0,h=null;function u(v){let b=v.isScene===!0?v.background:null;if(b&&b.isTexture){let S=v.backgroundBlurriness>0;b=t.get(b,S)}return b}function p(v){let b=!1,S=u(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),b=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(v,b){let S=u(b);S&&S.isCubeTexture?(c===void 0&&(c=new Hn(new fo(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:vr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,T,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(iM.makeRotationFromEuler(b.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Fm),c.material.toneMapped=ve.getTransfer(S.colorSpace)!==Ce,(f!==S||d!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,f=S,d=S.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Hn(new xa(2,2),new ts({name:"BackgroundMaterial",uniforms:vr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:es,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=ve.getTransfer(S.colorSpace)!==Ce,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(f!==S||d!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,f=S,d=S.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,b){v.getRGB(sh,uf(n)),e.buffers.color.setClear(sh.r,sh.g,sh.b,b,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,b=1){o.set(v),a=b,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:x,dispose:g}}function rM(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(P,O,B,N,G){let V=!1,F=d(P,N,B,O);r!==F&&(r=F,c(r.object)),V=u(P,N,B,G),V&&p(P,N,B,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(V||o)&&(o=!1,S(P,O,B,N),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function f(P){return n.deleteVertexArray(P)}function d(P,O,B,N){let G=N.wireframe===!0,V=i[O.id];V===void 0&&(V={},i[O.id]=V);let F=P.isInstancedMesh===!0?P.id:0,j=V[F];j===void 0&&(j={},V[F]=j);let X=j[B.id];X===void 0&&(X={},j[B.id]=X);let $=X[G];return $===void 0&&($=h(l()),X[G]=$),$}function h(P){let O=[],B=[],N=[];for(let G=0;G<e;G++)O[G]=0,B[G]=0,N[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:B,attributeDivisors:N,object:P,attributes:{},index:null}}function u(P,O,B,N){let G=r.attributes,V=O.attributes,F=0,j=B.getAttributes();for(let X in j)if(j[X].location>=0){let tt=G[X],it=V[X];if(it===void 0&&(X==="instanceMatrix"&&P.instanceMatrix&&(it=P.instanceMatrix),X==="instanceColor"&&P.instanceColor&&(it=P.instanceColor)),tt===void 0||tt.attribute!==it||it&&tt.data!==it.data)return!0;F++}return r.attributesNum!==F||r.index!==N}function p(P,O,B,N){let G={},V=O.attributes,F=0,j=B.getAttributes();for(let X in j)if(j[X].location>=0){let tt=V[X];tt===void 0&&(X==="instanceMatrix"&&P.instanceMatrix&&(tt=P.instanceMatrix),X==="instanceColor"&&P.instanceColor&&(tt=P.instanceColor));let it={};it.attribute=tt,tt&&tt.data&&(it.data=tt.data),G[X]=it,F++}r.attributes=G,r.attributesNum=F,r.index=N}function x(){let P=r.newAttributes;for(let O=0,B=P.length;O<B;O++)P[O]=0}function m(P){g(P,0)}function g(P,O){let B=r.newAttributes,N=r.enabledAttributes,G=r.attributeDivisors;B[P]=1,N[P]===0&&(n.enableVertexAttribArray(P),N[P]=1),G[P]!==O&&(n.vertexAttribDivisor(P,O),G[P]=O)}function v(){let P=r.newAttributes,O=r.enabledAttributes;for(let B=0,N=O.length;B<N;B++)O[B]!==P[B]&&(n.disableVertexAttribArray(B),O[B]=0)}function b(P,O,B,N,G,V,F){F===!0?n.vertexAttribIPointer(P,O,B,G,V):n.vertexAttribPointer(P,O,B,N,G,V)}function S(P,O,B,N){x();let G=N.attributes,V=B.getAttributes(),F=O.defaultAttributeValues;for(let j in V){let X=V[j];if(X.location>=0){let $=G[j];if($===void 0&&(j==="instanceMatrix"&&P.instanceMatrix&&($=P.instanceMatrix),j==="instanceColor"&&P.instanceColor&&($=P.instanceColor)),$!==void 0){let tt=$.normalized,it=$.itemSize,st=t.get($);if(st===void 0)continue;let Q=st.buffer,dt=st.type,pt=st.bytesPerElement,_t=dt===n.INT||dt===n.UNSIGNED_INT||$.gpuType===vc;if($.isInterleavedBufferAttribute){let yt=$.data,Ft=yt.isInterleavedBuffer===!0?yt.stride:yt.itemSize,Kt=$.offset;if(yt.isInstancedInterleavedBuffer||yt.isInstancedBufferAttribute){for(let Vt=0;Vt<X.locationSize;Vt++)g(X.location+Vt,yt.meshPerAttribute);P.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=yt.meshPerAttribute*yt.count)}else for(let Vt=0;Vt<X.locationSize;Vt++)m(X.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Vt=0;Vt<X.locationSize;Vt++)b(X.location+Vt,it/X.locationSize,dt,tt,Ft*pt,(Kt+it/X.locationSize*Vt)*pt,_t)}else{if($.isInstancedBufferAttribute){for(let yt=0;yt<X.locationSize;yt++)g(X.location+yt,$.meshPerAttribute);P.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let yt=0;yt<X.locationSize;yt++)m(X.location+yt);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let yt=0;yt<X.locationSize;yt++)b(X.location+yt,it/X.locationSize,dt,tt,it*pt,it/X.locationSize*yt*pt,_t)}}else if(F!==void 0){let tt=F[j];if(tt!==void 0)switch(tt.length){case 2:n.vertexAttrib2fv(X.location,tt);break;case 3:n.vertexAttrib3fv(X.location,tt);break;case 4:n.vertexAttrib4fv(X.location,tt);break;default:n.vertexAttrib1fv(X.location,tt)}}}}v()}function E(){C();for(let P in i){let O=i[P];for(let B in O){let N=O[B];for(let G in N){let V=N[G];for(let F in V)f(V[F].object),delete V[F];delete N[G]}}delete i[P]}}function T(P){if(i[P.id]===void 0)return;let O=i[P.id];for(let B in O){let N=O[B];for(let G in N){let V=N[G];for(let F in V)f(V[F].object),delete V[F];delete N[G]}}delete i[P.id]}function _(P){for(let O in i){let B=i[O];for(let N in B){let G=B[N];if(G[P.id]===void 0)continue;let V=G[P.id];for(let F in V)f(V[F].object),delete V[F];delete G[P.id]}}}function M(P){for(let O in i){let B=i[O],N=P.isInstancedMesh===!0?P.id:0,G=B[N];if(G!==void 0){for(let V in G){let F=G[V];for(let j in F)f(F[j].object),delete F[j];delete G[V]}delete B[N],Object.keys(B).length===0&&delete i[O]}}}function C(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:C,resetDefaultState:I,dispose:E,releaseStatesOfGeometry:T,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:v}}function oM(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,f){f!==0&&(n.drawArraysInstanced(i,l,c,f),e.update(c,i,f))}function a(l,c,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,f);let h=0;for(let u=0;u<f;u++)h+=c[u];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function aM(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==zi&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===Bi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ri&&_!==Oi&&!M&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",f=l(c);f!==c&&(Zt("WebGLRenderer:",c,"not supported, using",f,"instead."),c=f);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Zt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Zt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let u=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:u,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:b,maxFragmentUniforms:S,maxSamples:E,samples:T}}function lM(n){let t=this,e=null,i=0,s=!1,r=!1,o=new pi,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let u=d.length!==0||h||i!==0||s;return s=h,i=d.length,u},this.beginShadows=function(){r=!0,f(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){e=f(d,h,0)},this.setState=function(d,h,u){let p=d.clippingPlanes,x=d.clipIntersection,m=d.clipShadows,g=n.get(d);if(!s||p===null||p.length===0||r&&!m)r?f(null):c();else{let v=r?0:i,b=v*4,S=g.clippingState||null;l.value=S,S=f(p,h,b,u);for(let E=0;E!==b;++E)S[E]=e[E];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function f(d,h,u,p){let x=d!==null?d.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=u+x*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let b=0,S=u;b!==x;++b,S+=4)o.copy(d[b]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var Fa=class extends gi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new pa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new fo(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:vr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ni,blending:gr});r.uniforms.tEquirect.value=e;let o=new Hn(s,r),a=e.minFilter;return e.minFilter===ws&&(e.minFilter=ti),new po(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},pm=256,cM=3,hM=20,Om=256,Bm=16,uM=3,fM=new q,dM=new ce,oh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new po(1,10,null),this._boxMesh=new Hn(new fo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=fM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),f=this._getSourceTarget(!0);e>0&&(f.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,u=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(dM));let m=new po(i,s,f);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=u,l.autoClearStencil=p,t.background=x,e>0&&(f.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=_m(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=gm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(pm,af(t))}_fromTexture(t,e){t.mapping===xr||t.mapping===xo?this._setSize(t.image.length===0?pm:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=mm(t,!1,!1),i=Math.log2(t)-cM;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=mm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===xr||t.mapping===xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=_m()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=gm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=pM(),this._integrationMaterial=mM());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Bm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-uM)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Om*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=gM());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function mm(n,t,e){return new Fa(n,{minFilter:ws,generateMipmaps:t,type:Bi,colorSpace:ia,depthBuffer:e})}function Oa(n,t,e){return new ts({name:n,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:ni,blending:gr,depthTest:!1,depthWrite:!1})}function pM(){return Oa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Om}u

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
	`)}function mM(){return Oa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Bm}},`

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
	`)}function gM(){return Oa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${hM}
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
	`)}function gm(){return Oa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function _m(){return Oa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function _M(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,u=!1){return h==null?null:u?o(h):r(h)}function r(h){if(h&&h.isTexture){let u=h.mapping;if(u===_c||u===xc)if(t.has(h)){let p=t.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let x=new Fa(p.height);return x.fromEquirectangularTexture(n,h),t.set(h,x),h.addEventListener("dispose",c),a(x.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let u=h.mapping,p=u===_c||u===xc,x=u===xr||u===xo;if(p||x){let m=e.get(h),g=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return i===null&&(i=new oh(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),m.texture;if(m!==void 0)return m.texture;{let v=h.image;return p&&v&&v.height>0||x&&v&&l(v)?(i===null&&(i=new oh(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),h.addEventListener("dispose",f),m.texture):null}}}return h}function a(h,u){return u===_c?h.mapping=xr:u===xc&&(h.mapping=xo),h}function l(h){let u=0,p=6;for(let x=0;x<p;x++)h[x]!==void 0&&u++;return u===p}function c(h){let u=h.target;u.removeEventListener("dispose",c);let p=t.get(u);p!==void 0&&(t.delete(u),p.dispose())}function f(h){let u=h.target;u.removeEventListener("dispose",f);let p=e.get(u);p!==void 0&&(e.delete(u),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function xM(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Qo("WebGLRenderer: "+i+" extension not supported."),s}}}function yM(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function f(p){let x=p.attributes;for(let m in x)t.update(x[m],n.ARRAY_BUFFER)}function d(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=x!==null?x.array.length:m.array.length/3-1,b=m.count>=65535?ua:ha,S=new b(Math.ceil(v/3)*6,1),E=S.array;if(x!==null){let _=x.array;g=x.version;for(let M=0,C=0;M<v;M+=3){let I=_[M+0],P=_[M+1],O=_[M+2];E[C++]=I,E[C++]=P,E[C++]=P,E[C++]=O,E[C++]=O,E[C++]=I}}else{g=m.version;for(let _=0,M=0;_<v;_+=3){let C=_+0,I=_+1,P=_+2;E[M++]=C,E[M++]=I,E[M++]=I,E[M++]=P,E[M++]=P,E[M++]=C}}S.version=g;let T=r.get(p);T&&t.remove(T),r.set(p,S)}function h(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&d(p)}else d(p);return r.get(p)}function u(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:f,getWireframeAttribute:h,dispose:u}}function vM(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),e.update(h,i,1)}function c(d,h,u){u!==0&&(n.drawElementsInstanced(i,h,r,d*o,u),e.update(h,i,u))}function f(d,h,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,u);let x=0;for(let m=0;m<u;m++)x+=h[m];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=f}function MM(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ne("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function SM(n,t,e){let i=new WeakMap,s=new je;function r(o,a,l){let c=o.morphTargetInfluences,f=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=f!==void 0?f.length:0,h=i.get(a);if(h===void 0||h.count!==d){let C=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",C)};h!==void 0&&h.texture.dispose();let u=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],b=0;u===!0&&(b=1),p===!0&&(b=2),x===!0&&(b=3);let S=a.attributes.position.count*b,E=1;S>t.maxTextureSize&&(E=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let T=new Float32Array(S*E*4*d),_=new aa(T,S,E,d);_.type=Oi,_.needsUpdate=!0;let M=b*4;for(let I=0;I<d;I++){let P=m[I],O=g[I],B=v[I],N=S*E*4*I;for(let G=0;G<P.count;G++){let V=G*M;u===!0&&(s.fromBufferAttribute(P,G),T[N+V+0]=s.x,T[N+V+1]=s.y,T[N+V+2]=s.z,T[N+V+3]=0),p===!0&&(s.fromBufferAttribute(O,G),T[N+V+4]=s.x,T[N+V+5]=s.y,T[N+V+6]=s.z,T[N+V+7]=0),x===!0&&(s.fromBufferAttribute(B,G),T[N+V+8]=s.x,T[N+V+9]=s.y,T[N+V+10]=s.z,T[N+V+11]=B.itemSize===4?s.w:1)}}h={count:d,texture:_,size:new Yt(S,E)},i.set(a,h),a.addEventListener("dispose",C)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let u=0;for(let x=0;x<c.length;x++)u+=c[x];let p=a.morphTargetsRelative?1:1-u;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function bM(n,t,e,i,s){let r=new WeakMap;function o(c){let f=s.render.frame,d=c.geometry,h=t.get(c,d);if(r.get(h)!==f&&(t.update(h),r.set(h,f)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==f&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,f))),c.isSkinnedMesh){let u=c.skeleton;r.get(u)!==f&&(u.update(),r.set(u,f))}return h}function a(){r=new WeakMap}function l(c){let f=c.target;f.removeEventListener("dispose",l),i.releaseStatesOfObject(f),e.remove(f.instanceMatrix),f.instanceColor!==null&&e.remove(f.instanceColor)}return{update:o,dispose:a}}var wM={[zu]:"LINEAR_TONE_MAPPING",[ku]:"REINHARD_TONE_MAPPING",[Vu]:"CINEON_TONE_MAPPING",[Gu]:"ACES_FILMIC_TONE_MAPPING",[Wu]:"AGX_TONE_MAPPING",[Xu]:"NEUTRAL_TONE_MAPPING",[Hu]:"CUSTOM_TONE_MAPPING"};function TM(n,t,e,i,s,r){let o=new gi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,f=new Nn;f.setAttribute("position",new un([-1,3,0,-1,-1,0,3,-1,0],3)),f.setAttribute("uv",new un([0,2,0,0,2,0],2));let d=new ec({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Hn(f,d),u=new Sa(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,v=null,b=[],S=!1;this.setSize=function(E,T){o.setSize(E,T),a!==null&&a.setSize(E,T),l!==null&&l.setSize(E,T);for(let _=0;_<b.length;_++){let M=b[_];M.setSize&&M.setSize(E,T)}},this.setEffects=function(E){b=E,S=b.length>0&&b[0].isRenderPass===!0;let T=o.width,_=o.height;b.length>0&&a===null&&(a=new gi(T,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}),l=new gi(T,_,{type:Bi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&b.some(C=>C.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ss(T,_),r===!0&&(c.format=Ts,c.type=yr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let C=0;C<b.length;C++){let I=b[C];I.setSize&&I.setSize(T,_),M&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(E,T){if(m||E.toneMapping===ns&&b.length===0)return!1;if(v=T,T!==null){let _=T.width,M=T.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return S===!1&&E.setRenderTarget(o),g=E.toneMapping,E.toneMapping=ns,!0},this.hasRenderPass=function(){return S},this.end=function(E,T){E.toneMapping=g,m=!0;let _=o,M=a;for(let C=0;C<b.length;C++){let I=b[C];I.enabled!==!1&&(I.render(E,M,_,T),I.needsSwap!==!1&&(_=M,M=M===a?l:a))}if(p!==E.outputColorSpace||x!==E.toneMapping){p=E.outputColorSpace,x=E.toneMapping,d.defines={},ve.getTransfer(p)===Ce&&(d.defines.SRGB_TRANSFER="");let C=wM[x];C&&(d.defines[C]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,E.setRenderTarget(v),E.render(h,u),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),f.dispose(),d.dispose()}}var zm=new ei,km=new Ss(1,1),Vm=new ga(1),Gm=new aa,Hm=new Yl,Wm=new pa,xm=[],ym=[],vm=new Float32Array(16),Mm=new Float32Array(9),Sm=new Float32Array(4);function Mo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=xm[s];if(r===void 0&&(r=new Float32Array(s),xm[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Mn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Sn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function lh(n,t){let e=ym[t];e===void 0&&(e=new Int32Array(t),ym[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function EM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function AM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;n.uniform2fv(this.addr,t),Sn(e,t)}}function RM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;n.uniform3fv(this.addr,t),Sn(e,t)}}function CM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;n.uniform4fv(this.addr,t),Sn(e,t)}}function PM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Sn(e,t)}else{if(Mn(e,i))return;Sm.set(i),n.uniformMatrix2fv(this.addr,!1,Sm),Sn(e,i)}}function IM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Sn(e,t)}else{if(Mn(e,i))return;Mm.set(i),n.uniformMatrix3fv(this.addr,!1,Mm),Sn(e,i)}}function LM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Sn(e,t)}else{if(Mn(e,i))return;vm.set(i),n.uniformMatrix4fv(this.addr,!1,vm),Sn(e,i)}}function DM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function NM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;n.uniform2iv(this.addr,t),Sn(e,t)}}function UM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;n.uniform3iv(this.addr,t),Sn(e,t)}}function FM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;n.uniform4iv(this.addr,t),Sn(e,t)}}function OM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function BM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;n.uniform2uiv(this.addr,t),Sn(e,t)}}function zM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;n.uniform3uiv(this.addr,t),Sn(e,t)}}function kM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;n.uniform4uiv(this.addr,t),Sn(e,t)}}function ch(n){return n.version===0&&(n.compareFunction=nf,n.needsUpdate=!0),n}function VM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=ch(km):r=zm,e.setTexture2D(t||r,s)}function GM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Hm,s)}function HM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=ch(Vm):r=Wm,e.setTextureCube(t||r,s)}function WM(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Gm,s)}function XM(n){switch(n){case 5126:return EM;case 35664:return AM;case 35665:return RM;case 35666:return CM;case 35674:return PM;case 35675:return IM;case 35676:return LM;case 5124:case 35670:return DM;case 35667:case 35671:return NM;case 35668:case 35672:return UM;case 35669:case 35673:return FM;case 5125:return OM;case 36294:return BM;case 36295:return zM;case 36296:return kM;case 35678:case 36198:case 36298:case 36306:case 35682:return VM;case 35679:case 36299:case 36307:return GM;case 35680:case 36300:case 36308:case 36293:return HM;case 36289:case 36303:case 36311:case 36292:return WM}}function qM(n,t){n.uniform1fv(this.addr,t)}function YM(n,t){let e=Mo(t,this.size,2);n.uniform2fv(this.addr,e)}function $M(n,t){let e=Mo(t,this.size,3);n.uniform3fv(this.addr,e)}function ZM(n,t){let e=Mo(t,this.size,4);n.uniform4fv(this.addr,e)}function JM(n,t){let e=Mo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function KM(n,t){let e=Mo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function jM(n,t){let e=Mo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function QM(n,t){n.uniform1iv(this.addr,t)}function tS(n,t){n.uniform2iv(this.addr,t)}function eS(n,t){n.uniform3iv(this.addr,t)}function nS(n,t){n.uniform4iv(this.addr,t)}function iS(n,t){n.uniform1uiv(this.addr,t)}function sS(n,t){n.uniform2uiv(this.addr,t)}function rS(n,t){n.uniform3uiv(this.addr,t)}function oS(n,t){n.uniform4uiv(this.addr,t)}function aS(n,t,e){let i=this.cache,s=t.length,r=lh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=ch(km):o=zm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function lS(n,t,e){let i=this.cache,s=t.length,r=lh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Hm,r[o])}function cS(n,t,e){let i=this.cache,s=t.length,r=lh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=ch(Vm):o=Wm;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function hS(n,t,e){let i=this.cache,s=t.length,r=lh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),Sn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Gm,r[o])}function uS(n){switch(n){case 5126:return qM;case 35664:return YM;case 35665:return $M;case 35666:return ZM;case 35674:return JM;case 35675:return KM;case 35676:return jM;case 5124:case 35670:return QM;case 35667:case 35671:return tS;case 35668:case 35672:return eS;case 35669:case 35673:return nS;case 5125:return iS;case 36294:return sS;case 36295:return rS;case 36296:return oS;case 35678:case 36198:case 36298:case 36306:case 35682:return aS;case 35679:case 36299:case 36307:return lS;case 35680:case 36300:case 36308:case 36293:return cS;case 36289:case 36303:case 36311:case 36292:return hS}}var _f=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=XM(e.type)}},xf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=uS(e.type)}},yf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},mf=/(\w+)(\])?(\[|\.)?/g;function bm(n,t){n.seq.push(t),n.map[t.id]=t}function fS(n,t,e){let i=n.name,s=i.length;for(mf.lastIndex=0;;){let r=mf.exec(i),o=mf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){bm(e,c===void 0?new _f(a,n,t):new xf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new yf(a),bm(e,d)),e=d}}}var vo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);fS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function wm(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var dS=37297,pS=0;function mS(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Tm=new se;function gS(n){ve._getMatrix(Tm,ve.workingColorSpace,n);let t=`mat3( ${Tm.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(n)){case sa:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return Zt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Em(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+mS(n.getShaderSource(t),a)}else return r}function _S(n,t){let e=gS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var xS={[zu]:"Linear",[ku]:"Reinhard",[Vu]:"Cineon",[Gu]:"ACESFilmic",[Wu]:"AgX",[Xu]:"Neutral",[Hu]:"Custom"};function yS(n,t){let e=xS[t];return e===void 0?(Zt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var rh=new q;function vS(){ve.getLuminanceCoefficients(rh);let n=rh.x.toFixed(4),t=rh.y.toFixed(4),e=rh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function MS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ua).join(`
`)}function SS(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function bS(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ua(n){return n!==""}function Am(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Rm(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var wS=/^[ \t]*#include +<([\w\d./]+)>/gm;function vf(n){return n.replace(wS,TS)}function TS(n,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return vf(e)}var ES=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Cm(n){return n.replace(ES,AS)}function AS(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Pm(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var RS={[Ea]:"SHADOWMAP_TYPE_PCF",[go]:"SHADOWMAP_TYPE_VSM"};function CS(n){return RS[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var PS={[xo]:"ENVMAP_MODE_REFRACTION"};function IS(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":PS[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var LS={[gc]:"ENVMAP_BLENDING_MULTIPLY",[$p]:"ENVMAP_BLENDING_MIX",[Zp]:"ENVMAP_BLENDING_ADD"};function DS(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":LS[n.combine]||"ENVMAP_BLENDING_NONE"}function NS(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=CS(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",f=IS(e),d=DS(e),h=MS(e),u=SS(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,u].filter(Ua).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,u].filter(Ua).join(`
`),m.length>0&&(m+=`
`)):(x=[Pm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,u,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+f:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ua).join(`
`),m=[Pm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,u,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+f:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ns?"#define TONE_MAPPING":"",e.toneMapping!==ns?fe.tonemapping_pars_fragment:"",e.toneMapping!==ns?yS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,_S("linearToOutputTexel",e.outputColorSpace),vS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ua).join(`
`)),o=vf(o),o=Am(o,e),o=Rm(o,e),a=vf(a),a=Am(a,e),a=Rm(a,e),o=Cm(o),a=Cm(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===rf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===rf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+x+o,b=g+m+a,S=wm(s,s.VERTEX_SHADER,v),E=wm(s,s.FRAGMENT_SHADER,b);s.attachShader(p,S),s.attachShader(p,E),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(I){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",O=s.getShaderInfoLog(S)||"",B=s.getShaderInfoLog(E)||"",N=P.trim(),G=O.trim(),V=B.trim(),F=!0,j=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(F=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,E);else{let X=Em(s,S,"vertex"),$=Em(s,E,"fragment");ne("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+N+`
`+X+`
`+$)}else N!==""?Zt("WebGLProgram: Program Info Log:",N):(G===""||V==="")&&(j=!1);j&&(I.diagnostics={runnable:F,programLog:N,vertexShader:{log:G,prefix:x},fragmentShader:{log:V,prefix:m}})}s.deleteShader(S),s.deleteShader(E),_=new vo(s,p),M=bS(s,p)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let M;this.getAttributes=function(){return M===void 0&&T(this),M};let C=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return C===!1&&(C=s.getProgramParameter(p,dS)),C},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=pS++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=E,this}var US=0,Mf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Sf(t),e.set(t,i)),i}},Sf=class{constructor(t){this.id=US++,this.code=t,this.usedTimes=0}};function FS(n){return n===$s||n===La||n===Da}function OS(n,t,e,i,s,r){let o=new la,a=new Mf,l=new Set,c=[],f=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function u(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,M,C,I,P,O){let B=I.fog,N=P.geometry,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?I.environment:null,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,F=t.get(_.envMap||G,V),j=h[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&Zt("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let $=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,tt=$!==void 0?$.length:0,it=0;N.morphAttributes.position!==void 0&&(it=1),N.morphAttributes.normal!==void 0&&(it=2),N.morphAttributes.color!==void 0&&(it=3);let st,Q,dt,pt;if(j){let Ct=ss[j];st=Ct.vertexShader,Q=Ct.fragmentShader}else{st=_.vertexShader,Q=_.fragmentShader;let Ct=a.getVertexShaderStage(_),le=a.getFragmentShaderStage(_);a.update(_,Ct,le),dt=Ct.id,pt=le.id}let _t=n.getRenderTarget(),yt=n.state.buffers.depth.getReversed(),Ft=P.isInstancedMesh===!0,Kt=P.isBatchedMesh===!0,Vt=!!_.map,he=!!_.matcap,ae=!!F,Gt=ae&&F.isPMREMTexture===!0,Se=!!_.aoMap,Ie=!!_.lightMap,tn=!!_.bumpMap&&_.wireframe===!1,Re=!!_.normalMap,fn=!!_.displacementMap,xe=!!_.emissiveMap,ln=!!_.metalnessMap,Je=!!_.roughnessMap,en=_.anisotropy>0,z=_.clearcoat>0,Rt=_.diffuseRoughness>0,Jt=_.dispersion>0,oe=_.retroreflectivity>0,wt=_.iridescence>0,ze=_.sheen>0,Ht=_.transmission>0,$t=en&&!!_.anisotropyMap,L=z&&!!_.clearcoatMap,w=z&&!!_.clearcoatNormalMap,Y=z&&!!_.clearcoatRoughnessMap,ft=Rt&&!!_.diffuseRoughnessMap,ct=wt&&!!_.iridescenceMap,vt=wt&&!!_.iridescenceThicknessMap,Mt=ze&&!!_.sheenColorMap,rt=ze&&!!_.sheenRoughnessMap,at=!!_.specularMap,gt=!!_.specularColorMap,k=!!_.specularIntensityMap,lt=Ht&&!!_.transmissionMap,ot=Ht&&!!_.thicknessMap,Tt=!!_.gradientMap,xt=!!_.alphaMap,bt=_.alphaTest>0,Wt=!!_.alphaHash,te=!!_.extensions,ut=ns;_.toneMapped&&(_t===null||_t.isXRRenderTarget===!0)&&(ut=n.toneMapping);let Bt=Gt?F.isCompressedCubeTexture?F.image[0].mipmaps:F.mipmaps:null,ee={shaderID:j,shaderType:_.type,shaderName:_.name,vertexShader:st,fragmentShader:Q,defines:_.defines,customVertexShaderID:dt,customFragmentShaderID:pt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:Kt,batchingColor:Kt&&P._colorsTexture!==null,instancing:Ft,instancingColor:Ft&&P.instanceColor!==null,instancingMorph:Ft&&P.morphTexture!==null,outputColorSpace:_t===null?n.outputColorSpace:_t.isXRRenderTarget===!0?_t.texture.colorSpace:ve.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Vt,matcap:he,envMap:ae,envMapMode:ae&&F.mapping,envMapPMREM:Gt,envMapMaxLod:Gt?Bt.length-1:null,envMapSize:Gt?Bt[0].width:null,aoMap:Se,lightMap:Ie,bumpMap:tn,normalMap:Re,displacementMap:fn,emissiveMap:xe,normalMapObjectSpace:Re&&_.normalMapType===jp,normalMapTangentSpace:Re&&_.normalMapType===nh,packedNormalMap:Re&&_.normalMapType===nh&&FS(_.normalMap.format),metalnessMap:ln,roughnessMap:Je,anisotropy:en,anisotropyMap:$t,clearcoat:z,clearcoatMap:L,clearcoatNormalMap:w,clearcoatRoughnessMap:Y,diffuseRoughness:Rt,diffuseRoughnessMap:ft,dispersion:Jt,retroreflection:oe,iridescence:wt,iridescenceMap:ct,iridescenceThicknessMap:vt,sheen:ze,sheenColorMap:Mt,sheenRoughnessMap:rt,specularMap:at,specularColorMap:gt,specularIntensityMap:k,transmission:Ht,transmissionMap:lt,thicknessMap:ot,gradientMap:Tt,opaque:_.transparent===!1&&_.blending===_o&&_.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Wt,combine:_.combine,mapUv:Vt&&u(_.map.channel),aoMapUv:Se&&u(_.aoMap.channel),lightMapUv:Ie&&u(_.lightMap.channel),bumpMapUv:tn&&u(_.bumpMap.channel),normalMapUv:Re&&u(_.normalMap.channel),displacementMapUv:fn&&u(_.displacementMap.channel),emissiveMapUv:xe&&u(_.emissiveMap.channel),metalnessMapUv:ln&&u(_.metalnessMap.channel),roughnessMapUv:Je&&u(_.roughnessMap.channel),anisotropyMapUv:$t&&u(_.anisotropyMap.channel),clearcoatMapUv:L&&u(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&u(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&u(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ft&&u(_.diffuseRoughnessMap.channel),iridescenceMapUv:ct&&u(_.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&u(_.iridescenceThicknessMap.channel),sheenColorMapUv:Mt&&u(_.sheenColorMap.channel),sheenRoughnessMapUv:rt&&u(_.sheenRoughnessMap.channel),specularMapUv:at&&u(_.specularMap.channel),specularColorMapUv:gt&&u(_.specularColorMap.channel),specularIntensityMapUv:k&&u(_.specularIntensityMap.channel),transmissionMapUv:lt&&u(_.transmissionMap.channel),thicknessMapUv:ot&&u(_.thicknessMap.channel),alphaMapUv:xt&&u(_.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Re||en),vertexNormals:!!N.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!N.attributes.uv&&(Vt||xt),fog:!!B,useFog:_.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||N.attributes.normal===void 0&&Re===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:yt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:it,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:O.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:ut,decodeVideoTexture:Vt&&_.map.isVideoTexture===!0&&ve.getTransfer(_.map.colorSpace)===Ce,decodeVideoTextureEmissive:xe&&_.emissiveMap.isVideoTexture===!0&&ve.getTransfer(_.emissiveMap.colorSpace)===Ce,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===si,flipSided:_.side===ni,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:te&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&_.extensions.multiDraw===!0||Kt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return ee.vertexUv1s=l.has(1),ee.vertexUv2s=l.has(2),ee.vertexUv3s=l.has(3),l.clear(),ee}function x(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let C in _.defines)M.push(C),M.push(_.defines[C]);return _.isRawShaderMaterial===!1&&(m(M,_),g(M,_),M.push(n.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function m(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function g(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let M=h[_.type],C;if(M){let I=ss[M];C=um.clone(I.uniforms)}else C=_.uniforms;return C}function b(_,M){let C=f.get(M);return C!==void 0?++C.usedTimes:(C=new NS(n,M,_,s),c.push(C),f.set(M,C)),C}function S(_){if(--_.usedTimes===0){let M=c.indexOf(_);c[M]=c[c.length-1],c.pop(),f.delete(_.cacheKey),_.destroy()}}function E(_){a.remove(_)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:v,acquireProgram:b,releaseProgram:S,releaseShaderCache:E,programs:c,dispose:T}}function BS(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function zS(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Im(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Lm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let u=0;return h.isInstancedMesh&&(u+=2),h.isSkinnedMesh&&(u+=1),u}function a(h,u,p,x,m,g){let v=n[t];return v===void 0?(v={id:h.id,object:h,geometry:u,material:p,materialVariant:o(h),groupOrder:x,renderOrder:h.renderOrder,z:m,group:g},n[t]=v):(v.id=h.id,v.object=h,v.geometry=u,v.material=p,v.materialVariant=o(h),v.groupOrder=x,v.renderOrder=h.renderOrder,v.z=m,v.group=g),t++,v}function l(h,u,p,x,m,g,v){v.reversedDepth===!0&&(m=-m);let b=a(h,u,p,x,m,g);p.transmission>0?i.push(b):p.transparent===!0?s.push(b):e.push(b)}function c(h,u,p,x,m,g){let v=a(h,u,p,x,m,g);p.transmission>0?i.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function f(h,u){e.length>1&&e.sort(h||zS),i.length>1&&i.sort(u||Im),s.length>1&&s.sort(u||Im)}function d(){for(let h=t,u=n.length;h<u;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:f}}function kS(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Lm,n.set(i,[o])):s>=r.length?(o=new Lm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function VS(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new q,color:new ce};break;case"SpotLight":e={position:new q,direction:new q,color:new ce,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new q,color:new ce,distance:0,decay:0};break;case"HemisphereLight":e={direction:new q,skyColor:new ce,groundColor:new ce};break;case"RectAreaLight":e={color:new ce,position:new q,halfWidth:new q,halfHeight:new q};break}return n[t.id]=e,e}}}function GS(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var HS=0;function WS(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function XS(n){let t=new VS,e=GS(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new q);let s=new q,r=new He,o=new He;function a(c){let f=0,d=0,h=0;for(let O=0;O<9;O++)i.probe[O].set(0,0,0);let u=0,p=0,x=0,m=0,g=0,v=0,b=0,S=0,E=0,T=0,_=0,M=0,C=0,I=0;c.sort(WS);for(let O=0,B=c.length;O<B;O++){let N=c[O],G=N.color,V=N.intensity,F=N.distance,j=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===$s?j=N.shadow.map.texture:j=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)f+=G.r*V,d+=G.g*V,h+=G.b*V;else if(N.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(N.sh.coefficients[X],V);I++}else if(N.isSunLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let $=N.shadow,tt=e.get(N);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize.copy($.mapSize).multiply($.getFrameExtents()),i.sunShadow[p]=tt,i.sunShadowMap[p]=j;let it=$.getViewportCount();for(let st=0;st<it;st++)i.sunShadowMatrix[x+st]=$.getMatrix(st),i.sunShadowCascade[x+st]=$._cascadeData[st];x+=it,p++}i.sun[u]=X,u++}else if(N.isDirectionalLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let $=N.shadow,tt=e.get(N);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize=$.mapSize,i.directionalShadow[m]=tt,i.directionalShadowMap[m]=j,i.directionalShadowMatrix[m]=N.shadow.matrix,E++}i.directional[m]=X,m++}else if(N.isSpotLight){let X=t.get(N);X.position.setFromMatrixPosition(N.matrixWorld),X.color.copy(G).multiplyScalar(V),X.distance=F,X.coneCos=Math.cos(N.angle),X.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),X.decay=N.decay,i.spot[v]=X;let $=N.shadow;if(N.map&&(i.spotLightMap[M]=N.map,M++,$.updateMatrices(N),N.castShadow&&C++),i.spotLightMatrix[v]=$.matrix,N.castShadow){let tt=e.get(N);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize=$.mapSize,i.spotShadow[v]=tt,i.spotShadowMap[v]=j,_++}v++}else if(N.isRectAreaLight){let X=t.get(N);X.color.copy(G).multiplyScalar(V),X.halfWidth.set(N.width*.5,0,0),X.halfHeight.set(0,N.height*.5,0),i.rectArea[b]=X,b++}else if(N.isPointLight){let X=t.get(N);if(X.color.copy(N.color).multiplyScalar(N.intensity),X.distance=N.distance,X.decay=N.decay,N.castShadow){let $=N.shadow,tt=e.get(N);tt.shadowIntensity=$.intensity,tt.shadowBias=$.bias,tt.shadowNormalBias=$.normalBias,tt.shadowRadius=$.radius,tt.shadowMapSize=$.mapSize,tt.shadowCameraNear=$.camera.near,tt.shadowCameraFar=$.camera.far,i.pointShadow[g]=tt,i.pointShadowMap[g]=j,i.pointShadowMatrix[g]=N.shadow.matrix,T++}i.point[g]=X,g++}else if(N.isHemisphereLight){let X=t.get(N);X.skyColor.copy(N.color).multiplyScalar(V),X.groundColor.copy(N.groundColor).multiplyScalar(V),i.hemi[S]=X,S++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=f,i.ambient[1]=d,i.ambient[2]=h;let P=i.hash;(P.sunLength!==u||P.directionalLength!==m||P.pointLength!==g||P.spotLength!==v||P.rectAreaLength!==b||P.hemiLength!==S||P.numSunShadows!==p||P.numDirectionalShadows!==E||P.numPointShadows!==T||P.numSpotShadows!==_||P.numSpotMaps!==M||P.numLightProbes!==I)&&(i.sun.length=u,i.directional.length=m,i.spot.length=v,i.rectArea.length=b,i.point.length=g,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+M-C,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=C,i.numLightProbes=I,P.sunLength=u,P.directionalLength=m,P.pointLength=g,P.spotLength=v,P.rectAreaLength=b,P.hemiLength=S,P.numSunShadows=p,P.numDirectionalShadows=E,P.numPointShadows=T,P.numSpotShadows=_,P.numSpotMaps=M,P.numLightProbes=I,i.version=HS++)}function l(c,f){let d=0,h=0,u=0,p=0,x=0,m=0,g=f.matrixWorldInverse;for(let v=0,b=c.length;v<b;v++){let S=c[v];if(S.isSunLight){let E=i.sun[d];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(g),d++}else if(S.isDirectionalLight){let E=i.directional[h];E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),h++}else if(S.isSpotLight){let E=i.spot[p];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let E=i.rectArea[x];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),E.halfWidth.set(S.width*.5,0,0),E.halfHeight.set(0,S.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let E=i.point[u];E.position.setFromMatrixPosition(S.matrixWorld),E.position.applyMatrix4(g),u++}else if(S.isHemisphereLight){let E=i.hemi[m];E.direction.setFromMatrixPosition(S.matrixWorld),E.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Dm(n){let t=new XS(n),e=[],i=[],s=[];function r(d){f.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){t.setupView(e,d)}let f={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:f,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function qS(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Dm(n),t.set(s,[a])):r>=o.length?(a=new Dm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var YS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,$S=`uniform sampler2D shadow_pass;
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
}`,ZS=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],JS=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],Nm=new He,Na=new q,gf=new q;function KS(n,t,e){let i=new Vs,s=new Yt,r=new Yt,o=new je,a=new nc,l=new ic,c={},f=e.maxTextureSize,d={[es]:ni,[ni]:es,[si]:si},h=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:YS,fragmentShader:$S}),u=h.clone();u.defines.HORIZONTAL_PASS=1;let p=new Nn;p.setAttribute("position",new Qn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Hn(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ea;let g=this.type;this.render=function(T,_,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===Cp&&(Zt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ea);let C=n.getRenderTarget(),I=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),O=n.state;O.setBlending(gr),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let B=g!==this.type;B&&_.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(G=>G.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,G=T.length;N<G;N++){let V=T[N],F=V.shadow;if(F===void 0){Zt("WebGLShadowMap:",V,"has no shadow.");continue}if(F.autoUpdate===!1&&F.needsUpdate===!1)continue;s.copy(F.mapSize);let j=F.getFrameExtents();s.multiply(j),r.copy(F.mapSize),(s.x>f||s.y>f)&&(s.x>f&&(r.x=Math.floor(f/j.x),s.x=r.x*j.x,F.mapSize.x=r.x),s.y>f&&(r.y=Math.floor(f/j.y),s.y=r.y*j.y,F.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(F.camera._reversedDepth=X,F.map===null||B===!0){if(F.map!==null&&(F.map.depthTexture!==null&&(F.map.depthTexture.dispose(),F.map.depthTexture=null),F.map.dispose()),this.type===go){if(V.isPointLight){Zt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}F.map=new gi(s.x,s.y,{format:$s,type:Bi,minFilter:ti,magFilter:ti,generateMipmaps:!1}),F.map.texture.name=V.name+".shadowMap",F.map.depthTexture=new Ss(s.x,s.y,Oi),F.map.depthTexture.name=V.name+".shadowMapDepth",F.map.depthTexture.format=vs,F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=Dn,F.map.depthTexture.magFilter=Dn}else V.isPointLight?(F.map=new Fa(s.x),F.map.depthTexture=new ga(s.x,Fi)):(F.map=new gi(s.x,s.y),F.map.depthTexture=new Ss(s.x,s.y,Fi)),F.map.depthTexture.name=V.name+".shadowMap",F.map.depthTexture.format=vs,this.type===Ea?(F.map.depthTexture.compareFunction=X?ef:tf,F.map.depthTexture.minFilter=ti,F.map.depthTexture.magFilter=ti):(F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=Dn,F.map.depthTexture.magFilter=Dn);F.camera.updateProjectionMatrix()}F.map.isWebGLCubeRenderTarget!==!0&&(F.map.width!==s.x||F.map.height!==s.y)&&F.map.setSize(s.x,s.y);let $=F.map.isWebGLCubeRenderTarget?6:F.getViewportCount();V.isPointLight!==!0&&F.updateMatrices(V,M);let tt=(F.camera.layers.mask&4294967294)!==0?F.camera.layers:M.layers;for(let it=0;it<$;it++){let st=F.getCamera(it);if(V.isPointLight){let Q=F.camera,dt=F.matrix,pt=V.distance||Q.far;pt!==Q.far&&(Q.far=pt,Q.updateProjectionMatrix()),Na.setFromMatrixPosition(V.matrixWorld),Q.position.copy(Na),gf.copy(Q.position),gf.add(ZS[it]),Q.up.copy(JS[it]),Q.lookAt(gf),Q.updateMatrixWorld(),dt.makeTranslation(-Na.x,-Na.y,-Na.z),Nm.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),F._frustum.setFromProjectionMatrix(Nm,Q.coordinateSystem,Q.reversedDepth)}if(F.map.isWebGLCubeRenderTarget)n.setRenderTarget(F.map,it),n.clear();else{it===0&&(n.setRenderTarget(F.map),n.clear());let Q=F.getViewport(it);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),O.viewport(o)}i=F.getFrustum(it),S(_,M,st,V,tt,this.type)}F.isPointLightShadow!==!0&&this.type===go&&v(F,M),F.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(C,I,P)};function v(T,_){let M=t.update(x);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,u.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,u.needsUpdate=!0),T.mapPass===null?T.mapPass=new gi(s.x,s.y,{format:$s,type:Bi}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(_,null,M,h,x,null),u.uniforms.shadow_pass.value=T.mapPass.texture,u.uniforms.resolution.value.set(T.map.width,T.map.height),u.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(_,null,M,u,x,null)}function b(T,_,M,C){let I=null,P=M.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(P!==void 0)I=P;else if(I=M.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let O=I.uuid,B=_.uuid,N=c[O];N===void 0&&(N={},c[O]=N);let G=N[B];G===void 0&&(G=I.clone(),N[B]=G,_.addEventListener("dispose",E)),I=G}if(I.visible=_.visible,I.wireframe=_.wireframe,C===go?I.side=_.shadowSide!==null?_.shadowSide:_.side:I.side=_.shadowSide!==null?_.shadowSide:d[_.side],I.alphaMap=_.alphaMap,I.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,I.map=_.map,I.clipShadows=_.clipShadows,I.clippingPlanes=_.clippingPlanes,I.clipIntersection=_.clipIntersection,I.displacementMap=_.displacementMap,I.displacementScale=_.displacementScale,I.displacementBias=_.displacementBias,I.wireframeLinewidth=_.wireframeLinewidth,I.linewidth=_.linewidth,M.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let O=n.properties.get(I);O.light=M}return I}function S(T,_,M,C,I,P){if(T.visible===!1)return;if(T.layers.test(I)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&P===go)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,T.matrixWorld);let N=t.update(T),G=T.material;if(Array.isArray(G)){let V=N.groups;for(let F=0,j=V.length;F<j;F++){let X=V[F],$=G[X.materialIndex];if($&&$.visible){let tt=b(T,$,C,P);T.onBeforeShadow(n,T,_,M,N,tt,X),n.renderBufferDirect(M,null,N,tt,T,X),T.onAfterShadow(n,T,_,M,N,tt,X)}}}else if(G.visible){let V=b(T,G,C,P);T.onBeforeShadow(n,T,_,M,N,V,null),n.renderBufferDirect(M,null,N,V,T,null),T.onAfterShadow(n,T,_,M,N,V,null)}}let B=T.children;for(let N=0,G=B.length;N<G;N++)S(B[N],_,M,C,I,P)}function E(T){T.target.removeEventListener("dispose",E);for(let M in c){let C=c[M],I=T.target.uuid;I in C&&(C[I].dispose(),delete C[I])}}}function jS(n,t){function e(){let k=!1,lt=new je,ot=null,Tt=new je(0,0,0,0);return{setMask:function(xt){ot!==xt&&!k&&(n.colorMask(xt,xt,xt,xt),ot=xt)},setLocked:function(xt){k=xt},setClear:function(xt,bt,Wt,te,ut){ut===!0&&(xt*=te,bt*=te,Wt*=te),lt.set(xt,bt,Wt,te),Tt.equals(lt)===!1&&(n.clearColor(xt,bt,Wt,te),Tt.copy(lt))},reset:function(){k=!1,ot=null,Tt.set(-1,0,0,0)}}}function i(){let k=!1,lt=!1,ot=null,Tt=null,xt=null;return{setReversed:function(bt){if(lt!==bt){let Wt=t.get("EXT_clip_control");bt?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),lt=bt;let te=xt;xt=null,this.setClear(te)}},getReversed:function(){return lt},setTest:function(bt){bt?yt(n.DEPTH_TEST):Ft(n.DEPTH_TEST)},setMask:function(bt){ot!==bt&&!k&&(n.depthMask(bt),ot=bt)},setFunc:function(bt){if(lt&&(bt=lm[bt]),Tt!==bt){switch(bt){case Ul:n.depthFunc(n.NEVER);break;case Fl:n.depthFunc(n.ALWAYS);break;case Ol:n.depthFunc(n.LESS);break;case ro:n.depthFunc(n.LEQUAL);break;case Bl:n.depthFunc(n.EQUAL);break;case zl:n.depthFunc(n.GEQUAL);break;case kl:n.depthFunc(n.GREATER);break;case Vl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Tt=bt}},setLocked:function(bt){k=bt},setClear:function(bt){xt!==bt&&(xt=bt,lt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){k=!1,ot=null,Tt=null,xt=null,lt=!1}}}function s(){let k=!1,lt=null,ot=null,Tt=null,xt=null,bt=null,Wt=null,te=null,ut=null;return{setTest:function(Bt){k||(Bt?yt(n.STENCIL_TEST):Ft(n.STENCIL_TEST))},setMask:function(Bt){lt!==Bt&&!k&&(n.stencilMask(Bt),lt=Bt)},setFunc:function(Bt,ee,Ct){(ot!==Bt||Tt!==ee||xt!==Ct)&&(n.stencilFunc(Bt,ee,Ct),ot=Bt,Tt=ee,xt=Ct)},setOp:function(Bt,ee,Ct){(bt!==Bt||Wt!==ee||te!==Ct)&&(n.stencilOp(Bt,ee,Ct),bt=Bt,Wt=ee,te=Ct)},setLocked:function(Bt){k=Bt},setClear:function(Bt){ut!==Bt&&(n.clearStencil(Bt),ut=Bt)},reset:function(){k=!1,lt=null,ot=null,Tt=null,xt=null,bt=null,Wt=null,te=null,ut=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,f={},d={},h={},u=new WeakMap,p=[],x=null,m=!1,g=null,v=null,b=null,S=null,E=null,T=null,_=null,M=new ce(0,0,0),C=0,I=!1,P=null,O=null,B=null,N=null,G=null,V=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),F=!1,j=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(X)[1]),F=j>=1):X.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),F=j>=2);let $=null,tt={},it=n.getParameter(n.SCISSOR_BOX),st=n.getParameter(n.VIEWPORT),Q=new je().fromArray(it),dt=new je().fromArray(st);function pt(k,lt,ot,Tt){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(k,bt),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Wt=0;Wt<ot;Wt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(lt,0,n.RGBA,1,1,Tt,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(lt+Wt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let _t={};_t[n.TEXTURE_2D]=pt(n.TEXTURE_2D,n.TEXTURE_2D,1),_t[n.TEXTURE_CUBE_MAP]=pt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),_t[n.TEXTURE_2D_ARRAY]=pt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),_t[n.TEXTURE_3D]=pt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),yt(n.DEPTH_TEST),o.setFunc(ro),tn(!1),Re(Du),yt(n.CULL_FACE),Se(gr);function yt(k){f[k]!==!0&&(n.enable(k),f[k]=!0)}function Ft(k){f[k]!==!1&&(n.disable(k),f[k]=!1)}function Kt(k,lt){return h[k]!==lt?(n.bindFramebuffer(k,lt),h[k]=lt,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=lt),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=lt),!0):!1}function Vt(k,lt){let ot=p,Tt=!1;if(k){ot=u.get(lt),ot===void 0&&(ot=[],u.set(lt,ot));let xt=k.textures;if(ot.length!==xt.length||ot[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Wt=xt.length;bt<Wt;bt++)ot[bt]=n.COLOR_ATTACHMENT0+bt;ot.length=xt.length,Tt=!0}}else ot[0]!==n.BACK&&(ot[0]=n.BACK,Tt=!0);Tt&&n.drawBuffers(ot)}function he(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let ae={[_r]:n.FUNC_ADD,[Ip]:n.FUNC_SUBTRACT,[Lp]:n.FUNC_REVERSE_SUBTRACT};ae[Dp]=n.MIN,ae[Np]=n.MAX;let Gt={[Up]:n.ZERO,[Fp]:n.ONE,[Op]:n.SRC_COLOR,[Ou]:n.SRC_ALPHA,[Hp]:n.SRC_ALPHA_SATURATE,[Vp]:n.DST_COLOR,[zp]:n.DST_ALPHA,[Bp]:n.ONE_MINUS_SRC_COLOR,[Bu]:n.ONE_MINUS_SRC_ALPHA,[Gp]:n.ONE_MINUS_DST_COLOR,[kp]:n.ONE_MINUS_DST_ALPHA,[Wp]:n.CONSTANT_COLOR,[Xp]:n.ONE_MINUS_CONSTANT_COLOR,[qp]:n.CONSTANT_ALPHA,[Yp]:n.ONE_MINUS_CONSTANT_ALPHA};function Se(k,lt,ot,Tt,xt,bt,Wt,te,ut,Bt){if(k===gr){m===!0&&(Ft(n.BLEND),m=!1);return}if(m===!1&&(yt(n.BLEND),m=!0),k!==Pp){if(k!==g||Bt!==I){if((v!==_r||E!==_r)&&(n.blendEquation(n.FUNC_ADD),v=_r,E=_r),Bt)switch(k){case _o:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Nu:n.blendFunc(n.ONE,n.ONE);break;case Uu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Fu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ne("WebGLState: Invalid blending: ",k);break}else switch(k){case _o:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Nu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Uu:ne("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Fu:ne("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ne("WebGLState: Invalid blending: ",k);break}b=null,S=null,T=null,_=null,M.set(0,0,0),C=0,g=k,I=Bt}return}xt=xt||lt,bt=bt||ot,Wt=Wt||Tt,(lt!==v||xt!==E)&&(n.blendEquationSeparate(ae[lt],ae[xt]),v=lt,E=xt),(ot!==b||Tt!==S||bt!==T||Wt!==_)&&(n.blendFuncSeparate(Gt[ot],Gt[Tt],Gt[bt],Gt[Wt]),b=ot,S=Tt,T=bt,_=Wt),(te.equals(M)===!1||ut!==C)&&(n.blendColor(te.r,te.g,te.b,ut),M.copy(te),C=ut),g=k,I=!1}function Ie(k,lt){k.side===si?Ft(n.CULL_FACE):yt(n.CULL_FACE);let ot=k.side===ni;lt&&(ot=!ot),tn(ot),k.blending===_o&&k.transparent===!1?Se(gr):Se(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Tt=k.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),xe(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?yt(n.SAMPLE_ALPHA_TO_COVERAGE):Ft(n.SAMPLE_ALPHA_TO_COVERAGE)}function tn(k){P!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),P=k)}function Re(k){k!==Ap?(yt(n.CULL_FACE),k!==O&&(k===Du?n.cullFace(n.BACK):k===Rp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ft(n.CULL_FACE),O=k}function fn(k){k!==B&&(F&&n.lineWidth(k),B=k)}function xe(k,lt,ot){k?(yt(n.POLYGON_OFFSET_FILL),(N!==lt||G!==ot)&&(N=lt,G=ot,o.getReversed()&&(lt=-lt,ot=-ot),n.polygonOffset(lt,ot))):Ft(n.POLYGON_OFFSET_FILL)}function ln(k){k?yt(n.SCISSOR_TEST):Ft(n.SCISSOR_TEST)}function Je(k){k===void 0&&(k=n.TEXTURE0+V-1),$!==k&&(n.activeTexture(k),$=k)}function en(k,lt,ot){ot===void 0&&($===null?ot=n.TEXTURE0+V-1:ot=$);let Tt=tt[ot];Tt===void 0&&(Tt={type:void 0,texture:void 0},tt[ot]=Tt),(Tt.type!==k||Tt.texture!==lt)&&($!==ot&&(n.activeTexture(ot),$=ot),n.bindTexture(k,lt||_t[k]),Tt.type=k,Tt.texture=lt)}function z(){let k=tt[$];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(k){ne("WebGLState:",k)}}function Jt(){try{n.compressedTexImage3D(...arguments)}catch(k){ne("WebGLState:",k)}}function oe(){try{n.texSubImage2D(...arguments)}catch(k){ne("WebGLState:",k)}}function wt(){try{n.texSubImage3D(...arguments)}catch(k){ne("WebGLState:",k)}}function ze(){try{n.compressedTexSubImage2D(...arguments)}catch(k){ne("WebGLState:",k)}}function Ht(){try{n.compressedTexSubImage3D(...arguments)}catch(k){ne("WebGLState:",k)}}function $t(){try{n.texStorage2D(...arguments)}catch(k){ne("WebGLState:",k)}}function L(){try{n.texStorage3D(...arguments)}catch(k){ne("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){ne("WebGLState:",k)}}function Y(){try{n.texImage3D(...arguments)}catch(k){ne("WebGLState:",k)}}function ft(k){return d[k]!==void 0?d[k]:n.getParameter(k)}function ct(k,lt){d[k]!==lt&&(n.pixelStorei(k,lt),d[k]=lt)}function vt(k){Q.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),Q.copy(k))}function Mt(k){dt.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),dt.copy(k))}function rt(k,lt){let ot=c.get(lt);ot===void 0&&(ot=new WeakMap,c.set(lt,ot));let Tt=ot.get(k);Tt===void 0&&(Tt=n.getUniformBlockIndex(lt,k.name),n.uniformBlockBinding(lt,Tt,Tt),ot.set(k,Tt))}function at(k,lt,ot){let xt=c.get(lt).get(k);l[xt]!==ot&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,ot),l[xt]=ot)}function gt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),f={},d={},$=null,tt={},h={},l={},u=new WeakMap,p=[],x=null,m=!1,g=null,v=null,b=null,S=null,E=null,T=null,_=null,M=new ce(0,0,0),C=0,I=!1,P=null,O=null,B=null,N=null,G=null,Q.set(0,0,n.canvas.width,n.canvas.height),dt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:yt,disable:Ft,bindFramebuffer:Kt,drawBuffers:Vt,useProgram:he,setBlending:Se,setMaterial:Ie,setFlipSided:tn,setCullFace:Re,setLineWidth:fn,setPolygonOffset:xe,setScissorTest:ln,activeTexture:Je,bindTexture:en,unbindTexture:z,compressedTexImage2D:Rt,compressedTexImage3D:Jt,texImage2D:w,texImage3D:Y,pixelStorei:ct,getParameter:ft,updateUBOMapping:rt,uniformBlockBinding:at,texStorage2D:$t,texStorage3D:L,texSubImage2D:oe,texSubImage3D:wt,compressedTexSubImage2D:ze,compressedTexSubImage3D:Ht,scissor:vt,viewport:Mt,reset:gt}}function QS(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,f=new WeakMap,d=new Set,h,u=new WeakMap,p=new Set,x=new FinalizationRegistry(L=>p.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,w){return m?new OffscreenCanvas(L,w):ra("canvas")}function v(L,w,Y){let ft=1,ct=$t(L);if((ct.width>Y||ct.height>Y)&&(ft=Y/Math.max(ct.width,ct.height)),ft<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let vt=Math.floor(ft*ct.width),Mt=Math.floor(ft*ct.height);h===void 0&&(h=g(vt,Mt));let rt=w?g(vt,Mt):h;return rt.width=vt,rt.height=Mt,rt.getContext("2d").drawImage(L,0,0,vt,Mt),Zt("WebGLRenderer: Texture has been resized from ("+ct.width+"x"+ct.height+") to ("+vt+"x"+Mt+")."),rt}else return"data"in L&&Zt("WebGLRenderer: Image in DataTexture is too big ("+ct.width+"x"+ct.height+")."),L;return L}function b(L){return L.generateMipmaps}function S(L){n.generateMipmap(L)}function E(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(L,w,Y,ft,ct,vt=!1){if(L!==null){if(n[L]!==void 0)return n[L];Zt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let Mt;ft&&(Mt=t.get("EXT_texture_norm16"),Mt||Zt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let rt=w;if(w===n.RED&&(Y===n.FLOAT&&(rt=n.R32F),Y===n.HALF_FLOAT&&(rt=n.R16F),Y===n.UNSIGNED_BYTE&&(rt=n.R8),Y===n.UNSIGNED_SHORT&&Mt&&(rt=Mt.R16_EXT),Y===n.SHORT&&Mt&&(rt=Mt.R16_SNORM_EXT)),w===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(rt=n.R8UI),Y===n.UNSIGNED_SHORT&&(rt=n.R16UI),Y===n.UNSIGNED_INT&&(rt=n.R32UI),Y===n.BYTE&&(rt=n.R8I),Y===n.SHORT&&(rt=n.R16I),Y===n.INT&&(rt=n.R32I)),w===n.RG&&(Y===n.FLOAT&&(rt=n.RG32F),Y===n.HALF_FLOAT&&(rt=n.RG16F),Y===n.UNSIGNED_BYTE&&(rt=n.RG8),Y===n.UNSIGNED_SHORT&&Mt&&(rt=Mt.RG16_EXT),Y===n.SHORT&&Mt&&(rt=Mt.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(rt=n.RG8UI),Y===n.UNSIGNED_SHORT&&(rt=n.RG16UI),Y===n.UNSIGNED_INT&&(rt=n.RG32UI),Y===n.BYTE&&(rt=n.RG8I),Y===n.SHORT&&(rt=n.RG16I),Y===n.INT&&(rt=n.RG32I)),w===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(rt=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(rt=n.RGB16UI),Y===n.UNSIGNED_INT&&(rt=n.RGB32UI),Y===n.BYTE&&(rt=n.RGB8I),Y===n.SHORT&&(rt=n.RGB16I),Y===n.INT&&(rt=n.RGB32I)),w===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(rt=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(rt=n.RGBA16UI),Y===n.UNSIGNED_INT&&(rt=n.RGBA32UI),Y===n.BYTE&&(rt=n.RGBA8I),Y===n.SHORT&&(rt=n.RGBA16I),Y===n.INT&&(rt=n.RGBA32I)),w===n.RGB&&(Y===n.UNSIGNED_SHORT&&Mt&&(rt=Mt.RGB16_EXT),Y===n.SHORT&&Mt&&(rt=Mt.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(rt=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(rt=n.R11F_G11F_B10F)),w===n.RGBA){let at=vt?sa:ve.getTransfer(ct);Y===n.FLOAT&&(rt=n.RGBA32F),Y===n.HALF_FLOAT&&(rt=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(rt=at===Ce?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&Mt&&(rt=Mt.RGBA16_EXT),Y===n.SHORT&&Mt&&(rt=Mt.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(rt=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(rt=n.RGB5_A1)}return(rt===n.R16F||rt===n.R32F||rt===n.RG16F||rt===n.RG32F||rt===n.RGBA16F||rt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),rt}function _(L,w){let Y;return L?w===null||w===Fi||w===yr?Y=n.DEPTH24_STENCIL8:w===Oi?Y=n.DEPTH32F_STENCIL8:w===yo&&(Y=n.DEPTH24_STENCIL8,Zt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Fi||w===yr?Y=n.DEPTH_COMPONENT24:w===Oi?Y=n.DEPTH_COMPONENT32F:w===yo&&(Y=n.DEPTH_COMPONENT16),Y}function M(L,w){return b(L)===!0||L.isFramebufferTexture&&L.minFilter!==Dn&&L.minFilter!==ti?Math.log2(Math.max(w.width,w.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?w.mipmaps.length:1}function C(L){let w=new WeakRef(L);i.get(L).__ref=w,p.add(w),x.register(L,w,w)}function I(L){let w=i.get(L).__ref;w!==void 0&&(p.delete(w),x.unregister(w))}function P(L){B(L.target)}function O(L){N(L.target)}function B(L){L.removeEventListener("dispose",P),I(L),V(L),L.isVideoTexture&&f.delete(L),L.isHTMLTexture&&d.delete(L)}function N(L){L.removeEventListener("dispose",O),I(L),j(L)}function G(){for(let L of p){let w=L.deref();w!==void 0&&(w.isRenderTarget===!0?N(w):B(w))}p.clear(),d.clear()}function V(L){let w=i.get(L);if(w.__webglInit===void 0)return;let Y=L.source,ft=u.get(Y);if(ft){let ct=ft[w.__cacheKey];ct.usedTimes--,ct.usedTimes===0&&F(L),Object.keys(ft).length===0&&u.delete(Y)}i.remove(L)}function F(L){let w=i.get(L);n.deleteTexture(w.__webglTexture);let Y=L.source,ft=u.get(Y);delete ft[w.__cacheKey],o.memory.textures--}function j(L){let w=i.get(L);w.__depthDisposeCallback&&w.__depthDisposeCallback();let Y=L.depthTexture;if(Y&&Y.renderTarget===L&&B(Y),L.isWebGLCubeRenderTarget)for(let ct=0;ct<6;ct++){if(Array.isArray(w.__webglFramebuffer[ct]))for(let vt=0;vt<w.__webglFramebuffer[ct].length;vt++)n.deleteFramebuffer(w.__webglFramebuffer[ct][vt]);else n.deleteFramebuffer(w.__webglFramebuffer[ct]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[ct])}else{if(Array.isArray(w.__webglFramebuffer))for(let ct=0;ct<w.__webglFramebuffer.length;ct++)n.deleteFramebuffer(w.__webglFramebuffer[ct]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ct=0;ct<w.__webglColorRenderbuffer.length;ct++)w.__webglColorRenderbuffer[ct]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[ct]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let ft=L.textures;for(let ct=0,vt=ft.length;ct<vt;ct++){let Mt=i.get(ft[ct]);Mt.__webglTexture&&(n.deleteTexture(Mt.__webglTexture),o.memory.textures--),i.remove(ft[ct])}i.remove(L)}let X=0;function $(){X=0}function tt(){return X}function it(L){X=L}function st(){let L=X;return L>=s.maxTextures&&Zt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,L}function Q(L){let w=[];return w.push(L.wrapS),w.push(L.wrapT),w.push(L.wrapR||0),w.push(L.magFilter),w.push(L.minFilter),w.push(L.anisotropy),w.push(L.internalFormat),w.push(L.format),w.push(L.type),w.push(L.generateMipmaps),w.push(L.mipmapsAutoUpdate),w.push(L.premultiplyAlpha),w.push(L.flipY),w.push(L.unpackAlignment),w.push(L.colorSpace),w.join()}function dt(L,w){let Y=i.get(L);if(L.isVideoTexture&&ze(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Y.__version!==L.version){let ft=L.image;if(ft===null)Zt("WebGLRenderer: Texture marked for update but no image data found.");else if(ft.complete===!1)Zt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ie(Y,L,w);return}}else L.isExternalTexture&&(Y.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+w)}function pt(L,w){let Y=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Y.__version!==L.version){Ie(Y,L,w);return}else L.isExternalTexture&&(Y.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+w)}function _t(L,w){let Y=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Y.__version!==L.version){Ie(Y,L,w);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+w)}function yt(L,w){let Y=i.get(L);if(L.version>0&&Y.__version!==L.version){tn(Y,L,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+w)}let Ft={[Gl]:n.REPEAT,[Ki]:n.CLAMP_TO_EDGE,[Hl]:n.MIRRORED_REPEAT},Kt={[Dn]:n.NEAREST,[Jp]:n.NEAREST_MIPMAP_NEAREST,[Aa]:n.NEAREST_MIPMAP_LINEAR,[ti]:n.LINEAR,[yc]:n.LINEAR_MIPMAP_NEAREST,[ws]:n.LINEAR_MIPMAP_LINEAR},Vt={[tm]:n.NEVER,[nf]:n.ALWAYS,[em]:n.LESS,[tf]:n.LEQUAL,[nm]:n.EQUAL,[ef]:n.GEQUAL,[im]:n.GREATER,[sm]:n.NOTEQUAL};function he(L,w){if(w.type===Oi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===ti||w.magFilter===yc||w.magFilter===Aa||w.magFilter===ws||w.minFilter===ti||w.minFilter===yc||w.minFilter===Aa||w.minFilter===ws)&&Zt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,Ft[w.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,Ft[w.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,Ft[w.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,Kt[w.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,Kt[w.minFilter]),w.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Vt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Dn||w.minFilter!==Aa&&w.minFilter!==ws||w.type===Oi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function ae(L,w){let Y=!1;L.__webglInit===void 0&&(L.__webglInit=!0,w.addEventListener("dispose",P),C(w));let ft=w.source,ct=u.get(ft);ct===void 0&&(ct={},u.set(ft,ct));let vt=Q(w);if(vt!==L.__cacheKey){ct[vt]===void 0&&(ct[vt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),ct[vt].usedTimes++;let Mt=ct[L.__cacheKey];Mt!==void 0&&(ct[L.__cacheKey].usedTimes--,Mt.usedTimes===0&&F(w)),L.__cacheKey=vt,L.__webglTexture=ct[vt].texture}return Y}function Gt(L,w,Y){return Math.floor(Math.floor(L/Y)/w)}function Se(L,w,Y,ft){let vt=L.updateRanges;if(vt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,Y,ft,w.data);else{vt.sort((k,lt)=>k.start-lt.start);let Mt=0;for(let k=1;k<vt.length;k++){let lt=vt[Mt],ot=vt[k],Tt=lt.start+lt.count,xt=Gt(ot.start,w.width,4),bt=Gt(lt.start,w.width,4);ot.start<=Tt+1&&xt===bt&&Gt(ot.start+ot.count-1,w.width,4)===xt?lt.count=Math.max(lt.count,ot.start+ot.count-lt.start):(++Mt,vt[Mt]=ot)}vt.length=Mt+1;let rt=e.getParameter(n.UNPACK_ROW_LENGTH),at=e.getParameter(n.UNPACK_SKIP_PIXELS),gt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,lt=vt.length;k<lt;k++){let ot=vt[k],Tt=Math.floor(ot.start/4),xt=Math.ceil(ot.count/4),bt=Tt%w.width,Wt=Math.floor(Tt/w.width),te=xt,ut=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Wt,te,ut,Y,ft,w.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,rt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,at),e.pixelStorei(n.UNPACK_SKIP_ROWS,gt)}}function Ie(L,w,Y){let ft=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ft=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ft=n.TEXTURE_3D);let ct=ae(L,w),vt=w.source;e.bindTexture(ft,L.__webglTexture,n.TEXTURE0+Y);let Mt=i.get(vt);if(vt.version!==Mt.__version||ct===!0){if(e.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ut=ve.getPrimaries(ve.workingColorSpace),Bt=w.colorSpace===Es?null:ve.getPrimaries(w.colorSpace),ee=w.colorSpace===Es||ut===Bt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let at=v(w.image,!1,s.maxTextureSize);at=Ht(w,at);let gt=r.convert(w.format,w.colorSpace),k=r.convert(w.type),lt=T(w.internalFormat,gt,k,w.normalized,w.colorSpace,w.isVideoTexture);he(ft,w);let ot,Tt=w.mipmaps,xt=w.isVideoTexture!==!0,bt=Mt.__version===void 0||ct===!0,Wt=vt.dataReady,te=M(w,at);if(w.isDepthTexture)lt=_(w.format===Ts,w.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,lt,at.width,at.height):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,gt,k,null));else if(w.isDataTexture)if(Tt.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,te,lt,Tt[0].width,Tt[0].height);for(let ut=0,Bt=Tt.length;ut<Bt;ut++)ot=Tt[ut],xt?Wt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,ot.width,ot.height,gt,k,ot.data):e.texImage2D(n.TEXTURE_2D,ut,lt,ot.width,ot.height,0,gt,k,ot.data);w.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,te,lt,at.width,at.height),Wt&&Se(w,at,gt,k)):e.texImage2D(n.TEXTURE_2D,0,lt,at.width,at.height,0,gt,k,at.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,lt,Tt[0].width,Tt[0].height,at.depth);for(let ut=0,Bt=Tt.length;ut<Bt;ut++)if(ot=Tt[ut],w.format!==zi)if(gt!==null)if(xt){if(Wt)if(w.layerUpdates.size>0){let ee=pf(ot.width,ot.height,w.format,w.type);for(let Ct of w.layerUpdates){let le=ot.data.subarray(Ct*ee/ot.data.BYTES_PER_ELEMENT,(Ct+1)*ee/ot.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,Ct,ot.width,ot.height,1,gt,le)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,ot.width,ot.height,at.depth,gt,ot.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ut,lt,ot.width,ot.height,at.depth,0,ot.data,0,0);else Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Wt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ut,0,0,0,ot.width,ot.height,at.depth,gt,k,ot.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ut,lt,ot.width,ot.height,at.depth,0,gt,k,ot.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,te,lt,Tt[0].width,Tt[0].height);for(let ut=0,Bt=Tt.length;ut<Bt;ut++)ot=Tt[ut],w.format!==zi?gt!==null?xt?Wt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ut,0,0,ot.width,ot.height,gt,ot.data):e.compressedTexImage2D(n.TEXTURE_2D,ut,lt,ot.width,ot.height,0,ot.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Wt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,ot.width,ot.height,gt,k,ot.data):e.texImage2D(n.TEXTURE_2D,ut,lt,ot.width,ot.height,0,gt,k,ot.data)}else if(w.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,te,lt,at.width,at.height,at.depth),Wt)if(w.layerUpdates.size>0){let ut=pf(at.width,at.height,w.format,w.type);for(let Bt of w.layerUpdates){let ee=at.data.subarray(Bt*ut/at.data.BYTES_PER_ELEMENT,(Bt+1)*ut/at.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Bt,at.width,at.height,1,gt,k,ee)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,at.width,at.height,at.depth,gt,k,at.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,lt,at.width,at.height,at.depth,0,gt,k,at.data);else if(w.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,te,lt,at.width,at.height,at.depth),Wt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,at.width,at.height,at.depth,gt,k,at.data)):e.texImage3D(n.TEXTURE_3D,0,lt,at.width,at.height,at.depth,0,gt,k,at.data);else if(w.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,te,lt,at.width,at.height);else{let ut=at.width,Bt=at.height;for(let ee=0;ee<te;ee++)e.texImage2D(n.TEXTURE_2D,ee,lt,ut,Bt,0,gt,k,null),ut>>=1,Bt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ut=n.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),at.parentNode!==ut){ut.appendChild(at),d.add(w),ut.onpaint=Bt=>{let ee=Bt.changedElements;for(let Ct of d)ee.includes(Ct.image)&&(Ct.needsUpdate=!0)},ut.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,at);else{let ee=n.RGBA,Ct=n.RGBA,le=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,ee,Ct,le,at)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(xt&&bt){let ut=$t(Tt[0]);e.texStorage2D(n.TEXTURE_2D,te,lt,ut.width,ut.height)}for(let ut=0,Bt=Tt.length;ut<Bt;ut++)ot=Tt[ut],xt?Wt&&e.texSubImage2D(n.TEXTURE_2D,ut,0,0,gt,k,ot):e.texImage2D(n.TEXTURE_2D,ut,lt,gt,k,ot);w.generateMipmaps=!1}else if(xt){if(bt){let ut=$t(at);e.texStorage2D(n.TEXTURE_2D,te,lt,ut.width,ut.height)}Wt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,gt,k,at)}else e.texImage2D(n.TEXTURE_2D,0,lt,gt,k,at);b(w)&&w.mipmapsAutoUpdate===!0&&S(ft),Mt.__version=vt.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function tn(L,w,Y){if(w.image.length!==6)return;let ft=ae(L,w),ct=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+Y);let vt=i.get(ct);if(ct.version!==vt.__version||ft===!0){e.activeTexture(n.TEXTURE0+Y);let Mt=ve.getPrimaries(ve.workingColorSpace),rt=w.colorSpace===Es?null:ve.getPrimaries(w.colorSpace),at=w.colorSpace===Es||Mt===rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,at);let gt=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,lt=[];for(let Ct=0;Ct<6;Ct++)!gt&&!k?lt[Ct]=v(w.image[Ct],!0,s.maxCubemapSize):lt[Ct]=k?w.image[Ct].image:w.image[Ct],lt[Ct]=Ht(w,lt[Ct]);let ot=lt[0],Tt=r.convert(w.format,w.colorSpace),xt=r.convert(w.type),bt=T(w.internalFormat,Tt,xt,w.normalized,w.colorSpace),Wt=w.isVideoTexture!==!0,te=vt.__version===void 0||ft===!0,ut=ct.dataReady,Bt=M(w,ot);he(n.TEXTURE_CUBE_MAP,w);let ee;if(w.isDepthTexture){if(bt=_(w.format===Ts,w.type),te)if(Wt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,ot.width,ot.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,ot.width,ot.height,0,Tt,xt,null)}else if(gt){Wt&&te&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,bt,ot.width,ot.height);for(let Ct=0;Ct<6;Ct++){ee=lt[Ct].mipmaps;for(let le=0;le<ee.length;le++){let We=ee[le];w.format!==zi?Tt!==null?Wt?ut&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,We.width,We.height,Tt,We.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,We.width,We.height,0,We.data):Zt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,We.width,We.height,Tt,xt,We.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,We.width,We.height,0,Tt,xt,We.data)}}}else{if(ee=w.mipmaps,Wt&&te){ee.length>0&&Bt++;let Ct=$t(lt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(k){Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,lt[Ct].width,lt[Ct].height,Tt,xt,lt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,lt[Ct].width,lt[Ct].height,0,Tt,xt,lt[Ct].data);for(let le=0;le<ee.length;le++){let Xn=ee[le].image[Ct].image;Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,Xn.width,Xn.height,Tt,xt,Xn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,Xn.width,Xn.height,0,Tt,xt,Xn.data)}}else{Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Tt,xt,lt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,Tt,xt,lt[Ct]);for(let le=0;le<ee.length;le++){let We=ee[le];Wt?ut&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,Tt,xt,We.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,Tt,xt,We.image[Ct])}}}b(w)&&w.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),vt.__version=ct.version,w.onUpdate&&w.onUpdate(w)}L.__version=w.version}function Re(L,w,Y,ft,ct,vt){let Mt=r.convert(Y.format,Y.colorSpace),rt=r.convert(Y.type),at=T(Y.internalFormat,Mt,rt,Y.normalized,Y.colorSpace),gt=i.get(w),k=i.get(Y);if(k.__renderTarget=w,!gt.__hasExternalTextures){let lt=Math.max(1,w.width>>vt),ot=Math.max(1,w.height>>vt);ct===n.TEXTURE_3D||ct===n.TEXTURE_2D_ARRAY?e.texImage3D(ct,vt,at,lt,ot,w.depth,0,Mt,rt,null):e.texImage2D(ct,vt,at,lt,ot,0,Mt,rt,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ft,ct,k.__webglTexture,0,oe(w)):(ct===n.TEXTURE_2D||ct>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ct<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ft,ct,k.__webglTexture,vt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function fn(L,w,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,L),w.depthBuffer){let ft=w.depthTexture,ct=ft&&ft.isDepthTexture?ft.type:null,vt=_(w.stencilBuffer,ct),Mt=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,oe(w),vt,w.width,w.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,oe(w),vt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,vt,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Mt,n.RENDERBUFFER,L)}else{let ft=w.textures;for(let ct=0;ct<ft.length;ct++){let vt=ft[ct],Mt=r.convert(vt.format,vt.colorSpace),rt=r.convert(vt.type),at=T(vt.internalFormat,Mt,rt,vt.normalized,vt.colorSpace);wt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,oe(w),at,w.width,w.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,oe(w),at,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,at,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function xe(L,w,Y){let ft=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ct=i.get(w.depthTexture);ct.__renderTarget=w;let vt=ft?w.depthTexture.image[0]:w.depthTexture.image;(!ct.__webglTexture||vt.width!==w.width||vt.height!==w.height)&&(vt.width=w.width,vt.height=w.height,w.depthTexture.needsUpdate=!0),ft?yt(w.depthTexture,0):dt(w.depthTexture,0);let Mt=ct.__webglTexture,rt=oe(w),at=ft?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,gt=w.depthTexture.format===Ts?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===vs)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,at,Mt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,gt,at,Mt,0);else if(w.depthTexture.format===Ts)wt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,gt,at,Mt,0,rt):n.framebufferTexture2D(n.FRAMEBUFFER,gt,at,Mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function ln(L){let w=i.get(L),Y=L.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==L.depthTexture){let ft=L.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ft){let ct=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ft.removeEventListener("dispose",ct)};ft.addEventListener("dispose",ct),w.__depthDisposeCallback=ct}w.__boundDepthTexture=ft}if(L.depthTexture&&!w.__autoAllocateDepthBuffer)if(Y)for(let ft=0;ft<6;ft++)xe(w.__webglFramebuffer[ft],L,ft);else L.texture.mipmaps.length>0?xe(w.__webglFramebuffer[0],L,0):xe(w.__webglFramebuffer,L,0);else if(Y){w.__webglDepthbuffer=[];for(let ft=0;ft<6;ft++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[ft]),w.__webglDepthbuffer[ft]===void 0)w.__webglDepthbuffer[ft]=n.createRenderbuffer(),fn(w.__webglDepthbuffer[ft],L,!1);else{let ct=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=w.__webglDepthbuffer[ft];n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,vt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),fn(w.__webglDepthbuffer,L,!1);else{let ct=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,vt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ct,n.RENDERBUFFER,vt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Je(L,w,Y){let ft=i.get(L);w!==void 0&&Re(ft.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&ln(L)}function en(L){let w=L.texture,Y=i.get(L),ft=i.get(w);L.addEventListener("dispose",O),C(L);let ct=L.textures,vt=L.isWebGLCubeRenderTarget===!0,Mt=ct.length>1;if(Mt||(ft.__webglTexture===void 0&&(ft.__webglTexture=n.createTexture()),ft.__version=w.version,o.memory.textures++),vt){Y.__webglFramebuffer=[];for(let rt=0;rt<6;rt++)if(w.mipmaps.length>0){Y.__webglFramebuffer[rt]=[];for(let at=0;at<w.mipmaps.length;at++)Y.__webglFramebuffer[rt][at]=n.createFramebuffer()}else Y.__webglFramebuffer[rt]=n.createFramebuffer()}else{if(w.mipmaps.length>0){Y.__webglFramebuffer=[];for(let rt=0;rt<w.mipmaps.length;rt++)Y.__webglFramebuffer[rt]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(Mt)for(let rt=0,at=ct.length;rt<at;rt++){let gt=i.get(ct[rt]);gt.__webglTexture===void 0&&(gt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&wt(L)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let rt=0;rt<ct.length;rt++){let at=ct[rt];Y.__webglColorRenderbuffer[rt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[rt]);let gt=r.convert(at.format,at.colorSpace),k=r.convert(at.type),lt=T(at.internalFormat,gt,k,at.normalized,at.colorSpace,L.isXRRenderTarget===!0),ot=oe(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,ot,lt,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+rt,n.RENDERBUFFER,Y.__webglColorRenderbuffer[rt])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),fn(Y.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(vt){e.bindTexture(n.TEXTURE_CUBE_MAP,ft.__webglTexture),he(n.TEXTURE_CUBE_MAP,w);for(let rt=0;rt<6;rt++)if(w.mipmaps.length>0)for(let at=0;at<w.mipmaps.length;at++)Re(Y.__webglFramebuffer[rt][at],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,at);else Re(Y.__webglFramebuffer[rt],L,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0);b(w)?S(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(Mt){for(let rt=0,at=ct.length;rt<at;rt++){let gt=ct[rt],k=i.get(gt),lt=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(lt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(lt,k.__webglTexture),he(lt,gt),Re(Y.__webglFramebuffer,L,gt,n.COLOR_ATTACHMENT0+rt,lt,0),b(gt)&&S(lt)}e.unbindTexture()}else{let rt=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(rt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,ft.__webglTexture),he(rt,w),w.mipmaps.length>0)for(let at=0;at<w.mipmaps.length;at++)Re(Y.__webglFramebuffer[at],L,w,n.COLOR_ATTACHMENT0,rt,at);else Re(Y.__webglFramebuffer,L,w,n.COLOR_ATTACHMENT0,rt,0);b(w)?S(rt):w.mipmaps.length>0&&n.texParameteri(rt,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&ln(L)}function z(L){let w=L.textures;for(let Y=0,ft=w.length;Y<ft;Y++){let ct=w[Y];if(b(ct)&&ct.mipmapsAutoUpdate===!0){let vt=E(L),Mt=i.get(ct).__webglTexture;e.bindTexture(vt,Mt),S(vt),e.unbindTexture()}}}let Rt=[];function Jt(L){if(L.samples>0){if(wt(L)===!1){let w=L.textures,Y=L.width,ft=L.height,ct=n.COLOR_BUFFER_BIT,vt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Mt=i.get(L),rt=w.length>1;if(rt)for(let gt=0;gt<w.length;gt++)e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglFramebuffer);for(let gt=0;gt<w.length;gt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ct|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ct|=n.STENCIL_BUFFER_BIT)),rt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[gt]);let k=i.get(w[gt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,Y,ft,0,0,Y,ft,ct,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+gt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Rt.push(vt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),rt)for(let gt=0;gt<w.length;gt++){e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.RENDERBUFFER,Mt.__webglColorRenderbuffer[gt]);let k=i.get(w[gt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Mt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+gt,n.TEXTURE_2D,k,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Mt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let w=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function oe(L){return Math.min(s.maxSamples,L.samples)}function wt(L){let w=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function ze(L){let w=o.render.frame;f.get(L)!==w&&(f.set(L,w),L.update())}function Ht(L,w){let Y=L.colorSpace,ft=L.format,ct=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Y!==ia&&Y!==Es&&(ve.getTransfer(Y)===Ce?(ft!==zi||ct!==ri)&&Zt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ne("WebGLTextures: Unsupported texture color space:",Y)),w}function $t(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=st,this.resetTextureUnits=$,this.getTextureUnits=tt,this.setTextureUnits=it,this.setTexture2D=dt,this.setTexture2DArray=pt,this.setTexture3D=_t,this.setTextureCube=yt,this.rebindTextures=Je,this.setupRenderTarget=en,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Jt,this.setupDepthRenderbuffer=ln,this.setupFrameBufferTexture=Re,this.useMultisampledRTT=wt,this.dispose=G}function tb(n,t){function e(i,s=Es){let r,o=ve.getTransfer(s);if(i===ri)return n.UNSIGNED_BYTE;if(i===Mc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Sc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Zu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ju)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Yu)return n.BYTE;if(i===$u)return n.SHORT;if(i===yo)return n.UNSIGNED_SHORT;if(i===vc)return n.INT;if(i===Fi)return n.UNSIGNED_INT;if(i===Oi)return n.FLOAT;if(i===Bi)return n.HALF_FLOAT;if(i===Ku)return n.ALPHA;if(i===ju)return n.RGB;if(i===zi)return n.RGBA;if(i===vs)return n.DEPTH_COMPONENT;if(i===Ts)return n.DEPTH_STENCIL;if(i===Qu)return n.RED;if(i===bc)return n.RED_INTEGER;if(i===$s)return n.RG;if(i===wc)return n.RG_INTEGER;if(i===Tc)return n.RGBA_INTEGER;if(i===Ra||i===Ca||i===Pa||i===Ia)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ra)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ca)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ra)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ca)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Pa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ia)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ec||i===Ac||i===Rc||i===Cc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ec)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Ac)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Rc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Cc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Pc||i===Ic||i===Lc||i===Dc||i===Nc||i===La||i===Uc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Pc||i===Ic)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Lc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Dc)return r.COMPRESSED_R11_EAC;if(i===Nc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===La)return r.COMPRESSED_RG11_EAC;if(i===Uc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Fc||i===Oc||i===Bc||i===zc||i===kc||i===Vc||i===Gc||i===Hc||i===Wc||i===Xc||i===qc||i===Yc||i===$c||i===Zc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Fc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Oc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===zc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===kc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Vc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Gc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Hc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Wc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Xc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===qc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Yc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===$c)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Zc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Jc||i===Kc||i===jc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Jc)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Kc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===jc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Qc||i===th||i===Da||i===eh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Qc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===th)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Da)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===eh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===yr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var eb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,nb=`
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

}`,bf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new _a(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new ts({vertexShader:eb,fragmentShader:nb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Hn(new xa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},wf=class extends Ui{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,f=null,d=null,h=null,u=null,p=null,x=typeof XRWebGLBinding<"u",m=new bf,g={},v=e.getContextAttributes(),b=null,S=null,E=[],T=[],_=new Yt,M=null,C=null,I=new jn;I.viewport=new je;let P=new jn;P.viewport=new je;let O=[I,P],B=new mc,N=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let dt=E[Q];return dt===void 0&&(dt=new ho,E[Q]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(Q){let dt=E[Q];return dt===void 0&&(dt=new ho,E[Q]=dt),dt.getGripSpace()},this.getHand=function(Q){let dt=E[Q];return dt===void 0&&(dt=new ho,E[Q]=dt),dt.getHandSpace()};function V(Q){let dt=T.indexOf(Q.inputSource);if(dt===-1)return;let pt=E[dt];pt!==void 0&&(pt.update(Q.inputSource,Q.frame,c||o),pt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function F(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",F),s.removeEventListener("inputsourceschange",j);for(let Q=0;Q<E.length;Q++){let dt=T[Q];dt!==null&&(T[Q]=null,E[Q].disconnect(dt))}N=null,G=null,m.reset();for(let Q in g)delete g[Q];if(t.setRenderTarget(b),u=null,h=null,d=null,s=null,S=null,st.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(_.width,_.height,!1),C!==null){let Q=C.camera;Q.fov=C.fov,Q.zoom=C.zoom,Q.updateProjectionMatrix(),C=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Zt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Zt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:u},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",F),s.addEventListener("inputsourceschange",j),v.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let pt=null,_t=null,yt=null;v.depth&&(yt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,pt=v.stencil?Ts:vs,_t=v.stencil?yr:Fi);let Ft={colorFormat:e.RGBA8,depthFormat:yt,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ft),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),S=new gi(h.textureWidth,h.textureHeight,{format:zi,type:ri,depthTexture:new Ss(h.textureWidth,h.textureHeight,_t,void 0,void 0,void 0,void 0,void 0,void 0,pt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let pt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};u=new XRWebGLLayer(s,e,pt),s.updateRenderState({baseLayer:u}),t.setPixelRatio(1),t.setSize(u.framebufferWidth,u.framebufferHeight,!1),S=new gi(u.framebufferWidth,u.framebufferHeight,{format:zi,type:ri,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),st.setContext(s),st.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(Q){for(let dt=0;dt<Q.removed.length;dt++){let pt=Q.removed[dt],_t=T.indexOf(pt);_t>=0&&(T[_t]=null,E[_t].disconnect(pt))}for(let dt=0;dt<Q.added.length;dt++){let pt=Q.added[dt],_t=T.indexOf(pt);if(_t===-1){for(let Ft=0;Ft<E.length;Ft++)if(Ft>=T.length){T.push(pt),_t=Ft;break}else if(T[Ft]===null){T[Ft]=pt,_t=Ft;break}if(_t===-1)break}let yt=E[_t];yt&&yt.connect(pt)}}function X(Q,dt){dt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(dt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let dt=Q.near,pt=Q.far;m.texture!==null&&(m.depthNear>0&&(dt=m.depthNear),m.depthFar>0&&(pt=m.depthFar)),B.near=P.near=I.near=dt,B.far=P.far=I.far=pt,(N!==B.near||G!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),N=B.near,G=B.far),B.layers.mask=Q.layers.mask|6,I.layers.mask=B.layers.mask&-5,P.layers.mask=B.layers.mask&-3;let _t=Q.parent,yt=B.cameras;X(B,_t);for(let Ft=0;Ft<yt.length;Ft++)X(yt[Ft],_t);B.projectionMatrix.copy(I.projectionMatrix),B.projectionMatrixInverse.copy(I.projectionMatrixInverse),C===null&&Q.isPerspectiveCamera&&(C={camera:Q,fov:Q.fov,zoom:Q.zoom}),$(Q,B,_t)};function $(Q,dt,pt){pt===null?Q.matrix.copy(dt.matrixWorld):(Q.matrix.copy(pt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(dt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(dt.projectionMatrix),Q.projectionMatrixInverse.copy(dt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=lo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(h===null&&u===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),u!==null&&u.fixedFoveation!==void 0&&(u.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(Q){return g[Q]};let tt=null;function it(Q,dt){if(f=dt.getViewerPose(c||o),p=dt,f!==null){let pt=f.views;u!==null&&(t.setRenderTargetFramebuffer(S,u.framebuffer),t.setRenderTarget(S));let _t=!1;pt.length!==B.cameras.length&&(B.cameras.length=0,_t=!0);for(let Vt=0;Vt<pt.length;Vt++){let he=pt[Vt],ae=null;if(u!==null)ae=u.getViewport(he);else{let Se=d.getViewSubImage(h,he);ae=Se.viewport,Vt===0&&(t.setRenderTargetTextures(S,Se.colorTexture,Se.depthStencilTexture),t.setRenderTarget(S))}let Gt=O[Vt];Gt===void 0&&(Gt=new jn,Gt.layers.enable(Vt),Gt.viewport=new je,O[Vt]=Gt),Gt.matrix.fromArray(he.transform.matrix),Gt.matrix.decompose(Gt.position,Gt.quaternion,Gt.scale),Gt.projectionMatrix.fromArray(he.projectionMatrix),Gt.projectionMatrixInverse.copy(Gt.projectionMatrix).invert(),Gt.viewport.set(ae.x,ae.y,ae.width,ae.height),Vt===0&&(B.matrix.copy(Gt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),_t===!0&&B.cameras.push(Gt)}let yt=s.enabledFeatures;if(yt&&yt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){d=i.getBinding();let Vt=d.getDepthInformation(pt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(yt&&yt.includes("camera-access")&&x){t.state.unbindTexture(),d=i.getBinding();for(let Vt=0;Vt<pt.length;Vt++){let he=pt[Vt].camera;if(he){let ae=g[he];ae||(ae=new _a,g[he]=ae);let Gt=d.getCameraImage(he);ae.sourceTexture=Gt}}}}for(let pt=0;pt<E.length;pt++){let _t=T[pt],yt=E[pt];_t!==null&&yt!==void 0&&yt.update(_t,dt,c||o)}tt&&tt(Q,dt),dt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:dt}),p=null}let st=new Um;st.setAnimationLoop(it),this.setAnimationLoop=function(Q){tt=Q},this.dispose=function(){}}},ib=new He,Xm=new se;Xm.set(-1,0,0,0,1,0,0,0,1);function sb(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,uf(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,b,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),f(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),h(m,g),g.isMeshPhysicalMaterial&&u(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,v,b):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ni&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ni&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=t.get(g),b=v.envMap,S=v.envMapRotation;b&&(m.envMap.value=b,m.envMapRotation.value.setFromMatrix4(ib.makeRotationFromEuler(S)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Xm),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,v,b){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=b*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function f(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function h(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function u(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ni&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let v=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function rb(n,t,e,i){let s={},r={};function o(v,b){let S=b.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,b){let S=s[v.id];S===void 0&&(p(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",m));let E=b.program;i.updateUBOMapping(v,E);let T=t.render.frame;r[v.id]!==T&&(c(v),r[v.id]=T)}function l(v){let b=n.createBuffer(),S=v.__size,E=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,S,E),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function c(v){let b=s[v.id],S=v.uniforms,E=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let T=0,_=S.length;T<_;T++){let M=S[T];if(Array.isArray(M))for(let C=0,I=M.length;C<I;C++)f(M[C],T,C,E);else f(M,T,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(v,b,S,E){if(h(v,b,S,E)===!0){let T=v.__offset,_=v.value;if(Array.isArray(_)){let M=0;for(let C=0;C<_.length;C++){let I=_[C],P=x(I,!0);d(I,v.__data,M),M+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,v.__data)}}function d(v,b,S){typeof v=="number"||typeof v=="boolean"?b[S]=v:v.isMatrix3?(b[S]=v.elements[0],b[S+1]=v.elements[1],b[S+2]=v.elements[2],b[S+3]=0,b[S+4]=v.elements[3],b[S+5]=v.elements[4],b[S+6]=v.elements[5],b[S+7]=0,b[S+8]=v.elements[6],b[S+9]=v.elements[7],b[S+10]=v.elements[8],b[S+11]=0):ArrayBuffer.isView(v)?b.set(v.subarray(0,b.length-S),S):v.toArray(b,S)}function h(v,b,S,E){let T=v.value,_=b+"_"+S;if(Array.isArray(T)){E[_]===void 0&&(E[_]=[]);let M=E[_],C=!1;for(let I=0;I<T.length;I++)u(T[I],M,I)===!0&&(C=!0);return C}return u(T,E,_)}function u(v,b,S){if(b[S]===void 0)return typeof v=="number"||typeof v=="boolean"?b[S]=v:ArrayBuffer.isView(v)?b[S]=v.slice():b[S]=v.clone(),!0;{let E=b[S];if(typeof v=="number"||typeof v=="boolean"){if(E!==v)return b[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(E.equals(v)===!1)return E.copy(v),!0}}return!1}function p(v){let b=v.uniforms,S=0,E=16;for(let _=0,M=b.length;_<M;_++){let C=Array.isArray(b[_])?b[_]:[b[_]];for(let I=0,P=C.length;I<P;I++){let O=C[I],B=Array.isArray(O.value)?O.value:[O.value],N=Array.isArray(b[_])||Array.isArray(O.value),G=S;for(let F=0,j=B.length;F<j;F++){let X=B[F],$=x(X,N),tt=S%E,it=tt%$.boundary,st=tt+it;S+=it,st!==0&&E-st<$.storage&&(S+=E-st),F===0&&(G=S),S+=$.storage}let V=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new V((S-G)/Float32Array.BYTES_PER_ELEMENT),O.__offset=G}}let T=S%E;return T>0&&(S+=E-T),v.__size=S,v.__cache={},this}function x(v,b){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Zt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Zt("WebGLRenderer: Unsupported uniform value type.",v),b===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let b=v.target;b.removeEventListener("dispose",m),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function g(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var ob=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function ab(){return is===null&&(is=new Jl(ob,16,16,$s,Bi),is.name="DFG_LUT",is.minFilter=ti,is.magFilter=ti,is.wrapS=Ki,is.wrapT=Ki,is.generateMipmaps=!1,is.needsUpdate=!0),is}var ah=class{constructor(t={}){let{canvas:e=rm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:f="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:u=ri}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=u,m=new Set([Tc,wc,bc]),g=new Set([ri,Fi,yo,yr,Mc,Sc]),v=new Uint32Array(4),b=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},E=null,T=null,_=[],M=[],C=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,P=!1,O=null,B=null,N=null,G=null;this._outputColorSpace=di;let V=0,F=0,j=null,X=-1,$=null,tt=new je,it=new je,st=null,Q=new ce(0),dt=0,pt=e.width,_t=e.height,yt=1,Ft=null,Kt=null,Vt=new je(0,0,pt,_t),he=new je(0,0,pt,_t),ae=!1,Gt=new Vs,Se=new Kl,Ie=!1,tn=!1,Re=new He,fn=new q,xe=new je,ln={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Je=!1;function en(){return j===null?yt:1}let z=i;function Rt(R,H){return e.getContext(R,H)}let Jt,oe,wt,ze,Ht,$t,L,w,Y,ft,ct,vt,Mt,rt,at,gt,k,lt,ot,Tt,xt,bt,Wt;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:f,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),z===null){let H="webgl2";if(z=Rt(H,R),z===null)throw Rt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(R){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ne("WebGLRenderer: "+R.message),R}function te(){Jt=new xM(z),Jt.init(),xt=new tb(z,Jt),oe=new aM(z,Jt,t,xt),wt=new jS(z,Jt),oe.reversedDepthBuffer&&h&&wt.buffers.depth.setReversed(!0),B=z.createFramebuffer(),N=z.createFramebuffer(),G=z.createFramebuffer(),ze=new MM(z),Ht=new BS,$t=new QS(z,Jt,wt,Ht,oe,xt,ze),L=new _M(I),w=new bx(z),bt=new rM(z,w),Y=new yM(z,w,ze,bt),ft=new bM(z,Y,w,bt,ze),lt=new SM(z,oe,$t),at=new lM(Ht),ct=new OS(I,L,Jt,oe,bt,at),vt=new sb(I,Ht),Mt=new kS,rt=new qS(Jt),k=new sM(I,L,wt,ft,p,l),gt=new KS(I,ft,oe),Wt=new rb(z,ze,oe,wt),ot=new oM(z,Jt,ze),Tt=new vM(z,Jt,ze),ze.programs=ct.programs,I.capabilities=oe,I.extensions=Jt,I.properties=Ht,I.renderLists=Mt,I.shadowMap=gt,I.state=wt,I.info=ze}x!==ri&&(C=new TM(x,e.width,e.height,a,s,r));let ut=new wf(I,z);this.xr=ut,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let R=Jt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Jt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return yt},this.setPixelRatio=function(R){R!==void 0&&(yt=R,this.setSize(pt,_t,!1))},this.getSize=function(R){return R.set(pt,_t)},this.setSize=function(R,H,nt=!0){if(ut.isPresenting){Zt("WebGLRenderer: Can't change size while VR device is presenting.");return}pt=R,_t=H,e.width=Math.floor(R*yt),e.height=Math.floor(H*yt),nt===!0&&(e.style.width=R+"px",e.style.height=H+"px"),C!==null&&C.setSize(e.width,e.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(pt*yt,_t*yt).floor()},this.setDrawingBufferSize=function(R,H,nt){pt=R,_t=H,yt=nt,e.width=Math.floor(R*nt),e.height=Math.floor(H*nt),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(x===ri){ne("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){Zt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}C.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(tt)},this.getViewport=function(R){return R.copy(Vt)},this.setViewport=function(R,H,nt,Z){R.isVector4?Vt.set(R.x,R.y,R.z,R.w):Vt.set(R,H,nt,Z),wt.viewport(tt.copy(Vt).multiplyScalar(en()).round())},this.getScissor=function(R){return R.copy(he)},this.setScissor=function(R,H,nt,Z){R.isVector4?he.set(R.x,R.y,R.z,R.w):he.set(R,H,nt,Z),wt.scissor(it.copy(he).multiplyScalar(en()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(R){wt.setScissorTest(ae=R)},this.setOpaqueSort=function(R){Ft=R},this.setTransparentSort=function(R){Kt=R},this.getClearColor=function(R){return R.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,nt=!0){let Z=0;if(R){let J=!1;if(j!==null){let Et=j.texture.format;J=m.has(Et)}if(J){let Et=j.texture.type,Pt=g.has(Et),At=k.getClearColor(),It=k.getClearAlpha(),kt=At.r,ie=At.g,de=At.b;Pt?(v[0]=kt,v[1]=ie,v[2]=de,v[3]=It,z.clearBufferuiv(z.COLOR,0,v)):(b[0]=kt,b[1]=ie,b[2]=de,b[3]=It,z.clearBufferiv(z.COLOR,0,b))}else Z|=z.COLOR_BUFFER_BIT}H&&(Z|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),nt&&(Z|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&z.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),k.dispose(),Mt.dispose(),rt.dispose(),$t.dispose(),Ht.dispose(),L.dispose(),ft.dispose(),Y.dispose(),bt.dispose(),Wt.dispose(),ct.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Ka),ut.removeEventListener("sessionend",Hi),ls.stop()};function Bt(R){R.preventDefault(),oa("WebGLRenderer: Context Lost."),P=!0}function ee(){oa("WebGLRenderer: Context Restored."),P=!1;let R=ze.autoReset,H=gt.enabled,nt=gt.autoUpdate,Z=gt.needsUpdate,J=gt.type;te(),ze.autoReset=R,gt.enabled=H,gt.autoUpdate=nt,gt.needsUpdate=Z,gt.type=J}function Ct(R){ne("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function le(R){let H=R.target;H.removeEventListener("dispose",le),We(H)}function We(R){Xn(R),Ht.remove(R)}function Xn(R){let H=Ht.get(R).programs;H!==void 0&&(H.forEach(function(nt){ct.releaseProgram(nt)}),R.isShaderMaterial&&ct.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,nt,Z,J,Et){H===null&&(H=ln);let Pt=J.isMesh&&J.matrixWorld.determinantAffine()<0,At=Bo(R,H,nt,Z,J);wt.setMaterial(Z,Pt);let It=nt.index,kt=1;if(Z.wireframe===!0){if(It=Y.getWireframeAttribute(nt),It===void 0)return;kt=2}let ie=nt.drawRange,de=nt.attributes.position,zt=ie.start*kt,pe=(ie.start+ie.count)*kt;Et!==null&&(zt=Math.max(zt,Et.start*kt),pe=Math.min(pe,(Et.start+Et.count)*kt)),It!==null?(zt=Math.max(zt,0),pe=Math.min(pe,It.count)):de!=null&&(zt=Math.max(zt,0),pe=Math.min(pe,de.count));let Qe=pe-zt;if(Qe<0||Qe===1/0)return;bt.setup(J,Z,At,nt,It);let Le,De=ot;if(It!==null&&(Le=w.get(It),De=Tt,De.setIndex(Le)),J.isMesh)Z.wireframe===!0?(wt.setLineWidth(Z.wireframeLinewidth*en()),De.setMode(z.LINES)):De.setMode(z.TRIANGLES);else if(J.isLine){let vn=Z.linewidth;vn===void 0&&(vn=1),wt.setLineWidth(vn*en()),J.isLineSegments?De.setMode(z.LINES):J.isLineLoop?De.setMode(z.LINE_LOOP):De.setMode(z.LINE_STRIP)}else J.isPoints?De.setMode(z.POINTS):J.isSprite&&De.setMode(z.TRIANGLES);if(J.isBatchedMesh)if(Jt.get("WEBGL_multi_draw"))De.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let vn=J._multiDrawStarts,Ut=J._multiDrawCounts,dn=J._multiDrawCount,ye=It?w.get(It).bytesPerElement:1,hs=Ht.get(Z).currentProgram.getUniforms();for(let pn=0;pn<dn;pn++)hs.setValue(z,"_gl_DrawID",pn),De.render(vn[pn]/ye,Ut[pn])}else if(J.isInstancedMesh)De.renderInstances(zt,Qe,J.count);else if(nt.isInstancedBufferGeometry){let vn=nt._maxInstanceCount!==void 0?nt._maxInstanceCount:1/0,Ut=Math.min(nt.instanceCount,vn);De.renderInstances(zt,Qe,Ut)}else De.render(zt,Qe)};function Uo(R,H,nt,Z){O!==null&&R.isNodeMaterial&&O.setObject(Z,R),Ie===!0&&at.setState(R,nt,!1),R.transparent===!0&&R.side===si&&R.forceSinglePass===!1?(R.side=ni,R.needsUpdate=!0,Wi(R,H,Z),R.side=es,R.needsUpdate=!0,Wi(R,H,Z),R.side=si):Wi(R,H,Z)}this.compile=function(R,H,nt=null){nt===null&&(nt=R),O!==null&&O.renderStart(R,H,nt),T=rt.get(nt),T.init(H),M.push(T),nt.traverseVisible(function(J){J.isLight&&J.layers.test(H.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),R!==nt&&R.traverseVisible(function(J){J.isLight&&J.layers.test(H.layers)&&(T.pushLight(J),J.castShadow&&T.pushShadow(J))}),T.setupLights(),O!==null&&O.updateLights(T.state.lightsArray),tn=this.localClippingEnabled,Ie=at.init(this.clippingPlanes,tn),Ie===!0&&at.setGlobalState(this.clippingPlanes,H),O!==null&&gt.render(T.state.shadowsArray,nt,H);let Z=new Set;return R.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Et=J.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let At=Et[Pt];Uo(At,nt,H,J),Z.add(At)}else Uo(Et,nt,H,J),Z.add(Et)}),T=M.pop(),O!==null&&O.renderEnd(),Z},this.compileAsync=function(R,H,nt=null){let Z=this.compile(R,H,nt);return new Promise(J=>{function Et(){if(Z.forEach(function(Pt){let It=Ht.get(Pt).currentProgram;(It===void 0||It.isReady())&&Z.delete(Pt)}),Z.size===0){J(R);return}setTimeout(Et,10)}Jt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Rr=null;function Yh(R){Rr&&Rr(R)}function Ka(){ls.stop()}function Hi(){ls.start()}let ls=new Um;ls.setAnimationLoop(Yh),typeof self<"u"&&ls.setContext(self),this.setAnimationLoop=function(R){Rr=R,ut.setAnimationLoop(R),R===null?ls.stop():ls.start()},ut.addEventListener("sessionstart",Ka),ut.addEventListener("sessionend",Hi),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){ne("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(R,H);let nt=ut.enabled===!0&&ut.isPresenting===!0,Z=C!==null&&(j===null||nt)&&C.begin(I,j);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(C===null||C.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(H),H=ut.getCamera()),R.isScene===!0&&R.onBeforeRender(I,R,H,j),T=rt.get(R,M.length),T.init(H),T.state.textureUnits=$t.getTextureUnits(),M.push(T),Re.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Se.setFromArrayCamera(H):Gt.setFromProjectionMatrix(Re,Ti,H.reversedDepth),tn=this.localClippingEnabled,Ie=at.init(this.clippingPlanes,tn),E=Mt.get(R,_.length),E.init(),_.push(E),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Pt=I.xr.getDepthSensingMesh();Pt!==null&&cs(Pt,H,-1/0,I.sortObjects)}cs(R,H,0,I.sortObjects),E.finish(),O!==null&&O.updateLights(T.state.lightsArray),I.sortObjects===!0&&E.sort(Ft,Kt),Je=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Je&&k.addToRenderList(E,R),this.info.autoReset===!0&&this.info.reset(),Ie===!0&&at.beginShadows();let J=T.state.shadowsArray;if(gt.render(J,R,H),Ie===!0&&at.endShadows(),(Z&&C.hasRenderPass())===!1){let Pt=E.opaque,At=E.transmissive;if(T.setupLights(),H.isArrayCamera){let It=H.cameras;if(At.length>0)for(let kt=0,ie=It.length;kt<ie;kt++){let de=It[kt];Ci(Pt,At,R,de)}Je&&k.render(R);for(let kt=0,ie=It.length;kt<ie;kt++){let de=It[kt];Fo(E,R,de,de.viewport)}}else At.length>0&&Ci(Pt,At,R,H),Je&&k.render(R),Fo(E,R,H)}j!==null&&F===0&&($t.updateMultisampleRenderTarget(j),$t.updateRenderTargetMipmap(j)),Z&&C.end(I),R.isScene===!0&&R.onAfterRender(I,R,H),bt.resetDefaultState(),X=-1,$=null,M.pop(),M.length>0?(T=M[M.length-1],$t.setTextureUnits(T.state.textureUnits),Ie===!0&&at.setGlobalState(I.clippingPlanes,T.state.camera)):T=null,_.pop(),_.length>0?E=_[_.length-1]:E=null,O!==null&&O.renderEnd()};function cs(R,H,nt,Z){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)nt=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)T.pushLight(R),R.castShadow&&T.pushShadow(R);else if(R.isSprite){let Pt=H.isArrayCamera?Se:Gt;if(!R.frustumCulled||R.intersectsFrustum(Pt)){Z&&xe.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Re);let At=ft.update(R),It=R.material;It.visible&&E.push(R,At,It,nt,xe.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Pt=H.isArrayCamera?Se:Gt;if(!R.frustumCulled||R.intersectsFrustum(Pt)){let At=ft.update(R),It=R.material;if(Z&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),xe.copy(R.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),xe.copy(At.boundingSphere.center)),xe.applyMatrix4(R.matrixWorld).applyMatrix4(Re)),Array.isArray(It)){let kt=At.groups;for(let ie=0,de=kt.length;ie<de;ie++){let zt=kt[ie],pe=It[zt.materialIndex];pe&&pe.visible&&E.push(R,At,pe,nt,xe.z,zt,H)}}else It.visible&&E.push(R,At,It,nt,xe.z,null,H)}}}let Et=R.children;for(let Pt=0,At=Et.length;Pt<At;Pt++)cs(Et[Pt],H,nt,Z)}function Fo(R,H,nt,Z){let{opaque:J,transmissive:Et,transparent:Pt}=R;T.setupLightsView(nt),Ie===!0&&at.setGlobalState(I.clippingPlanes,nt),Z&&wt.viewport(tt.copy(Z)),J.length>0&&nn(J,H,nt),Et.length>0&&nn(Et,H,nt),Pt.length>0&&nn(Pt,H,nt),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ci(R,H,nt,Z){if((nt.isScene===!0?nt.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Z.id]===void 0){let zt=Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Z.id]=new gi(1,1,{generateMipmaps:!0,type:zt?Bi:ri,minFilter:ws,samples:Math.max(4,oe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ve.workingColorSpace})}let Et=T.state.transmissionRenderTarget[Z.id],Pt=Z.viewport||tt;Et.setSize(Pt.z*I.transmissionResolutionScale,Pt.w*I.transmissionResolutionScale);let At=I.getRenderTarget(),It=I.getActiveCubeFace(),kt=I.getActiveMipmapLevel();I.setRenderTarget(Et),I.getClearColor(Q),dt=I.getClearAlpha(),dt<1&&I.setClearColor(16777215,.5),I.clear(),Je&&k.render(nt);let ie=I.toneMapping;I.toneMapping=ns;let de=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),T.setupLightsView(Z),Ie===!0&&at.setGlobalState(I.clippingPlanes,Z),nn(R,nt,Z),$t.updateMultisampleRenderTarget(Et),$t.updateRenderTargetMipmap(Et),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let pe=0,Qe=H.length;pe<Qe;pe++){let Le=H[pe],{object:De,geometry:vn,material:Ut,group:dn}=Le;if(Ut.side===si&&De.layers.test(Z.layers)){let ye=Ut.side;Ut.side=ni,Ut.needsUpdate=!0,cn(De,nt,Z,vn,Ut,dn),Ut.side=ye,Ut.needsUpdate=!0,zt=!0}}zt===!0&&($t.updateMultisampleRenderTarget(Et),$t.updateRenderTargetMipmap(Et))}I.setRenderTarget(At,It,kt),I.setClearColor(Q,dt),de!==void 0&&(Z.viewport=de),I.toneMapping=ie}function nn(R,H,nt){let Z=H.isScene===!0?H.overrideMaterial:null;for(let J=0,Et=R.length;J<Et;J++){let Pt=R[J],{object:At,geometry:It,group:kt}=Pt,ie=Pt.material;ie.allowOverride===!0&&Z!==null&&(ie=Z),At.layers.test(nt.layers)&&cn(At,H,nt,It,ie,kt)}}function cn(R,H,nt,Z,J,Et){O!==null&&J.isNodeMaterial&&O.setObject(R,J),R.onBeforeRender(I,H,nt,Z,J,Et),R.modelViewMatrix.multiplyMatrices(nt.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),J.onBeforeRender(I,H,nt,Z,R,Et),J.transparent===!0&&J.side===si&&J.forceSinglePass===!1?(J.side=ni,J.needsUpdate=!0,I.renderBufferDirect(nt,H,Z,J,R,Et),J.side=es,J.needsUpdate=!0,I.renderBufferDirect(nt,H,Z,J,R,Et),J.side=si):I.renderBufferDirect(nt,H,Z,J,R,Et),R.onAfterRender(I,H,nt,Z,J,Et)}function hn(R){let H=0;for(let nt of R)nt.texture!==null&&H++;return H}function Wi(R,H,nt){H.isScene!==!0&&(H=ln);let Z=Ht.get(R),J=T.state.lights,Et=T.state.shadowsArray,Pt=J.state.version,At=ct.getParameters(R,J.state,Et,H,nt,T.state.lightProbeGridArray),It=ct.getProgramCacheKey(At),kt=Z.programs;Z.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Z.fog=H.fog;let ie=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Z.envMap=L.get(R.envMap||Z.environment,ie),Z.envMapRotation=Z.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,kt===void 0&&(R.addEventListener("dispose",le),kt=new Map,Z.programs=kt,Z.programVariants=new Map);let de=kt.get(It);if(de!==void 0){if(Z.currentProgram===de&&Z.lightsStateVersion===Pt)return Oo(R,At),de}else At.uniforms=ct.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,nt,At),R.onBeforeCompile(At,I),de=ct.acquireProgram(At,It),kt.set(It,de),Z.uniforms=At.uniforms;let zt=Z.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(zt.clippingPlanes=at.uniform),Oo(R,At),Z.needsLights=Is(R),Z.lightsStateVersion=Pt,Z.needsLights&&(zt.ambientLightColor.value=J.state.ambient,zt.lightProbe.value=J.state.probe,zt.sunLights.value=J.state.sun,zt.sunLightShadows.value=J.state.sunShadow,zt.directionalLights.value=J.state.directional,zt.directionalLightShadows.value=J.state.directionalShadow,zt.spotLights.value=J.state.spot,zt.spotLightShadows.value=J.state.spotShadow,zt.rectAreaLights.value=J.state.rectArea,zt.ltc_1.value=J.state.rectAreaLTC1,zt.ltc_2.value=J.state.rectAreaLTC2,zt.pointLights.value=J.state.point,zt.pointLightShadows.value=J.state.pointShadow,zt.hemisphereLights.value=J.state.hemi,zt.sunShadowMatrix.value=J.state.sunShadowMatrix,zt.sunShadowCascade.value=J.state.sunShadowCascade,zt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,zt.spotLightMatrix.value=J.state.spotLightMatrix,zt.spotLightMap.value=J.state.spotLightMap,zt.pointShadowMatrix.value=J.state.pointShadowMatrix),Z.numLightProbeGrids=hn(T.state.lightProbeGridArray),Z.currentProgram=de,Z.uniformsList=null,de}function ai(R,H,nt,Z,J){let Et=Ht.get(R),Pt=Et.currentProgram.id+","+Z+","+J,At=Et.programVariants.get(Pt);return At===void 0?(At=Wi(R,H,nt),Et.programVariants.set(Pt,At)):(Et.currentProgram=At,Et.uniformsList=null,Et.outputColorSpace=Z,Et.toneMapping=J),At}function Ps(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=vo.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function Oo(R,H){let nt=Ht.get(R);nt.outputColorSpace=H.outputColorSpace,nt.batching=H.batching,nt.batchingColor=H.batchingColor,nt.instancing=H.instancing,nt.instancingColor=H.instancingColor,nt.instancingMorph=H.instancingMorph,nt.skinning=H.skinning,nt.morphTargets=H.morphTargets,nt.morphNormals=H.morphNormals,nt.morphColors=H.morphColors,nt.morphTargetsCount=H.morphTargetsCount,nt.numClippingPlanes=H.numClippingPlanes,nt.numIntersection=H.numClipIntersection,nt.vertexAlphas=H.vertexAlphas,nt.vertexTangents=H.vertexTangents,nt.toneMapping=H.toneMapping}function Bo(R,H,nt,Z,J){H.isScene!==!0&&(H=ln),$t.resetTextureUnits();let Et=H.fog,Pt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?H.environment:null,At=j===null?I.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:ve.workingColorSpace,It=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,kt=L.get(Z.envMap||Pt,It),ie=Z.vertexColors===!0&&!!nt.attributes.color&&nt.attributes.color.itemSize===4,de=!!nt.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),zt=!!nt.morphAttributes.position,pe=!!nt.morphAttributes.normal,Qe=!!nt.morphAttributes.color,Le=ns;Z.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(Le=I.toneMapping);let De=nt.morphAttributes.position||nt.morphAttributes.normal||nt.morphAttributes.color,vn=De!==void 0?De.length:0,Ut=Ht.get(Z),dn=T.state.lights;if(Ie===!0&&(tn===!0||R!==$)){let Ne=R===$&&Z.id===X;at.setState(Z,R,Ne)}let ye=!1,hs=!1;Z.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==dn.state.version||J.isBatchedMesh&&Ut.batching===!1||!J.isBatchedMesh&&Ut.batching===!0||J.isBatchedMesh&&Ut.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ut.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ut.instancing===!1||!J.isInstancedMesh&&Ut.instancing===!0||J.isSkinnedMesh&&Ut.skinning===!1||!J.isSkinnedMesh&&Ut.skinning===!0||J.isInstancedMesh&&Ut.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ut.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ut.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ut.instancingMorph===!1&&J.morphTexture!==null||Ut.envMap!==kt||Z.fog===!0&&Ut.fog!==Et||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==at.numPlanes||Ut.numIntersection!==at.numIntersection)||Ut.vertexAlphas!==ie||Ut.vertexTangents!==de||Ut.morphTargets!==zt||Ut.morphNormals!==pe||Ut.morphColors!==Qe||Ut.morphTargetsCount!==vn||Ut.numLightProbeGrids!==hn(T.state.lightProbeGridArray)?ye=!0:(Ut.outputColorSpace!==At||Ut.toneMapping!==Le)&&(hs=!0):(ye=!0,Ut.__version=Z.version);let pn=Ut.currentProgram;(ye===!0||hs===!0)&&(pn=hs===!0?ai(Z,H,J,At,Le):Wi(Z,H,J),O&&Z.isNodeMaterial&&O.onUpdateProgram(Z,pn,Ut));let Ir=!1,Xi=!1,us=!1,ue=pn.getUniforms(),sn=Ut.uniforms;if(wt.useProgram(pn.program)&&(Ir=!0,Xi=!0,us=!0),Z.id!==X&&(X=Z.id,Xi=!0),Ir||$!==R){wt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ue.setValue(z,"projectionMatrix",R.projectionMatrix),ue.setValue(z,"viewMatrix",R.matrixWorldInverse);let mn=ue.map.cameraPosition;mn!==void 0&&mn.setValue(z,fn.setFromMatrixPosition(R.matrixWorld)),oe.logarithmicDepthBuffer&&ue.setValue(z,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ue.setValue(z,"isOrthographic",R.isOrthographicCamera===!0),$!==R&&($=R,Xi=!0,us=!0)}if(Ut.needsLights&&(dn.state.sunShadowMap.length>0&&ue.setValue(z,"sunShadowMap",dn.state.sunShadowMap,$t),dn.state.directionalShadowMap.length>0&&ue.setValue(z,"directionalShadowMap",dn.state.directionalShadowMap,$t),dn.state.spotShadowMap.length>0&&ue.setValue(z,"spotShadowMap",dn.state.spotShadowMap,$t),dn.state.pointShadowMap.length>0&&ue.setValue(z,"pointShadowMap",dn.state.pointShadowMap,$t)),J.isSkinnedMesh){ue.setOptional(z,J,"bindMatrix"),ue.setOptional(z,J,"bindMatrixInverse");let Ne=J.skeleton;Ne&&(Ne.boneTexture===null&&Ne.computeBoneTexture(),ue.setValue(z,"boneTexture",Ne.boneTexture,$t))}J.isBatchedMesh&&(ue.setOptional(z,J,"batchingTexture"),ue.setValue(z,"batchingTexture",J._matricesTexture,$t),ue.setOptional(z,J,"batchingIdTexture"),ue.setValue(z,"batchingIdTexture",J._indirectTexture,$t),ue.setOptional(z,J,"batchingColorTexture"),J._colorsTexture!==null&&ue.setValue(z,"batchingColorTexture",J._colorsTexture,$t));let qn=nt.morphAttributes;if((qn.position!==void 0||qn.normal!==void 0||qn.color!==void 0)&&lt.update(J,nt,pn),(Xi||Ut.receiveShadow!==J.receiveShadow)&&(Ut.receiveShadow=J.receiveShadow,ue.setValue(z,"receiveShadow",J.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&H.environment!==null&&(sn.envMapIntensity.value=H.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=ab()),Xi){if(ue.setValue(z,"toneMappingExposure",I.toneMappingExposure),Ut.needsLights&&Cr(sn,us),Et&&Z.fog===!0&&vt.refreshFogUniforms(sn,Et),vt.refreshMaterialUniforms(sn,Z,yt,_t,T.state.transmissionRenderTarget[R.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Ne=S,mn=0;for(let kn of T.state.lightProbeGridArray)kn.texture!==null&&(Ne.textures[mn]=kn.texture,Ne.min[mn]=kn.boundingBox.min,Ne.max[mn]=kn.boundingBox.max,Ne.resolution[mn]=kn.resolution,mn++);for(let kn in Ne)Ne[kn].length=mn;sn.probesSH.value=Ne.textures,sn.probesMin.value=Ne.min,sn.probesMax.value=Ne.max,sn.probesResolution.value=Ne.resolution}vo.upload(z,Ps(Ut),sn,$t)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(vo.upload(z,Ps(Ut),sn,$t),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ue.setValue(z,"center",J.center),ue.setValue(z,"modelViewMatrix",J.modelViewMatrix),ue.setValue(z,"normalMatrix",J.normalMatrix),ue.setValue(z,"modelMatrix",J.matrixWorld),Z.uniformsGroups!==void 0){let Ne=Z.uniformsGroups;for(let mn=0,kn=Ne.length;mn<kn;mn++){let ja=Ne[mn];Wt.update(ja,pn),Wt.bind(ja,pn)}}return pn}function Cr(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function Is(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return V},this.getActiveMipmapLevel=function(){return F},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(R,H,nt){let Z=Ht.get(R);Z.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Ht.get(R.texture).__webglTexture=H,Ht.get(R.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:nt,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let nt=Ht.get(R);nt.__webglFramebuffer=H,nt.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,nt=0){j=R,V=H,F=nt;let Z=null,J=!1,Et=!1;if(R){let At=Ht.get(R);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(z.FRAMEBUFFER,At.__webglFramebuffer),tt.copy(R.viewport),it.copy(R.scissor),st=R.scissorTest,wt.viewport(tt),wt.scissor(it),wt.setScissorTest(st),X=-1;return}else if(At.__webglFramebuffer===void 0)$t.setupRenderTarget(R);else if(At.__hasExternalTextures)$t.rebindTextures(R,Ht.get(R.texture).__webglTexture,Ht.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ie=R.depthTexture;if(At.__boundDepthTexture!==ie){if(ie!==null&&Ht.has(ie)&&(R.width!==ie.image.width||R.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(R)}}let It=R.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let kt=Ht.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(kt[H])?Z=kt[H][nt]:Z=kt[H],J=!0):R.samples>0&&$t.useMultisampledRTT(R)===!1?Z=Ht.get(R).__webglMultisampledFramebuffer:Array.isArray(kt)?Z=kt[nt]:Z=kt,tt.copy(R.viewport),it.copy(R.scissor),st=R.scissorTest}else tt.copy(Vt).multiplyScalar(yt).floor(),it.copy(he).multiplyScalar(yt).floor(),st=ae;if(nt!==0&&(Z=B),wt.bindFramebuffer(z.FRAMEBUFFER,Z)&&wt.drawBuffers(R,Z),wt.viewport(tt),wt.scissor(it),wt.setScissorTest(st),J){let At=Ht.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,At.__webglTexture,nt)}else if(Et){let At=H;for(let It=0;It<R.textures.length;It++){let kt=Ht.get(R.textures[It]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+It,kt.__webglTexture,nt,At)}}else if(R!==null&&nt!==0){let At=Ht.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,At.__webglTexture,nt)}X=-1};function Pr(R){let H=Ht.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=oe.textureFormatReadable(R.format),H.__typeReadable=oe.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,nt,Z,J,Et,Pt,At=0){if(!(R&&R.isWebGLRenderTarget)){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(z.FRAMEBUFFER,It);try{let kt=R.textures[At],ie=kt.format,de=kt.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+At);let zt=Pr(kt);if(zt.__formatReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Z&&nt>=0&&nt<=R.height-J&&z.readPixels(H,nt,Z,J,xt.convert(ie),xt.convert(de),Et)}finally{let kt=j!==null?Ht.get(j).__webglFramebuffer:null;wt.bindFramebuffer(z.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(R,H,nt,Z,J,Et,Pt,At=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=Ht.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(H>=0&&H<=R.width-Z&&nt>=0&&nt<=R.height-J){wt.bindFramebuffer(z.FRAMEBUFFER,It);let kt=R.textures[At],ie=kt.format,de=kt.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+At);let zt=Pr(kt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,pe),z.bufferData(z.PIXEL_PACK_BUFFER,Et.byteLength,z.STREAM_READ),z.readPixels(H,nt,Z,J,xt.convert(ie),xt.convert(de),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Qe=j!==null?Ht.get(j).__webglFramebuffer:null;wt.bindFramebuffer(z.FRAMEBUFFER,Qe);let Le=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await am(z,Le,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,pe),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Et),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(pe),z.deleteSync(Le),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,nt=0){let Z=Math.pow(2,-nt),J=Math.floor(R.image.width*Z),Et=Math.floor(R.image.height*Z),Pt=H!==null?H.x:0,At=H!==null?H.y:0;$t.setTexture2D(R,0),z.copyTexSubImage2D(z.TEXTURE_2D,nt,0,0,Pt,At,J,Et),wt.unbindTexture()},this.copyTextureToTexture=function(R,H,nt=null,Z=null,J=0,Et=0){let Pt,At,It,kt,ie,de,zt,pe,Qe,Le=R.isCompressedTexture?R.mipmaps[Et]:R.image;if(nt!==null)Pt=nt.max.x-nt.min.x,At=nt.max.y-nt.min.y,It=nt.isBox3?nt.max.z-nt.min.z:1,kt=nt.min.x,ie=nt.min.y,de=nt.isBox3?nt.min.z:0;else{let ue=Math.pow(2,-J);Pt=Math.floor(Le.width*ue),At=Math.floor(Le.height*ue),R.isDataArrayTexture?It=Le.depth:R.isData3DTexture?It=Math.floor(Le.depth*ue):It=1,kt=0,ie=0,de=0}Z!==null?(zt=Z.x,pe=Z.y,Qe=Z.z):(zt=0,pe=0,Qe=0);let De=xt.convert(H.format),vn=xt.convert(H.type),Ut;H.isData3DTexture?($t.setTexture3D(H,0),Ut=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?($t.setTexture2DArray(H,0),Ut=z.TEXTURE_2D_ARRAY):($t.setTexture2D(H,0),Ut=z.TEXTURE_2D),wt.activeTexture(z.TEXTURE0),wt.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),wt.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),wt.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let dn=wt.getParameter(z.UNPACK_ROW_LENGTH),ye=wt.getParameter(z.UNPACK_IMAGE_HEIGHT),hs=wt.getParameter(z.UNPACK_SKIP_PIXELS),pn=wt.getParameter(z.UNPACK_SKIP_ROWS),Ir=wt.getParameter(z.UNPACK_SKIP_IMAGES);wt.pixelStorei(z.UNPACK_ROW_LENGTH,Le.width),wt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Le.height),wt.pixelStorei(z.UNPACK_SKIP_PIXELS,kt),wt.pixelStorei(z.UNPACK_SKIP_ROWS,ie),wt.pixelStorei(z.UNPACK_SKIP_IMAGES,de);let Xi=R.isDataArrayTexture||R.isData3DTexture,us=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let ue=Ht.get(R),sn=Ht.get(H),qn=Ht.get(ue.__renderTarget),Ne=Ht.get(sn.__renderTarget);wt.bindFramebuffer(z.READ_FRAMEBUFFER,qn.__webglFramebuffer),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ne.__webglFramebuffer);for(let mn=0;mn<It;mn++)Xi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ht.get(R).__webglTexture,J,de+mn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ht.get(H).__webglTexture,Et,Qe+mn)),z.blitFramebuffer(kt,ie,kt+Pt,ie+At,zt,pe,zt+Pt,pe+At,z.DEPTH_BUFFER_BIT,z.NEAREST);wt.bindFramebuffer(z.READ_FRAMEBUFFER,null),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(J!==0||R.isRenderTargetTexture||Ht.has(R)){let ue=Ht.get(R),sn=Ht.get(H);wt.bindFramebuffer(z.READ_FRAMEBUFFER,N),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,G);for(let qn=0;qn<It;qn++)Xi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ue.__webglTexture,J,de+qn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ue.__webglTexture,J),us?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,sn.__webglTexture,Et,Qe+qn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,sn.__webglTexture,Et),J!==0?z.blitFramebuffer(kt,ie,kt+Pt,ie+At,zt,pe,zt+Pt,pe+At,z.COLOR_BUFFER_BIT,z.NEAREST):us?z.copyTexSubImage3D(Ut,Et,zt,pe,Qe+qn,kt,ie,Pt,At):z.copyTexSubImage2D(Ut,Et,zt,pe,kt,ie,Pt,At);wt.bindFramebuffer(z.READ_FRAMEBUFFER,null),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else us?R.isDataTexture||R.isData3DTexture?z.texSubImage3D(Ut,Et,zt,pe,Qe,Pt,At,It,De,vn,Le.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Ut,Et,zt,pe,Qe,Pt,At,It,De,Le.data):z.texSubImage3D(Ut,Et,zt,pe,Qe,Pt,At,It,De,vn,Le):R.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Et,zt,pe,Pt,At,De,vn,Le.data):R.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Et,zt,pe,Le.width,Le.height,De,Le.data):z.texSubImage2D(z.TEXTURE_2D,Et,zt,pe,Pt,At,De,vn,Le);wt.pixelStorei(z.UNPACK_ROW_LENGTH,dn),wt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ye),wt.pixelStorei(z.UNPACK_SKIP_PIXELS,hs),wt.pixelStorei(z.UNPACK_SKIP_ROWS,pn),wt.pixelStorei(z.UNPACK_SKIP_IMAGES,Ir),Et===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(R){Ht.get(R).__webglFramebuffer===void 0&&$t.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$t.setTextureCube(R,0):R.isData3DTexture?$t.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$t.setTexture2DArray(R,0):$t.setTexture2D(R,0),wt.unbindTexture()},this.resetState=function(){V=0,F=0,j=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var Ba=()=>{let n=zr(!1);return t=>n(1-t)};function rs({radius_m:n}){let[t,e]=[n[0],n.at(-1)],i=n.length>1?(e-t)/(n.length-1)/2:t;return[Math.max(t-i,0),e+i]}var So=({depth_m:n})=>n.reduce((t,e)=>e>t?e:t,0);function Tf(n,t,e){let[i,s]=rs(n),r=n.radius_m.length,o=n.angle_rad.length,a=Math.floor((Math.hypot(t,e)-i)/(s-i)*r);if(a<0||a>=r)return NaN;let l=Math.atan2(e,t)/(2*Math.PI),c=Math.min(Math.floor((l-Math.floor(l))*o),o-1);return n.depth_m[a*o+c]}function zn(n,t,e){let i=t-n;if(!(i>0)||!Number.isFinite(i))return{values:[n],step:1};let s=i/Math.max(e,1),r=10**Math.floor(Math.log10(s)),o=[1,2,2.5,5,10].map(l=>l*r).find(l=>l>=s*.999),a=[];for(let l=Math.ceil(n/o-1e-9);l*o<=t+o*1e-9;l++)a.push(l*o);return{values:a,step:o}}var Ef=(n,t)=>n<8?"start":n>t-8?"end":"middle",lb={start:0,middle:.5,end:1};function qm(n,t,e){for(let r=Math.floor(e/24);r>1;r--){let o=zn(n,t,r),a=o.values.map(l=>{let c=(l-n)/(t-n)*e,f=6.2*Un(l,o.step).length,d=c-lb[Ef(c,e)]*f;return[d,d+f]});if(a.every(([l],c)=>c===0||a[c-1][1]+5<=l))return o}return zn(n,t,1)}function Un(n,t){let e=Math.abs(n)<t*1e-6?0:n,i=0;for(;i<8&&Math.abs(t*10**i-Math.round(t*10**i))>1e-6;)i++;return sr(e.toFixed(i))}function Ym(n,t,e,i){if(!(n<=t)||n===0&&t===0)return[0,i];(e||n>0&&n<.35*t)&&(n=Math.min(n,0)),(e||t<0&&t>.35*n)&&(t=Math.max(t,0));let r=.05*(t-n||Math.abs(t)*.2||1);return[n===0?0:n-r,t===0?0:t+r]}function hh(n,t,e,i){let s=Array.from({length:21},(l,c)=>`rgb(${i(c/20).join(" ")}) ${c*5}%`),r=e.map(l=>_e(l,t)),{values:o,step:a}=zn(r[0],r[1],4);return[et("span",{},n),et("div",{class:"ramp",style:`background:linear-gradient(to right, ${s.join(",")})`}),et("div",{class:"ramp-ticks"},o.map(l=>et("span",{style:`left:${(l-r[0])/(r[1]-r[0])*100}%`},Un(l,a))))]}var $m=matchMedia("(prefers-color-scheme: dark)"),Af=!1,bn=()=>Af,cb=()=>!Af&&(qt.theme==="dark"||qt.theme==="auto"&&$m.matches);function Zm(n){let t=()=>{document.documentElement.dataset.theme=cb()?"dark":"light"},e=()=>{t(),n()};$m.addEventListener("change",e);let i=s=>()=>{Af=s;for(let r of document.querySelectorAll("details.prints"))s?(r.dataset.was=r.open?"open":"",r.open=!0):r.open=r.dataset.was==="open";e()};return addEventListener("beforeprint",i(!0)),addEventListener("afterprint",i(!1)),t(),s=>{an({theme:s}),e()}}var os=44,hb=34,Js=18,Rf=8,uh=400,ub=270;function Jm(n,t){let e=et("canvas",{class:"plan",role:"img","aria-label":"The bottom of the hole from above"}),i=et("p",{class:"readout-line"}," "),s=et("div",{class:"plan-holder"},e,i),r=uh;function o(){let c=n();if(!c)return;r=bn()?ub:Math.min(Math.max((s.clientWidth||uh)-os-Rf,150),uh);let f=Math.max(devicePixelRatio,2),[d,h]=[os+r+Rf,Js+r+hb];[e.width,e.height]=[d*f,h*f],e.style.width=`${d}px`,e.style.height=`${h}px`;let u=e.getContext("2d");u.scale(f,f),u.font="11px system-ui, sans-serif";let p=1.04*rs(c)[1];a(u,c,p,Math.round(r*f)),l(u,p)}function a(c,f,d,h){let u=Ba(),p=So(f)||1,x=new ImageData(h,h),m=v=>(2*((v+.5)/h)-1)*d;for(let v=0;v<h;v++)for(let b=0;b<h;b++){let S=Tf(f,-m(v),m(b));Number.isFinite(S)&&x.data.set([...u(S/p),255],4*(v*h+b))}let g=new OffscreenCanvas(h,h);g.getContext("2d").putImageData(x,0,0),c.drawImage(g,os,Js,r,r)}function l(c,f){let d=_e(f,"diameter"),{values:h,step:u}=zn(-d,d,6),p=m=>.5+Jn(m,"diameter")/(2*f);c.fillStyle=Ue("muted"),c.textAlign="center",c.textBaseline="top";for(let m of h)c.fillText(Un(m,u),os+p(m)*r,Js+r+5);let x=t?"to the right":"across";c.fillText(`${x}, ${Be("diameter")}`,os+r/2,Js+r+19),c.textAlign="right",c.textBaseline="middle";for(let m of h)c.fillText(Un(m,u),os-6,Js+(1-p(m))*r);t&&(c.textAlign="center",c.textBaseline="bottom",c.fillText("high side ▴",os+r/2,Js-4)),c.strokeStyle=Ue("frame"),c.strokeRect(os,Js,r,r)}return e.addEventListener("pointermove",c=>{let f=n();if(!f)return;let d=e.getBoundingClientRect(),h=1.04*rs(f)[1],u=v=>(2*(v/r)-1)*h,p=u(c.clientX-d.left-os),x=-u(c.clientY-d.top-Js),m=Tf(f,x,p),g=(Math.atan2(p,x)+2*Math.PI)%(2*Math.PI);i.textContent=Number.isFinite(m)?`radius ${ke(Math.hypot(x,p),"diameter",3)}, ${ke(g,"angle",3)}: ${ke(m,"diameter",3)} deep`:" "}),e.addEventListener("pointerleave",()=>i.textContent=" "),new ResizeObserver(()=>{let c=Math.min(Math.max(s.clientWidth-os-Rf,150),uh);!bn()&&s.clientWidth&&c!==r&&o()}).observe(s),{element:s,draw:o}}function Mr(n,t,e,i="text",s=.5){let r=et("canvas",{}),o=r.getContext("2d"),a="600 44px system-ui, sans-serif";o.font=a,r.width=Math.ceil(o.measureText(n).width)+8,r.height=56,o.font=a,o.textBaseline="middle",o.fillStyle=Ue(i),o.fillText(n,4,30);let l=new da(new uo({map:new ma(r),depthTest:!1,transparent:!0}));return l.position.set(...t),l.center.set(s,.5),l.scale.set(e*r.width/r.height,e,1),l.renderOrder=3,l}function Cf(n,[t,e]){let i=new q(1/0,1/0,1/0),s=i.clone().negate();for(let o=0;o<=100;o++){let a=new q(...n.at(t+(e-t)*o/100,{}).place);i.min(a),s.max(a)}let r=.22*s.clone().sub(i).length();for(let o of["x","y","z"]){let l=Math.max(r-(s[o]-i[o]),0)/2+(o==="y"?0:.03*r);i[o]-=l,s[o]+=l}return{low:i,high:s}}function Pf({low:n,high:t},[e,,i]){let[s,r]=e>=0?[n.x,t.x]:[t.x,n.x],[o,a]=i>=0?[n.z,t.z]:[t.z,n.z];return[[s,o],[r,o],[s,a]]}function Km(n,t,e,i){let s=Cf(n,t),{low:r,high:o}=s,[a,l,c]=Pf(s,i),f=o.clone().sub(r).length(),d=Be("length"),h=zn(_e(t[0],"length"),_e(t[1],"length"),8),u=h.values.map(b=>{let{place:S,high:E}=n.at(Jn(b,"length"),{}),T=e+.012*f;return Mr(`${Un(b,h.step)} ${d}`,S.map((_,M)=>_+T*E[M]),.021*f,"text",0)}),p=[],x=(b,S)=>p.push(...b,...S),m=zn(_e(-o.y,"length"),_e(-r.y,"length"),5),g=m.values.map(b=>{let S=-Jn(b,"length"),E=([T,_])=>[T,S,_];return x(E(a),E(l)),x(E(a),E(c)),Mr(`TVD ${Un(b,m.step)} ${d}`,E(c),.019*f,"muted",1.06)});for(let[b,S]of[a,l,c])x([b,r.y,S],[b,o.y,S]);let v=new Nn;return v.setAttribute("position",new un(p,3)),[new mr(v,new Gs({color:Ue("frame"),transparent:!0,opacity:.35})),...u,...g,Mr("N",[(r.x+o.x)/2,o.y,r.z-.04*f],.024*f),Mr("E",[o.x+.04*f,o.y,(r.z+o.z)/2],.024*f)]}var jm={type:"change"},Lf={type:"start"},tg={type:"end"},fh=new pr,Qm=new pi,fb=Math.cos(70*hf.DEG2RAD),wn=new q,oi=2*Math.PI,Ee={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},If=1e-6,dh=class extends Ta{constructor(t,e=null){super(t,e),this.state=Ee.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qs.ROTATE,MIDDLE:qs.DOLLY,RIGHT:qs.PAN},this.touches={ONE:Ys.ROTATE,TWO:Ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new mi,this._lastTargetPosition=new q,this._quat=new mi().setFromUnitVectors(t.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new mo,this._sphericalDelta=new mo,this._scale=1,this._panOffset=new q,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new q,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=pb.bind(this),this._onPointerDown=db.bind(this),this._onPointerUp=mb.bind(this),this._onContextMenu=Sb.bind(this),this._onMouseWheel=xb.bind(this),this._onKeyDown=yb.bind(this),this._onTouchStart=vb.bind(this),this._onTouchMove=Mb.bind(this),this._onMouseDown=gb.bind(this),this._onMouseMove=_b.bind(this),this._interceptControlDown=bb.bind(this),this._interceptControlUp=wb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ee.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(jm),this.update(),this.state=Ee.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;wn.copy(e).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===Ee.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=oi:i>Math.PI&&(i-=oi),s<-Math.PI?s+=oi:s>Math.PI&&(s-=oi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),e.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(fh.origin.copy(this.object.position),fh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(fh.direction))<fb?this.object.lookAt(this.target):(Qm.setFromNormalAndCoplanarPoint(this.object.up,this.target),fh.intersectPlane(Qm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>If||8*(1-this._lastQuaternion.dot(this.object.quaternion))>If||this._lastTargetPosition.distanceToSquared(this.target)>If?(this.dispatchEvent(jm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?oi/60*this.autoRotateSpeed*t:oi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){wn.setFromMatrixColumn(e,0),wn.multiplyScalar(-t),this._panOffset.add(wn)}_panUp(t,e){this.screenSpacePanning===!0?wn.setFromMatrixColumn(e,1):(wn.setFromMatrixColumn(e,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(t),this._panOffset.add(wn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(oi*this._rotateDelta.x/e.clientHeight),this._rotateUp(oi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-oi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(oi*this._rotateDelta.x/e.clientHeight),this._rotateUp(oi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function db(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function pb(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function mb(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(tg),this.state=Ee.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function gb(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ee.DOLLY;break;case qs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ee.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ee.ROTATE}break;case qs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ee.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ee.PAN}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(Lf)}function _b(n){switch(this.state){case Ee.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ee.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ee.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function xb(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ee.NONE||(n.preventDefault(),this.dispatchEvent(Lf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(tg))}function yb(n){this.enabled!==!1&&this._handleKeyDown(n)}function vb(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ys.ROTATE:if(this.enableRotate===!1){this.state=Ee.NONE;break}this._handleTouchStartRotate(n),this.state=Ee.TOUCH_ROTATE;break;case Ys.PAN:if(this.enablePan===!1){this.state=Ee.NONE;break}this._handleTouchStartPan(n),this.state=Ee.TOUCH_PAN;break;default:this.state=Ee.NONE}break;case 2:switch(this.touches.TWO){case Ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ee.TOUCH_DOLLY_PAN;break;case Ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ee.TOUCH_DOLLY_ROTATE;break;default:this.state=Ee.NONE}break;default:this.state=Ee.NONE}this.state!==Ee.NONE&&this.dispatchEvent(Lf)}function Mb(n){switch(this._trackPointer(n),this.state){case Ee.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ee.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ee.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ee.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ee.NONE}}function Sb(n){this.enabled!==!1&&n.preventDefault()}function bb(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function wb(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ph=()=>et("p",{class:"warning"},"This view needs WebGL, which this browser does not give."),mh="drag to turn, right-drag to move, Ctrl + wheel to go nearer";function gh(n,t,e=0){let i=et("canvas",{class:"space",style:`height:${t}px`,role:"img","aria-label":n}),s;try{s=new ah({canvas:i,antialias:!0,alpha:!0,preserveDrawingBuffer:!0})}catch{return null}let r=new ca,o=new jn(38,1,1,1e5),a=new dh(o,i);a.enableDamping=!1,a.enableZoom=!1;let l=new ba(16777215,2.2);r.add(new wa(16777215,1.6),l);let c=et("canvas",{class:"space-paper"}),f=et("div",{class:"space-holder"},i,c),d=[];i.addEventListener("wheel",v=>{if(!v.ctrlKey&&!v.metaKey)return;v.preventDefault();let b=o.position.clone().sub(a.target).multiplyScalar(Math.exp(v.deltaY*.002));o.position.copy(a.target).add(b),p()},{passive:!1}),a.addEventListener("change",p);function h(v){return d.push(v),r.add(v),v}function u(v=d){for(let b of v)r.remove(b),b.geometry?.dispose(),b.material.map?.dispose(),b.material.dispose();d=d.filter(b=>!v.includes(b))}function p(){let v=e*o.position.distanceTo(a.target);l.position.copy(o.position).add(new q(-v,v,0).applyQuaternion(o.quaternion)),l.target.position.copy(a.target),l.target.updateMatrixWorld(),s.render(r,o),bn()&&([c.width,c.height]=[i.width,i.height],c.getContext("2d").drawImage(i,0,0))}function x(v,b,S=new ji().setFromArray(v.flat()).getCenter(new q)){let E=(i.clientWidth||1200)/t,T=new q(...b).normalize(),_=new q(0,1,0).cross(T).normalize(),M=T.clone().cross(_),C=Math.tan(o.fov*Math.PI/360),I=0;for(let P of v){let O=new q(...P).sub(S),B=Math.max(Math.abs(O.dot(_))/(C*E*.86),Math.abs(O.dot(M))/(C*.93));I=Math.max(I,B+O.dot(T))}a.target.copy(S),o.position.copy(S).addScaledVector(T,I),o.near=I/200,o.far=I*20,o.updateProjectionMatrix(),a.update(),p()}function m(){let v=f.clientWidth||1200;s.setPixelRatio(Math.min(devicePixelRatio*(devicePixelRatio<1.5?1.5:1),2.5)),s.setSize(v,t,!1),o.aspect=v/t,o.updateProjectionMatrix()}let g=0;return new ResizeObserver(()=>{f.clientWidth!==g&&(g=f.clientWidth,m(),p())}).observe(f),{holder:f,add:h,has:v=>d.includes(v),remove:u,render:p,lookAt:x,size:m,from:()=>o.position.clone().sub(a.target)}}var Tb=460,eg=[-.35,.95,.9];function xh(n,t){let e=gh("The bottom of the hole in space",Tb,.9),i=Jm(n,t),s=et("div",{class:"colour-key"}),r=1,o=null,a=et("output",{}),l=et("input",{type:"range",min:0,max:1.3,step:.01,"aria-label":"Exaggeration of depth",oninput:()=>{r=10**Number(l.value),d()}}),c=[["At an angle",eg],["From above",[0,1,.001]],["From the side",[0,.12,1]]].map(([m,g])=>et("button",{type:"button",onclick:()=>h(g)},m)),f=et("div",{class:"tools noprint"},et("label",{},"Depth × ",l,a),c,et("span",{class:"hint"},mh));function d(){let m=n();if(!m)return;let[,g]=rs(m),v=So(m),b=Be("diameter");s.replaceChildren(...hh(`Depth below the rim, ${b}`,"diameter",[0,v],Ba())),e&&(e.remove(),e.add(Ab(m,v,r)),e.add(Rb(m,r)),Cb(g,t?ig(m)*r:null).forEach(e.add),a.textContent=` ${On(r,2)}`,e.render())}function h(m){let g=n();if(!g||!e)return;let[,v]=rs(g),b=So(g)*r,S=g.depth_m.reduce((M,C)=>C<M?C:M,0)*r,T=Array.from({length:24},(M,C)=>C*Math.PI/12).flatMap(M=>[S,b].map(C=>_h(v,M,C))),_=[-1,1].map(M=>[.7*M*v,0,1.25*v]);t&&_.push([0,.2*v-S,-v]),e.lookAt([...T,..._],m,new q(0,-(S+b)/2,.22*v))}function u(){let m=n();if(o=m,!m)return;let g=.3*rs(m)[1]/(So(m)||1);r=[10,5,2].find(v=>v<=g)??1,l.value=Math.log10(r),d(),h(eg)}function p(){i.draw(),e&&e.size(),n()===o?d():u()}Oe("units",()=>{i.draw(),d()}),Oe("operation",()=>{i.draw(),u()});let x=e?[f,et("div",{class:"bottom"},e.holder,i.element)]:[ph(),i.element];return{element:et("div",{},x,s),redraw:p}}var _h=(n,t,e)=>[n*Math.sin(t),-e,-n*Math.cos(t)];function Eb(n){let[t,e]=rs(n),i=n.angle_rad.length,s=n.radius_m.length-1,r=f=>n.depth_m.subarray(f*i,(f+1)*i),o=Array.from(n.radius_m,(f,d)=>[f,r(d)]),a=r(0),l=a.filter(Number.isFinite),c=l.reduce((f,d)=>f+d,0)/l.length;return o.unshift(t>0?[t,a]:[0,a.map(()=>c)]),o.push([e,r(s)]),o}function Ab(n,t,e){let i=Eb(n),s=n.angle_rad.length,r=Ba(),o=new ce,[a,l,c]=[[],[],[]];for(let[h,u]of i)u.forEach((p,x)=>{let m=Number.isFinite(p)?p:0;a.push(..._h(h,n.angle_rad[x],m*e));let[g,v,b]=r(m/(t||1)).map(S=>S/255);o.setRGB(g,v,b,"srgb"),l.push(o.r,o.g,o.b)});let f=(h,u)=>Number.isFinite(i[h][1][u]);for(let h=0;h+1<i.length;h++)for(let u=0;u<s;u++){let p=(u+1)%s;if(![f(h,u),f(h,p),f(h+1,u),f(h+1,p)].every(Boolean))continue;let[x,m]=[h*s+u,h*s+p];c.push(x,m,x+s,m,m+s,x+s)}let d=new Nn;return d.setAttribute("position",new un(a,3)),d.setAttribute("color",new un(l,3)),d.setIndex(c),d.computeVertexNormals(),new Hn(d,new bs({vertexColors:!0,side:si}))}var ng=n=>n.depth_m.subarray((n.radius_m.length-1)*n.angle_rad.length),ig=n=>Math.min(0,...ng(n).filter(Number.isFinite));function Rb(n,t){let[,e]=rs(n),i=n.angle_rad.length,s=ng(n),r=ig(n)*t-.02*e,[o,a]=[[],[]];s.forEach((c,f)=>{let d=n.angle_rad[f];o.push(..._h(e,d,r)),o.push(..._h(e,d,(Number.isFinite(c)?c:0)*t));let[h,u]=[2*f,2*((f+1)%i)];a.push(h,h+1,u,u,h+1,u+1)});let l=new Nn;return l.setAttribute("position",new un(o,3)),l.setIndex(a),l.computeVertexNormals(),new Hn(l,new bs({color:Ue("rock"),side:es}))}function Cb(n,t){let{values:e,step:i}=zn(0,_e(1.4*n,"diameter"),3),s=Jn(e.at(-1),"diameter"),r=1.12*n,[o,a]=[-s/2,s/2],l=.025*n,c=[o,0,r,a,0,r];for(let u of[o,a])c.push(u,0,r-l,u,0,r+l);let f=new Nn;f.setAttribute("position",new un(c,3));let d=.075*n,h=`${Un(e.at(-1),i)} ${Be("diameter")}`;return[new mr(f,new Gs({color:Ue("text")})),Mr(h,[0,0,r+1.1*d],d),...t===null?[]:[Mr("high side",[0,1.2*d-t,-n],d)]]}var yh=()=>et("details",{},et("summary",{},"Plots by uPlot, 3D by three.js: their licences (MIT)"),et("pre",{},document.getElementById("licences").content.textContent));function vh(n,t,e){let i=Zm(e);return et("header",{},et("div",{class:"title-line"},et("h1",{},n),et("div",{class:"controls noprint"},ir("Units",[["si","SI"],["metric","Metric"],["field","US field"]],qt.units,s=>an({units:s})),ir("Colours",[["auto","Auto"],["light","Light"],["dark","Dark"]],qt.theme,i),et("button",{type:"button",onclick:()=>print()},"Print"))),t)}var Mh=(n,t,...e)=>et("section",{id:n},et("h2",{},t),e);function sg(n){let t=et("div",{class:"figure-holder"}),e=()=>{let i=document.getElementById(`${n}-${qt.units}`);t.replaceChildren(...i?[i.content.cloneNode(!0)]:["No point was finished."])};return Oe("units",e),e(),t}function rg(n){let{bottoms:t}=n,e=t.length-1,i=t.length?xh(()=>t[e].bottom,!1):null,s=et("div",{class:"tools noprint"}),r=et("p",{class:"note"}),o=({weight_N:h,rotary_rad_per_s:u})=>`${ke(h,"force",3)} at ${ke(u,"rotary speed",3)}`,a=()=>{let h=t.map((u,p)=>[String(p),o(u)]);s.replaceChildren(el("Point: ",h,String(e),u=>{e=Number(u),l(),i.redraw()})),l()},l=()=>r.textContent=`After ${o(t[e])}.`,[c,...f]=n.sheets,d=document.getElementById("page");d.append(vh(n.title,al(n),()=>i?.redraw()),...n.message?[et("p",{class:"warning"},n.message)]:[],Mh("drill-off","Drill-off",sg("drill-off")),Mh("energy","Specific energy",sg("specific-energy"))),i&&(a(),Oe("units",a),d.append(Mh("bottom","Bottom of the hole",s,i.element,r))),d.append(et("section",{id:"points"},Wo(c)),...f.length?[Mh("inputs","Inputs, defaults included",f.map(Wo))]:[],et("footer",{},et("p",{},`Made by ${n.program}. The tables beside this file hold every digit.`),yh())),i?.redraw()}function og(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function Pb(n){if(n.f32!==void 0)return new Float32Array(og(n.f32));let[t,e,i]=n.i16,s=new Int16Array(og(t)),r=new Float32Array(s.length);for(let o=0;o<s.length;o++)r[o]=s[o]===-32768?NaN:e+i*s[o];return r}function Df(n){return Array.isArray(n)?n.map(Df):n===null||typeof n!="object"?n:typeof n.f32=="string"||Array.isArray(n.i16)?Pb(n):Object.fromEntries(Object.entries(n).map(([t,e])=>[t,Df(e)]))}function ag(){return Df(JSON.parse(document.getElementById("report").textContent))}var Ib="uplot",Lb="u-hz",Db="u-vt",Nb="u-title",Ub="u-wrap",Fb="u-under",Ob="u-over",Bb="u-axis",wr="u-off",zb="u-select",kb="u-cursor-x",Vb="u-cursor-y",Gb="u-cursor-pt",Hb="u-legend",Wb="u-live",Xb="u-inline",qb="u-series",Yb="u-marker",lg="u-label",$b="u-value",ka="width",Va="height";var cg="bottom",bo="left",Nf="right",Kf="#000",hg=Kf+"0",Uf="mousemove",ug="mousedown",Ff="mouseup",fg="mouseenter",dg="mouseleave",pg="dblclick",Zb="resize",Jb="scroll",mg="change",Eh="dppxchange",jf="--",Po=typeof window<"u",Vf=Po?document:null,To=Po?window:null,Kb=Po?navigator:null,Ae,Sh;function Gf(){let n=devicePixelRatio;Ae!=n&&(Ae=n,Sh&&Wf(mg,Sh,Gf),Sh=matchMedia(`(min-resolution: ${Ae-.001}dppx) and (max-resolution: ${Ae+.001}dppx)`),Tr(mg,Sh,Gf),To.dispatchEvent(new CustomEvent(Eh)))}function xi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Hf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ze(n,t,e){n.style[t]=e+"px"}function ki(n,t,e,i){let s=Vf.createElement(n);return t!=null&&xi(s,t),e?.insertBefore(s,i),s}function Ei(n,t){return ki("div",n,t)}var gg=new WeakMap;function as(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=gg.get(n);r!=o&&(n.style.transform=r,gg.set(n,r),t<0||e<0||t>i||e>s?xi(n,wr):Hf(n,wr))}var _g=new WeakMap;function xg(n,t,e){let i=t+e,s=_g.get(n);i!=s&&(_g.set(n,i),n.style.background=t,n.style.borderColor=e)}var yg=new WeakMap;function vg(n,t,e,i){let s=t+""+e,r=yg.get(n);s!=r&&(yg.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Qf={passive:!0},jb={...Qf,capture:!0};function Tr(n,t,e,i){t.addEventListener(n,e,i?jb:Qf)}function Wf(n,t,e,i){t.removeEventListener(n,e,Qf)}Po&&Gf();function Vi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:yi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function $g(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Zg=n=>n!=null,Jg=n=>n!=null&&n>0,Ch=$g(Zg),Qb=$g(Jg);function tw(n,t,e,i=0,s=!1){let r=s?Qb:Ch,o=s?Jg:Zg;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let f=n[c];o(f)&&(f<a?a=f:f>l&&(l=f))}return[a??Ve,l??-Ve]}function Ph(n,t,e,i){let s=bg(n),r=bg(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?As:Kg,a=s==1?yi:Ai,l=r==1?Ai:yi,c=a(o(En(n))),f=l(o(En(t))),d=Eo(e,c),h=Eo(e,f);return e==10&&(c<0&&(d=Ge(d,-c)),f<0&&(h=Ge(h,-f))),i||e==2?(n=d*s,t=h*r):(n=e0(n,d),t=Ih(t,h)),[n,t]}function td(n,t,e,i){let s=Ph(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var ed=.1,Mg={mode:3,pad:ed},Ha={pad:0,soft:null,mode:0},ew={min:Ha,max:Ha};function Ah(n,t,e,i){return Lh(e)?Sg(n,t,e):(Ha.pad=e,Ha.soft=i?0:null,Ha.mode=i?3:0,Sg(n,t,ew))}function we(n,t){return n??t}function nw(n,t,e){for(t=we(t,0),e=we(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Sg(n,t,e){let i=e.min,s=e.max,r=we(i.pad,0),o=we(s.pad,0),a=we(i.hard,-Ve),l=we(s.hard,Ve),c=we(i.soft,Ve),f=we(s.soft,-Ve),d=we(i.mode,0),h=we(s.mode,0),u=t-n,p=As(u),x=ii(En(n),En(t)),m=As(x),g=En(m-p);(u<1e-24||g>10)&&(u=0,(n==0||t==0)&&(u=1e-24,d==2&&c!=Ve&&(r=0),h==2&&f!=-Ve&&(o=0)));let v=u||x||1e3,b=As(v),S=Eo(10,yi(b)),E=v*(u==0?n==0?.1:1:r),T=Ge(e0(n-E,S/10),24),_=n>=c&&(d==1||d==3&&T<=c||d==2&&T>=c)?c:Ve,M=ii(a,T<_&&n>=_?_:Gi(_,T)),C=v*(u==0?t==0?.1:1:o),I=Ge(Ih(t+C,S/10),24),P=t<=f&&(h==1||h==3&&I>=f||h==2&&I<=f)?f:-Ve,O=Gi(l,I>P&&t<=P?P:ii(P,I));return M==O&&M==0&&(O=100),[M,O]}var iw=new Intl.NumberFormat(Po?Kb.language:"en-US"),nd=n=>iw.format(n),vi=Math,Th=vi.PI,En=vi.abs,yi=vi.floor,Tn=vi.round,Ai=vi.ceil,Gi=vi.min,ii=vi.max,Eo=vi.pow,bg=vi.sign,As=vi.log10,Kg=vi.log2,sw=(n,t=1)=>vi.sinh(n)*t,Of=(n,t=1)=>vi.asinh(n/t),Ve=1/0;function wg(n){return(As((n^n>>31)-(n>>31))|0)+1}function Xf(n,t,e){return Gi(ii(n,t),e)}function jg(n){return typeof n=="function"}function Me(n){return jg(n)?n:()=>n}var rw=()=>{},Qg=n=>n,t0=(n,t)=>t,ow=n=>null,Tg=n=>!0,Eg=(n,t)=>n==t,aw=/\.\d*?(?=9{6,}|0{6,})/gm,Er=n=>{if(i0(n)||js.has(n))return n;let t=`${n}`,e=t.match(aw);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Er(s)}e${r}`}return Ge(n,i)};function Sr(n,t){return Er(Ge(Er(n/t))*t)}function Ih(n,t){return Er(Ai(Er(n/t))*t)}function e0(n,t){return Er(yi(Er(n/t))*t)}function Ge(n,t=0){if(i0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Tn(i)/e}var js=new Map;function n0(n){return((""+n).split(".")[1]||"").length}function Xa(n,t,e,i){let s=[],r=i.map(n0);for(let o=t;o<e;o++){let a=En(o),l=Ge(Eo(n,o),a);for(let c=0;c<i.length;c++){let f=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?f:Ge(f,d);s.push(h),js.set(h,d)}}return s}var Wa={},id=[],Ao=[null,null],Ks=Array.isArray,i0=Number.isInteger,lw=n=>n===void 0;function Ag(n){return typeof n=="string"}function Lh(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function cw(n){return n!=null&&typeof n=="object"}var hw=Object.getPrototypeOf(Uint8Array),s0="__proto__";function Ro(n,t=Lh){let e;if(Ks(n)){let i=n.find(s=>s!=null);if(Ks(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Ro(n[s],t)}else e=n.slice()}else if(n instanceof hw)e=n.slice();else if(t(n)){e={};for(let i in n)i!=s0&&(e[i]=Ro(n[i],t))}else e=n;return e}function xn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=s0&&(Lh(n[s])?xn(n[s],Ro(i[s])):n[s]=Ro(i[s]))}return n}var uw=0,fw=1,dw=2;function pw(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function mw(n,t){if(xw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return yw(o[0])||(o=_w(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let f=0;f<c;f++)e.add(l[f])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let f=a[c],d=Array(s).fill(void 0),h=t?t[o][c]:fw,u=[];for(let p=0;p<f.length;p++){let x=f[p],m=r.get(l[p]);x===null?h!=uw&&(d[m]=x,h==dw&&u.push(m)):d[m]=x}pw(d,u,s),i.push(d)}}return i}var gw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function _w(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function xw(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function yw(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ii(1,yi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var r0=["January","February","March","April","May","June","July","August","September","October","November","December"],o0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function a0(n){return n.slice(0,3)}var vw=o0.map(a0),Mw=r0.map(a0),Sw={MMMM:r0,MMM:Mw,WWWW:o0,WWW:vw};function za(n){return(n<10?"0":"")+n}function bw(n){return(n<10?"00":n<100?"0":"")+n}var ww={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>za(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>za(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>za(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>za(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>za(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>bw(n.getMilliseconds())};function sd(n,t){t=t||Sw;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?ww[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Tw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Ew(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==Tw?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var l0=n=>n%1==0,Rh=[1,2,2.5,5],Aw=Xa(10,-32,0,Rh),c0=Xa(10,0,32,Rh),Rw=c0.filter(l0),br=Aw.concat(c0),rd=`
`,h0="{YYYY}",Rg=rd+h0,u0="{M}/{D}",Ga=rd+u0,bh=Ga+"/{YY}",f0="{aa}",Cw="{h}:{mm}",wo=Cw+f0,Cg=rd+wo,Pg=":{ss}",Pe=null;function d0(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Xa(10,0,3,Rh).filter(l0):Xa(10,-3,0,Rh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,h0,Pe,Pe,Pe,Pe,Pe,Pe,1],[s*28,"{MMM}",Rg,Pe,Pe,Pe,Pe,Pe,1],[s,u0,Rg,Pe,Pe,Pe,Pe,Pe,1],[i,"{h}"+f0,bh,Pe,Ga,Pe,Pe,Pe,1],[e,wo,bh,Pe,Ga,Pe,Pe,Pe,1],[t,Pg,bh+" "+wo,Pe,Ga+" "+wo,Pe,Cg,Pe,1],[n,Pg+".{fff}",bh+" "+wo,Pe,Ga+" "+wo,Pe,Cg,Pe,1]];function f(d){return(h,u,p,x,m,g)=>{let v=[],b=m>=o,S=m>=r&&m<o,E=d(p),T=Ge(E*n,3),_=Bf(E.getFullYear(),b?0:E.getMonth(),S||b?1:E.getDate()),M=Ge(_*n,3);if(S||b){let C=S?m/r:0,I=b?m/o:0,P=T==M?T:Ge(Bf(_.getFullYear()+I,_.getMonth()+C,1)*n,3),O=new Date(Tn(P/n)),B=O.getFullYear(),N=O.getMonth();for(let G=0;P<=x;G++){let V=Bf(B+I*G,N+C*G,1),F=V-d(Ge(V*n,3));P=Ge((+V+F)*n,3),P<=x&&v.push(P)}}else{let C=m>=s?s:m,I=yi(p)-yi(T),P=M+I+Ih(T-M,C);v.push(P);let O=d(P),B=O.getHours()+O.getMinutes()/e+O.getSeconds()/i,N=m/i,G=h.axes[u]._space,V=g/G;for(;P=Ge(P+m,n==1?0:3),!(P>x);)if(N>1){let F=yi(Ge(B+N,6))%24,$=d(P).getHours()-F;$>1&&($=-1),P-=$*i,B=(B+N)%24;let tt=v[v.length-1];Ge((P-tt)/m,3)*V>=.7&&v.push(P)}else v.push(P)}return v}}return[l,c,f]}var[Pw,Iw,Lw]=d0(1),[Dw,Nw,Uw]=d0(.001);Xa(2,-53,53,[1]);function Ig(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Lg(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,f,d,h,u;return i.map(p=>{let x=n(p),m=x.getFullYear(),g=x.getMonth(),v=x.getDate(),b=x.getHours(),S=x.getMinutes(),E=x.getSeconds(),T=m!=l&&a[2]||g!=c&&a[3]||v!=f&&a[4]||b!=d&&a[5]||S!=h&&a[6]||E!=u&&a[7]||a[1];return l=m,c=g,f=v,d=b,h=S,u=E,T(x)})}}function Fw(n,t){let e=sd(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Bf(n,t,e){return new Date(n,t,e)}function Dg(n,t){return t(n)}var Ow="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ng(n,t){return(e,i,s,r)=>r==null?jf:t(n(i))}function Bw(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function zw(n,t){return n.series[t].fill(n,t)}var kw={show:!0,live:!0,isolate:!1,mount:rw,markers:{show:!0,width:2,stroke:Bw,fill:zw,dash:"solid"},idx:null,idxs:null,values:[]};function Vw(n,t){let e=n.cursor.points,i=Ei(),s=e.size(n,t);Ze(i,ka,s),Ze(i,Va,s);let r=s/-2;Ze(i,"marginLeft",r),Ze(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ze(i,"borderWidth",o),i}function Gw(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Hw(n,t){let e=n.series[t].points;return e._stroke||e._fill}function Ww(n,t){return n.series[t].points.size}var zf=[0,0];function Xw(n,t,e){return zf[0]=t,zf[1]=e,zf}function wh(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function kf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var qw={show:!0,x:!0,y:!0,lock:!1,move:Xw,points:{one:!1,show:Vw,size:Ww,width:0,stroke:Hw,fill:Gw},bind:{mousedown:wh,mouseup:wh,click:wh,dblclick:wh,mousemove:kf,mouseleave:kf,mouseenter:kf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},p0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},od=xn({},p0,{filter:t0}),m0=xn({},od,{size:10}),g0=xn({},p0,{show:!1}),ad='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',_0="bold "+ad,x0=1.5,Ug={show:!0,scale:"x",stroke:Kf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:_0,side:2,grid:od,ticks:m0,border:g0,font:ad,lineGap:x0,rotate:0},Yw="Value",$w="Time",Fg={show:!0,scale:"x",auto:!1,sorted:1,min:Ve,max:-Ve,idxs:[]};function Zw(n,t,e,i,s){return t.map(r=>r==null?"":nd(r))}function Jw(n,t,e,i,s,r,o){let a=[],l=js.get(s)||0;e=o?e:Ge(Ih(e,s),l);for(let c=e;c<=i;c=Ge(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function qf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?As:Kg,f=yi(c(e));s=Eo(l,f),l==10&&(s=br[Vi(s,br)]);let d=e,h=s*l;l==10&&(h=br[Vi(h,br)]);do a.push(d),d=d+s,l==10&&!js.has(d)&&(d=Ge(d,js.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=br[Vi(h,br)]));while(d<=i);return a}function Kw(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?qf(n,t,ii(l,e),i,s):[l],f=i>=0&&e<=0?[0]:[];return(e<-l?qf(n,t,ii(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(f,c)}var y0=/./,jw=/[12357]/,Qw=/[125]/,Og=/1/,Yf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function t1(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,f=l(10,o),d=l(9,o)-f>=c?y0:l(7,o)-f>=c?jw:l(5,o)-f>=c?Qw:Og;if(d==Og){let h=En(l(1,o)-f);if(h<c)return Yf(t.slice().reverse(),a.distr,d,Ai(c/h)).reverse()}return Yf(t,a.distr,d,1)}function e1(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?Yf(t.slice().reverse(),3,y0,Ai(a/c)).reverse():t}function n1(n,t,e,i){return i==null?jf:t==null?"":nd(t)}var Bg={show:!0,scale:"y",stroke:Kf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:_0,side:3,grid:od,ticks:m0,border:g0,font:ad,lineGap:x0,rotate:0};function i1(n,t){let e=3+(n||1)*2;return Ge(e*t,3)}function s1(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=En(o-r),l=n.series[t],c=a/(l.points.space*Ae);return i[1]-i[0]<=c}var zg={scale:null,auto:!0,sorted:0,min:Ve,max:-Ve},v0=(n,t,e,i,s)=>s,kg={show:!0,auto:!0,sorted:0,gaps:v0,alpha:1,facets:[xn({},zg,{scale:"x"}),xn({},zg,{scale:"y"})]},Vg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:v0,alpha:1,points:{show:s1,filter:null},values:null,min:Ve,max:-Ve,idxs:[],path:null,clip:null};function r1(n,t,e,i,s){return e/10}var M0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},o1=xn({},M0,{time:!1,ori:1}),Gg={};function S0(n,t){let e=Gg[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let f=0;f<e.plots.length;f++)e.plots[f]!=s&&e.plots[f].pub(i,s,r,o,a,l,c)}},n!=null&&(Gg[n]=e)),e}var Co=1,$f=2;function Ar(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],f=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,u=a.top,p=a.width,x=a.height,m=n.valToPosH,g=n.valToPosV;return f.ori==0?e(s,l,c,f,d,m,g,h,u,p,x,Nh,Io,Fh,w0,E0):e(s,l,c,f,d,g,m,u,h,x,p,Uh,Lo,hd,T0,A0)}function ld(n,t){let e=0,i=0,s=we(n.bands,id);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function a1(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Rs(n,t,e,i,s,r){return Ar(n,t,(o,a,l,c,f,d,h,u,p,x,m)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),b=c.ori==0?Io:Lo,S,E;v==1?(S=e,E=i):(S=i,E=e);let T=g(d(a[S],c,x,u)),_=g(h(l[S],f,m,p)),M=g(d(a[E],c,x,u)),C=g(h(r==1?f.max:f.min,f,m,p)),I=new Path2D(s);return b(I,M,C),b(I,T,C),b(I,T,_),I})}function Dh(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Fh:hd,l=e;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let u=h[0]-l;u>0&&a(o,l,i,u,i+r),l=h[1]}}let c=e+s-l,f=10;c>0&&a(o,l,i-f/2,c,i+r+f)}return o}function l1(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function cd(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let u=r(n[d]),p=h==d?u:r(n[h]),x=d-s;u=o<=0&&x>=0&&x<l?r(n[x]):u;let g=h+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=u&&a.push([u,p])}return a}function Hg(n){return n==0?Qg:n==1?Tn:t=>Sr(t,n)}function b0(n){let t=n==0?Nh:Uh,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,f=0)=>{c==0&&f==0?i(s,r,o,a,l):(c=Gi(c,a/2,l/2),f=Gi(f,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,f),e(s,r,o+l,r,o,f),e(s,r,o,r+a,o,c),s.closePath())}}var Nh=(n,t,e)=>{n.moveTo(t,e)},Uh=(n,t,e)=>{n.moveTo(e,t)},Io=(n,t,e)=>{n.lineTo(t,e)},Lo=(n,t,e)=>{n.lineTo(e,t)},Fh=b0(0),hd=b0(1),w0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},T0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},E0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},A0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function R0(n){return(t,e,i,s,r)=>Ar(t,e,(o,a,l,c,f,d,h,u,p,x,m)=>{let{pxRound:g,points:v}=o,b,S;c.ori==0?(b=Nh,S=w0):(b=Uh,S=T0);let E=Ge(v.width*Ae,3),T=(v.size-v.width)/2*Ae,_=Ge(T*2,3),M=new Path2D,C=new Path2D,{left:I,top:P,width:O,height:B}=t.bbox;Fh(C,I-_,P-_,O+_*2,B+_*2);let N=G=>{if(l[G]!=null){let V=g(d(a[G],c,x,u)),F=g(h(l[G],f,m,p));b(M,V+T,F),S(M,V,F,T,0,Th*2)}};if(r)r.forEach(N);else for(let G=i;G<=s;G++)N(G);return{stroke:E>0?M:null,fill:M,clip:C,flags:Co|$f}})}function C0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var c1=C0(Io),h1=C0(Lo);function P0(n){let t=we(n?.alignGaps,0);return(e,i,s,r)=>Ar(e,i,(o,a,l,c,f,d,h,u,p,x,m)=>{[s,r]=Ch(l,s,r);let g=o.pxRound,v=B=>g(d(B,c,x,u)),b=B=>g(h(B,f,m,p)),S,E;c.ori==0?(S=Io,E=c1):(S=Lo,E=h1);let T=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Co},M=_.stroke,C=!1;if(r-s>=x*4){let B=st=>e.posToVal(st,c.key,!0),N=null,G=null,V,F,j,X=v(a[T==1?s:r]),$=v(a[s]),tt=v(a[r]),it=B(T==1?$+1:tt-1);for(let st=T==1?s:r;st>=s&&st<=r;st+=T){let Q=a[st],pt=(T==1?Q<it:Q>it)?X:v(Q),_t=l[st];pt==X?_t!=null?(F=_t,N==null?(S(M,pt,b(F)),V=N=G=F):F<N?N=F:F>G&&(G=F)):_t===null&&(C=!0):(N!=null&&E(M,X,b(N),b(G),b(V),b(F)),_t!=null?(F=_t,S(M,pt,b(F)),N=G=V=F):(N=G=null,_t===null&&(C=!0)),X=pt,it=B(X+T))}N!=null&&N!=G&&j!=X&&E(M,X,b(N),b(G),b(V),b(F))}else for(let B=T==1?s:r;B>=s&&B<=r;B+=T){let N=l[B];N===null?C=!0:N!=null&&S(M,v(a[B]),b(N))}let[P,O]=ld(e,i);if(o.fill!=null||P!=0){let B=_.fill=new Path2D(M),N=o.fillTo(e,i,o.min,o.max,P),G=b(N),V=v(a[s]),F=v(a[r]);T==-1&&([F,V]=[V,F]),S(B,F,G),S(B,V,G)}if(!o.spanGaps){let B=[];C&&B.push(...cd(a,l,s,r,T,v,t)),_.gaps=B=o.gaps(e,i,s,r,B),_.clip=Dh(B,c.ori,u,p,x,m)}return O!=0&&(_.band=O==2?[Rs(e,i,s,r,M,-1),Rs(e,i,s,r,M,1)]:Rs(e,i,s,r,M,O)),_})}function u1(n){let t=we(n.align,1),e=we(n.ascDesc,!1),i=we(n.alignGaps,0),s=we(n.extend,!1);return(r,o,a,l)=>Ar(r,o,(c,f,d,h,u,p,x,m,g,v,b)=>{[a,l]=Ch(d,a,l);let S=c.pxRound,{left:E,width:T}=r.bbox,_=$=>S(p($,h,v,m)),M=$=>S(x($,u,b,g)),C=h.ori==0?Io:Lo,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Co},P=I.stroke,O=h.dir*(h.ori==0?1:-1),B=M(d[O==1?a:l]),N=_(f[O==1?a:l]),G=N,V=N;s&&t==-1&&(V=E,C(P,V,B)),C(P,N,B);for(let $=O==1?a:l;$>=a&&$<=l;$+=O){let tt=d[$];if(tt==null)continue;let it=_(f[$]),st=M(tt);t==1?C(P,it,B):C(P,G,st),C(P,it,st),B=st,G=it}let F=G;s&&t==1&&(F=E+T,C(P,F,B));let[j,X]=ld(r,o);if(c.fill!=null||j!=0){let $=I.fill=new Path2D(P),tt=c.fillTo(r,o,c.min,c.max,j),it=M(tt);C($,F,it),C($,V,it)}if(!c.spanGaps){let $=[];$.push(...cd(f,d,a,l,O,_,i));let tt=c.width*Ae/2,it=e||t==1?tt:-tt,st=e||t==-1?-tt:tt;$.forEach(Q=>{Q[0]+=it,Q[1]+=st}),I.gaps=$=c.gaps(r,o,a,l,$),I.clip=Dh($,h.ori,m,g,v,b)}return X!=0&&(I.band=X==2?[Rs(r,o,a,l,P,-1),Rs(r,o,a,l,P,1)]:Rs(r,o,a,l,P,X)),I})}function Wg(n,t,e,i,s,r,o=Ve){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let f=En(n[l]-n[a]);f<c&&(c=f,o=En(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function f1(n){n=n||Wa;let t=we(n.size,[.6,Ve,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),o=1-t[0],a=we(t[1],Ve),l=we(t[2],1),c=we(n.disp,Wa),f=we(n.each,u=>{}),{fill:d,stroke:h}=c;return(u,p,x,m)=>Ar(u,p,(g,v,b,S,E,T,_,M,C,I,P)=>{let O=g.pxRound,B=e,N=i*Ae,G=a*Ae,V=l*Ae,F,j;S.ori==0?[F,j]=r(u,p):[j,F]=r(u,p);let X=S.dir*(S.ori==0?1:-1),$=S.ori==0?Fh:hd,tt=S.ori==0?f:(Rt,Jt,oe,wt,ze,Ht,$t)=>{f(Rt,Jt,oe,ze,wt,$t,Ht)},it=we(u.bands,id).find(Rt=>Rt.series[0]==p),st=it!=null?it.dir:0,Q=g.fillTo(u,p,g.min,g.max,st),dt=O(_(Q,E,P,C)),pt,_t,yt,Ft=I,Kt=O(g.width*Ae),Vt=!1,he=null,ae=null,Gt=null,Se=null;d!=null&&(Kt==0||h!=null)&&(Vt=!0,he=d.values(u,p,x,m),ae=new Map,new Set(he).forEach(Rt=>{Rt!=null&&ae.set(Rt,new Path2D)}),Kt>0&&(Gt=h.values(u,p,x,m),Se=new Map,new Set(Gt).forEach(Rt=>{Rt!=null&&Se.set(Rt,new Path2D)})));let{x0:Ie,size:tn}=c;if(Ie!=null&&tn!=null){B=1,v=Ie.values(u,p,x,m),Ie.unit==2&&(v=v.map(oe=>u.posToVal(M+oe*I,S.key,!0)));let Rt=tn.values(u,p,x,m);tn.unit==2?_t=Rt[0]*I:_t=T(Rt[0],S,I,M)-T(0,S,I,M),Ft=Wg(v,b,T,S,I,M,Ft),yt=Ft-_t+N}else Ft=Wg(v,b,T,S,I,M,Ft),yt=Ft*o+N,_t=Ft-yt;yt<1&&(yt=0),Kt>=_t/2&&(Kt=0),yt<5&&(O=Qg);let Re=yt>0,fn=Ft-yt-(Re?Kt:0);_t=O(Xf(fn,V,G)),pt=(B==0?_t/2:B==X?0:_t)-B*X*((B==0?N/2:0)+(Re?Kt/2:0));let xe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},ln=Vt?null:new Path2D,Je=null;if(it!=null)Je=u.data[it.series[1]];else{let{y0:Rt,y1:Jt}=c;Rt!=null&&Jt!=null&&(b=Jt.values(u,p,x,m),Je=Rt.values(u,p,x,m))}let en=F*_t,z=j*_t;for(let Rt=X==1?x:m;Rt>=x&&Rt<=m;Rt+=X){let Jt=b[Rt];if(Jt==null)continue;if(Je!=null){let Y=Je[Rt]??0;if(Jt-Y==0)continue;dt=_(Y,E,P,C)}let oe=S.distr!=2||c!=null?v[Rt]:Rt,wt=T(oe,S,I,M),ze=_(we(Jt,Q),E,P,C),Ht=O(wt-pt),$t=O(ii(ze,dt)),L=O(Gi(ze,dt)),w=$t-L;if(Jt!=null){let Y=Jt<0?z:en,ft=Jt<0?en:z;Vt?(Kt>0&&Gt[Rt]!=null&&$(Se.get(Gt[Rt]),Ht,L+yi(Kt/2),_t,ii(0,w-Kt),Y,ft),he[Rt]!=null&&$(ae.get(he[Rt]),Ht,L+yi(Kt/2),_t,ii(0,w-Kt),Y,ft)):$(ln,Ht,L+yi(Kt/2),_t,ii(0,w-Kt),Y,ft),tt(u,p,Rt,Ht-Kt/2,L,_t+Kt,w)}}return Kt>0?xe.stroke=Vt?Se:ln:Vt||(xe._fill=g.width==0?g._fill:g._stroke??g._fill,xe.width=0),xe.fill=Vt?ae:ln,xe})}function d1(n,t){let e=we(t?.alignGaps,0);return(i,s,r,o)=>Ar(i,s,(a,l,c,f,d,h,u,p,x,m,g)=>{[r,o]=Ch(c,r,o);let v=a.pxRound,b=F=>v(h(F,f,m,p)),S=F=>v(u(F,d,g,x)),E,T,_;f.ori==0?(E=Nh,_=Io,T=E0):(E=Uh,_=Lo,T=A0);let M=f.dir*(f.ori==0?1:-1),C=b(l[M==1?r:o]),I=C,P=[],O=[];for(let F=M==1?r:o;F>=r&&F<=o;F+=M)if(c[F]!=null){let X=l[F],$=b(X);P.push(I=$),O.push(S(c[F]))}let B={stroke:n(P,O,E,_,T,v),fill:null,clip:null,band:null,gaps:null,flags:Co},N=B.stroke,[G,V]=ld(i,s);if(a.fill!=null||G!=0){let F=B.fill=new Path2D(N),j=a.fillTo(i,s,a.min,a.max,G),X=S(j);_(F,I,X),_(F,C,X)}if(!a.spanGaps){let F=[];F.push(...cd(l,c,r,o,M,b,e)),B.gaps=F=a.gaps(i,s,r,o,F),B.clip=Dh(F,f.ori,p,x,m,g)}return V!=0&&(B.band=V==2?[Rs(i,s,r,o,N,-1),Rs(i,s,r,o,N,1)]:Rs(i,s,r,o,N,V)),B})}function p1(n){return d1(m1,n)}function m1(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),f=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)f[h]=t[h+1]-t[h],d[h]=n[h+1]-n[h],c[h]=f[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,t[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,t[h+1]-l[h+1]*d[h]/3,n[h+1],t[h+1])}return a}var Zf=new Set;function Xg(){for(let n of Zf)n.syncRect(!0)}Po&&(Tr(Zb,To,Xg),Tr(Jb,To,Xg,!0),Tr(Eh,To,()=>{yn.pxRatio=Ae}));var g1=P0(),_1=R0();function qg(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Jf(r,o,t,e))}function x1(n,t){return n.map((e,i)=>i==0?{}:xn({},t,e))}function Jf(n,t,e,i){return xn({},t==0?e:i,n)}function I0(n,t,e){return t==null?Ao:[t,e]}var y1=I0;function v1(n,t,e){return t==null?Ao:Ah(t,e,ed,!0)}function L0(n,t,e,i){return t==null?Ao:Ph(t,e,n.scales[i].log,!1)}var M1=L0;function D0(n,t,e,i){return t==null?Ao:td(t,e,n.scales[i].log,!1)}var S1=D0;function b1(n,t,e,i,s){let r=ii(wg(n),wg(t)),o=t-n,a=Vi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Yg(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Tn((e=+s)*Ae))+"px"),[n,t,e]}function w1(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ge(t[2]*Ae,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function yn(n,t,e){let i={mode:we(n.mode,1)},s=i.mode;function r(y,A,D,U){let W=A.valToPct(y);return U+D*(A.dir==-1?1-W:W)}function o(y,A,D,U){let W=A.valToPct(y);return U+D*(A.dir==-1?W:1-W)}function a(y,A,D,U){return A.ori==0?r(y,A,D,U):o(y,A,D,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ei(Ib);if(n.id!=null&&(c.id=n.id),xi(c,n.class),n.title){let y=Ei(Nb,c);y.textContent=n.title}let f=ki("canvas"),d=i.ctx=f.getContext("2d"),h=Ei(Ub,c);Tr("click",h,y=>{y.target===p&&(Xe!=Nr||Ke!=Ur)&&Fn.click(i,y)},!0);let u=i.under=Ei(Fb,h);h.appendChild(f);let p=i.over=Ei(Ob,h);n=Ro(n);let x=+we(n.pxAlign,1),m=Hg(x);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let g=n.ms||.001,v=i.series=s==1?qg(n.series||[],Fg,Vg,!1):x1(n.series||[null],kg),b=i.axes=qg(n.axes||[],Ug,Bg,!0),S=i.scales={},E=i.bands=n.bands||[];E.forEach(y=>{y.fill=Me(y.fill||null),y.dir=we(y.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,_={axes:us,series:pe},M=(n.drawOrder||["axes","series"]).map(y=>_[y]);function C(y){let A=y.distr==3?D=>As(D>0?D:y.clamp(i,D,y.min,y.max,y.key)):y.distr==4?D=>Of(D,y.asinh):y.distr==100?D=>y.fwd(D):D=>D;return D=>{let U=A(D),{_min:W,_max:K}=y,ht=K-W;return(U-W)/ht}}function I(y){let A=S[y];if(A==null){let D=(n.scales||Wa)[y]||Wa;if(D.from!=null){I(D.from);let U=xn({},S[D.from],D,{key:y});U.valToPct=C(U),S[y]=U}else{A=S[y]=xn({},y==T?M0:o1,D),A.key=y;let U=A.time,W=A.range,K=Ks(W);if((y!=T||s==2&&!U)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Mg:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Mg:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&Lh(W))){let ht=W;W=(mt,St,Dt)=>St==null?Ao:Ah(St,Dt,ht)}A.range=Me(W||(U?y1:y==T?A.distr==3?M1:A.distr==4?S1:I0:A.distr==3?L0:A.distr==4?D0:v1)),A.auto=Me(K?!1:A.auto),A.clamp=Me(A.clamp||r1),A._min=A._max=null,A.valToPct=C(A)}}}I("x"),I("y"),s==1&&v.forEach(y=>{I(y.scale)}),b.forEach(y=>{I(y.scale)});for(let y in n.scales)I(y);let P=S[T],O=P.distr,B,N;P.ori==0?(xi(c,Lb),B=r,N=o):(xi(c,Db),B=o,N=r);let G={};for(let y in S){let A=S[y];(A.min!=null||A.max!=null)&&(G[y]={min:A.min,max:A.max},A.min=A.max=null)}let V=n.tzDate||(y=>new Date(Tn(y/g))),F=n.fmtDate||sd,j=g==1?Lw(V):Uw(V),X=Lg(V,Ig(g==1?Iw:Nw,F)),$=Ng(V,Dg(Ow,F)),tt=[],it=i.legend=xn({},kw,n.legend),st=i.cursor=xn({},qw,{drag:{y:s==2}},n.cursor),Q=it.show,dt=st.show,pt=it.markers;it.idxs=tt,pt.width=Me(pt.width),pt.dash=Me(pt.dash),pt.stroke=Me(pt.stroke),pt.fill=Me(pt.fill);let _t,yt,Ft,Kt=[],Vt=[],he,ae=!1,Gt={};if(it.live){let y=v[1]?v[1].values:null;ae=y!=null,he=ae?y(i,1,0):{_:0};for(let A in he)Gt[A]=jf}if(Q)if(_t=ki("table",Hb,c),Ft=ki("tbody",null,_t),it.mount(i,_t),ae){yt=ki("thead",null,_t,Ft);let y=ki("tr",null,yt);ki("th",null,y);for(var Se in he)ki("th",lg,y).textContent=Se}else xi(_t,Xb),it.live&&xi(_t,Wb);let Ie={show:!0},tn={show:!1};function Re(y,A){if(A==0&&(ae||!it.live||s==2))return Ao;let D=[],U=ki("tr",qb,Ft,Ft.childNodes[A]);xi(U,y.class),y.show||xi(U,wr);let W=ki("th",null,U);if(pt.show){let mt=Ei(Yb,W);if(A>0){let St=pt.width(i,A);St&&(mt.style.border=St+"px "+pt.dash(i,A)+" "+pt.stroke(i,A)),mt.style.background=pt.fill(i,A)}}let K=Ei(lg,W);y.label instanceof HTMLElement?K.appendChild(y.label):K.textContent=y.label,A>0&&(pt.show||(K.style.color=y.width>0?pt.stroke(i,A):pt.fill(i,A)),xe("click",W,mt=>{if(st._lock)return;te(mt);let St=v.indexOf(y);if((mt.ctrlKey||mt.metaKey)!=it.isolate){let Dt=v.some((Nt,Ot)=>Ot>0&&Ot!=St&&Nt.show);v.forEach((Nt,Ot)=>{Ot>0&&qi(Ot,Dt?Ot==St?Ie:tn:Ie,!0,gn.setSeries)})}else qi(St,{show:!y.show},!0,gn.setSeries)},!1),ee&&xe(fg,W,mt=>{st._lock||(te(mt),qi(v.indexOf(y),Or,!0,gn.setSeries))},!1));for(var ht in he){let mt=ki("td",$b,U);mt.textContent="--",D.push(mt)}return[U,D]}let fn=new Map;function xe(y,A,D,U=!0){let W=fn.get(A)||{},K=st.bind[y](i,A,D,U);K&&(Tr(y,A,W[y]=K),fn.set(A,W))}function ln(y,A,D){let U=fn.get(A)||{};for(let W in U)(y==null||W==y)&&(Wf(W,A,U[W]),delete U[W]);y==null&&fn.delete(A)}let Je=0,en=0,z=0,Rt=0,Jt=0,oe=0,wt=Jt,ze=oe,Ht=z,$t=Rt,L=0,w=0,Y=0,ft=0;i.bbox={};let ct=!1,vt=!1,Mt=!1,rt=!1,at=!1,gt=!1;function k(y,A,D){(D||y!=i.width||A!=i.height)&&lt(y,A),ue(!1),Mt=!0,vt=!0,kn()}function lt(y,A){i.width=Je=z=y,i.height=en=Rt=A,Jt=oe=0,bt(),Wt();let D=i.bbox;L=D.left=Sr(Jt*Ae,.5),w=D.top=Sr(oe*Ae,.5),Y=D.width=Sr(z*Ae,.5),ft=D.height=Sr(Rt*Ae,.5)}let ot=3;function Tt(){let y=!1,A=0;for(;!y;){A++;let D=Ir(A),U=Xi(A);y=A==ot||D&&U,y||(lt(i.width,i.height),vt=!0)}}function xt({width:y,height:A}){k(y,A)}i.setSize=xt;function bt(){let y=!1,A=!1,D=!1,U=!1;b.forEach((W,K)=>{if(W.show&&W._show){let{side:ht,_size:mt}=W,St=ht%2,Dt=W.label!=null?W.labelSize:0,Nt=mt+Dt;Nt>0&&(St?(z-=Nt,ht==3?(Jt+=Nt,U=!0):D=!0):(Rt-=Nt,ht==0?(oe+=Nt,y=!0):A=!0))}}),Hi[0]=y,Hi[1]=D,Hi[2]=A,Hi[3]=U,z-=Ci[1]+Ci[3],Jt+=Ci[3],Rt-=Ci[2]+Ci[0],oe+=Ci[0]}function Wt(){let y=Jt+z,A=oe+Rt,D=Jt,U=oe;function W(K,ht){switch(K){case 1:return y+=ht,y-ht;case 2:return A+=ht,A-ht;case 3:return D-=ht,D+ht;case 0:return U-=ht,U+ht}}b.forEach((K,ht)=>{if(K.show&&K._show){let mt=K.side;K._pos=W(mt,K._size),K.label!=null&&(K._lpos=W(mt,K.labelSize))}})}if(st.dataIdx==null){let y=st.hover,A=y.skip=new Set(y.skip??[]);A.add(void 0);let D=y.prox=Me(y.prox),U=y.bias??=0;st.dataIdx=(W,K,ht,mt)=>{if(K==0)return ht;let St=ht,Dt=D(W,K,ht,mt)??Ve,Nt=Dt>=0&&Dt<Ve,Ot=P.ori==0?z:Rt,re=st.left,Te=t[0],be=t[K];if(A.has(be[ht])){St=null;let ge=null,jt=null,Xt;if(U==0||U==-1)for(Xt=ht;ge==null&&Xt-- >0;)A.has(be[Xt])||(ge=Xt);if(U==0||U==1)for(Xt=ht;jt==null&&Xt++<be.length;)A.has(be[Xt])||(jt=Xt);if(ge!=null||jt!=null)if(Nt){let Ye=ge==null?-1/0:B(Te[ge],P,Ot,0),rn=jt==null?1/0:B(Te[jt],P,Ot,0),Pn=re-Ye,Fe=rn-re;Pn<=Fe?Pn<=Dt&&(St=ge):Fe<=Dt&&(St=jt)}else St=jt==null?ge:ge==null?jt:ht-ge<=jt-ht?ge:jt}else Nt&&En(re-B(Te[ht],P,Ot,0))>Dt&&(St=null);return St}}let te=y=>{st.event=y};st.idxs=tt,st._lock=!1;let ut=st.points;ut.show=Me(ut.show),ut.size=Me(ut.size),ut.stroke=Me(ut.stroke),ut.width=Me(ut.width),ut.fill=Me(ut.fill);let Bt=i.focus=xn({},n.focus||{alpha:.3},st.focus),ee=Bt.prox>=0,Ct=ee&&ut.one,le=[],We=[],Xn=[];function Uo(y,A){let D=ut.show(i,A);if(D instanceof HTMLElement)return xi(D,Gb),xi(D,y.class),as(D,-10,-10,z,Rt),p.insertBefore(D,le[A]),D}function Rr(y,A){if(s==1||A>0){let D=s==1&&S[y.scale].time,U=y.value;y.value=D?Ag(U)?Ng(V,Dg(U,F)):U||$:U||n1,y.label=y.label||(D?$w:Yw)}if(Ct||A>0){y.width=y.width==null?1:y.width,y.paths=y.paths||g1||ow,y.fillTo=Me(y.fillTo||a1),y.pxAlign=+we(y.pxAlign,x),y.pxRound=Hg(y.pxAlign),y.stroke=Me(y.stroke||null),y.fill=Me(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let D=i1(ii(1,y.width),1),U=y.points=xn({},{size:D,width:ii(1,D*.2),stroke:y.stroke,space:D*2,paths:_1,_stroke:null,_fill:null},y.points);U.show=Me(U.show),U.filter=Me(U.filter),U.fill=Me(U.fill),U.stroke=Me(U.stroke),U.paths=Me(U.paths),U.pxAlign=y.pxAlign}if(Q){let D=Re(y,A);Kt.splice(A,0,D[0]),Vt.splice(A,0,D[1]),it.values.push(null)}if(dt){tt.splice(A,0,null);let D=null;Ct?A==0&&(D=Uo(y,A)):A>0&&(D=Uo(y,A)),le.splice(A,0,D),We.splice(A,0,0),Xn.splice(A,0,0)}Cn("addSeries",A)}function Yh(y,A){A=A??v.length,y=s==1?Jf(y,A,Fg,Vg):Jf(y,A,{},kg),v.splice(A,0,y),Rr(v[A],A)}i.addSeries=Yh;function Ka(y){if(v.splice(y,1),Q){it.values.splice(y,1),Vt.splice(y,1);let A=Kt.splice(y,1)[0];ln(null,A.firstChild),A.remove()}dt&&(tt.splice(y,1),le.splice(y,1)[0].remove(),We.splice(y,1),Xn.splice(y,1)),Cn("delSeries",y)}i.delSeries=Ka;let Hi=[!1,!1,!1,!1];function ls(y,A){if(y._show=y.show,y.show){let D=y.side%2,U=S[y.scale];U==null&&(y.scale=D?v[1].scale:T,U=S[y.scale]);let W=U.time;y.size=Me(y.size),y.space=Me(y.space),y.rotate=Me(y.rotate),Ks(y.incrs)&&y.incrs.forEach(ht=>{!js.has(ht)&&js.set(ht,n0(ht))}),y.incrs=Me(y.incrs||(U.distr==2?Rw:W?g==1?Pw:Dw:br)),y.splits=Me(y.splits||(W&&U.distr==1?j:U.distr==3?qf:U.distr==4?Kw:Jw)),y.stroke=Me(y.stroke),y.grid.stroke=Me(y.grid.stroke),y.ticks.stroke=Me(y.ticks.stroke),y.border.stroke=Me(y.border.stroke);let K=y.values;y.values=Ks(K)&&!Ks(K[0])?Me(K):W?Ks(K)?Lg(V,Ig(K,F)):Ag(K)?Fw(V,K):K||X:K||Zw,y.filter=Me(y.filter||(U.distr>=3&&U.log==10?t1:U.distr==3&&U.log==2?e1:t0)),y.font=Yg(y.font),y.labelFont=Yg(y.labelFont),y._size=y.size(i,null,A,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Hi[A]=!0,y._el=Ei(Bb,h))}}function cs(y,A,D,U){let[W,K,ht,mt]=D,St=A%2,Dt=0;return St==0&&(mt||K)&&(Dt=A==0&&!W||A==2&&!ht?Tn(Ug.size/3):0),St==1&&(W||ht)&&(Dt=A==1&&!K||A==3&&!mt?Tn(Bg.size/2):0),Dt}let Fo=i.padding=(n.padding||[cs,cs,cs,cs]).map(y=>Me(we(y,cs))),Ci=i._padding=Fo.map((y,A)=>y(i,A,Hi,0)),nn,cn=null,hn=null,Wi=s==1?v[0].idxs:null,ai=null,Ps=!1;function Oo(y,A){if(t=y??[],i.data=i._data=t,s==2){nn=0;for(let D=1;D<v.length;D++)nn+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ai=t[0],nn=ai.length;let D=t;if(O==2){D=t.slice();let U=D[0]=Array(nn);for(let W=0;W<nn;W++)U[W]=W}i._data=t=D}if(ue(!0),Cn("setData"),O==2&&(Mt=!0),A!==!1){let D=P;D.auto(i,Ps)?Bo():Ds(T,D.min,D.max),rt=rt||st.left>=0,gt=!0,kn()}}i.setData=Oo;function Bo(){Ps=!0;let y,A;s==1&&(nn>0?(cn=Wi[0]=0,hn=Wi[1]=nn-1,y=t[0][cn],A=t[0][hn],O==2?(y=cn,A=hn):y==A&&(O==3?[y,A]=Ph(y,y,P.log,!1):O==4?[y,A]=td(y,y,P.log,!1):P.time?A=y+Tn(86400/g):[y,A]=Ah(y,A,ed,!0))):(cn=Wi[0]=y=null,hn=Wi[1]=A=null)),Ds(T,y,A)}let Cr,Is,Pr,R,H,nt,Z,J,Et,Pt;function At(y,A,D,U,W,K){y??=hg,D??=id,U??="butt",W??=hg,K??="round",y!=Cr&&(d.strokeStyle=Cr=y),W!=Is&&(d.fillStyle=Is=W),A!=Pr&&(d.lineWidth=Pr=A),K!=H&&(d.lineJoin=H=K),U!=nt&&(d.lineCap=nt=U),D!=R&&d.setLineDash(R=D)}function It(y,A,D,U){A!=Is&&(d.fillStyle=Is=A),y!=Z&&(d.font=Z=y),D!=J&&(d.textAlign=J=D),U!=Et&&(d.textBaseline=Et=U)}function kt(y,A,D,U,W=0){if(U.length>0&&y.auto(i,Ps)&&(A==null||A.min==null)){let K=we(cn,0),ht=we(hn,U.length-1),mt=D.min==null?tw(U,K,ht,W,y.distr==3):[D.min,D.max];y.min=Gi(y.min,D.min=mt[0]),y.max=ii(y.max,D.max=mt[1])}}let ie={min:null,max:null};function de(){for(let U in S){let W=S[U];G[U]==null&&(W.min==null||G[T]!=null&&W.auto(i,Ps))&&(G[U]=ie)}for(let U in S){let W=S[U];G[U]==null&&W.from!=null&&G[W.from]!=null&&(G[U]=ie)}G[T]!=null&&ue(!0);let y={};for(let U in G){let W=G[U];if(W!=null){let K=y[U]=Ro(S[U],cw);if(W.min!=null)xn(K,W);else if(U!=T||s==2)if(nn==0&&K.from==null){let ht=K.range(i,null,null,U);K.min=ht[0],K.max=ht[1]}else K.min=Ve,K.max=-Ve}}if(nn>0){v.forEach((U,W)=>{if(s==1){let K=U.scale,ht=G[K];if(ht==null)return;let mt=y[K];if(W==0){let St=mt.range(i,mt.min,mt.max,K);mt.min=St[0],mt.max=St[1],cn=Vi(mt.min,t[0]),hn=Vi(mt.max,t[0]),hn-cn>1&&(t[0][cn]<mt.min&&cn++,t[0][hn]>mt.max&&hn--),U.min=ai[cn],U.max=ai[hn]}else U.show&&U.auto&&kt(mt,ht,U,t[W],U.sorted);U.idxs[0]=cn,U.idxs[1]=hn}else if(W>0&&U.show&&U.auto){let[K,ht]=U.facets,mt=K.scale,St=ht.scale,[Dt,Nt]=t[W],Ot=y[mt],re=y[St];Ot!=null&&kt(Ot,G[mt],K,Dt,K.sorted),re!=null&&kt(re,G[St],ht,Nt,ht.sorted),U.min=ht.min,U.max=ht.max}});for(let U in y){let W=y[U],K=G[U];if(W.from==null&&(K==null||K.min==null)){let ht=W.range(i,W.min==Ve?null:W.min,W.max==-Ve?null:W.max,U);W.min=ht[0],W.max=ht[1]}}}for(let U in y){let W=y[U];if(W.from!=null){let K=y[W.from];if(K.min==null)W.min=W.max=null;else{let ht=W.range(i,K.min,K.max,U);W.min=ht[0],W.max=ht[1]}}}let A={},D=!1;for(let U in y){let W=y[U],K=S[U];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let ht=K.distr;K._min=ht==3?As(K.min):ht==4?Of(K.min,K.asinh):ht==100?K.fwd(K.min):K.min,K._max=ht==3?As(K.max):ht==4?Of(K.max,K.asinh):ht==100?K.fwd(K.max):K.max,A[U]=D=!0}}if(D){v.forEach((U,W)=>{s==2?W>0&&A.y&&(U._paths=null):A[U.scale]&&(U._paths=null)});for(let U in A)Mt=!0,Cn("setScale",U);dt&&st.left>=0&&(rt=gt=!0)}for(let U in G)G[U]=null}function zt(y){let A=Xf(cn-1,0,nn-1),D=Xf(hn+1,0,nn-1);for(;y[A]==null&&A>0;)A--;for(;y[D]==null&&D<nn-1;)D++;return[A,D]}function pe(){if(nn>0){let y=v.some(A=>A._focus)&&Pt!=Bt.alpha;y&&(d.globalAlpha=Pt=Bt.alpha),v.forEach((A,D)=>{if(D>0&&A.show&&(Qe(D,!1),Qe(D,!0),A._paths==null)){let U=Pt;Pt!=A.alpha&&(d.globalAlpha=Pt=A.alpha);let W=s==2?[0,t[D][0].length-1]:zt(t[D]);A._paths=A.paths(i,D,W[0],W[1]),Pt!=U&&(d.globalAlpha=Pt=U)}}),v.forEach((A,D)=>{if(D>0&&A.show){let U=Pt;Pt!=A.alpha&&(d.globalAlpha=Pt=A.alpha),A._paths!=null&&Le(D,!1);{let W=A._paths!=null?A._paths.gaps:null,K=A.points.show(i,D,cn,hn,W),ht=A.points.filter(i,D,K,W);(K||ht)&&(A.points._paths=A.points.paths(i,D,cn,hn,ht),Le(D,!0))}Pt!=U&&(d.globalAlpha=Pt=U),Cn("drawSeries",D)}}),y&&(d.globalAlpha=Pt=1)}}function Qe(y,A){let D=A?v[y].points:v[y];D._stroke=D.stroke(i,y),D._fill=D.fill(i,y)}function Le(y,A){let D=A?v[y].points:v[y],{stroke:U,fill:W,clip:K,flags:ht,_stroke:mt=D._stroke,_fill:St=D._fill,_width:Dt=D.width}=D._paths;Dt=Ge(Dt*Ae,3);let Nt=null,Ot=Dt%2/2;A&&St==null&&(St=Dt>0?"#fff":mt);let re=D.pxAlign==1&&Ot>0;if(re&&d.translate(Ot,Ot),!A){let Te=L-Dt/2,be=w-Dt/2,ge=Y+Dt,jt=ft+Dt;Nt=new Path2D,Nt.rect(Te,be,ge,jt)}A?Ut(mt,Dt,D.dash,D.cap,St,U,W,ht,K):De(y,mt,Dt,D.dash,D.cap,St,U,W,ht,Nt,K),re&&d.translate(-Ot,-Ot)}function De(y,A,D,U,W,K,ht,mt,St,Dt,Nt){let Ot=!1;St!=0&&E.forEach((re,Te)=>{if(re.series[0]==y){let be=v[re.series[1]],ge=t[re.series[1]],jt=(be._paths||Wa).band;Ks(jt)&&(jt=re.dir==1?jt[0]:jt[1]);let Xt,Ye=null;be.show&&jt&&nw(ge,cn,hn)?(Ye=re.fill(i,Te)||K,Xt=be._paths.clip):jt=null,Ut(A,D,U,W,Ye,ht,mt,St,Dt,Nt,Xt,jt),Ot=!0}}),Ot||Ut(A,D,U,W,K,ht,mt,St,Dt,Nt)}let vn=Co|$f;function Ut(y,A,D,U,W,K,ht,mt,St,Dt,Nt,Ot){At(y,A,D,U,W),(St||Dt||Ot)&&(d.save(),St&&d.clip(St),Dt&&d.clip(Dt)),Ot?(mt&vn)==vn?(d.clip(Ot),Nt&&d.clip(Nt),ye(W,ht),dn(y,K,A)):mt&$f?(ye(W,ht),d.clip(Ot),dn(y,K,A)):mt&Co&&(d.save(),d.clip(Ot),Nt&&d.clip(Nt),ye(W,ht),d.restore(),dn(y,K,A)):(ye(W,ht),dn(y,K,A)),(St||Dt||Ot)&&d.restore()}function dn(y,A,D){D>0&&(A instanceof Map?A.forEach((U,W)=>{d.strokeStyle=Cr=W,d.stroke(U)}):A!=null&&y&&d.stroke(A))}function ye(y,A){A instanceof Map?A.forEach((D,U)=>{d.fillStyle=Is=U,d.fill(D)}):A!=null&&y&&d.fill(A)}function hs(y,A,D,U){let W=b[y],K;if(U<=0)K=[0,0];else{let ht=W._space=W.space(i,y,A,D,U),mt=W._incrs=W.incrs(i,y,A,D,U,ht);K=b1(A,D,mt,U,ht)}return W._found=K}function pn(y,A,D,U,W,K,ht,mt,St,Dt){let Nt=ht%2/2;x==1&&d.translate(Nt,Nt),At(mt,ht,St,Dt,mt),d.beginPath();let Ot,re,Te,be,ge=W+(U==0||U==3?-K:K);D==0?(re=W,be=ge):(Ot=W,Te=ge);for(let jt=0;jt<y.length;jt++)A[jt]!=null&&(D==0?Ot=Te=y[jt]:re=be=y[jt],d.moveTo(Ot,re),d.lineTo(Te,be));d.stroke(),x==1&&d.translate(-Nt,-Nt)}function Ir(y){let A=!0;return b.forEach((D,U)=>{if(!D.show)return;let W=S[D.scale];if(W.min==null){D._show&&(A=!1,D._show=!1,ue(!1));return}else D._show||(A=!1,D._show=!0,ue(!1));let K=D.side,ht=K%2,{min:mt,max:St}=W,[Dt,Nt]=hs(U,mt,St,ht==0?z:Rt);if(Nt==0)return;let Ot=W.distr==2,re=D._splits=D.splits(i,U,mt,St,Dt,Nt,Ot),Te=W.distr==2?re.map(Xt=>ai[Xt]):re,be=W.distr==2?ai[re[1]]-ai[re[0]]:Dt,ge=D._values=D.values(i,D.filter(i,Te,U,Nt,be),U,Nt,be);D._rotate=K==2?D.rotate(i,ge,U,Nt):0;let jt=D._size;D._size=Ai(D.size(i,ge,U,y)),jt!=null&&D._size!=jt&&(A=!1)}),A}function Xi(y){let A=!0;return Fo.forEach((D,U)=>{let W=D(i,U,Hi,y);W!=Ci[U]&&(A=!1),Ci[U]=W}),A}function us(){for(let y=0;y<b.length;y++){let A=b[y];if(!A.show||!A._show)continue;let D=A.side,U=D%2,W,K,ht=A.stroke(i,y),mt=D==0||D==3?-1:1,[St,Dt]=A._found;if(A.label!=null){let $n=A.labelGap*mt,hi=Tn((A._lpos+$n)*Ae);It(A.labelFont[0],ht,"center",D==2?"top":cg),d.save(),U==1?(W=K=0,d.translate(hi,Tn(w+ft/2)),d.rotate((D==3?-Th:Th)/2)):(W=Tn(L+Y/2),K=hi);let nr=jg(A.label)?A.label(i,y,St,Dt):A.label;d.fillText(nr,W,K),d.restore()}if(Dt==0)continue;let Nt=S[A.scale],Ot=U==0?Y:ft,re=U==0?L:w,Te=A._splits,be=Nt.distr==2?Te.map($n=>ai[$n]):Te,ge=Nt.distr==2?ai[Te[1]]-ai[Te[0]]:St,jt=A.ticks,Xt=A.border,Ye=jt.show?jt.size:0,rn=Tn(Ye*Ae),Pn=Tn((A.alignTo==2?A._size-Ye-A.gap:A.gap)*Ae),Fe=A._rotate*-Th/180,on=m(A._pos*Ae),li=(rn+Pn)*mt,Yn=on+li;K=U==0?Yn:0,W=U==1?Yn:0;let Mi=A.font[0],Pi=A.align==1?bo:A.align==2?Nf:Fe>0?bo:Fe<0?Nf:U==0?"center":D==3?Nf:bo,$i=Fe||U==1?"middle":D==2?"top":cg;It(Mi,ht,Pi,$i);let ci=A.font[1]*A.lineGap,Si=Te.map($n=>m(a($n,Nt,Ot,re))),Ii=A._values;for(let $n=0;$n<Ii.length;$n++){let hi=Ii[$n];if(hi!=null){U==0?W=Si[$n]:K=Si[$n],hi=""+hi;let nr=hi.indexOf(`
`)==-1?[hi]:hi.split(/\n/gm);for(let Zn=0;Zn<nr.length;Zn++){let Ud=nr[Zn];Fe?(d.save(),d.translate(W,K+Zn*ci),d.rotate(Fe),d.fillText(Ud,0,0),d.restore()):d.fillText(Ud,W,K+Zn*ci)}}}jt.show&&pn(Si,jt.filter(i,be,y,Dt,ge),U,D,on,rn,Ge(jt.width*Ae,3),jt.stroke(i,y),jt.dash,jt.cap);let Zi=A.grid;Zi.show&&pn(Si,Zi.filter(i,be,y,Dt,ge),U,U==0?2:1,U==0?w:L,U==0?ft:Y,Ge(Zi.width*Ae,3),Zi.stroke(i,y),Zi.dash,Zi.cap),Xt.show&&pn([on],[1],U==0?1:0,U==0?1:2,U==1?w:L,U==1?ft:Y,Ge(Xt.width*Ae,3),Xt.stroke(i,y),Xt.dash,Xt.cap)}Cn("drawAxes")}function ue(y){v.forEach((A,D)=>{D>0&&(A._paths=null,y&&(s==1?(A.min=null,A.max=null):A.facets.forEach(U=>{U.min=null,U.max=null})))})}let sn=!1,qn=!1,Ne=[];function mn(){qn=!1;for(let y=0;y<Ne.length;y++)Cn(...Ne[y]);Ne.length=0}function kn(){sn||(gw(_d),sn=!0)}function ja(y,A=!1){sn=!0,qn=A,y(i),_d(),A&&Ne.length>0&&queueMicrotask(mn)}i.batch=ja;function _d(){if(ct&&(de(),ct=!1),Mt&&(Tt(),Mt=!1),vt){if(Ze(u,bo,Jt),Ze(u,"top",oe),Ze(u,ka,z),Ze(u,Va,Rt),Ze(p,bo,Jt),Ze(p,"top",oe),Ze(p,ka,z),Ze(p,Va,Rt),Ze(h,ka,Je),Ze(h,Va,en),f.width=Tn(Je*Ae),f.height=Tn(en*Ae),b.forEach(({_el:y,_show:A,_size:D,_pos:U,side:W})=>{if(y!=null)if(A){let K=W===3||W===0?D:0,ht=W%2==1;Ze(y,ht?"left":"top",U-K),Ze(y,ht?"width":"height",D),Ze(y,ht?"top":"left",ht?oe:Jt),Ze(y,ht?"height":"width",ht?Rt:z),Hf(y,wr)}else xi(y,wr)}),Cr=Is=Pr=H=nt=Z=J=Et=R=null,Pt=1,Vo(!0),Jt!=wt||oe!=ze||z!=Ht||Rt!=$t){ue(!1);let y=z/Ht,A=Rt/$t;if(dt&&!rt&&st.left>=0){st.left*=y,st.top*=A,Lr&&as(Lr,Tn(st.left),0,z,Rt),Dr&&as(Dr,0,Tn(st.top),z,Rt);for(let D=0;D<le.length;D++){let U=le[D];U!=null&&(We[D]*=y,Xn[D]*=A,as(U,Ai(We[D]),Ai(Xn[D]),z,Rt))}}if(qe.show&&!at&&qe.left>=0&&qe.width>0){qe.left*=y,qe.width*=y,qe.top*=A,qe.height*=A;for(let D in Qh)Ze(Fr,D,qe[D])}wt=Jt,ze=oe,Ht=z,$t=Rt}Cn("setSize"),vt=!1}Je>0&&en>0&&(d.clearRect(0,0,f.width,f.height),Cn("drawClear"),M.forEach(y=>y()),Cn("draw")),qe.show&&at&&(Qa(qe),at=!1),dt&&rt&&(er(null,!0,!1),rt=!1),it.show&&it.live&&gt&&(Kh(),gt=!1),l||(l=!0,i.status=1,Cn("ready")),Ps=!1,sn=!1}i.redraw=(y,A)=>{Mt=A||!1,y!==!1?Ds(T,P.min,P.max):kn()};function $h(y,A){let D=S[y];if(D.from==null){if(nn==0){let U=D.range(i,A.min,A.max,y);A.min=U[0],A.max=U[1]}if(A.min>A.max){let U=A.min;A.min=A.max,A.max=U}if(nn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;y==T&&D.distr==2&&nn>0&&(A.min=Vi(A.min,t[0]),A.max=Vi(A.max,t[0]),A.min==A.max&&A.max++),G[y]=A,ct=!0,kn()}}i.setScale=$h;let Zh,Jh,Lr,Dr,xd,yd,Nr,Ur,vd,Md,Xe,Ke,Ls=!1,Fn=st.drag,An=Fn.x,Rn=Fn.y;dt&&(st.x&&(Zh=Ei(kb,p)),st.y&&(Jh=Ei(Vb,p)),P.ori==0?(Lr=Zh,Dr=Jh):(Lr=Jh,Dr=Zh),Xe=st.left,Ke=st.top);let qe=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Fr=qe.show?Ei(zb,qe.over?p:u):null;function Qa(y,A){if(qe.show){for(let D in y)qe[D]=y[D],D in Qh&&Ze(Fr,D,y[D]);A!==!1&&Cn("setSelect")}}i.setSelect=Qa;function n_(y){if(v[y].show)Q&&Hf(Kt[y],wr);else if(Q&&xi(Kt[y],wr),dt){let D=Ct?le[0]:le[y];D!=null&&as(D,-10,-10,z,Rt)}}function Ds(y,A,D){$h(y,{min:A,max:D})}function qi(y,A,D,U){A.focus!=null&&a_(y),A.show!=null&&v.forEach((W,K)=>{K>0&&(y==K||y==null)&&(W.show=A.show,n_(K),s==2?(Ds(W.facets[0].scale,null,null),Ds(W.facets[1].scale,null,null)):Ds(W.scale,null,null),kn())}),D!==!1&&Cn("setSeries",y,A),U&&Go("setSeries",i,y,A)}i.setSeries=qi;function i_(y,A){xn(E[y],A)}function s_(y,A){y.fill=Me(y.fill||null),y.dir=we(y.dir,-1),A=A??E.length,E.splice(A,0,y)}function r_(y){y==null?E.length=0:E.splice(y,1)}i.addBand=s_,i.setBand=i_,i.delBand=r_;function o_(y,A){v[y].alpha=A,dt&&le[y]!=null&&(le[y].style.opacity=A),Q&&Kt[y]&&(Kt[y].style.opacity=A)}let fs,Ns,tr,Or={focus:!0};function a_(y){if(y!=tr){let A=y==null,D=Bt.alpha!=1;v.forEach((U,W)=>{if(s==1||W>0){let K=A||W==0||W==y;U._focus=A?null:K,D&&o_(W,K?1:Bt.alpha)}}),tr=y,D&&kn()}}Q&&ee&&xe(dg,_t,y=>{st._lock||(te(y),tr!=null&&qi(null,Or,!0,gn.setSeries))});function Yi(y,A,D){let U=S[A];D&&(y=y/Ae-(U.ori==1?oe:Jt));let W=z;U.ori==1&&(W=Rt,y=W-y),U.dir==-1&&(y=W-y);let K=U._min,ht=U._max,mt=y/W,St=K+(ht-K)*mt,Dt=U.distr;return Dt==3?Eo(10,St):Dt==4?sw(St,U.asinh):Dt==100?U.bwd(St):St}function l_(y,A){let D=Yi(y,T,A);return Vi(D,t[0],cn,hn)}i.valToIdx=y=>Vi(y,t[0]),i.posToIdx=l_,i.posToVal=Yi,i.valToPos=(y,A,D)=>S[A].ori==0?r(y,S[A],D?Y:z,D?L:0):o(y,S[A],D?ft:Rt,D?w:0),i.setCursor=(y,A,D)=>{Xe=y.left,Ke=y.top,er(null,A,D)};function Sd(y,A){Ze(Fr,bo,qe.left=y),Ze(Fr,ka,qe.width=A)}function bd(y,A){Ze(Fr,"top",qe.top=y),Ze(Fr,Va,qe.height=A)}let zo=P.ori==0?Sd:bd,ko=P.ori==1?Sd:bd;function c_(){if(Q&&it.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&ae)continue;let A=it.values[y],D=0;for(let U in A)Vt[y][D++].firstChild.nodeValue=A[U]}}function Kh(y,A){if(y!=null&&(y.idxs?y.idxs.forEach((D,U)=>{tt[U]=D}):lw(y.idx)||tt.fill(y.idx),it.idx=tt[0]),Q&&it.live){for(let D=0;D<v.length;D++)(D>0||s==1&&!ae)&&h_(D,tt[D]);c_()}gt=!1,A!==!1&&Cn("setLegend")}i.setLegend=Kh;function h_(y,A){let D=v[y],U=y==0&&O==2?ai:t[y],W;ae?W=D.values(i,y,A)??Gt:(W=D.value(i,A==null?null:U[A],y,A),W=W==null?Gt:{_:W}),it.values[y]=W}function er(y,A,D){vd=Xe,Md=Ke,[Xe,Ke]=st.move(i,Xe,Ke),st.left=Xe,st.top=Ke,dt&&(Lr&&as(Lr,Tn(Xe),0,z,Rt),Dr&&as(Dr,0,Tn(Ke),z,Rt));let U,W=cn>hn;fs=Ve,Ns=null;let K=P.ori==0?z:Rt,ht=P.ori==1?z:Rt;if(Xe<0||nn==0||W){U=st.idx=null;for(let mt=0;mt<v.length;mt++){let St=le[mt];St!=null&&as(St,-10,-10,z,Rt)}ee&&qi(null,Or,!0,y==null&&gn.setSeries),it.live&&(tt.fill(U),gt=!0)}else{let mt,St,Dt;s==1&&(mt=P.ori==0?Xe:Ke,St=Yi(mt,T),U=st.idx=Vi(St,t[0],cn,hn),Dt=B(t[0][U],P,K,0));let Nt=-10,Ot=-10,re=0,Te=0,be=!0,ge="",jt="";for(let Xt=s==2?1:0;Xt<v.length;Xt++){let Ye=v[Xt],rn=tt[Xt],Pn=rn==null?null:s==1?t[Xt][rn]:t[Xt][1][rn],Fe=st.dataIdx(i,Xt,U,St),on=Fe==null?null:s==1?t[Xt][Fe]:t[Xt][1][Fe];if(gt=gt||on!=Pn||Fe!=rn,tt[Xt]=Fe,Xt>0&&Ye.show){let li=Fe==null?-10:Fe==U?Dt:B(s==1?t[0][Fe]:t[Xt][0][Fe],P,K,0),Yn=on==null?-10:N(on,s==1?S[Ye.scale]:S[Ye.facets[1].scale],ht,0);if(ee&&on!=null){let Mi=P.ori==1?Xe:Ke,Pi=En(Bt.dist(i,Xt,Fe,Yn,Mi));if(Pi<fs){let $i=Bt.bias;if($i!=0){let ci=Yi(Mi,Ye.scale),Si=on>=0?1:-1,Ii=ci>=0?1:-1;Ii==Si&&(Ii==1?$i==1?on>=ci:on<=ci:$i==1?on<=ci:on>=ci)&&(fs=Pi,Ns=Xt)}else fs=Pi,Ns=Xt}}if(gt||Ct){let Mi,Pi;P.ori==0?(Mi=li,Pi=Yn):(Mi=Yn,Pi=li);let $i,ci,Si,Ii,Zi,$n,hi=!0,nr=ut.bbox;if(nr!=null){hi=!1;let Zn=nr(i,Xt);Si=Zn.left,Ii=Zn.top,$i=Zn.width,ci=Zn.height}else Si=Mi,Ii=Pi,$i=ci=ut.size(i,Xt);if($n=ut.fill(i,Xt),Zi=ut.stroke(i,Xt),Ct)Xt==Ns&&fs<=Bt.prox&&(Nt=Si,Ot=Ii,re=$i,Te=ci,be=hi,ge=$n,jt=Zi);else{let Zn=le[Xt];Zn!=null&&(We[Xt]=Si,Xn[Xt]=Ii,vg(Zn,$i,ci,hi),xg(Zn,$n,Zi),as(Zn,Ai(Si),Ai(Ii),z,Rt))}}}}if(Ct){let Xt=Bt.prox,Ye=tr==null?fs<=Xt:fs>Xt||Ns!=tr;if(gt||Ye){let rn=le[0];rn!=null&&(We[0]=Nt,Xn[0]=Ot,vg(rn,re,Te,be),xg(rn,ge,jt),as(rn,Ai(Nt),Ai(Ot),z,Rt))}}}if(qe.show&&Ls)if(y!=null){let[mt,St]=gn.scales,[Dt,Nt]=gn.match,[Ot,re]=y.cursor.sync.scales,Te=y.cursor.drag;if(An=Te._x,Rn=Te._y,An||Rn){let{left:be,top:ge,width:jt,height:Xt}=y.select,Ye=y.scales[Ot].ori,rn=y.posToVal,Pn,Fe,on,li,Yn,Mi=mt!=null&&Dt(mt,Ot),Pi=St!=null&&Nt(St,re);Mi&&An?(Ye==0?(Pn=be,Fe=jt):(Pn=ge,Fe=Xt),on=S[mt],li=B(rn(Pn,Ot),on,K,0),Yn=B(rn(Pn+Fe,Ot),on,K,0),zo(Gi(li,Yn),En(Yn-li))):zo(0,K),Pi&&Rn?(Ye==1?(Pn=be,Fe=jt):(Pn=ge,Fe=Xt),on=S[St],li=N(rn(Pn,re),on,ht,0),Yn=N(rn(Pn+Fe,re),on,ht,0),ko(Gi(li,Yn),En(Yn-li))):ko(0,ht)}else tu()}else{let mt=En(vd-xd),St=En(Md-yd);if(P.ori==1){let re=mt;mt=St,St=re}An=Fn.x&&mt>=Fn.dist,Rn=Fn.y&&St>=Fn.dist;let Dt=Fn.uni;Dt!=null?An&&Rn&&(An=mt>=Dt,Rn=St>=Dt,!An&&!Rn&&(St>mt?Rn=!0:An=!0)):Fn.x&&Fn.y&&(An||Rn)&&(An=Rn=!0);let Nt,Ot;An&&(P.ori==0?(Nt=Nr,Ot=Xe):(Nt=Ur,Ot=Ke),zo(Gi(Nt,Ot),En(Ot-Nt)),Rn||ko(0,ht)),Rn&&(P.ori==1?(Nt=Nr,Ot=Xe):(Nt=Ur,Ot=Ke),ko(Gi(Nt,Ot),En(Ot-Nt)),An||zo(0,K)),!An&&!Rn&&(zo(0,0),ko(0,0))}if(Fn._x=An,Fn._y=Rn,y==null){if(D){if(Nd!=null){let[mt,St]=gn.scales;gn.values[0]=mt!=null?Yi(P.ori==0?Xe:Ke,mt):null,gn.values[1]=St!=null?Yi(P.ori==1?Xe:Ke,St):null}Go(Uf,i,Xe,Ke,z,Rt,U)}if(ee){let mt=D&&gn.setSeries,St=Bt.prox;tr==null?fs<=St&&qi(Ns,Or,!0,mt):fs>St?qi(null,Or,!0,mt):Ns!=tr&&qi(Ns,Or,!0,mt)}}gt&&(it.idx=U,Kh()),A!==!1&&Cn("setCursor")}let Us=null;Object.defineProperty(i,"rect",{get(){return Us==null&&Vo(!1),Us}});function Vo(y=!1){y?Us=null:(Us=p.getBoundingClientRect(),Cn("syncRect",Us))}function wd(y,A,D,U,W,K,ht){st._lock||Ls&&y!=null&&y.movementX==0&&y.movementY==0||(jh(y,A,D,U,W,K,ht,!1,y!=null),y!=null?er(null,!0,!0):er(A,!0,!1))}function jh(y,A,D,U,W,K,ht,mt,St){if(Us==null&&Vo(!1),te(y),y!=null)D=y.clientX-Us.left,U=y.clientY-Us.top;else{if(D<0||U<0){Xe=-10,Ke=-10;return}let[Dt,Nt]=gn.scales,Ot=A.cursor.sync,[re,Te]=Ot.values,[be,ge]=Ot.scales,[jt,Xt]=gn.match,Ye=A.axes[0].side%2==1,rn=P.ori==0?z:Rt,Pn=P.ori==1?z:Rt,Fe=Ye?K:W,on=Ye?W:K,li=Ye?U:D,Yn=Ye?D:U;if(be!=null?D=jt(Dt,be)?a(re,S[Dt],rn,0):-10:D=rn*(li/Fe),ge!=null?U=Xt(Nt,ge)?a(Te,S[Nt],Pn,0):-10:U=Pn*(Yn/on),P.ori==1){let Mi=D;D=U,U=Mi}}St&&(A==null||A.cursor.event.type==Uf)&&((D<=1||D>=z-1)&&(D=Sr(D,z)),(U<=1||U>=Rt-1)&&(U=Sr(U,Rt))),mt?(xd=D,yd=U,[Nr,Ur]=st.move(i,D,U)):(Xe=D,Ke=U)}let Qh={width:0,height:0,left:0,top:0};function tu(){Qa(Qh,!1)}let Td,Ed,Ad,Rd;function Cd(y,A,D,U,W,K,ht){Ls=!0,An=Rn=Fn._x=Fn._y=!1,jh(y,A,D,U,W,K,ht,!0,!1),y!=null&&(xe(Ff,Vf,Pd,!1),Go(ug,i,Nr,Ur,z,Rt,null));let{left:mt,top:St,width:Dt,height:Nt}=qe;Td=mt,Ed=St,Ad=Dt,Rd=Nt}function Pd(y,A,D,U,W,K,ht){Ls=Fn._x=Fn._y=!1,jh(y,A,D,U,W,K,ht,!1,!0);let{left:mt,top:St,width:Dt,height:Nt}=qe,Ot=Dt>0||Nt>0,re=Td!=mt||Ed!=St||Ad!=Dt||Rd!=Nt;if(Ot&&re&&Qa(qe),Fn.setScale&&Ot&&re){let Te=mt,be=Dt,ge=St,jt=Nt;if(P.ori==1&&(Te=St,be=Nt,ge=mt,jt=Dt),An&&Ds(T,Yi(Te,T),Yi(Te+be,T)),Rn)for(let Xt in S){let Ye=S[Xt];Xt!=T&&Ye.from==null&&Ye.min!=Ve&&Ds(Xt,Yi(ge+jt,Xt),Yi(ge,Xt))}tu()}else st.lock&&(st._lock=!st._lock,er(A,!0,y!=null));y!=null&&(ln(Ff,Vf),Go(Ff,i,Xe,Ke,z,Rt,null))}function u_(y,A,D,U,W,K,ht){if(st._lock)return;te(y);let mt=Ls;if(Ls){let St=!0,Dt=!0,Nt=10,Ot,re;P.ori==0?(Ot=An,re=Rn):(Ot=Rn,re=An),Ot&&re&&(St=Xe<=Nt||Xe>=z-Nt,Dt=Ke<=Nt||Ke>=Rt-Nt),Ot&&St&&(Xe=Xe<Nr?0:z),re&&Dt&&(Ke=Ke<Ur?0:Rt),er(null,!0,!0),Ls=!1}Xe=-10,Ke=-10,tt.fill(null),er(null,!0,!0),mt&&(Ls=mt)}function Id(y,A,D,U,W,K,ht){st._lock||(te(y),Bo(),tu(),y!=null&&Go(pg,i,Xe,Ke,z,Rt,null))}function Ld(){b.forEach(w1),k(i.width,i.height,!0)}Tr(Eh,To,Ld);let Br={};Br.mousedown=Cd,Br.mousemove=wd,Br.mouseup=Pd,Br.dblclick=Id,Br.setSeries=(y,A,D,U)=>{let W=gn.match[2];D=W(i,A,D),D!=-1&&qi(D,U,!0,!1)},dt&&(xe(ug,p,Cd),xe(Uf,p,wd),xe(fg,p,y=>{te(y),Vo(!1)}),xe(dg,p,u_),xe(pg,p,Id),Zf.add(i),i.syncRect=Vo);let tl=i.hooks=n.hooks||{};function Cn(y,A,D){qn?Ne.push([y,A,D]):y in tl&&tl[y].forEach(U=>{U.call(null,i,A,D)})}(n.plugins||[]).forEach(y=>{for(let A in y.hooks)tl[A]=(tl[A]||[]).concat(y.hooks[A])});let Dd=(y,A,D)=>D,gn=xn({key:null,setSeries:!1,filters:{pub:Tg,sub:Tg},scales:[T,v[1]?v[1].scale:null],match:[Eg,Eg,Dd],values:[null,null]},st.sync);gn.match.length==2&&gn.match.push(Dd),st.sync=gn;let Nd=gn.key,eu=S0(Nd);function Go(y,A,D,U,W,K,ht){gn.filters.pub(y,A,D,U,W,K,ht)&&eu.pub(y,A,D,U,W,K,ht)}eu.sub(i);function f_(y,A,D,U,W,K,ht){gn.filters.sub(y,A,D,U,W,K,ht)&&Br[y](null,A,D,U,W,K,ht)}i.pub=f_;function d_(){eu.unsub(i),Zf.delete(i),fn.clear(),Wf(Eh,To,Ld),c.remove(),_t?.remove(),Cn("destroy")}i.destroy=d_;function nu(){Cn("init",n,t),Oo(t||n.data,!1),G[T]?$h(T,G[T]):Bo(),at=qe.show&&(qe.width>0||qe.height>0),rt=gt=!0,k(n.width,n.height)}return v.forEach(Rr),b.forEach(ls),e?e instanceof HTMLElement?(e.appendChild(c),nu()):e(i,nu):nu(),i}yn.assign=xn;yn.fmtNum=nd;yn.rangeNum=Ah;yn.rangeLog=Ph;yn.rangeAsinh=td;yn.orient=Ar;yn.pxRatio=Ae;yn.join=mw;yn.fmtDate=sd,yn.tzDate=Ew;yn.sync=S0;{yn.addGap=l1,yn.clipGaps=Dh;let n=yn.paths={points:R0};n.linear=P0,n.stepped=u1,n.bars=f1,n.spline=p1}var T1=n=>sr(String(Number(n.toFixed(6)))),E1=364,Do=n=>bn()?E1:Math.max(n.clientWidth,200);function Oh(n){let t={stroke:Ue("muted"),grid:{stroke:Ue("grid"),width:1},ticks:{show:!1},font:"11px system-ui, sans-serif",values:(e,i)=>i.map(T1)};return[{...t,size:30,label:n,labelSize:18,labelFont:t.font},{...t,size:62}]}var No=(n,t)=>t==null?"–":On(t),Bh={live:!0,markers:{width:0,fill:(n,t)=>n.series[t].stroke(n,t)}};function qa(n,t,e){if(n===null||t===null)return[0,1];let i=.002*Math.max(Math.abs(n),Math.abs(t))||_e(1,e),s=Math.max(t-n,i),r=(n+t)/2;return[r-.58*s,r+.58*s]}function Cs(n,t){let e=0,i=n.length;for(;e<i;){let s=e+i>>1;n[s]<t?e=s+1:i=s}return e}function fd(n,[t,e]){return[Math.max(Cs(n,t)-1,0),Math.min(Cs(n,e)+1,n.length)]}function zh(n,t,e){if(n.length===0||e<n[0]-1||e>n[n.length-1]+1)return NaN;let i=Math.min(Math.max(Cs(n,e),1),n.length-1),s=n[i]-n[i-1],r=s>0?Math.min(Math.max((e-n[i-1])/s,0),1):0;return t[i-1]+r*(t[i]-t[i-1])}function N0(n,t,e){let[i,s]=[1/0,-1/0],[r,o]=fd(n,e);for(let a=r;a<o;a++)t[a]<i&&(i=t[a]),t[a]>s&&(s=t[a]);return[i,s]}var ud=(n,t)=>`${n.toFixed(1)} ${t.toFixed(1)}`;function U0(n,t,e,i,s){let[r,o]=fd(n,e),a=o-r>2*Math.abs(s(e[1])-s(e[0])),l="",c="M",f=h=>{l+=c+ud(i(t[h]),s(n[h])),c="L"},d=r;for(;d<o;){if(!Number.isFinite(t[d])){c="M",d++;continue}if(!a){f(d++);continue}let h=Math.round(s(n[d])),[u,p,x]=[d,d,d];for(;x+1<o&&Math.round(s(n[x+1]))===h&&Number.isFinite(t[x+1]);)x++,t[x]<t[u]&&(u=x),t[x]>t[p]&&(p=x);for(let m of[...new Set([d,Math.min(u,p),Math.max(u,p),x])])f(m);d=x+1}return l}function kh(n,t,e,i,s,r){let[o,a]=fd(n,i),l=Math.max(Math.floor((a-o)/(2*Math.abs(r(i[1])-r(i[0]))+1)),1),c=[],f=[];for(let d=o;d<a;d+=l){let[h,u]=[1/0,-1/0];for(let p=d;p<Math.min(d+l,a);p++)t[p]<h&&(h=t[p]),e[p]>u&&(u=e[p]);h<=u&&(c.push(ud(s(u),r(n[d]))),f.push(ud(s(h),r(n[d]))))}return c.length>1?`M${c.join("L")}L${f.reverse().join("L")}Z`:""}function F0(n,t,e){let i=new Float32Array(t.length),[s,r,o]=[0,0,0];for(let a=0;a<t.length;a++){for(;r<t.length&&n[r]<=n[a]+e;)o+=t[r++];for(;n[s]<n[a]-e;)o-=t[s++];i[a]=o/(r-s)}return i}function Vh(n,t,e){let i=new Float32Array(t.length),s=0;for(let r=0;r<t.length;r++){for(;n[s]<n[r]-e;)s++;let o=-1/0;for(let a=s;a<t.length&&n[a]<=n[r]+e;a++)o=Math.max(o,t[a]);i[r]=o}return i}var dd=[["contact_force_N","Contact force of the node","force"],["tension_N","Effective tension","force"],["torque_N_m","Torque","torque"],["rotary_speed_rad_per_s","Rotary speed","rotary speed"],["bending_moment_N_m","Bending moment","torque"],["offset_high_m","Offset to the high side","diameter"],["offset_right_m","Offset to the right","diameter"]];var A1=yn.sync("time"),O0=216,R1=196;function pd(n,t,e){let i=et("div",{class:"histories"}),s=[],r=!1;function o(b){let S=b.history,E=t.map(_=>({..._,columns:_.columns.filter(([M])=>S[M])})).filter(_=>_.columns.length).filter(_=>_.columns.some(([M])=>S[M].some(C=>C!==0))).map(_=>({..._,times:S.time_s,values:_.columns.map(([M])=>S[M])})),T=e?l(b):null;return T?[...E,T]:E}let a="contact_force_N";function l(b){let{frames:S,contact:E}=b;if(S?.channels[a]){let T=S.md_m.length,_=Ya(S.md_m,qt.depth),[M,C,I]=dd.find(([O])=>O===a),P=Float32Array.from(S.time_s,(O,B)=>S.channels[M][B*T+_]);return{title:`${C} at ${ke(S.md_m[_],"length",5)}`,dimension:I,columns:[[M,"node"]],times:S.time_s,values:[P],chooses:dd.filter(([O])=>S.channels[O])}}if(E){let T=E.md_m.length,_=Ya(E.md_m,qt.depth),M=Float32Array.from(E.time_s,(C,I)=>E.side_force[I*T+_]);return{title:`Side force around ${ke(E.md_m[_],"length",5)}`,dimension:"force per length",columns:[["side_force_N_per_m","side force"]],times:E.time_s,values:[M]}}return null}function c(){s.forEach(E=>E.destroy()),s=[];let b=In(n),S=b?o(b).map(E=>f(E,b)):[];i.replaceChildren(...S.map(E=>E.element));for(let{plot:E,body:T}of S)s.push(d(E,T,b))}function f(b,S){let E=et("div",{class:"plot"}),T=Be(b.dimension),_=et("h3",{},b.points&&b.columns.length===1?b.columns[0][1].replace(/^./,M=>M.toUpperCase()):b.title,T&&et("span",{class:"unit"},` ${T}`));return b.chooses&&_.append(et("select",{class:"noprint","aria-label":"Quantity of the chosen node",onchange:M=>{a=M.target.value,c()}},b.chooses.map(([M,C])=>et("option",{value:M,selected:M===a},C)))),{plot:b,body:E,element:et("figure",{class:"card history"},_,E)}}function d(b,S,E){let T=h(b),_=[Array.from(b.times),...b.values.map(P=>sl(P,b.dimension))],M=b.columns.map(([,P],O)=>{let B=P==="set";return{label:P,stroke:B?Ue("muted"):or([0,2,3][O]??O),width:B?1:1.4,dash:B?[5,4]:void 0,spanGaps:!!b.points,points:{show:!1},value:No}});T!==null&&(_.push(_[0].map(()=>T)),M.push({label:"soft string",stroke:or(1),width:1.4,dash:[7,4],points:{show:!1},value:No}));let C=qt.times??[0,Math.max(E.history.time_s.at(-1),.001)],I=new yn({width:Do(S),height:bn()?R1:O0,cursor:{sync:{key:A1.key,scales:["x",null]},drag:{x:!0,y:!1,uni:8},points:{size:6}},legend:Bh,scales:{x:{time:!1,min:C[0],max:C[1]},y:{dir:b.points?-1:1,range:(P,O,B)=>qa(O,B,b.dimension)}},axes:Oh("Time, s"),series:[{label:"time, s",value:(P,O)=>O===null?"–":O.toFixed(2)},...M],hooks:{setScale:[(P,O)=>O==="x"&&u(P)],drawClear:[P=>p(P,E)],draw:[P=>x(P,E)]}},_,S);return m(I),I}function h(b){let S=bi(n,"soft");if(!b.soft||!S)return null;let E=S.profile[b.soft]?.[0];return Number.isFinite(E)?_e(E,b.dimension):null}function u(b){if(r||b.scales.x.min==null||s.length===0)return;r=!0;let{min:S,max:E}=b.scales.x,_=In(n).history.time_s.at(-1);for(let M of s)M!==b&&M.setScale("x",{min:S,max:E});an({times:S<=1e-6&&E>=_-1e-6?null:[S,E]}),r=!1}function p(b,S){let{ctx:E,bbox:T}=b,_=b.valToPos(S.window_s,"x",!0),M=Math.min(Math.max(_,T.left),T.left+T.width);E.save(),E.fillStyle=Ue("settling"),E.fillRect(T.left,T.top,M-T.left,T.height),E.restore()}function x(b,S){let{ctx:E,bbox:T}=b,_=devicePixelRatio,M=-1/0;E.save(),E.font=`${10*_}px system-ui, sans-serif`,E.textAlign="left",E.fillStyle=Ue("muted"),E.strokeStyle=Ue("muted"),E.setLineDash([2*_,3*_]);let C=qt.moment===null?[]:[[qt.moment,""]];for(let[I,P]of[...S.notes,...C]){let O=b.valToPos(I,"x",!0);if(O<T.left||O>T.left+T.width)continue;E.beginPath(),E.moveTo(O,T.top),E.lineTo(O,T.top+T.height),E.stroke();let B=E.measureText(P).width;P&&O>M&&O+B<T.left+T.width&&(E.fillText(P,O+3*_,T.top+11*_),M=O+B+8*_)}E.restore()}function m(b){let{over:S}=b,E=()=>In(n).history.time_s.at(-1),T=(_,M)=>{let C=Math.max(_,0),I=Math.min(M,E());I-C>.001&&b.setScale("x",{min:C,max:I})};S.addEventListener("wheel",_=>{if(!_.ctrlKey&&!_.metaKey)return;_.preventDefault();let M=b.posToVal(_.clientX-S.getBoundingClientRect().left,"x"),C=Math.exp(_.deltaY*.002);T(M+(b.scales.x.min-M)*C,M+(b.scales.x.max-M)*C)},{passive:!1}),S.addEventListener("mousedown",_=>{if(!_.shiftKey)return;_.stopImmediatePropagation();let M=_.clientX,{min:C,max:I}=b.scales.x,P=O=>{let B=(M-O.clientX)/S.clientWidth*(I-C),N=Math.min(Math.max(B,-C),E()-I);T(C+N,I+N)};addEventListener("mousemove",P),addEventListener("mouseup",()=>removeEventListener("mousemove",P),{once:!0})},{capture:!0}),S.addEventListener("dblclick",()=>b.setScale("x",{min:0,max:E()}))}Oe(e?"units operation depth":"units operation",c),Oe("times",()=>{if(r)return;let b=In(n);if(!b)return;let[S,E]=qt.times??[0,b.history.time_s.at(-1)];r=!0;for(let T of s)T.setScale("x",{min:S,max:E});r=!1}),Oe("moment",()=>s.forEach(b=>b.redraw(!1,!1)));let g=0;new ResizeObserver(()=>{if(!(bn()||i.clientWidth===g)){g=i.clientWidth;for(let b of s)b.setSize({width:Do(b.root.parentElement),height:O0})}}).observe(i);let v=et("p",{class:"hint noprint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, double-click for all times; grey: before the window of the statistics");return{element:et("div",{},v,i),redraw:c}}function Ya(n,t){let e=Math.min(Math.max(Cs(n,t??0),1),n.length-1);return Math.abs(n[e]-t)<Math.abs(n[e-1]-t)?e:e-1}var Gh=58,B0=96,Hh=10,z0=34,md=430,C1=700;function P1(n,t){let e=n.filter(Number.isFinite).map(Math.abs).sort((i,s)=>i-s);return e[Math.floor(t*(e.length-1))]||1}function k0(n){let t="side_force",e=et("canvas",{class:"map",role:"img","aria-label":"Contact over depth and time"}),i=et("p",{class:"readout-line"}," "),s=et("div",{class:"map-holder"},e),r=et("div",{class:"tools noprint"},ir("What the map shows",[["side_force","Side force, by side"],["contact_force","Contact force"]],t,u=>{t=u,a()}),et("span",{class:"hint"},"follows the depths and times in view above; click to choose a depth and a time")),o=u=>({depths:qt.depths??[0,u.contact.md_m.at(-1)],times:qt.times??[u.contact.from_s,u.contact.time_s.at(-1)]});function a(){let u=In(n);if(!u?.contact)return;let p=Math.max(devicePixelRatio,2),x=bn()?C1:s.clientWidth||1200;e.width=x*p,e.height=md*p,e.style.aspectRatio=`${x} / ${md}`;let m=e.getContext("2d");m.scale(p,p),m.font="11px system-ui, sans-serif";let{depths:g,times:v}=o(u),b={left:Gh,top:Hh,width:x-Gh-B0,height:md-Hh-z0},S=P1(Array.from(u.contact[t]),.985),E=t==="side_force",T=zr(E),_=M=>T(E?.5+.5*M/S:M/S);l(m,u,b,g,v,_),c(m,b,g,v,u),f(m,b,S,_)}function l(u,p,x,[m,g],[v,b],S){let{contact:E}=p,T=E.md_m.length,_=new ImageData(E.time_s.length,Math.round(x.height));for(let P=0;P<_.height;P++){let O=Ya(E.md_m,m+(P+.5)/_.height*(g-m));for(let B=0;B<_.width;B++){let[N,G,V]=S(E[t][B*T+O]||0);_.data.set([N,G,V,255],4*(P*_.width+B))}}let M=new OffscreenCanvas(_.width,_.height);M.getContext("2d").putImageData(_,0,0),u.save(),u.beginPath(),u.rect(x.left,x.top,x.width,x.height),u.clip(),u.imageSmoothingEnabled=!1;let C=P=>x.left+(P-v)/(b-v)*x.width,I=E.from_s;E.time_s.forEach((P,O)=>{u.drawImage(M,O,0,1,_.height,C(I),x.top,C(P)-C(I)+.5,x.height),I=P}),u.restore()}function c(u,p,[x,m],[g,v],b){let S=C=>p.top+(C-x)/(m-x)*p.height,E=C=>p.left+(C-g)/(v-g)*p.width;u.fillStyle=u.strokeStyle=Ue("muted"),u.textBaseline="middle",u.textAlign="right";let T=zn(_e(x,"length"),_e(m,"length"),9);for(let C of T.values)u.fillText(Un(C,T.step),p.left-8,S(Jn(C,"length")));u.textAlign="center",u.textBaseline="top";let _=zn(g,v,12);for(let C of _.values)u.fillText(Un(C,_.step),E(C),p.top+p.height+6);u.fillText("time, s",p.left+p.width/2,p.top+p.height+20),u.save(),u.translate(9,p.top+p.height/2),u.rotate(-Math.PI/2),u.fillText(`MD, ${Be("length")}`,0,-4),u.restore(),u.strokeStyle=Ue("frame"),u.strokeRect(p.left,p.top,p.width,p.height);let M=(C,I,P,O)=>{u.beginPath(),u.moveTo(C,I),u.lineTo(P,O),u.stroke()};u.strokeStyle=Ue("text"),u.setLineDash([4,4]),b.window_s>g&&b.window_s<v&&(M(E(b.window_s),p.top,E(b.window_s),p.top+p.height),u.textAlign="left",u.fillStyle=Ue("text"),u.fillText("window ▸",E(b.window_s)+4,p.top+4)),u.setLineDash([1,3]);for(let{kind:C,to_m:I}of n.hole)C==="casing"&&I>x&&I<m&&(M(p.left,S(I),p.left+p.width,S(I)),u.textAlign="left",u.fillStyle=Ue("text"),u.fillText("shoe",p.left+4,S(I)-13));u.setLineDash([]),qt.depth!==null&&qt.depth>x&&qt.depth<m&&M(p.left,S(qt.depth),p.left+p.width,S(qt.depth)),qt.moment!==null&&qt.moment>g&&qt.moment<v&&M(E(qt.moment),p.top,E(qt.moment),p.top+p.height)}function f(u,p,x,m){let g=p.left+p.width+14,v=t==="side_force"?-x:0,b=120;for(let E=0;E<b;E++){let[T,_,M]=m(v+(E+.5)/b*(x-v));u.fillStyle=`rgb(${T} ${_} ${M})`,u.fillRect(g,p.top+p.height*(1-(E+1)/b),12,p.height/b+.6)}u.strokeStyle=Ue("frame"),u.strokeRect(g,p.top,12,p.height);let S=zn(_e(v,"force per length"),_e(x,"force per length"),6);u.fillStyle=Ue("muted"),u.textAlign="left",u.textBaseline="middle";for(let E of S.values){let T=(Jn(E,"force per length")-v)/(x-v);u.fillText(Un(E,S.step),g+17,p.top+p.height*(1-T))}u.fillText(Be("force per length"),g,p.top+p.height+12),t==="side_force"&&(u.save(),u.textAlign="center",u.translate(g+66,p.top+p.height*.25),u.rotate(-Math.PI/2),u.fillText("high side",0,0),u.restore(),u.save(),u.textAlign="center",u.translate(g+66,p.top+p.height*.75),u.rotate(-Math.PI/2),u.fillText("low side",0,0),u.restore())}function d(u){let p=In(n);if(!p?.contact)return null;let x=e.getBoundingClientRect(),{depths:m,times:g}=o(p),v=(u.clientX-x.left-Gh)/(x.width-Gh-B0),b=(u.clientY-x.top-Hh)/(x.height-Hh-z0);return v<0||v>1||b<0||b>1?null:{depth:m[0]+b*(m[1]-m[0]),moment:g[0]+v*(g[1]-g[0])}}e.addEventListener("pointermove",u=>{let p=d(u);if(an({pointer:p?.depth??null}),!p)return void(i.textContent=" ");let{contact:x}=In(n),m=Math.min(Math.max(Array.from(x.time_s).findIndex(b=>b>=p.moment),0),x.time_s.length-1),g=x[t][m*x.md_m.length+Ya(x.md_m,p.depth)],v=t==="contact_force"||Math.abs(g)===0?"":g>0?", high side":", low side";i.textContent=`MD ${ke(p.depth,"length",5)}, ${On(p.moment,4)} s: ${ke(Math.abs(g),"force per length",3)}${v}`}),e.addEventListener("pointerleave",()=>{an({pointer:null}),i.textContent=" "}),e.addEventListener("click",u=>{let p=d(u);p&&an(p)}),Oe("units operation depths times depth moment",a);let h=0;return new ResizeObserver(()=>{s.clientWidth!==h&&(h=s.clientWidth,a())}).observe(s),{element:et("div",{},r,s,i),redraw:a}}var V0=260,I1=[["rate_m_per_s","Rate of penetration against weight","rate of penetration","rate of penetration"],["torque_N_m","Torque against weight","torque","torque on bit"]];function G0(n){let t=et("div",{class:"histories"}),e=[];function i(){e.forEach(h=>h.destroy()),e=[];let a=In(n)?.drill_off;if(!a)return t.replaceChildren();let l=Array.from(a.weight_N,(h,u)=>u).filter(h=>Number.isFinite(a.weight_N[h])).sort((h,u)=>a.weight_N[h]-a.weight_N[u]),c=(h,u)=>sl(Array.from(l,p=>a[h][p]),u),f=c("weight_N","force"),d=I1.map(([h,u,p,x])=>{let m=et("div",{class:"plot"}),g=et("h3",{},u,et("span",{class:"unit"},` ${Be(p)}`)),v=()=>e.push(s(m,f,c(h,p),p,x));return{element:et("figure",{class:"card history"},g,m),make:v}});t.replaceChildren(...d.map(h=>h.element));for(let h of d)h.make()}function s(a,l,c,f,d){let h=or(0);return new yn({width:Do(a),height:V0,cursor:{drag:{x:!0,y:!0,uni:8},points:{size:6}},legend:Bh,scales:{x:{time:!1,range:(u,p,x)=>qa(p,x,"force")},y:{range:(u,p,x)=>qa(p,x,f)}},axes:Oh(`Weight on bit, ${Be("force")}`),series:[{label:`weight, ${Be("force")}`,value:No},{label:d,stroke:h,paths:()=>null,points:{show:!0,size:3.5,width:0,fill:`color-mix(in srgb, ${h} 55%, transparent)`},value:No}]},[l,c],a)}Oe("units operation",i);let r=0;new ResizeObserver(()=>{if(!(bn()||t.clientWidth===r)){r=t.clientWidth;for(let a of e)a.setSize({width:Do(a.root.parentElement),height:V0})}}).observe(t);let o=et("p",{class:"note"},"Each point is a sample of the window of the statistics.");return{element:et("div",{class:"drill-off"},t,o),redraw:i}}var Wh=class{constructor(t){this.well=t}at(t,e){let{md_m:i,north_m:s,east_m:r,tvd_m:o,high:a}=this.well,l=Math.min(Math.max(Cs(i,t),1),i.length-1),c=(t-i[l-1])/(i[l]-i[l-1]||1),f=u=>u[l-1]+c*(u[l]-u[l-1]);e.place=[f(r),-f(o),-f(s)],e.high=gd([f(a[1]),-f(a[2]),-f(a[0])]);let d=[r,o,s].map(u=>u[l]-u[l-1]),h=gd([d[0],-d[1],-d[2]]);return e.right=gd(L1(h,e.high)),e}},gd=n=>{let t=Math.hypot(...n)||1;return n.map(e=>e/t)},L1=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],$a=class extends Nn{constructor(t,e){super(),this.rings=t,this.sides=e;let i=t*e;this.setAttribute("position",new Qn(new Float32Array(3*i),3)),this.setAttribute("normal",new Qn(new Float32Array(3*i),3)),this.setAttribute("color",new Qn(new Float32Array(3*i).fill(1),3));let s=[];for(let r=0;r+1<t;r++)for(let o=0;o<e;o++){let[a,l]=[r*e+o,r*e+(o+1)%e];s.push(a,l,a+e,l,l+e,a+e)}this.setIndex(s),this.turns=Array.from({length:e},(r,o)=>[Math.cos(2*Math.PI*o/e),Math.sin(2*Math.PI*o/e)])}ring(t,e,i,s,r){let{position:o,normal:a}=this.attributes;for(let l=0;l<this.sides;l++){let[c,f]=this.turns[l],d=3*(t*this.sides+l);for(let h=0;h<3;h++){let u=c*i[h]+f*s[h];a.array[d+h]=u,o.array[d+h]=e[h]+r*u}}}paint(t,e,i,s){let{color:r}=this.attributes;for(let o=0;o<this.sides;o++)r.array.set([e,i,s],3*(t*this.sides+o))}changed(){for(let t of Object.values(this.attributes))t.needsUpdate=!0;this.computeBoundingSphere()}};var D1=[["side_force_N_per_m","Side force, by side","force per length",!0],["contact_force_N","Contact force of the node","force",!0],["tension_N","Effective tension","force",!1],["torque_N_m","Torque","torque",!1],["bending_moment_N_m","Bending moment","torque",!1],["rotary_speed_rad_per_s","Rotary speed","rotary speed",!1],["von_mises_stress_max_Pa","Largest von Mises stress","pressure",!1],["contact_fraction","Share of time in contact","percent",!1]];function N1(n,t){let{profile:e}=t,i=e.md_m,s=e.lateral_offset_m??U1(n,e),r=F1(e);return{depths:i,high:s.map((o,a)=>-o*Math.cos(r[a])),right:s.map((o,a)=>o*Math.sin(r[a])),values:o=>e[o],has:o=>!!e[o]&&o!=="contact_force_N"}}function U1(n,t){return t.md_m.map(e=>{let i=o=>e>=o.from_m&&e<=o.to_m,s=n.hole.find(i),r=n.string.find(i);return s&&r?(s.diameter_m-r.contact_od_m)/2:0})}function F1(n){let t=[];for(let s=0;s<n.md_m.length;s++){let r=n.climb_rad?.[s];Number.isFinite(r)?t.push([n.md_m[s],Math.cos(r),Math.sin(r)]):!n.climb_rad&&n.side_force_N_per_m[s]!==0&&t.push([n.md_m[s],n.side_force_N_per_m[s]>0?-1:1,0])}if(t.length===0)return n.md_m.map(()=>0);let e=[0,1,2].map(s=>Float32Array.from(t,r=>r[s])),i=(s,r)=>{let o=zh(e[0],r,Math.min(Math.max(s,e[0][0]),e[0].at(-1)));return Number.isFinite(o)?o:0};return n.md_m.map(s=>Math.atan2(i(s,e[2]),i(s,e[1])))}function O1(n,t){let e=n.md_m.length,i=s=>n.channels[s].subarray(t*e,(t+1)*e);return{depths:n.md_m.map(s=>s+n.moved_m[t]),high:i("offset_high_m"),right:i("offset_right_m"),values:i,has:s=>!!n.channels[s]}}function H0(n,t,e){return t?.frames&&e!==null?O1(t.frames,e):N1(n,bi(n,"dynamic")??bi(n,"soft"))}var W0=n=>D1.filter(([t])=>n.has(t));function X0(n,t,e,i,s){let r=t?.frames&&e!==null?t.frames.channels[i]:n.values(i),o=Array.from(r).filter(Number.isFinite).sort((f,d)=>f-d);if(o.length===0)return[0,1];let a=f=>o[Math.round(f*(o.length-1))];if(s){let f=Math.max(Math.abs(a(.01)),Math.abs(a(.99)))||1;return[-f,f]}let[l,c]=[a(.002),a(.998)];return l<c?[l,c]:[l-.5*Math.abs(l||1),c+.5*Math.abs(c||1)]}function q0(n,t){let e=Math.min(Math.max(Cs(n.time_s,t),1),n.time_s.length-1);return e<1?0:t-n.time_s[e-1]<n.time_s[e]-t?e-1:e}var B1=520,z1=10;function Y0(n){let t=gh("The well in space, the string in it",B1);if(!t)return{element:ph(),redraw:()=>{}};let e=new Wh(n.well),i=n.well.md_m.at(-1),s=Math.max(...n.hole.map(V=>V.diameter_m),.1),r=k1(.03*i/s),o=null,a=null,l=null,c=et("div",{class:"colour-key"}),f=et("output",{}),d=et("input",{type:"range",min:0,step:1,"aria-label":"Moment",oninput:()=>{let V=In(n);an({moment:V.frames.time_s[Number(d.value)]})}}),h=et("button",{type:"button",onclick:()=>l?E():S()},"Play"),u=et("button",{type:"button",onclick:()=>{E(),an({moment:null})}},"Mean"),p=et("div",{class:"moments"},h,u,d,f),x=et("output",{}),m=et("input",{type:"range",min:0,max:3.7,step:.01,value:Math.log10(r),"aria-label":"Exaggeration across the hole",oninput:()=>{r=10**Number(m.value),M()}}),g=et("span",{}),v=[["Whole well",()=>B(.3)],["From the side",()=>B(.02)],["From above",()=>[.001,1,.001]]].map(([V,F])=>et("button",{type:"button",onclick:()=>N(F())},V)),b=et("div",{class:"tools noprint"},g,et("label",{},"Across × ",m,x),v,et("span",{class:"hint"},`${mh}; shows the depths in view above`));function S(){h.textContent="Stop",l=setInterval(()=>{let{frames:V}=In(n),F=(Number(d.value)+1)%V.time_s.length;an({moment:V.time_s[F]})},80)}function E(){clearInterval(l),l=null,h.textContent="Play"}let T=()=>qt.depths??[n.well.md_m[0],i];function _([V,F]){let j=Array.from(n.well.md_m).filter(tt=>tt>V&&tt<F),X=(F-V)/300;return[...Array.from({length:301},(tt,it)=>V+it*X),...j].sort((tt,it)=>tt-it)}function M(){t.remove();let[V,F]=T(),j={};for(let X of n.hole){let $=[Math.max(X.from_m,V),Math.min(X.to_m,F)];if($[1]<=$[0])continue;let tt=_($),it=new $a(tt.length,28);tt.forEach((dt,pt)=>{e.at(dt,j),it.ring(pt,j.place,j.high,j.right,X.diameter_m/2*r)}),it.changed();let st=X.kind==="casing",Q=new bs({color:Ue(st?"casing":"rock"),transparent:!0,opacity:st?.16:.26,side:si,depthWrite:!1});t.add(new Hn(it,Q)).renderOrder=2}Km(e,[V,F],s/2*r,B(.3)).forEach(t.add),P(),x.textContent=` ${On(r,2)}`,t.render()}let C=null,I=null;function P(){let V=In(n);a=V?.frames&&qt.moment!==null?q0(V.frames,qt.moment):null;let F=H0(n,V,a),j=W0(F);j.some(([Gt])=>Gt===o)||(o=j[0][0]);let[,X,$,tt]=j.find(([Gt])=>Gt===o);g.replaceChildren(el("Colour: ",j.map(([Gt,Se])=>[Gt,Se]),o,Gt=>{o=Gt,P(),t.render()}));let[it,st]=T(),Q=Array.from(F.depths,(Gt,Se)=>[Gt,Se]).filter(([Gt])=>Gt>=it-1&&Gt<=st+1);(!C||I.geometry!==C||C.rings!==Q.length)&&(I&&t.remove([I]),C=new $a(Math.max(Q.length,2),z1),I=t.add(new Hn(C,new bs({vertexColors:!0})))),t.has(I)||t.add(I);let dt=F.values(o),pt=X0(F,V,a,o,tt),_t=zr(tt),yt=Gt=>_t((Gt-pt[0])/(pt[1]-pt[0])).map(Se=>Se/255),Ft={},Kt=new ce,Vt=n.string;Q.forEach(([Gt,Se],Ie)=>{e.at(Math.min(Gt,i),Ft);let[tn,Re]=[F.high[Se]*r||0,F.right[Se]*r||0],fn=Ft.place.map((z,Rt)=>z+tn*Ft.high[Rt]+Re*Ft.right[Rt]),xe=Vt.find(z=>Gt<=z.to_m)??Vt.at(-1);C.ring(Ie,fn,Ft.high,Ft.right,(xe?.od_m??.12)/2*r);let[ln,Je,en]=Number.isFinite(dt[Se])?yt(dt[Se]):[.5,.5,.5];Kt.setRGB(ln,Je,en,"srgb"),C.paint(Ie,Kt.r,Kt.g,Kt.b)}),C.changed();let he=Be($)?`, ${Be($)}`:"",ae=tt?" (low side −, high side +)":"";c.replaceChildren(...hh(`${X}${he}${ae}, ${ar(qt.operation)}`,$,pt,_t)),p.hidden=!V?.frames,V?.frames&&(d.max=V.frames.time_s.length-1,a!==null&&(d.value=a),u.disabled=a===null,f.textContent=a===null?"mean of the window":`${V.frames.time_s[a].toFixed(2)} s`)}function O(){let[V,F]=T();return Array.from({length:41},(j,X)=>e.at(V+(F-V)*X/40,{}).place)}function B(V){let[F,j]=T().map(st=>e.at(st,{}).place),[X,$]=[j[0]-F[0],j[2]-F[2]],tt=Math.hypot(X,$);if(tt<.001)return[.6,V,.8];let it=X-$<0?-1:1;return[-$/tt*it,V,X/tt*it]}function N(V){let{low:F,high:j}=Cf(e,T()),X=F.clone().add(j).multiplyScalar(.5),$=Pf({low:F,high:j},B(.3)).flatMap(([tt,it])=>[F.y,j.y].map(st=>[tt,st,it]));t.lookAt([...$,...O()],V,X)}function G(){t.size(),M(),N(B(.3))}return Oe("units operation",()=>{E(),M()}),Oe("depths",()=>{M(),N(t.from().toArray())}),Oe("moment",()=>{P(),t.render()}),{element:et("div",{},b,t.holder,p,c),redraw:G}}function k1(n){let t=10**Math.floor(Math.log10(Math.max(n,1)));return[5,2,1].map(e=>e*t).find(e=>e<=Math.max(n,1))??1}var $0=4;function Z0({cover:n,band:t,picture:e,head:i,height:s,total:r,full:o,view:a,zoom:l}){let c=u=>{let[p,x]=a();return i+(u-p)/(x-p)*s},f=u=>{let p=e.getBoundingClientRect(),[x,m]=a(),g=(u.clientY-p.top)/p.height*r;return x+(g-i)/s*(m-x)},d=null;function h(u){let[p,x]=a(),m=r/e.getBoundingClientRect().height*(x-p)/s,g=v=>{let b=(u.clientY-v.clientY)*m,S=Math.min(Math.max(b,o[0]-p),o[1]-x);l([p+S,x+S])};addEventListener("pointermove",g),addEventListener("pointerup",()=>removeEventListener("pointermove",g),{once:!0})}n.addEventListener("pointerdown",u=>{if(u.button===0){if(u.shiftKey)return h(u);d={depth:f(u),y:u.clientY},n.setPointerCapture(u.pointerId)}}),n.addEventListener("pointermove",u=>{let p=f(u);if(d&&Math.abs(u.clientY-d.y)>$0){let x=[c(d.depth),c(p)].sort((m,g)=>m-g);t.setAttribute("y",x[0]),t.setAttribute("height",x[1]-x[0]),t.setAttribute("visibility","visible")}an({pointer:p})}),n.addEventListener("pointerup",u=>{if(!d)return;let{depth:p,y:x}=d;d=null,t.setAttribute("visibility","hidden"),Math.abs(u.clientY-x)>$0?l([p,f(u)]):an({depth:Math.min(Math.max(p,o[0]),o[1])})}),n.addEventListener("pointerleave",()=>an({pointer:null})),n.addEventListener("dblclick",()=>l(o)),n.addEventListener("wheel",u=>{if(!u.ctrlKey&&!u.metaKey)return;u.preventDefault();let p=f(u),x=Math.exp(u.deltaY*.002);l(a().map(m=>p+(m-p)*x))},{passive:!1})}var V1=5,J0=n=>n.kind==="casing"?"casing":"open hole";function K0(n,t){let e=r=>t>=r.from_m&&t<=r.to_m,i=n.hole.find(e),s=n.string.find(e);return[i&&`${J0(i)} ${ke(i.diameter_m,"diameter")}`,s&&`${s.name} ${ke(s.od_m,"diameter")}`].filter(Boolean)}function j0(n,{left:t,width:e,top:i,height:s},[r,o],a){let l=t+e/2,c=Math.max(...n.hole.map(x=>x.diameter_m),...n.string.map(x=>x.contact_od_m)),f=x=>(e-22)/2*(x/c),d=Qt("g",{"clip-path":"inset(0)"}),h=x=>Math.min(Math.max(a(x),i-12),i+s+12);for(let x of n.hole){if(x.to_m<r||x.from_m>o)continue;let[m,g,v]=[h(x.from_m),h(x.to_m),f(x.diameter_m)],b=Qt("title",{},`${J0(x)} ${ke(x.diameter_m,"diameter")}, ${ke(x.from_m,"length",5)} to ${ke(x.to_m,"length",5)}, friction ${x.friction}`);d.append(Qt("rect",{x:l-v,y:m,width:2*v,height:Math.max(g-m,0),class:x.kind==="casing"?"bore":"rock"},b));for(let S of[-1,1]){let E=l+S*v;d.append(Qt("line",{x1:E,x2:E,y1:m,y2:g,class:x.kind==="casing"?"casing":"wall"})),x.kind==="casing"&&x.to_m<o&&d.append(Qt("path",{d:`M${E} ${g}h${S*8}L${E} ${g-9}Z`,class:"shoe"}))}}let u=n.string.at(-1),p=u&&u.to_m-u.from_m<V1?u:null;for(let x of n.string){if(x.to_m<r||x.from_m>o)continue;let[m,g,v]=[h(x.from_m),h(x.to_m),Math.max(f(x.od_m),1.5)],b=Qt("title",{},`${x.name}, OD ${ke(x.od_m,"diameter")}, ${ke(x.from_m,"length",5)} to ${ke(x.to_m,"length",5)}`),S=/pipe/i.test(x.name)&&!/heavy/i.test(x.name)?"pipe":"tool",E=x===p?Qt("path",{d:`M${l-v} ${Math.min(m,g-5)}h${2*v}v${Math.max(g-m,5)*.5}L${l} ${g+3}L${l-v} ${g-Math.max(g-m,5)*.5}Z`,class:"bit"}):Qt("rect",{x:l-v,y:m,width:2*v,height:Math.max(g-m,.7),class:S});E.append(b),d.append(E)}return d}var Xh=6;function G1(n,t){if(t.from==="well"){let e=n.well[t.column];return e.length?[{depths:n.well.md_m,values:e,well:!0}]:[]}return n.solved.flatMap(e=>{let i=t.from==="wear"?e.wear:e.profile,s=i[t.column];if(!s)return[];let r=i.md_m,[o,a]=(t.band??[]).map(c=>i[c]),l={solved:e,depths:r,values:s,low:o,high:a};return t.touches&&(l.values=Vh(r,s,Xh)),t.swings&&(l.far={values:F0(r,s,Xh),low:o&&Vh(r,o.map(c=>-c),Xh).map(c=>-c),high:a&&Vh(r,a,Xh)}),[l]})}var Q0=n=>n.tracks.map(t=>({...t,curves:G1(n,t)})).filter(t=>t.curves.length);var H1=400,W1=700,X1=126,q1=120,Ri=54,Za=88,Ja=14,Qs=82,Y1=20;function t_(n){let t=Q0(n),i=[0,Math.max(n.well.md_m.at(-1)??0,...n.solved.map(_=>_.profile.md_m?.at(-1)??0))],s=()=>qt.depths??i,r=et("div",{class:"tracks"}),o=[],a=["from","to"].map((_,M)=>et("input",{type:"number","aria-label":`Depths in view, ${_}`,step:"any",onchange:C=>{let I=[...s()];I[M]=Jn(Number(C.target.value),"length"),d(I)}})),l=et("span",{}),c=et("button",{type:"button",onclick:()=>d(i)},"All depths"),f=et("div",{class:"tools noprint"},et("label",{},"Depths from ",a[0]),et("label",{},"to ",a[1]),l,c,et("span",{class:"hint"},"drag to zoom, Ctrl + wheel, Shift + drag to move, click to choose a depth, double-click for all"));function d([_,M]){let[C,I]=[Math.max(Math.min(_,M),i[0]),Math.min(Math.max(_,M),i[1])];I-C>=2&&an({depths:C<=i[0]&&I>=i[1]?null:[C,I]})}function h(){let _=bn()?W1:r.clientWidth||1360,M=bn()?q1:X1,C=Math.max(Math.floor((_-Ri-Za-Ja)/(M+Ja)),1),I=Math.ceil(t.length/Math.min(C,t.length)),P=Math.ceil(t.length/I),O=I===1?640:bn()?370:500;o=Array.from({length:I},(G,V)=>u(t.slice(V*P,(V+1)*P),_,P,O)),r.replaceChildren(...o.map(G=>G.picture));let[B,N]=s();a[0].value=_e(B,"length").toFixed(1),a[1].value=_e(N,"length").toFixed(1),l.textContent=Be("length"),c.disabled=qt.depths===null,v()}function u(_,M,C,I){let[P,O]=s(),B=_t=>Qs+(_t-P)/(O-P)*I,N=Qs+I+Y1,G=Qt("svg",{viewBox:`0 0 ${M} ${N}`,width:M,height:N,role:"img","aria-label":_.map(_t=>_t.title).join(", ")}),V=Ri+Za+Ja,F=(M-V-Ja*(C-1)-2)/C;p(G,[P,O],B,M,V);let j={left:Ri,width:Za,top:Qs,height:I},X=Qt("svg",{x:0,y:Qs-10,width:M,height:I+18,viewBox:`0 ${Qs-10} ${M} ${I+18}`});X.append(j0(n,j,[P,O],B)),G.append(X,Qt("text",{x:Ri+Za/2,y:16,class:"title middle"},"Hole, string"));let $=_.map((_t,yt)=>{let Ft={left:V+yt*(F+Ja),width:F,top:Qs,height:I};return{track:_t,text:x(G,_t,Ft,[P,O],B)}}),tt=Qt("line",{x1:Ri,x2:M,class:"cursor",visibility:"hidden"}),it=Qt("line",{x1:Ri,x2:M,class:"chosen",visibility:"hidden"}),st=Qt("text",{x:2,class:"flag",visibility:"hidden"}),Q=Qt("g",{class:"readout"}),dt=Qt("rect",{x:Ri,width:M-Ri,class:"drag",visibility:"hidden"}),pt=Qt("rect",{x:Ri,y:Qs,width:M-Ri,height:I,class:"cover"});return G.append(dt,it,tt,st,Q,pt),Z0({cover:pt,band:dt,picture:G,head:Qs,height:I,total:N,full:i,view:s,zoom:d}),{picture:G,y:B,readouts:$,cursor:tt,chosenLine:it,flag:st,what:Q}}function p(_,[M,C],I,P,O){let{values:B,step:N}=zn(_e(M,"length"),_e(C,"length"),12);for(let G of B){let V=I(Jn(G,"length"));_.append(Qt("line",{x1:O,x2:P,y1:V,y2:V,class:"grid"}),Qt("text",{x:Ri-8,y:V+4,class:"tick end"},Un(G,N)))}_.append(Qt("text",{x:0,y:16,class:"title"},"MD"),Qt("text",{x:0,y:31,class:"unit"},Be("length")))}function x(_,M,C,[I,P],O){let B=[I,P],N=P-I>H1,G=M.curves.map(it=>N&&it.far?{...it,...it.far}:it),V=M.range;if(!V){let it=G.flatMap(st=>[st.values,st.low,st.high].filter(Boolean).map(Q=>N0(st.depths,Q,B)));V=Ym(Math.min(...it.map(st=>st[0])),Math.max(...it.map(st=>st[1])),M.zero||M.sides,Jn(1,M.dimension))}let F=it=>C.left+(it-V[0])/(V[1]-V[0])*C.width,j=Qt("svg",{x:C.left,y:C.top,width:C.width,height:C.height,viewBox:`${C.left} ${C.top} ${C.width} ${C.height}`}),X=qm(_e(V[0],M.dimension),_e(V[1],M.dimension),C.width);for(let it of X.values){let st=F(Jn(it,M.dimension)),Q=Ef(st-C.left,C.width);_.append(Qt("line",{x1:st,x2:st,y1:C.top,y2:C.top+C.height,class:it===0?"zero":"grid"}),Qt("text",{x:st,y:C.top-7,class:`tick ${Q}`},Un(it,X.step)))}for(let it of n.hole.filter(st=>st.kind==="casing"&&st.to_m>I&&st.to_m<P))j.append(Qt("line",{x1:C.left,x2:C.left+C.width,y1:O(it.to_m),y2:O(it.to_m),class:"shoe-depth"}));M.sides&&m(j,M,B,F,O);for(let it of G){let{colour:st,dashed:Q}=it.well?{colour:"var(--text)",dashed:!1}:ol(n,it.solved),dt=!it.well&&kr(n).length>1&&it.solved.operation!==qt.operation;it.low&&it.high&&j.append(Qt("path",{d:kh(it.depths,it.low,it.high,B,F,O),fill:st,class:dt?"band faint":"band"})),j.append(Qt("path",{d:U0(it.depths,it.values,B,F,O),stroke:st,class:`curve${Q?" dashed":""}${dt?" faint":""}`}))}M.touches&&g(j,M,C,B,O);let $=C.left+C.width/2;_.append(j,Qt("rect",{x:C.left,y:C.top,width:C.width,height:C.height,class:"frame"}),Qt("text",{x:$,y:16,class:"title middle"},M.title),Qt("text",{x:$,y:31,class:"unit middle"},Be(M.dimension))),M.sides&&_.append(Qt("text",{x:C.left,y:C.top+C.height+14,class:"side low"},"◂ low side"),Qt("text",{x:C.left+C.width,y:C.top+C.height+14,class:"side high end"},"high side ▸")),M.swings&&N&&_.append(Qt("text",{x:C.left,y:C.top+C.height+14,class:"side"},"joint to joint")),M.touches&&_.append(Qt("text",{x:C.left,y:C.top+C.height+14,class:"side"},"▌ always ",Qt("tspan",{class:"sometimes"},"▌")," at times"));let tt=Qt("text",{x:$,y:48,class:"readout middle"});return _.append(tt),tt}function m(_,M,C,I,P){let O=bi(n,"dynamic")??bi(n,"soft"),B=M.curves.find(V=>V.solved===O);if(!B)return;let N=new Float32Array(B.values.length),G=V=>B.values.map(F=>V(F)?F:0);_.append(Qt("path",{d:kh(B.depths,N,G(V=>V>0),C,I,P),class:"high-side"}),Qt("path",{d:kh(B.depths,G(V=>V<0),N,C,I,P),class:"low-side"}))}function g(_,M,C,I,P){let O=bi(n,"dynamic"),B=M.curves.find(j=>j.solved===O);if(!B)return;let N=j=>j<.01?0:j<=.99?1:2,G=0,{depths:V,values:F}=B;for(let j=1;j<=F.length;j++){if(j<F.length&&N(F[j])===N(F[G]))continue;let X=N(F[G]),[$,tt]=[P(V[G]),P(V[Math.min(j,F.length-1)])];X>0&&tt>C.top&&$<C.top+C.height&&_.append(Qt("rect",{x:C.left,y:$,width:6,height:Math.max(tt-$,.7),class:X===2?"always":"sometimes"})),G=j}}function v(){let[_,M]=s();for(let{y:C,readouts:I,cursor:P,chosenLine:O,flag:B,what:N}of o){let G=(F,j)=>{let X=j!==null&&j>=_&&j<=M;if(F.setAttribute("visibility",X?"visible":"hidden"),X)for(let $ of["y1","y2"])F.setAttribute($,C(j));return X};G(O,qt.depth);let V=G(P,qt.pointer);B.setAttribute("visibility",V?"visible":"hidden"),B.setAttribute("y",V?C(qt.pointer)+4:0),B.textContent=V?On(_e(qt.pointer,"length"),5):"",N.replaceChildren(...(V?K0(n,qt.pointer):[]).map((F,j)=>Qt("text",{x:Ri+Za/2,y:34+13*j,class:"readout middle small"},F.length>24?`${F.slice(0,23)}…`:F)));for(let{track:F,text:j}of I)j.replaceChildren(...V?b(F):[])}}function b(_){return _.curves.filter(C=>C.well||C.solved.operation===qt.operation).map((C,I)=>{let P=zh(C.depths,C.values,qt.pointer),O=C.well?"var(--text)":ol(n,C.solved).colour;return Qt("tspan",{fill:O,dx:I?6:0},Number.isFinite(P)?On(_e(P,_.dimension)):"–")})}function S(){let _=n.solved.map(I=>{let{colour:P,dashed:O}=ol(n,I);return et("span",{class:"key"},Qt("svg",{width:26,height:10},Qt("line",{x1:1,x2:25,y1:5,y2:5,stroke:P,class:`curve${O?" dashed":""}`})),$d(n,I))}),M=n.runs.length?[et("span",{class:"key"},Qt("svg",{width:26,height:10},Qt("rect",{width:26,height:10,fill:"var(--line-0)",class:"band"})),"5–95 % of the time")]:[],C=["high","low"].map(I=>et("span",{class:"key"},Qt("svg",{width:14,height:10},Qt("rect",{width:14,height:10,class:`${I}-side`})),`on the ${I} side`));return[..._,...M,...C]}let E=et("div",{class:"legend"}),T=()=>{E.replaceChildren(...S()),h()};return Oe("units depths operation",T),Oe("pointer depth",v),new ResizeObserver(()=>!bn()&&r.clientWidth!==Number(o[0]?.picture.getAttribute("width"))&&h()).observe(r),{element:et("div",{},E,f,r),redraw:T,full:i}}function e_(n){let t=kr(n),e=n.runs.at(-1);Object.assign(qt,{units:n.units,operation:e?.operation??t.at(-1),depth:(n.well.md_m.at(-1)??0)/2});let i={answers:Zd(n),tracks:t_(n)};n.runs.length&&(i.history=pd(n,n.time_plots,!0),i.contact=k0(n)),n.runs.some(h=>h.drill_off)&&(i.bit=pd(n,n.bit_plots,!1),i.drillOff=G0(n)),n.runs.some(h=>h.bottom)&&(i.bottom=xh(()=>In(n)?.bottom,!0)),n.well.md_m.length>1&&(i.scene=Y0(n));let s=(h,u,...p)=>et("section",{id:h},et("h2",{},u),p),r=h=>n.sheets.filter(u=>u.place===h).map(Wo);function o(h){let u=h.history.time_s.length,p=u<h.samples?`${h.samples} samples are drawn as ${u}, the smallest and the largest of each few: peaks keep their height`:`all ${h.samples} samples are drawn`,{frames:x}=h,m=x&&(x.time_s.length<x.kept?`; ${x.time_s.length} of ${x.kept} frames`:`; all ${x.kept} frames`),g=x&&x.md_m.length<x.nodes?`, ${x.md_m.length} of ${x.nodes} nodes`:"";return`${ar(h.operation)}: ${p}${m??""}${g}.`}let a=document.getElementById("page"),l=t.length>1?ir("Operation",t.map(h=>[h,ar(h)]),qt.operation,h=>an({operation:h,times:null,moment:null})):null;a.append(vh(n.title,al(n),()=>Object.values(i).forEach(h=>h.redraw())),s("answer","Answer",l&&et("div",{class:"operations"},l),i.answers.element),s("tracks","Along the hole",i.tracks.element));let c=[],f=(h,...u)=>c.push([s(...u),h]);if(i.history&&f(h=>h,"history","In time",i.history.element),i.bit&&f(h=>h?.drill_off,"bit","Bit",i.bit.element,i.drillOff.element),i.bottom){let h=et("p",{class:"note"},"As the operation left it.");f(u=>u?.bottom,"bottom","Bottom of the hole",i.bottom.element,h)}i.contact&&f(h=>h,"contact","Contact over depth and time",i.contact.element),a.append(...c.map(([h])=>h)),i.scene&&a.append(s("scene","In space",i.scene.element)),a.append(s("results","All numbers",r("results")),...n.runs.length?[s("numerics","Numerics",r("numerics"))]:[],s("inputs","Inputs, defaults included",r("inputs")),et("footer",{},et("p",{},`Made by ${n.program}. The tables beside this file hold every digit; this page holds what can be seen. `,n.runs.map(o).join(" ")),yh()));let d=()=>c.forEach(([h,u])=>h.toggleAttribute("hidden",!u(In(n))));Oe("operation",d),d(),Object.values(i).forEach(h=>h.redraw())}var qh=ag();Bd(qh.dimensions);qt.units=qh.units;(qh.bottoms?rg:e_)(qh);document.documentElement.dataset.ready="";})();

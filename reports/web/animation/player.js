// Moves the picture of an animated linkage: play, slider, keys, the hand.
const scene=JSON.parse(document.getElementById('scene').textContent);
const $=id=>document.getElementById(id), svg=$('picture'), slider=$('moment'), play=$('play');
const bodies=(scene.moments[0].length-1)/3, names=[...svg.querySelectorAll('.name')], lastMoment=scene.moments.length-1;
let now=0,way=1,running=false,last=null,exact=0;
const shown=[];  // what else follows the moment: functions of its number
function place(i,m){const [b,x,y]=scene.points[i];if(b===0)return[x,y];
  const o=3*b-2,c=Math.cos(m[o+2]),s=Math.sin(m[o+2]);return[m[o]+c*x-s*y,m[o+1]+s*x+c*y];}
const plain=v=>{const t=v.toFixed(scene.decimals);return +t===0?(0).toFixed(scene.decimals):t;};
/** An arrow's path that ends at (x, y), or starts there; nothing of one too short to have a head. */
function arrow(x,y,u,v,starts){const size=Math.hypot(u,v);if(size<.6*scene.offset)return '';
  const tip=starts?[x+u,y+v]:[x,y],h=Math.min(1.4*scene.offset/size,.5),a=tip[0]-h*u,b=tip[1]-h*v,c=.4*h*v,d=.4*h*u;
  return `M${tip[0]-u} ${tip[1]-v}L${tip[0]} ${tip[1]}M${a-c} ${b+d}L${tip[0]} ${tip[1]}L${a+c} ${b-d}`;}
function showLoads(row,scale){const l=scene.loads,n=l.units.length;
  l.units.forEach((unit,k)=>$('force'+k).textContent=row[k]===null?'no force balances the loads':+row[k].toPrecision(4)+' '+unit);
  for(let k=0;k<l.arrows;k++){const [x,y,fx,fy]=row.slice(n+4*k,n+4*k+4);$('arrow'+k).setAttribute('d',arrow(x,y,fx*scale,fy*scale));}}
function show(i){now=i;const m=scene.moments[i];
  for(let b=1;b<=bodies;b++){const o=3*b-2;
    $('body'+b).setAttribute('transform',`translate(${m[o]} ${m[o+1]}) rotate(${m[o+2]*180/Math.PI})`);}
  names.forEach((t,k)=>{const p=place(k,m);t.setAttribute('x',p[0]+scene.offset);t.setAttribute('y',p[1]-scene.offset);});
  scene.traced.forEach(k=>{const p=place(k,m),dot=$('dot'+k);dot.setAttribute('cx',p[0]);dot.setAttribute('cy',p[1]);
    $('place'+k).textContent=`(${plain(p[0])}, ${plain(-p[1])}) ${scene.unit}`;});
  if(scene.loads)showLoads(scene.loads.moments[i],scene.loads.shown??scene.loads.scale);
  for(const follow of shown)follow(i);
  slider.value=i;$('step').textContent='step '+(+m[0].toFixed(2))+' of '+$('step').dataset.all;
  slider.setAttribute('aria-valuetext',$('step').textContent);}
function tick(t){if(!running)return;
  if(last!==null){exact+=way*(t-last)/1000*lastMoment/scene.seconds*$('speed').value;
    if(scene.closed){exact=((exact%lastMoment)+lastMoment)%lastMoment;}
    else{if(exact>lastMoment){exact=2*lastMoment-exact;way=-1;}if(exact<0){exact=-exact;way=1;}exact=Math.min(lastMoment,Math.max(0,exact));}
    show(Math.round(exact));}
  last=t;requestAnimationFrame(tick);}
function run(on){running=on;last=null;play.textContent=on?'Pause':'Play';play.setAttribute('aria-pressed',on);
  if(on){exact=now;requestAnimationFrame(tick);}}
function stopAt(i){run(false);show(Math.min(lastMoment,Math.max(0,i)));}
play.onclick=()=>run(!running);
slider.oninput=()=>stopAt(+slider.value);
$('names').onchange=e=>names.forEach(t=>t.style.display=e.target.checked?'':'none');
const keys={' ':()=>run(!running),ArrowLeft:()=>stopAt(now-1),ArrowRight:()=>stopAt(now+1),n:()=>$('names').click()};
addEventListener('keydown',e=>{const at=e.target;
  if(e.ctrlKey||e.altKey||e.metaKey||at.tagName==='SELECT')return;
  if(at.tagName==='BUTTON'&&e.key===' '||at===slider&&e.key.startsWith('Arrow'))return;
  const act=keys[e.key.length===1?e.key.toLowerCase():e.key];if(act){e.preventDefault();act();}});
// A point taken by hand leads the linkage to the moment, of those that follow each other from here, that brings it nearest.
let held=null;
const onPicture=e=>{const p=new DOMPoint(e.clientX,e.clientY).matrixTransform(svg.getScreenCTM().inverse());return[p.x,p.y];};
const gap=(a,b)=>Math.hypot(a[0]-b[0],a[1]-b[1]);
svg.addEventListener('pointerdown',e=>{const at=onPicture(e),m=scene.moments[now];let best=4*scene.offset;
  scene.points.forEach(([b],k)=>{const d=gap(place(k,m),at);if(b!==0&&d<best){best=d;held=k;}});
  if(held!==null){run(false);svg.setPointerCapture(e.pointerId);e.preventDefault();}});
svg.addEventListener('pointermove',e=>{if(held===null)return;
  const at=onPicture(e),reach=Math.max(2,Math.round(lastMoment/8));let best=now,least=Infinity;
  for(let d=-reach;d<=reach;d++){let i=now+d;
    if(scene.closed)i=((i%lastMoment)+lastMoment)%lastMoment;else if(i<0||i>lastMoment)continue;
    const way=gap(place(held,scene.moments[i]),at)+1e-9*Math.abs(d);if(way<least){least=way;best=i;}}
  show(best);});
for(const end of ['pointerup','pointercancel'])svg.addEventListener(end,()=>{held=null;});

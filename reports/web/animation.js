// Moves the picture of an animated linkage: play, slider, keys.
const scene=JSON.parse(document.getElementById('scene').textContent);
const $=id=>document.getElementById(id), svg=$('picture'), slider=$('moment'), play=$('play');
const bodies=(scene.moments[0].length-1)/3, names=[...svg.querySelectorAll('.name')];
let now=0,way=1,running=false,last=null,exact=0;
function place(i,m){const [b,x,y]=scene.points[i];if(b===0)return[x,y];
  const o=3*b-2,c=Math.cos(m[o+2]),s=Math.sin(m[o+2]);return[m[o]+c*x-s*y,m[o+1]+s*x+c*y];}
const plain=v=>{const t=v.toFixed(scene.decimals);return +t===0?(0).toFixed(scene.decimals):t;};
function showLoads(row){const l=scene.loads,n=l.units.length;
  l.units.forEach((unit,k)=>$('force'+k).textContent=row[k]===null?'no force balances the loads':+row[k].toPrecision(4)+' '+unit);
  for(let k=0;k<l.arrows;k++){const [x,y,fx,fy]=row.slice(n+4*k,n+4*k+4),u=fx*l.scale,v=fy*l.scale,size=Math.hypot(u,v);
    if(size<scene.offset){$('arrow'+k).setAttribute('d','');continue;}
    const h=1.4*scene.offset/size,a=x-h*u,b=y-h*v,c=.4*h*v,d=.4*h*u;
    $('arrow'+k).setAttribute('d',`M${x-u} ${y-v}L${x} ${y}M${a-c} ${b+d}L${x} ${y}L${a+c} ${b-d}`);}}
function show(i){now=i;const m=scene.moments[i];
  for(let b=1;b<=bodies;b++){const o=3*b-2;
    $('body'+b).setAttribute('transform',`translate(${m[o]} ${m[o+1]}) rotate(${m[o+2]*180/Math.PI})`);}
  names.forEach((t,k)=>{const p=place(k,m);t.setAttribute('x',p[0]+scene.offset);t.setAttribute('y',p[1]-scene.offset);});
  scene.traced.forEach(k=>{const p=place(k,m),dot=$('dot'+k);dot.setAttribute('cx',p[0]);dot.setAttribute('cy',p[1]);
    $('place'+k).textContent=`(${plain(p[0])}, ${plain(-p[1])}) ${scene.unit}`;});
  if(scene.loads)showLoads(scene.loads.moments[i]);
  slider.value=i;$('step').textContent='step '+(+m[0].toFixed(2))+' of '+$('step').dataset.all;
  slider.setAttribute('aria-valuetext',$('step').textContent);}
function tick(t){if(!running)return;
  if(last!==null){exact+=way*(t-last)/1000*(scene.moments.length-1)/scene.seconds*$('speed').value;
    const end=scene.moments.length-1;
    if(scene.closed){exact=((exact%end)+end)%end;}
    else{if(exact>end){exact=2*end-exact;way=-1;}if(exact<0){exact=-exact;way=1;}exact=Math.min(end,Math.max(0,exact));}
    show(Math.round(exact));}
  last=t;requestAnimationFrame(tick);}
function run(on){running=on;last=null;play.textContent=on?'Pause':'Play';play.setAttribute('aria-pressed',on);
  if(on){exact=now;requestAnimationFrame(tick);}}
play.onclick=()=>run(!running);
slider.oninput=()=>{run(false);show(+slider.value);};
$('names').onchange=e=>names.forEach(t=>t.style.display=e.target.checked?'':'none');
addEventListener('keydown',e=>{const step={ArrowLeft:-1,ArrowRight:1}[e.key];
  if(e.key===' '&&e.target!==play){e.preventDefault();run(!running);}
  else if(step&&e.target!==slider&&e.target.id!=='speed'){run(false);show(Math.min(scene.moments.length-1,Math.max(0,now+step)));}});
const asked=/^#(\d+)$/.exec(location.hash);
show(asked?Math.min(+asked[1],scene.moments.length-1):0);
if(!asked&&!matchMedia('(prefers-reduced-motion: reduce)').matches)run(true);

// Arrows of velocities, accelerations and reactions; plots over the driver that follow the pointer; marks of the motion.
const motion=scene.motion, loads=scene.loads, many=scene.moments.length;
const isMoving=k=>scene.points[k][0]!==0, moving=scene.points.map((_,k)=>k).filter(isMoving);
const make=(tag,attributes={},text)=>{const e=document.createElementNS('http://www.w3.org/2000/svg',tag);
  for(const [k,v] of Object.entries(attributes))e.setAttribute(k,v);if(text!==undefined)e.textContent=text;return e;};
const word=(tag,text,name)=>{const e=document.createElement(tag);e.textContent=text;if(name)e.className=name;return e;};
/** Velocity (kind 0) or acceleration (1) of a point at a moment, y downward; null where there is none. */
function rateOf(k,i,kind){const row=motion.rates[i],[b,x,y]=scene.points[k];if(!row)return null;if(b===0)return[0,0];
  const o=3*b-2,m=scene.moments[i],c=Math.cos(m[o+2]),s=Math.sin(m[o+2]),rx=c*x-s*y,ry=s*x+c*y,f=6*(b-1),w=row[f+2];
  if(kind===0)return[row[f]-w*ry,row[f+1]+w*rx];
  const a=row[f+5];return[row[f+3]-a*ry-w*w*rx,row[f+4]+a*rx-w*w*ry];}
const figure=v=>v===null||v===undefined?'none':String(+v.toPrecision(6)).replace('-','\u2212');

// Arrows. A kind is on or off; its longest arrow of the whole motion is a fifth of the picture.
const view=svg.viewBox.baseVal, home=[view.x,view.y,view.width,view.height], extent=Math.max(home[2],home[3])/1.18;
const kinds=[['velocities','v',0],['accelerations','a',1]].map(([name,letter,kind])=>{
  let most=0;for(let i=0;i<many;i++)for(const k of moving){const r=rateOf(k,i,kind);if(r)most=Math.max(most,Math.hypot(...r));}
  const arrows=moving.map(k=>{const e=make('path',{class:'rate '+name,id:`${letter}${k}`,fill:'none'});return e;});
  return{name,letter,kind,most,arrows,scale:most>0?.2*extent/most:0,on:false,unit:`${scene.unit}/s${kind?'\u00b2':''}`};});
const bearing=loads?loads.reactions.map((_,k)=>make('path',{class:'rate reactions',id:`r${k}`,fill:'none'})):[];
const width=+(svg.querySelector('.link')||svg.querySelector('.pin'))?.getAttribute('stroke-width')||extent/200;
const layer=make('g',{'stroke-width':.75*width,'stroke-linecap':'round','stroke-linejoin':'round','pointer-events':'none'});
for(const e of [...kinds.flatMap(k=>k.arrows),...bearing])layer.append(e);
svg.insertBefore(layer,names[0]||null);
let bearingMost=0;if(loads)for(const row of loads.forces)for(const f of row)if(f)bearingMost=Math.max(bearingMost,Math.hypot(f[2],f[3]));
const bearingScale=bearingMost>0?Math.min(loads.scale||Infinity,.2*extent/bearingMost):0;
let bearingOn=false;
shown.push(i=>{for(const k of kinds)k.arrows.forEach((e,n)=>{const r=k.on?rateOf(moving[n],i,k.kind):null;
    const p=place(moving[n],scene.moments[i]);e.setAttribute('d',r?arrow(p[0],p[1],r[0]*k.scale,r[1]*k.scale,true):'');});
  bearing.forEach((e,n)=>{const f=bearingOn?loads.forces[i][n]:null;
    e.setAttribute('d',f?arrow(f[0],f[1],f[2]*bearingScale,f[3]*bearingScale):'');});});
/** The picture widened to hold every arrow that is on, at every moment. */
function fitView(){let[x0,y0,w,h]=home,x1=x0+w,y1=y0+h;const pad=.03*extent;
  const hold=(x,y)=>{x0=Math.min(x0,x-pad);x1=Math.max(x1,x+pad);y0=Math.min(y0,y-pad);y1=Math.max(y1,y+pad);};
  for(let i=0;i<many;i++){for(const k of kinds)if(k.on)for(const n of moving){const r=rateOf(n,i,k.kind),p=place(n,scene.moments[i]);
      if(r)hold(p[0]+r[0]*k.scale,p[1]+r[1]*k.scale);}
    if(bearingOn)for(const f of loads.forces[i])if(f)hold(f[0]-f[2]*bearingScale,f[1]-f[3]*bearingScale);}
  svg.setAttribute('viewBox',`${x0} ${y0} ${x1-x0} ${y1-y0}`);}
function tellArrows(){const words=[];
  for(const k of kinds)if(k.on)words.push([k.name,`longest ${figure(k.most)} ${k.unit}`]);
  if(bearingOn)words.push(['reactions',`longest ${figure(bearingMost)} N`]);
  $('arrowkey').replaceChildren(...words.map(([name,text])=>{const e=word('span',`${name}: ${text}`,name);return e;}));}
function toggle(button,set){const on=button.getAttribute('aria-pressed')!=='true';button.setAttribute('aria-pressed',on);set(on);
  fitView();tellArrows();show(now);}
for(const k of kinds){const b=$(k.name);b.onclick=()=>toggle(b,on=>{k.on=on;showPolygon();});keys[k.letter]=()=>b.click();}
if(loads&&loads.reactions.length){const b=$('reactions');
  b.onclick=()=>toggle(b,on=>{bearingOn=on;loads.shown=on?bearingScale:loads.scale;});keys.r=()=>b.click();}

// Polygons: the rates of all points from one pole; a link's own are its image, turned and scaled.
const polygons=$('polygons');
function showPolygon(){polygons.hidden=!kinds.some(k=>k.on);kinds.forEach(k=>{$('polygon-'+k.name).hidden=!k.on;});}
kinds.forEach(k=>{const box=$('polygon-'+k.name),p=box.querySelector('svg'),size=200;
  let[x0,x1,y0,y1]=[0,0,0,0];for(let i=0;i<many;i++)for(const n of moving){const r=rateOf(n,i,k.kind);if(!r)continue;
    x0=Math.min(x0,r[0]);x1=Math.max(x1,r[0]);y0=Math.min(y0,r[1]);y1=Math.max(y1,r[1]);}
  const s=(size-44)/(Math.max(x1-x0,y1-y0)||1),ox=(size-s*(x0+x1))/2,oy=(size-s*(y0+y1))/2;
  shown.push(i=>{if(!k.on)return;p.replaceChildren();
    for(let b=1;b<motion.links;b++){const ends=[];scene.points.forEach(([home,,],n)=>{if(home===b)ends.push(n);});
      const d=ends.map(n=>rateOf(n,i,k.kind)).filter(Boolean).map(r=>`${ox+s*r[0]} ${oy+s*r[1]}`);
      if(d.length>1)p.append(make('path',{class:'image',d:'M'+d.join('L')+(d.length>2?'Z':'')}));}
    const taken=[];
    for(const n of moving){const r=rateOf(n,i,k.kind);if(!r)continue;const x=ox+s*r[0],y=oy+s*r[1];
      p.append(make('path',{class:'ray '+k.name,d:`M${ox} ${oy}L${x} ${y}`}));p.append(make('circle',{class:'tip '+k.name,cx:x,cy:y,r:2.4}));
      const twin=taken.find(t=>Math.hypot(t.x-x,t.y-y)<9);
      if(twin)twin.words.push(motion.names[n].toLowerCase());else taken.push({x,y,words:[motion.names[n].toLowerCase()]});}
    p.append(make('circle',{class:'pole',cx:ox,cy:oy,r:3}));
    for(const t of taken)p.append(make('text',{x:t.x+5,y:t.y-4},t.words.join(', ')));
    p.append(make('text',{x:ox-5,y:oy+12,'text-anchor':'end'},'o'));});});

// What can be plotted: each thing has three plots, each plot its curves.
const sorts=[];
const curve=(name,words,of)=>({name,words,of});
moving.forEach(k=>{const n=motion.names[k];sorts.push({group:'Points',name:n,plots:[
  ['place',scene.unit,[curve('x','x',i=>place(k,scene.moments[i])[0]),curve('y','y',i=>-place(k,scene.moments[i])[1])]],
  ...kinds.map(t=>[t.kind?'acceleration':'velocity',t.unit,[
    curve('x',`${t.letter}x`,i=>rateOf(k,i,t.kind)?.[0]??null),curve('y',`${t.letter}y`,i=>{const r=rateOf(k,i,t.kind);return r?-r[1]:null;}),
    curve('size',`|${t.letter}|`,i=>{const r=rateOf(k,i,t.kind);return r?Math.hypot(...r):null;})]])]});});
for(let b=1;b<motion.links;b++){if(motion.names.includes(motion.bodies[b]))continue;  // a point of no link
  const spin=(i,at)=>motion.rates[i]?-motion.rates[i][6*(b-1)+at]:null;
  sorts.push({group:'Links',name:motion.bodies[b],plots:[
    ['angle','degrees',[curve('x','angle',i=>-scene.moments[i][3*b]*180/Math.PI)]],
    ['angular velocity','rad/s',[curve('x','\u03c9',i=>spin(i,2))]],
    ['angular acceleration','rad/s\u00b2',[curve('x','\u03b1',i=>spin(i,5))]]]});}
if(loads){loads.reactions.forEach((label,n)=>{const f=(i,at)=>loads.forces[i][n]?.[at]??null;
    sorts.push({group:'Reactions',name:label,plots:[['force','N',[curve('x','Fx',i=>f(i,2)),curve('y','Fy',i=>{const v=f(i,3);return v===null?null:-v;}),
      curve('size','|F|',i=>f(i,2)===null?null:Math.hypot(f(i,2),f(i,3)))]]]});});
  loads.units.forEach((unit,n)=>sorts.push({group:'Drivers',name:motion.drivers[n][0],plots:[
    [unit==='N'?'force':'moment',unit,[curve('x',unit==='N'?'F':'M',i=>loads.moments[i][n])]]]}));}
const of=$('of');
for(const group of [...new Set(sorts.map(s=>s.group))]){const g=document.createElement('optgroup');g.label=group;
  sorts.forEach((s,n)=>{if(s.group===group){const o=word('option',s.name);o.value=n;g.append(o);}});of.append(g);}
// Over what: a driver that goes one way, or the time.
const overs=motion.drivers.map(([label,unit],n)=>({label:`${label}, ${unit==='deg'?'degrees':unit}`,at:i=>motion.values[i][n]}))
  .filter(o=>{let up=true,down=true;for(let i=1;i<many;i++){up&&=o.at(i)>o.at(i-1);down&&=o.at(i)<o.at(i-1);}return many>1&&(up||down);});
overs.push({label:'time, s',at:i=>scene.moments[i][0]*motion.seconds_a_step});
overs.forEach((o,n)=>{const e=word('option',o.label);e.value=n;$('over').append(e);});

const W=400,H=158,L=58,R=12,T=10,B=26;
function ticks(low,high,count){const raw=(high-low)/count,power=10**Math.floor(Math.log10(raw)),step=[1,2,2.5,5,10].map(f=>f*power).find(s=>s>=raw*(1-1e-9));
  const all=[];for(let i=Math.ceil(low/step-1e-9);i*step<=high+1e-9*step;i++)all.push(i*step);return all;}
const angleTicks=(low,high)=>{const step=[15,30,45,60,90,180,360].find(s=>(high-low)/s<=6);const all=[];
  for(let i=Math.ceil(low/step-1e-9);i*step<=high+1e-9;i++)all.push(i*step);return all;};
const tick3=v=>{const t=Math.abs(v)>=1e5||v!==0&&Math.abs(v)<1e-3?v.toExponential(1):String(+v.toPrecision(5));return t.replace('-','\u2212');};
let drawn=[];
function drawPlots(){const sort=sorts[+of.value],over=overs[+$('over').value];drawn=[];
  for(let n=0;n<3;n++){const box=$('plot'+n),p=box.querySelector('svg'),caption=box.querySelector('figcaption');p.replaceChildren();caption.replaceChildren();
    const plot=sort.plots[n];box.hidden=!plot;if(!plot)continue;const[title,unit,curves]=plot;
    const xs=Array.from({length:many},(_,i)=>over.at(i)),x0=Math.min(...ends(xs)),x1=Math.max(...ends(xs));
    const ys=curves.map(c=>Array.from({length:many},(_,i)=>c.of(i)));
    let low=Infinity,high=-Infinity;for(const row of ys)for(const y of row)if(y!==null){low=Math.min(low,y);high=Math.max(high,y);}
    if(!(low<=high)){low=-1;high=1;}
    const size=Math.max(Math.abs(low),Math.abs(high),1e-9);if(high-low<1e-6*size){low-=.5*size;high+=.5*size;}
    if(title!=='place'&&title!=='angle'){low=Math.min(low,0);high=Math.max(high,0);}
    const room=.05*(high-low);low-=room;high+=room;
    const X=x=>L+(W-L-R)*(x-x0)/((x1-x0)||1),Y=y=>H-B-(H-B-T)*(y-low)/(high-low);
    const isAngle=over.label.endsWith('degrees')&&x1-x0>=60;
    for(const x of isAngle?angleTicks(x0,x1):ticks(x0,x1,6)){p.append(make('path',{class:'grid',d:`M${X(x)} ${T}V${H-B}`}));
      p.append(make('text',{x:X(x),y:H-B+14,'text-anchor':'middle'},tick3(x)));}
    for(const y of ticks(low,high,4)){p.append(make('path',{class:Math.abs(y)<1e-12*size?'grid zero':'grid',d:`M${L} ${Y(y)}H${W-R}`}));
      p.append(make('text',{x:L-6,y:Y(y)+4,'text-anchor':'end'},tick3(Math.abs(y)<1e-12*size?0:y)));}
    for(const mark of motion.marks){const i=Math.floor(mark.at),j=Math.min(i+1,lastMoment),x=xs[i]+(mark.at-i)*(xs[j]-xs[i]);
      const line=make('path',{class:'mark',d:`M${X(x)} ${T}V${H-B}`});line.append(make('title',{},mark.words));p.append(line);}
    ys.forEach((row,c)=>{let d='',pen=false;row.forEach((y,i)=>{if(y===null){pen=false;return;}d+=`${pen?'L':'M'}${X(xs[i]).toFixed(2)} ${Y(y).toFixed(2)}`;pen=true;});
      p.append(make('path',{class:'curve '+curves[c].name,d}));});
    const cursor=make('path',{class:'cursor'}),dots=curves.map(c=>make('circle',{class:'at '+c.name,r:3.2}));p.append(cursor,...dots);
    caption.append(word('b',`${title}, ${unit}`));const values=curves.map(c=>{const s=word('span','',c.name),o=word('output','');
      s.append(word('i',c.words),' ',o);caption.append(s);return o;});
    p.setAttribute('aria-label',`${title} of ${sort.name} over ${over.label}`);
    drawn.push({p,xs,X,Y,ys,cursor,dots,values,least:1e-8*size});}  // what is smaller is the solver's rounding
  $('overword').textContent=over.label;followPlots(now);}
const ends=xs=>[xs[0],xs[xs.length-1]];
function followPlots(i){for(const d of drawn){d.cursor.setAttribute('d',`M${d.X(d.xs[i])} ${T}V${H-B}`);
    d.ys.forEach((row,c)=>{const y=row[i];d.values[c].textContent=figure(y!==null&&Math.abs(y)<d.least?0:y);d.dots[c].style.display=y===null?'none':'';
      if(y!==null){d.dots[c].setAttribute('cx',d.X(d.xs[i]));d.dots[c].setAttribute('cy',d.Y(y));}});}}
shown.push(followPlots);
for(let n=0;n<3;n++){const p=$('plot'+n).querySelector('svg');p.setAttribute('viewBox',`0 0 ${W} ${H}`);
  const lead=e=>{if(e.type==='pointermove'&&e.pointerType!=='mouse'&&!e.buttons)return;const d=drawn.find(one=>one.p===p);if(!d)return;
    const x=new DOMPoint(e.clientX,e.clientY).matrixTransform(p.getScreenCTM().inverse()).x;let best=0,least=Infinity;
    d.xs.forEach((v,i)=>{const way=Math.abs(d.X(v)-x);if(way<least){least=way;best=i;}});stopAt(best);};
  p.addEventListener('pointermove',lead);p.addEventListener('pointerdown',lead);}
of.onchange=$('over').onchange=drawPlots;
of.value=Math.max(0,sorts.findIndex(s=>s.name===motion.names[scene.traced[0]]));

// Marks: where the motion stands out, to go there.
$('marks').replaceChildren(...motion.marks.map(mark=>{const item=document.createElement('li'),b=word('button',`step ${+(stepAt(mark.at)).toFixed(2)}`);
  b.type='button';b.onclick=()=>stopAt(Math.round(mark.at));item.append(b,' '+mark.words);return item;}));
function stepAt(at){const i=Math.floor(at),j=Math.min(i+1,lastMoment);return scene.moments[i][0]+(at-i)*(scene.moments[j][0]-scene.moments[i][0]);}
$('marksbox').hidden=motion.marks.length===0;
drawPlots();
const asked=/^#(\d+)$/.exec(location.hash);
show(asked?Math.min(+asked[1],lastMoment):0);
if(!asked&&!matchMedia('(prefers-reduced-motion: reduce)').matches)run(true);

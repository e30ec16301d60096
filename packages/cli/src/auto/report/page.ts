import type { AutoArea, JointArea } from 'furrow/author'
import type { Landmarks, Place } from 'furrow/internal'
import { htmlPage } from '../../html-page.ts'
import { type Content, html, type Markup } from '../../markup.ts'
import type { JointPose } from './joint-poses.ts'
import type { BeforeAndAfter, ReportImage, RestAndBent } from './pictures.ts'
import type { Pose } from './poses.ts'
import type { ReportSource } from './report-source.ts'
import { COLOUR_SCALE, MAX_COMPRESSION } from './strain-colours.ts'
import { STYLE } from './style.ts'

/** Content of the report page. `strain` and `faces` are in the order of `poses`. */
export interface PageSource extends Omit<ReportSource, 'path' | 'glb'> {
  title: string
  poses: readonly Pose[]
  strain: readonly ReportImage[]
  areas: readonly ReportImage[]
  layers: readonly (readonly ReportImage[])[]
  /** Two images per pose, or the reason why the face could not be drawn. */
  faces: readonly BeforeAndAfter[] | string
  jointPoses: readonly JointPose[]
  /** Three images per pose of joints, or the reason why they could not be drawn. */
  joints: readonly RestAndBent[] | string
  times: readonly { step: string; seconds: number }[]
}

/** Returns the HTML of the report of `furrow auto`. Its images are in the same folder. */
export function reportPage(source: PageSource): string {
  const { title, wrinkles, poses } = source
  const { layers, areas, jointAreas, targets, landmarks } = wrinkles
  const joints = new Set(jointAreas.flatMap(({ drivers }) => drivers.map(({ joints: [, joint] }) => joint)))
  const causes = [
    ...(targets.length > 0 ? [count(targets.length, 'blendshape')] : []),
    ...(joints.size > 0 ? [count(joints.size, 'joint')] : []),
  ]
  const body = html`<header>
<h1>${title}</h1>
<p>${count(areas.length + jointAreas.length, 'area')} on ${count(layers.length, 'layer')}, generated from ${causes.join(' and ')} by
<b>furrow auto</b>. ${targets.length > 0 ? recognised(landmarks) : undefined}</p>
${warnings(source.warnings)}
</header>
<main>
${poses.length > 0 ? expressions(source) : undefined}
${source.jointPoses.length > 0 ? jointSection(source) : undefined}
<section>
<h2>Areas</h2>
<p>Compression: relative shortening of the skin across the lines, in the expression that drives the area. Error: root mean square
difference between the driver’s activation and the measured activation over many poses, 0 to 1.</p>
${areaTable(areas, wrinkles.jointAreas, source.areas)}
</section>
<section>
<h2>Layers</h2>
<div class="tiles">${layers.map(({ name }, i) => layerTiles(name, source.layers[i]))}</div>
</section>
<section>
<h2>Details</h2>
<div class="facts">
${facts('Skin', [
  ['Mesh', source.found.meshName],
  ['Material', source.found.materialName],
  ['Triangles', (source.found.skin.indices.length / 3).toLocaleString('en')],
  ['Blendshapes', `${targets.length} of ${source.found.skin.targets.length} used`],
])}
${facts('Settings', Object.entries(source.settings))}
${facts(
  'Time',
  source.times.map(({ step, seconds }) => [step, `${seconds.toFixed(1)} s`]),
)}
${landmarks && landmarkFacts(landmarks)}
</div>
</section>
</main>
`
  return htmlPage({ title: `${title}: wrinkles by furrow auto`, style: STYLE }, body)
}

function recognised(landmarks: Landmarks | undefined): string {
  return landmarks
    ? 'A face was recognised.'
    : 'No face was recognised, so the lines follow only the compression of the skin.'
}

function expressions({ faces, poses, strain }: PageSource): Markup {
  return html`<section>
<h2>Before and after</h2>
${beforeAndAfter(faces, poses)}
</section>
<section>
<h2>Skin compression</h2>
<p>Largest relative shortening of the skin at each texel, in UV space.</p>
${legend()}
<div class="tiles">${poses.map((pose, i) => strainTile(pose, strain[i]))}</div>
</section>`
}

function jointSection({ joints, jointPoses }: PageSource): Markup {
  if (typeof joints === 'string' || joints.length === 0)
    return html`<section><h2>Joints</h2><p class="missing">The joints were not drawn.${typeof joints === 'string' ? ` ${joints}.` : ''}</p></section>`
  return html`<section>
<h2>Joints</h2>
<p>The largest areas that joints fold: at rest, bent without wrinkles, and bent with wrinkles.</p>
<div class="pairs">${jointPoses.map(({ name, joint, degrees }, i) => {
    const [rest, before, after] = joints[i]
    return html`<figure>
<div class="pair three">${image(rest, `${name}, at rest`)}${image(before, `${name}, bent, without wrinkles`)}${image(after, `${name}, bent, with wrinkles`)}</div>
<figcaption><b>${name}</b><span class="chips"><span class="chip more">${joint} <b>${degrees}°</b></span></span></figcaption>
</figure>`
  })}</div>
</section>`
}

function count(number: number, word: string): string {
  return `${number} ${word}${number === 1 ? '' : 's'}`
}

function warnings(texts: readonly string[]): Markup | undefined {
  return texts.length > 0
    ? html`<ul class="warnings">${texts.map((text) => html`<li>${text}</li>`)}</ul>`
    : undefined
}

function beforeAndAfter(faces: PageSource['faces'], poses: readonly Pose[]): Markup {
  if (typeof faces === 'string') return html`<p class="missing">The face was not drawn. ${faces}.</p>`
  return html`<p>Each pose without and with wrinkles.</p>
<div class="pairs">${poses.map(
    (pose, i) => html`<figure>
<div class="pair">${image(faces[i][0], `${pose.name}, without wrinkles`)}${image(faces[i][1], `${pose.name}, with wrinkles`)}</div>
${caption(pose)}
</figure>`,
  )}</div>`
}

function caption({ name, targets }: Pose): Markup {
  const weights = Object.entries(targets).map(([target, weight]) => chip(target, weight))
  return html`<figcaption><b>${name}</b><span class="chips">${weights}</span></figcaption>`
}

function strainTile(pose: Pose, map: ReportImage): Markup {
  return html`<figure>${image(map, `${pose.name}: skin compression in UV space`)}<figcaption><b>${pose.name}</b></figcaption></figure>`
}

function legend(): Markup {
  const colours = COLOUR_SCALE.map((rgb) => `rgb(${rgb.join(' ')})`).join(', ')
  const marks = COLOUR_SCALE.map(
    (_, i) => `${Math.round((100 * MAX_COMPRESSION * i) / (COLOUR_SCALE.length - 1))}%`,
  )
  marks[marks.length - 1] += ' and more'
  return html`<div class="legend"><div style="background: linear-gradient(to right, ${colours})"></div>
<p>${marks.map((mark) => html`<span>${mark}</span>`)}</p></div>`
}

function areaTable(
  areas: readonly AutoArea[],
  jointAreas: readonly JointArea[],
  images: readonly ReportImage[],
): Markup {
  const driven = areas.map(({ driver, ...area }) => {
    const links = [...driver.targets].sort((a, b) => (b.weight ?? 1) - (a.weight ?? 1))
    return { ...area, links: links.map(({ name, weight }) => chip(name, weight ?? 1)) }
  })
  const turned = jointAreas.map(({ drivers, ...area }) => ({
    ...area,
    links: drivers.map(({ joints: [, joint] }) => html`<span class="chip">${joint}</span>`),
  }))
  const rows = [...driven, ...turned].map(({ name, layer, lines, compression, error, links }, i) => {
    return html`<tr>
<td class="map">${image(images[i], `Area ${name} in UV space`)}</td>
<th scope="row">${name}</th>
<td data-label="Layer">${layer + 1}</td>
<td data-label="Lines">${lines}</td>
<td data-label="Compression">${(100 * compression).toFixed(0)}%</td>
<td data-label="Error">${error.toFixed(2)}</td>
<td class="links"><span class="chips">${links}</span></td>
</tr>`
  })
  return html`<table>
<thead><tr><td></td><th scope="col">Area</th><th scope="col">Layer</th><th scope="col">Lines</th><th scope="col">Compression</th>
<th scope="col">Error</th><th scope="col">Driven by</th></tr></thead>
<tbody>${rows}</tbody>
</table>`
}

function layerTiles(name: string, images: readonly ReportImage[]): Content {
  const [normal, height] = images
  return [
    normal &&
      html`<figure>${image(normal, `Normal map of layer ${name}`)}<figcaption><b>${name}</b> normal</figcaption></figure>`,
    height &&
      html`<figure>${image(height, `Heights of layer ${name}`)}<figcaption><b>${name}</b> height</figcaption></figure>`,
  ]
}

/** Returns the name and weight of a blendshape. Their colour depends on the sign of the weight. */
function chip(target: string, weight: number): Markup {
  const sign = weight < 0 ? 'less' : 'more'
  return html`<span class="chip ${sign}">${target} <b>${signed(Number(weight.toFixed(2)))}</b></span>`
}

function image({ file, width, height }: ReportImage, alt: string): Markup {
  return html`<a href="${file}"><img src="${file}" width="${width}" height="${height}" alt="${alt}"></a>`
}

function facts(title: string, rows: readonly (readonly [string, string | number])[]): Markup {
  return html`<div><h3>${title}</h3><dl>${rows.map(([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}</dl></div>`
}

function landmarkFacts(landmarks: Landmarks): Markup {
  const rows = Object.entries(landmarks).map(([name, point]: [string, Place | number]) => {
    const words = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`)
    const position =
      typeof point === 'number'
        ? `${signed(Math.round(point))} up`
        : point.map((mm) => signed(Math.round(mm))).join(', ')
    return [words, position] as const
  })
  return facts('Landmarks (mm left, up, forwards)', rows)
}

/** Formats a number with a minus sign instead of a hyphen, and formats -0 as 0. */
function signed(value: number): string {
  return String(value === 0 ? 0 : value).replace('-', '−')
}

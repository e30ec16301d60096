import { join } from 'node:path'
import { AUTO_REGIONS, autoWrinkles, type Skin } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { noName, SCHEMES, type Spell, STAND_INS, swapSide } from './naming-schemes.ts'
import { spelled } from './rename.ts'

/** The page that has the table, and the lines around it. */
export const PAGE = 'docs/auto-formats.md'
export const MARKS = ['<!-- rigs: npm run rig-table -->', '<!-- end of rigs -->'] as const

/** A blendshape that nearly all rigs have: the table shows its name. */
const EXAMPLE = 'mouthSmileLeft'

/** Gives each shape a name that tells nothing. */
function unnamed(): Spell {
  const shapes: string[] = []
  return (shape) => {
    if (!shapes.includes(shape)) shapes.push(shape)
    return noName(shapes.indexOf(shape))
  }
}

/** Rows of the table: how the names of a face's blendshapes are spelled. */
export const ROWS: Readonly<Record<string, Spell>> = {
  ARKit: (shape) => shape,
  ...SCHEMES,
  ...STAND_INS,
  'left and right swapped': swapSide,
  'no names': unnamed(),
}

/** The face that the rows rename: it has all of ARKit's shapes that move skin. */
export async function readFace(root: string): Promise<Skin> {
  const path = join(root, 'faces/human.glb')
  return findSkin(await readDocument(path, 'rig table'), path, 'rig table').skin
}

/** Makes a row: the rig, its name of a smile, the number of blendshapes, and which sides of each region get areas. */
export function rowOf(name: string, face: Skin): string {
  const spell = ROWS[name]!
  const skin = spelled(face, spell)
  const areas = autoWrinkles(skin, { size: 64, areaSize: 64 }).areas.map((area) => area.name)
  const cells = AUTO_REGIONS.map((region) => {
    const [first, second] = areas.filter((area) => area.replace(/(Left|Right)$/, '') === region)
    if (first === undefined) return '–'
    return first === region || second !== undefined ? 'yes' : first.slice(region.length).toLowerCase()
  })
  const example = spell(EXAMPLE) === undefined ? '–' : `\`${spell(EXAMPLE)}\``.replace('|', '\\|')
  return lineOf([name, example, String(skin.targets.length), ...cells])
}

/** The first two lines of the table. */
export const HEAD = [
  lineOf(['rig', `\`${EXAMPLE}\``, 'shapes', ...AUTO_REGIONS]),
  lineOf(Array.from({ length: AUTO_REGIONS.length + 3 }, () => '---')),
]

function lineOf(cells: readonly string[]): string {
  return `| ${cells.join(' | ')} |`
}

/** The lines of the table in the page. */
export function readTable(page: string): string[] {
  return partsOf(page)[1].trim().split('\n')
}

/** The page with other lines in its table. */
export function withTable(page: string, lines: readonly string[]): string {
  const [before, , after] = partsOf(page)
  return `${before}${MARKS[0]}\n\n${lines.join('\n')}\n\n${MARKS[1]}${after}`
}

function partsOf(page: string): [before: string, table: string, after: string] {
  const [before, rest = ''] = page.split(MARKS[0])
  const [table, after] = rest.split(MARKS[1])
  if (table === undefined || after === undefined) throw new Error(`no table between ${MARKS.join(' and ')}`)
  return [before!, table, after]
}

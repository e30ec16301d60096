import { join } from 'node:path'
import type { AutoArea, AutoWrinkles } from 'furrow/author'
import { CHARACTER_LIMITS } from 'furrow/internal'
import { type Cost, kilobytes } from 'furrow-files'
import type { WrinkledSurface } from './wrinkle-surface.ts'

interface Outputs {
  output: string
  symmetry: number
  report?: string
  ktx2?: boolean
}

export function summaryOf(
  made: readonly WrinkledSurface[],
  { output, symmetry, report }: Outputs,
  bytes: number,
  warnings: readonly string[],
) {
  const [{ wrinkles }, ...others] = made
  return {
    file: output,
    ...(report !== undefined && { report: join(report, 'index.html') }),
    bytes,
    total: {
      areas: totalAreas(made),
      file: made.reduce((sum, { cost }) => sum + cost.file, 0),
      gpu: made.reduce((sum, { cost }) => sum + cost.gpu, 0),
    },
    isFace: wrinkles.landmarks !== undefined,
    symmetry,
    ...surfaceSummary(made[0]),
    others: others.map(surfaceSummary),
    warnings,
  }
}

function surfaceSummary({ found, wrinkles, cost }: WrinkledSurface) {
  const { layers, areas, jointAreas, missing, seed } = wrinkles
  return {
    mesh: found.meshName,
    material: found.materialName,
    reason: found.reason,
    cost,
    seed,
    layers: layers.map(({ name }) => name),
    areas: areas.map(({ name, layer, driver, compression, error, lines }) => ({
      name,
      layer,
      lines,
      compression,
      error,
      links: driver.targets,
    })),
    jointAreas: jointAreas.map(({ name, layer, drivers, compression, lost, error, lines }) => ({
      name,
      layer,
      lines,
      compression,
      ...(lost !== undefined && { lost }),
      error,
      joints: drivers.map(({ joints: [, joint] }) => joint),
    })),
    areasWithoutLines: areasWithoutLines(wrinkles),
    missing,
  }
}

function totalAreas(made: readonly Pick<WrinkledSurface, 'wrinkles'>[]): number {
  return made.reduce((sum, { wrinkles }) => sum + areaCount(wrinkles), 0)
}

function areaCount(wrinkles: AutoWrinkles): number {
  return wrinkles.areas.length + wrinkles.jointAreas.length + areasWithoutLines(wrinkles).length
}

/** Returns the names of areas that only change skin colour, only raise the skin, or contain only fine furrows. */
function areasWithoutLines({ blood, bulges, furrows }: AutoWrinkles): string[] {
  return [...blood.areas, ...bulges, ...(furrows?.areas ?? [])].map(({ name }) => name)
}

/** Tools such as glTF-Transform drop extensions that they do not know. */
const OTHER_TOOLS =
  'tools such as glTF-Transform drop the wrinkles: optimise the file before furrow auto, or register FurrowWrinkleMaps'

export function summaryLines(made: readonly WrinkledSurface[], { output, report, ktx2 }: Outputs): string[] {
  const page = report === undefined ? [] : [`${join(report, 'index.html')}: the report`]
  const advice = `${ktx2 ? 'fewer --layers' : '--ktx2'} or a smaller --size saves memory`
  const total = (size: keyof Cost) => kilobytes(made.reduce((sum, { cost }) => sum + cost[size], 0))
  const onPhone = ktx2 ? ` (${total('phone')} on a phone, as ASTC)` : ''
  const areas = totalAreas(made)
  const sizes = `in total ${areas} of at most ${CHARACTER_LIMITS.areas} areas; wrinkles: ${total('file')} in the file, ${total('gpu')} on the GPU${onPhone}; ${advice}`
  return [...made.flatMap((surface) => surfaceLines(surface, output)), sizes, ...page, OTHER_TOOLS]
}

function surfaceLines({ found, wrinkles }: WrinkledSurface, output: string): string[] {
  const { meshName, materialName, reason } = found
  const { layers, areas, jointAreas, missing, seed } = wrinkles
  const others = areasWithoutLines(wrinkles)
  const count = areaCount(wrinkles)
  const head = `${output}: mesh "${meshName}", material "${materialName}" (${reason}); layers: ${layers.length}; areas: ${count}; seed: ${seed}`
  const rows = areas.map((area) => {
    const links = area.driver.targets.map(({ name: target, weight }) => `${target} ${weight ?? 1}`)
    return areaRow(area, links)
  })
  const jointRows = jointAreas.map((area) => {
    const joints = area.drivers.map(({ joints: [, joint], curve }) => `${joint} ${degrees(curve)}`)
    const limit =
      area.lost === undefined ? [] : [`folds are limited: the cloth loses ${Math.round(100 * area.lost)}%`]
    return areaRow(area, [...joints, ...limit])
  })
  const otherRows = others.length > 0 ? [`  without lines: ${others.join(', ')}`] : []
  return [head, ...rows, ...jointRows, ...otherRows, ...missingRows(missing)]
}

function areaRow(
  { name, layer, compression, error }: Pick<AutoArea, 'name' | 'layer' | 'compression' | 'error'>,
  links: readonly string[],
): string {
  const percent = `${Math.round(100 * compression)}%`.padStart(4)
  return `  ${name.padEnd(20)} layer ${layer + 1}  compression ${percent}  error ${error.toFixed(2)}  ${links.join(', ')}`
}

/** Returns the largest angle of a curve over an angle in radians. */
function degrees(curve: readonly (readonly number[])[]): string {
  return `${Math.round((curve[curve.length - 1][0] * 180) / Math.PI)} degrees`
}

/** Returns one line per reason why regions of the face got no wrinkles. */
function missingRows(missing: AutoWrinkles['missing']): string[] {
  const reasons = [...new Set(missing.map(({ reason }) => reason))]
  return reasons.map((reason) => {
    const names = missing.filter((region) => region.reason === reason).map(({ name }) => name)
    return `  skipped: ${names.join(', ')} (${reason})`
  })
}

import { join } from 'node:path'
import type { AutoWrinkles } from 'furrow/author'
import { type Cost, type FoundSkin, kilobytes } from 'furrow-files'

interface Outputs {
  output: string
  symmetry: number
  report?: string
  ktx2?: boolean
}

export function summaryOf(
  wrinkles: AutoWrinkles,
  { meshName, materialName, reason }: FoundSkin,
  { output, symmetry, report }: Outputs,
  bytes: number,
  cost: Cost,
) {
  const { layers, areas, missing, landmarks, warnings, seed } = wrinkles
  return {
    file: output,
    ...(report !== undefined && { report: join(report, 'index.html') }),
    mesh: meshName,
    material: materialName,
    reason,
    bytes,
    cost,
    isFace: landmarks !== undefined,
    seed,
    symmetry,
    warnings,
    layers: layers.map(({ name }) => name),
    areas: areas.map(({ name, layer, driver, compression, error, lines }) => ({
      name,
      layer,
      lines,
      compression,
      error,
      links: driver.targets,
    })),
    areasWithoutLines: areasWithoutLines(wrinkles),
    missing,
  }
}

/** Returns the names of areas that only change skin colour, only raise the skin, or contain only fine furrows. */
function areasWithoutLines({ blood, bulges, furrows }: AutoWrinkles): string[] {
  return [...blood.areas, ...bulges, ...(furrows?.areas ?? [])].map(({ name }) => name)
}

/** Tools such as glTF-Transform drop extensions that they do not know. */
const OTHER_TOOLS =
  'tools such as glTF-Transform drop the wrinkles: optimise the file before furrow auto, or register FurrowWrinkleMaps'

export function summaryLines(
  wrinkles: AutoWrinkles,
  { meshName, materialName, reason }: FoundSkin,
  { output, report, ktx2 }: Outputs,
  cost: Cost,
): string[] {
  const { layers, areas, missing, seed } = wrinkles
  const others = areasWithoutLines(wrinkles)
  const count = areas.length + others.length
  const head = `${output}: mesh "${meshName}", material "${materialName}" (${reason}); layers: ${layers.length}; areas: ${count}; seed: ${seed}`
  const rows = areas.map(({ name, layer, compression, error, driver }) => {
    const links = driver.targets.map(({ name: target, weight }) => `${target} ${weight ?? 1}`).join(', ')
    const percent = `${Math.round(100 * compression)}%`.padStart(4)
    return `  ${name.padEnd(20)} layer ${layer + 1}  compression ${percent}  error ${error.toFixed(2)}  ${links}`
  })
  const otherRows = others.length > 0 ? [`  without lines: ${others.join(', ')}`] : []
  const page = report === undefined ? [] : [`${join(report, 'index.html')}: the report`]
  const advice = `${ktx2 ? 'fewer --layers' : '--ktx2'} or a smaller --size saves memory`
  const onPhone = ktx2 ? ` (${kilobytes(cost.phone)} on a phone, as ASTC)` : ''
  const sizes = `wrinkles: ${kilobytes(cost.file)} in the file, ${kilobytes(cost.gpu)} on the GPU${onPhone}; ${advice}`
  return [head, ...rows, ...otherRows, ...missingRows(missing), sizes, ...page, OTHER_TOOLS]
}

/** Returns one line per reason why regions of the face got no wrinkles. */
function missingRows(missing: AutoWrinkles['missing']): string[] {
  const reasons = [...new Set(missing.map(({ reason }) => reason))]
  return reasons.map((reason) => {
    const names = missing.filter((region) => region.reason === reason).map(({ name }) => name)
    return `  skipped: ${names.join(', ')} (${reason})`
  })
}

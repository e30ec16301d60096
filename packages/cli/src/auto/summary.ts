import { join } from 'node:path'
import type { AutoWrinkles } from 'furrow/author'
import { type Cost, type FoundSkin, kilobytes } from 'furrow-files'

/** Options of `furrow auto`. */
interface Outputs {
  output: string
  report?: string
  ktx2?: boolean
}

/** Returns the result of `furrow auto` as JSON. */
export function summaryOf(
  { layers, areas, missing, landmarks, warnings }: AutoWrinkles,
  { meshName, materialName, reason }: FoundSkin,
  { output, report }: Outputs,
  bytes: number,
  cost: Cost,
) {
  return {
    file: output,
    ...(report !== undefined && { report: join(report, 'index.html') }),
    mesh: meshName,
    material: materialName,
    reason,
    bytes,
    cost,
    isFace: landmarks !== undefined,
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
    missing,
  }
}

/** Tools such as glTF-Transform drop extensions that they do not know. */
const OTHER_TOOLS =
  'other tools drop the wrinkles: optimise the file before furrow auto, or register FurrowWrinkleMaps'

/** Returns the result of `furrow auto` as text. */
export function summaryLines(
  { layers, areas, missing }: AutoWrinkles,
  { meshName, materialName, reason }: FoundSkin,
  { output, report, ktx2 }: Outputs,
  cost: Cost,
): string[] {
  const head = `${output}: mesh "${meshName}", material "${materialName}" (${reason}); layers: ${layers.length}; areas: ${areas.length}`
  const rows = areas.map(({ name, layer, compression, error, driver }) => {
    const links = driver.targets.map(({ name: target, weight }) => `${target} ${weight ?? 1}`).join(', ')
    const percent = `${Math.round(100 * compression)}%`.padStart(4)
    return `  ${name.padEnd(20)} layer ${layer + 1}  compression ${percent}  error ${error.toFixed(2)}  ${links}`
  })
  const page = report === undefined ? [] : [`${join(report, 'index.html')}: the report`]
  const advice = ktx2 ? 'a smaller --size or fewer --layers use less' : '--ktx2 or a smaller --size uses less'
  const onPhone = ktx2 ? ` (${kilobytes(cost.phone)} on a phone, as ASTC)` : ''
  const sizes = `wrinkles: ${kilobytes(cost.file)} in the file, ${kilobytes(cost.gpu)} on the GPU${onPhone}; ${advice}`
  return [head, ...rows, ...missingRows(missing), sizes, ...page, OTHER_TOOLS]
}

/** Returns one line per reason. */
function missingRows(missing: AutoWrinkles['missing']): string[] {
  const reasons = [...new Set(missing.map(({ reason }) => reason))]
  return reasons.map((reason) => {
    const names = missing.filter((region) => region.reason === reason).map(({ name }) => name)
    return `  skipped: ${names.join(', ')} (${reason})`
  })
}

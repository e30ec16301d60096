import type { Link, WrinkleDriver } from 'furrow'
import { type Contribution, canonicalTargetName } from 'furrow/internal'
import { areaOf } from '../../document/drivers.ts'
import { blendshapeLabel, regionLabel } from '../../labels/names.ts'
import type { PanelModel } from '../model.ts'
import { useThrottled } from './throttled.ts'
import { driverTypeOf } from './types/types.ts'

/** Number of inputs that are shown. */
const MOST = 3
/** Inputs below this contribution are omitted. */
const LEAST = 0.01

interface Reason {
  label: string
  /** Name of the area or the blendshape in the file. */
  name?: string
  value: number
}

/** Name and activation of an area, and the strongest inputs of its drivers, as bars. They are updated while the face moves. */
export function Reasons({ area, model: { viewer, frame } }: { area: string; model: PanelModel }) {
  useThrottled(frame).value
  const face = viewer.value
  if (!face) return null
  const { drivers } = face.driven
  const activation = face.areas.find(({ name }) => name === area)?.read() ?? 0
  return (
    <div class="explanation">
      <Bar label={regionLabel(area)} name={area} value={activation} />
      {reasonsOf(area, drivers.list, drivers.contributions()).map((reason) => (
        <Bar key={reason.name ?? reason.label} {...reason} />
      ))}
    </div>
  )
}

function Bar({ label, name, value }: Reason) {
  const shown = value.toFixed(2)
  return (
    <div class="bar" title={name === undefined ? shown : `${name}: ${shown}`}>
      {label}
      <meter aria-label={label} max={1} value={Number(shown)} />
    </div>
  )
}

function reasonsOf(
  area: string,
  drivers: readonly WrinkleDriver[],
  contributions: readonly (Contribution | null)[],
): Reason[] {
  const all = drivers.flatMap((driver, i): Reason[] => {
    const contribution = contributions[i]
    if (!contribution || areaOf(driver) !== area) return []
    const { targets } = driver as { targets?: Link[] }
    if (driver.type === 'morph' && targets)
      return targets.map(({ name }, k) => ({
        label: blendshapeLabel(canonicalTargetName(name)),
        name,
        value: contribution.links[k],
      }))
    return [{ label: driverTypeOf(driver.type)?.label ?? driver.type, value: contribution.activation }]
  })
  const seen = all.filter(({ value }) => value >= LEAST).sort((a, b) => b.value - a.value)
  return seen.slice(0, MOST)
}

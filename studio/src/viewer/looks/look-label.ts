import type { WrinkleMode } from 'furrow/three'
import { regionLabel } from '../../labels/names.ts'
import { VIEW } from '../../labels/stage.ts'
import type { Look } from './look.ts'

/** Returns the label of the side of the divider that shows wrinkles. */
export function lookLabel(look: Look, mode: WrinkleMode): string {
  if (look.name === 'influence')
    return look.area === undefined ? VIEW.influence : [look.area].flat().map(regionLabel).join(', ')
  if (look.name === 'wireframe' || look.name === 'strain') return VIEW[look.name]
  if (look.name === 'onset') return look.layer === undefined ? VIEW.onset : `${VIEW.onsetOf} ${look.layer}`
  return mode === 'off' ? VIEW.without : VIEW.with
}

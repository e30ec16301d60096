import { areasOf } from '../../drivers/driver.ts'
import { driversOf } from '../../drivers/types.ts'
import type { SourceType } from '../sources/source.ts'
import { sampledTension, tenseMesh } from '../sources/tension.ts'
import { AreaTension } from './area-tension.ts'
import { canCompute } from './buffers.ts'

/**
 * Measures all triangles under an area on the graphics card. Until its first result is there, and where the renderer has no
 * compute passes, the processor measures a sample of them.
 */
export const computedTension: SourceType = {
  types: ['tension'],
  create(wrinkles, drivers) {
    const own = driversOf('tension', drivers)
    const tense = tenseMesh(wrinkles, own)
    const { driver, update } = sampledTension(wrinkles.mesh, tense, own)
    const tension = new AreaTension(wrinkles.mesh, tense)
    wrinkles.onDispose(() => tension.dispose())
    const areas = areasOf(own).places
    const places = own.map(({ measure }, i) => 2 * areas[i] + (measure === 'stretch' ? 1 : 0))
    const measured = new Float64Array(own.length)
    return {
      driver,
      update(_, renderer) {
        if (canCompute(renderer)) tension.update(renderer)
        if (!tension.isReady) return update()
        for (let i = 0; i < measured.length; i++) measured[i] = tension.values[places[i]]
        driver.takeMeasured(measured)
      },
    }
  },
}

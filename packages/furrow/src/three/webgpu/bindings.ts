import { BINDINGS as WEBGL_BINDINGS } from '../sources/bind-drivers.ts'
import type { InputBindings } from '../sources/binding.ts'
import { bindComputedTension } from './compute/computed-tension.ts'

/** How `furrow/webgpu` reads each kind of input. */
export const BINDINGS = { ...WEBGL_BINDINGS, tension: bindComputedTension } satisfies InputBindings

import { listNames } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import { didYouMean } from '../../core/nearest-name.ts'

export function unknownLayer(name: string, layers: readonly { name: string }[], who: string): FurrowError {
  return new FurrowError({
    code: 'unknown-name',
    who,
    problem: 'unknown layer',
    value: name,
    limit: listNames(layers),
    remedy: didYouMean(
      name,
      layers.map((layer) => layer.name),
      'name one of the layers of the set',
    ),
  })
}

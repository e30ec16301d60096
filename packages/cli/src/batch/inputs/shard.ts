import { createHash } from 'node:crypto'
import { InvalidArgumentError } from 'commander'

/** A part of the inputs: the one of `index`, 1 to `count`. */
export interface Shard {
  index: number
  count: number
}

/** A parser for `Option.argParser` of `i/n`. */
export function parseShard(text: string): Shard {
  const [index, count] = /^(\d+)\/(\d+)$/.exec(text)?.slice(1).map(Number) ?? []
  if (index >= 1 && index <= count) return { index, count }
  throw new InvalidArgumentError('It must be I/N, a part and the number of parts, from 1/N to N/N.')
}

/**
 * Whether an input belongs to a shard. By its address and not by its place in the list: machines whose lists differ, since files
 * were added meanwhile, still agree about all others.
 */
export function isInShard(input: string, { index, count }: Shard): boolean {
  return createHash('sha256').update(input).digest().readUInt32BE() % count === index - 1
}

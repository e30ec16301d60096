import { createHash } from 'node:crypto'
import { InvalidArgumentError } from 'commander'

/** Part `index` of the inputs, 1 to `count`. */
export interface Shard {
  index: number
  count: number
}

/** Parses `i/n`, for `Option.argParser`. */
export function parseShard(text: string): Shard {
  const [index, count] = /^(\d+)\/(\d+)$/.exec(text)?.slice(1).map(Number) ?? []
  if (index >= 1 && index <= count) return { index, count }
  throw new InvalidArgumentError('It must be I/N, part I of N parts, from 1/N to N/N.')
}

/**
 * Returns whether an input belongs to a shard. Depends only on the input's address, so that machines agree even if
 * their lists differ because files were added.
 */
export function isInShard(input: string, { index, count }: Shard): boolean {
  return createHash('sha256').update(input).digest().readUInt32BE() % count === index - 1
}

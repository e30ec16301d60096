import { createHash } from 'node:crypto'
import { InvalidArgumentError } from 'commander'

/** One of `count` parts of the inputs of a batch. `index` starts at 1. */
export interface Shard {
  index: number
  count: number
}

export function parseShard(text: string): Shard {
  const [index, count] = /^(\d+)\/(\d+)$/.exec(text)?.slice(1).map(Number) ?? []
  if (index >= 1 && index <= count) return { index, count }
  throw new InvalidArgumentError('It must be I/N, from 1/N to N/N, for part I of N.')
}

/**
 * Returns whether a shard contains an input. The result depends only on the address of the input, so that machines
 * agree even if one of them finds more files than another.
 */
export function isInShard(input: string, { index, count }: Shard): boolean {
  return createHash('sha256').update(input).digest().readUInt32BE() % count === index - 1
}

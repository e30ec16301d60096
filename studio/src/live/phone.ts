import { FurrowError } from 'furrow'
import { connectLive, type LiveConnection } from 'furrow/live'
import type { StartSource } from './source.ts'

/** Time without an answer after which the page tells what may be wrong, milliseconds. */
const PATIENCE = 3000

/** Receives scores of phones and programs from `furrow live`. */
export const startPhone: StartSource = async ({ address }, { onScores, onStatus }) => {
  /** Difference between the clocks of this page and of `furrow live`, seconds. Unknown until the first frame of a connection. */
  let offset: number | null = null
  onStatus('connecting')
  const timer: ReturnType<typeof setTimeout> = setTimeout(() => onStatus('noAnswer'), PATIENCE)
  const connection = connect(address.trim(), {
    onFrame: ({ source, time, scores }) => {
      offset ??= performance.now() / 1000 - time
      onScores(scores, time + offset, source)
    },
    onChange: (isConnected) => {
      clearTimeout(timer)
      offset = null
      onStatus(isConnected ? 'noScores' : 'lost')
    },
  })
  return {
    stop: () => {
      clearTimeout(timer)
      connection.close()
    },
  }
}

interface Handlers {
  onFrame: Parameters<typeof connectLive>[1]
  onChange(isConnected: boolean): void
}

function connect(address: string, { onFrame, onChange }: Handlers): LiveConnection {
  try {
    return connectLive(address, onFrame, { onChange })
  } catch (cause) {
    const isRefused = !(cause instanceof FurrowError)
    throw new FurrowError(
      {
        code: 'unsupported',
        who: 'Studio',
        problem: isRefused
          ? 'the browser allows no connection from this secure page to that address'
          : 'this is not an address of furrow live',
        value: address,
        limit: 'an address such as ws://127.0.0.1:8765/?token=...',
        remedy: isRefused
          ? 'run furrow live on this computer'
          : 'run npx furrow live, and paste the address that it prints',
      },
      { cause },
    )
  }
}

import { readFileSync } from 'node:fs'

/**
 * Returns this process's peak resident memory, bytes. On Linux `maxRSS` includes the parent's memory at the start of the
 * process, so `VmHWM` of proc(5) is read instead.
 */
export function peakMemory(): number {
  const [, kilobytes] = process.platform === 'linux' ? (/^VmHWM:\s*(\d+)/m.exec(ownStatus()) ?? []) : []
  return 1024 * Number(kilobytes ?? process.resourceUsage().maxRSS)
}

function ownStatus(): string {
  return readFileSync('/proc/self/status', 'utf8')
}

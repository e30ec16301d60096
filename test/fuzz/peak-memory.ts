import { readFileSync } from 'node:fs'

/**
 * Returns this process's peak resident memory, bytes. On Linux `maxRSS` starts at the parent's memory, so `VmHWM`
 * (proc(5)) is read instead.
 */
export function peakMemory(): number {
  const [, kilobytes] = process.platform === 'linux' ? (/^VmHWM:\s*(\d+)/m.exec(ownStatus()) ?? []) : []
  return 1024 * Number(kilobytes ?? process.resourceUsage().maxRSS)
}

function ownStatus(): string {
  return readFileSync('/proc/self/status', 'utf8')
}

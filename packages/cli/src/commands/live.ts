import { randomBytes } from 'node:crypto'
import { isIP } from 'node:net'
import { InvalidArgumentError, Option } from 'commander'
import { FurrowError } from 'furrow'
import { createCommand } from '../command.ts'
import { startLive } from '../live/live.ts'
import { SOURCES, type SourceName } from '../live/sources.ts'
import { assignmentParser, numberParser } from '../options.ts'
import { print, warn } from '../print.ts'

const WHO = 'furrow live'

const NAMES = Object.keys(SOURCES) as SourceName[]

interface Options {
  sources: SourceName[]
  host: string
  port: number
  devices: string
  udpPort?: Record<string, number>
  phone?: string
  origin: string[]
  token?: string
}

export const liveCommand = createCommand('live')
  .description('pass a face tracker on to pages, over WebSocket')
  .addOption(new Option('--sources <names...>', 'sources to receive').choices(NAMES).default(NAMES))
  .option('--host <address>', 'address at which pages connect', parseAddress, '127.0.0.1')
  .option('--port <number>', 'TCP port for pages', numberParser({ min: 0, max: 65535, integer: true }), 8765)
  .option(
    '--devices <address>',
    'address at which devices send; 0.0.0.0 for phones',
    parseAddress,
    '127.0.0.1',
  )
  .option('--udp-port <source=number...>', 'other UDP ports', assignmentParser({ min: 0, max: 65535 }))
  .option('--phone <address>', 'address of a phone with iFacialMocap', parseAddress)
  .option('--origin <urls...>', 'further pages that may connect, e.g. https://example.com', [])
  .option('--token <text>', 'secret of the address (default: random)')
  .addHelpText(
    'after',
    `
UDP ports: ${NAMES.map((name) => `${name} ${SOURCES[name].port}`).join(', ')}.
Pages of this computer may connect with the printed address. Ctrl-C stops.

Examples:
  $ furrow live --sources vmc
  $ furrow live --sources live-link-face --devices 0.0.0.0
  $ furrow live --sources ifacialmocap --devices 0.0.0.0 --phone 192.168.1.7`,
  )
  .action(live)

async function live({
  sources,
  udpPort = {},
  origin,
  token = randomToken(),
  ...options
}: Options): Promise<void> {
  const unknown = Object.keys(udpPort).find((name) => !NAMES.includes(name as SourceName))
  if (unknown !== undefined) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      problem: 'unknown source in --udp-port',
      value: unknown,
      limit: NAMES.join(', '),
      remedy: 'name one of these',
    })
  }
  const { port, ports } = await startLive({
    ...options,
    who: WHO,
    token,
    origins: origin.map(toOrigin),
    ports: Object.fromEntries(sources.map((name) => [name, udpPort[name] ?? SOURCES[name].port])),
    onSender: (source, sender) => print(`${source}: receives from ${sender}`),
  })
  const { host } = options
  print([
    ...Object.entries(ports).map(([name, number]) => `${name}: UDP port ${number} of ${options.devices}`),
    `pages: ws://${host.includes(':') ? `[${host}]` : host}:${port}/?token=${encodeURIComponent(token)}`,
  ])
  if (!/^(127\.|::1$)/.test(host)) {
    warn(`${WHO}: the address for pages is open to the network, and the connection is not encrypted`)
  }
}

/** Returns a text that cannot be guessed. */
function randomToken(): string {
  return randomBytes(16).toString('base64url')
}

function parseAddress(text: string): string {
  if (isIP(text)) return text
  throw new InvalidArgumentError('It must be an IP address, e.g. 127.0.0.1.')
}

function toOrigin(text: string): string {
  const { origin } = URL.canParse(text) ? new URL(text) : { origin: 'null' }
  if (origin !== 'null') return origin
  throw new FurrowError({
    code: 'usage',
    who: WHO,
    problem: 'invalid origin',
    value: text,
    limit: 'the address of a page',
    remedy: 'write e.g. --origin https://example.com',
  })
}

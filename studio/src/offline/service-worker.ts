/**
 * Keeps the built page in the browser, so that it works without a network. A build is kept as a whole and never mixed with another one: the
 * new one takes over when all pages of the old one are closed.
 *
 * Written into the build by `offline.ts`, which fills in what is quoted here.
 */

const FILES: unknown = 'FILES'
const CACHE = `furrow-studio ${'VERSION'}`

/** What TypeScript's library for pages does not have. */
interface LifeEvent extends Event {
  waitUntil(work: Promise<unknown>): void
}
interface RequestEvent extends LifeEvent {
  readonly request: Request
  respondWith(response: Promise<Response>): void
}

addEventListener('install', (event) => {
  const keep = async () => {
    const cache = await caches.open(CACHE)
    // Past the browser's own cache, which may have files of an older build.
    await cache.addAll((FILES as string[]).map((path) => new Request(path, { cache: 'reload' })))
  }
  ;(event as LifeEvent).waitUntil(keep())
})

addEventListener('activate', (event) => {
  const forget = async () => {
    const names = await caches.keys()
    const old = names.filter((name) => name.startsWith('furrow-studio ') && name !== CACHE)
    await Promise.all(old.map((name) => caches.delete(name)))
  }
  ;(event as LifeEvent).waitUntil(forget())
})

addEventListener('fetch', (event) => {
  const { request } = event as RequestEvent
  const isOwn = new URL(request.url).origin === location.origin
  if (request.method !== 'GET' || !isOwn) return
  ;(event as RequestEvent).respondWith(answer(request))
})

/** From the cache, else from the network, and kept: the addresses of a build's files never change what they mean. */
async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE)
  // What follows the path is read by the page itself, and files are the same whoever asks: some servers say `Vary: Origin`.
  const known = await cache.match(request, { ignoreSearch: true, ignoreVary: true })
  if (known) return known
  const response = await fetch(request)
  if (response.status === 200) await cache.put(request, response.clone()).catch(() => {})
  return response
}

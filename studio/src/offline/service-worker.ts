/**
 * Caches the built page for offline use. Builds are never mixed: a new one takes over when all pages of the old one are closed.
 *
 * `offline.ts` writes this file into the build and replaces the constants in quotes.
 */

const FILES: unknown = 'FILES'
const CACHE = `furrow-studio ${'VERSION'}`

/** Types missing in TypeScript's library for pages. */
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
    // Bypass the HTTP cache, which can hold files of an older build.
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

/** Serves from the cache, else from the network, and caches the response: files of a build never change. */
async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE)
  // The page itself reads the query. Files do not depend on the origin, although some servers send `Vary: Origin`.
  const known = await cache.match(request, { ignoreSearch: true, ignoreVary: true })
  if (known) return known
  const response = await fetch(request)
  if (response.status === 200) await cache.put(request, response.clone()).catch(() => {})
  return response
}

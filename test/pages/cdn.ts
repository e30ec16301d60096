import { createRequire } from 'node:module'
import type { Page } from 'playwright-core'
import { build, type Rolldown } from 'vite'

/** Packages that examples import from esm.sh, because they have no modules for browsers. */
const PACKAGES = ['react', 'react/jsx-runtime', 'react-dom/client', '@react-three/fiber']

const ORIGIN = 'https://esm.sh/'

const require = createRequire(import.meta.url)

let bundles: Promise<Map<string, string>> | undefined

/** Answers a page's requests to esm.sh with bundles of the installed packages, because tests do not use the network. */
export async function answerCdn(page: Page): Promise<void> {
  await page.route(`${ORIGIN}**`, async (route) => {
    bundles ??= bundlePackages()
    const path = new URL(route.request().url()).pathname.slice(1)
    const body = (await bundles).get(path.replace(/(?<=.)@\d+/, ''))
    if (body === undefined) return route.fulfill({ status: 404 })
    return route.fulfill({
      contentType: 'text/javascript',
      headers: { 'access-control-allow-origin': '*' },
      body,
    })
  })
}

/** Bundles the packages into shared chunks, so that all use one copy of React. The page provides three.js. */
async function bundlePackages(): Promise<Map<string, string>> {
  const built = (await build({
    configFile: false,
    logLevel: 'error',
    define: { 'process.env.NODE_ENV': '"production"' },
    plugins: [
      {
        name: 'furrow-cdn',
        resolveId: (id) => (id.startsWith('cdn:') ? id : null),
        load(id) {
          if (!id.startsWith('cdn:')) return null
          const name = id.slice('cdn:'.length)
          if (name.startsWith('@')) return `export * from '${name}'`
          // These packages are CommonJS, whose exports a bundler cannot list, so import the module to list them.
          const names = Object.keys(require(name))
          return `export { ${names.join(', ')} } from '${name}'`
        },
      },
    ],
    build: {
      write: false,
      minify: false,
      rolldownOptions: {
        input: Object.fromEntries(PACKAGES.map((name) => [name, `cdn:${name}`])),
        external: ['three'],
        preserveEntrySignatures: 'strict',
        output: { entryFileNames: '[name]', chunkFileNames: 'chunks/[name].js' },
      },
    },
  })) as Rolldown.RolldownOutput
  return new Map(
    built.output.flatMap((chunk) => (chunk.type === 'chunk' ? [[chunk.fileName, chunk.code]] : [])),
  )
}

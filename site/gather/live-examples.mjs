// Bundles the examples from the built packages. The import maps of the examples name files that the site's server does
// not have.

import { join } from 'node:path'
import { build } from 'vite'
import { exampleNames } from '../../scripts/lib/examples.mjs'
import { ROOT } from '../../scripts/lib/run.mjs'

/** Path of the folder with the faces, relative to a bundled example. The build of the studio contains this folder. */
const FACES = '../../studio/faces/'

/** Writes `NAME.html` for every example. */
export function buildLiveExamples(outDir) {
  const root = join(ROOT, 'examples')
  return build({
    configFile: false,
    root,
    base: './',
    logLevel: 'error',
    plugins: [forStatic()],
    worker: { format: 'es' },
    build: {
      outDir,
      emptyOutDir: true,
      chunkSizeWarningLimit: 2500,
      rolldownOptions: { input: exampleNames().map((name) => join(root, `${name}.html`)) },
    },
  })
}

/**
 * Removes import maps, because a bundled page does not need one. Makes URLs relative, so that the site works under any
 * path.
 */
function forStatic() {
  return {
    name: 'furrow-static-examples',
    enforce: 'pre',
    transformIndexHtml: {
      order: 'pre',
      handler: (html) => relativeFaces(html.replace(/<script type="importmap">[\s\S]*?<\/script>\n?/, '')),
    },
    // Vite turns an inline script into a virtual module. Its relative imports are resolved here, against the folder of
    // examples.
    resolveId(source, importer) {
      if (!source.startsWith('./') || !importer?.includes('html-proxy')) return null
      return join(ROOT, 'examples', source)
    },
    transform: (code) => (code.includes('/faces/') ? relativeFaces(code) : null),
  }
}

function relativeFaces(text) {
  return text.replace(/(['"`])\/faces\//g, `$1${FACES}`)
}

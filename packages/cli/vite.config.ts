import { defineConfig } from 'vite'
import { SOURCES } from '../../scripts/lib/sources.mjs'

/**
 * Builds src/ into dist/, with one output per module. The output includes the modules of `furrow` and `furrow-files`
 * that the CLI uses. All other packages stay dependencies. The job process of a batch is a second entry point.
 */
export default defineConfig({
  logLevel: 'warn',
  resolve: SOURCES.resolve,
  ssr: { ...SOURCES.ssr, noExternal: ['furrow', 'furrow-files'] },
  build: {
    ssr: true,
    target: 'node20.19',
    sourcemap: true,
    rolldownOptions: {
      input: ['src/main.ts', 'src/batch/processes/job-process.ts'],
      output: { preserveModules: true, preserveModulesRoot: 'src', entryFileNames: '[name].js' },
    },
  },
})

import { defineConfig } from 'vite'
import { SOURCES } from '../../scripts/lib/sources.mjs'

/**
 * Builds the commands into dist/, module by module as in src/, and with them the modules of `furrow` and `furrow-files`
 * that they use: the package then needs no copy of either beside it. All other packages stay dependencies. The processes of a batch have
 * an entry of their own.
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

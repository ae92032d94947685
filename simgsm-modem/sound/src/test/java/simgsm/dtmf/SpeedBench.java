package simgsm.dtmf;

import java.time.Duration;

/**
 * Times the receiver: the process's CPU time, compilers included, for each pass over files of speech (raw, 8 kHz, 16 bit), and
 * seconds of sound per second of it. Arguments: passes, files. The first pass is cold, the last ones are warm.
 */
final class SpeedBench {
    private SpeedBench() {}

    private static double cpuSeconds() {
        Duration used = ProcessHandle.current().info().totalCpuDuration().orElseThrow();
        return used.toMillis() / 1000.0;
    }

    public static void main(String[] args) throws Exception {
        short[][] sounds = new short[args.length - 1][];
        double seconds = 0;
        for (int i = 0; i < sounds.length; i++) {
            sounds[i] = LikelihoodFit.read(args[i + 1]);
            seconds += sounds[i].length / 8000.0;
        }
        for (int pass = 0; pass < Integer.parseInt(args[0]); pass++) {
            int[] keys = new int[1];
            double before = cpuSeconds();
            for (short[] sound : sounds) {
                DtmfReceiver receiver = new DtmfReceiver(digit -> keys[0]++);
                receiver.accept(sound);
                receiver.finish();
            }
            double cpu = cpuSeconds() - before;
            System.out.printf(
                    "pass %d: %.2f s of CPU, %.0f times real time, %d keys%n", pass, cpu, seconds / cpu, keys[0]);
        }
    }
}

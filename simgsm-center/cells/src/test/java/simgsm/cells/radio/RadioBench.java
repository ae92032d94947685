package simgsm.cells.radio;

import java.util.Random;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownReader;

/**
 * The processor time of the radio of many mobiles: levels of all towers, interference, error rates, every 480 ms. Arguments:
 * mobiles, towers, seconds; by default 1000, 50, 60. The figure in docs/MEASURED.md is of this main.
 */
final class RadioBench {
    private static final double PERIOD_SECONDS = 0.48;

    private RadioBench() {}

    public static void main(String[] args) throws Exception {
        int mobiles = args.length > 0 ? Integer.parseInt(args[0]) : 1_000;
        int towers = args.length > 1 ? Integer.parseInt(args[1]) : 50;
        int seconds = args.length > 2 ? Integer.parseInt(args[2]) : 60;
        RadioField field = new RadioField(new Propagation(town(towers), 1));
        double[] levels = new double[towers];
        Random random = new Random(2);
        double sum = 0;
        long before = 0;
        int rounds = (int) (seconds / PERIOD_SECONDS);
        for (int round = -20; round < rounds; round++) {
            if (round == 0) {
                before = processorNanos();
            }
            for (int i = 0; i < mobiles; i++) {
                field.levelsDbm(random.nextDouble(10_000), random.nextDouble(10_000), levels);
                double errors = ReceptionQuality.bitErrorRate(field.carrierDecibels(i % towers, levels));
                sum += ReceptionQuality.frameErasureRate(errors) + ReceptionQuality.blockErasureRate(errors);
            }
        }
        double used = (processorNanos() - before) / 1e9;
        System.out.printf(
                "%d mobiles, %d towers: %.3f s of processor time for %d s, %.1f %% of a core (%.1f)%n",
                mobiles, towers, used, seconds, 100 * used / seconds, sum);
    }

    /** Of the whole process. */
    private static long processorNanos() {
        return ProcessHandle.current().info().totalCpuDuration().orElseThrow().toNanos();
    }

    private static Town town(int towers) throws Exception {
        StringBuilder text = new StringBuilder("shadow 7 50\nhill h 5000 5000 radius=900 height=60\n");
        for (int i = 0; i < 30; i++) {
            text.append(
                    "building b%d %d %d %d %d loss=15%n".formatted(i, 300 * i, 250 * i, 300 * i + 100, 250 * i + 80));
        }
        Random random = new Random(1);
        for (int i = 0; i < towers; i++) {
            text.append("tower t%d %d %d arfcn=%d bsic=%d lac=1%n"
                    .formatted(i, random.nextInt(10_000), random.nextInt(10_000), 1 + i % 40, i % 64));
        }
        return TownReader.read("bench.town", text.toString());
    }
}

package simgsm.center.msc;

import java.time.Duration;

/**
 * Measures the exchange without sockets: phones register and answer the pings of an hour. Prints a line for each step, with
 * the heap of phones and exchange together.
 *
 * <pre>
 *   java -Xmx2g -cp simgsm-center/target/test-classes:target/dist/simgsm-center.jar:target/dist/simgsm-modem.jar \
 *       simgsm.center.msc.ManyPhonesBench [PHONES]
 * </pre>
 */
public final class ManyPhonesBench {
    private static final int FIRST_NUMBER = 7_000_000;

    private ManyPhonesBench() {}

    public static void main(String[] args) {
        int phones = args.length > 0 ? Integer.parseInt(args[0]) : 50_000;
        TestNetwork network = new TestNetwork();
        TestMobile[] mobiles = new TestMobile[phones];
        measure("attached", phones, () -> {
            for (int i = 0; i < phones; i++) {
                mobiles[i] = network.attach(String.valueOf(FIRST_NUMBER + i));
                mobiles[i].received.clear();
            }
        });
        measure("hour", phones, () -> network.pass(Duration.ofHours(1)));
        System.out.println("links=" + network.exchange.linkCount());
    }

    private static void measure(String step, int phones, Runnable action) {
        long start = System.nanoTime();
        action.run();
        double seconds = (System.nanoTime() - start) / 1e9;
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        System.out.printf(
                "%s phones=%d seconds=%.2f usEach=%.1f heapMB=%d%n",
                step, phones, seconds, seconds * 1e6 / phones, (runtime.totalMemory() - runtime.freeMemory()) >> 20);
    }
}

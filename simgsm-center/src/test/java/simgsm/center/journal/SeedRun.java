package simgsm.center.journal;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.SplittableRandom;
import java.util.logging.Level;
import java.util.logging.Logger;
import javax.crypto.Cipher;
import javax.crypto.spec.SecretKeySpec;
import simgsm.octets.OctetString;
import simgsm.sim.GsmVector;
import simgsm.sim.Milenage;

/**
 * Runs seeds of {@link Simulation} one after the other in one process, for as long as it takes. Arguments: first seed,
 * number of seeds, step (2 from an odd seed: closed networks only). After each broken seed it compares the product's
 * MILENAGE with {@link PlainMilenage} on random inputs and runs the seed once more; after the first one it also prints the
 * list of compiled methods. Ends with 1 if a seed broke.
 */
final class SeedRun {
    private static final int REPORT_EVERY = 1_000;
    private static final int CHECKED_INPUTS = 2_000;

    private static final PrintStream OUT = System.out;

    private static long acknowledged;
    private static long deaths;

    private SeedRun() {}

    public static void main(String[] arguments) {
        Logger.getLogger("").setLevel(Level.OFF);
        long first = Long.parseLong(arguments[0]);
        long count = Long.parseLong(arguments[1]);
        long step = arguments.length > 2 ? Long.parseLong(arguments[2]) : 1;
        Instant start = Instant.now();
        OUT.println(start + " Java " + System.getProperty("java.runtime.version") + ", seeds from " + first + ", step "
                + step + "; self-check: " + selfCheck(first));
        long broken = 0;
        for (long i = 0; i < count; i++) {
            long seed = first + i * step;
            Throwable cause = failure(seed);
            if (cause != null) {
                broken++;
                OUT.println(Instant.now() + " seed " + seed + " broke: " + cause);
                report(seed, cause, broken == 1);
            }
            if ((i + 1) % REPORT_EVERY == 0 || i + 1 == count) {
                OUT.println(Instant.now() + " " + (i + 1) + " seeds in "
                        + Duration.between(start, Instant.now()).toSeconds() + " s, " + broken + " broken, "
                        + acknowledged + " messages acknowledged, " + deaths + " deaths");
            }
        }
        System.exit(broken == 0 ? 0 : 1);
    }

    private static Throwable failure(long seed) {
        Simulation simulation = new Simulation(seed);
        try {
            simulation.run();
            return null;
        } catch (Throwable cause) {
            return cause;
        } finally {
            acknowledged += simulation.acknowledgedCount();
            deaths += simulation.deaths();
        }
    }

    private static void report(long seed, Throwable cause, boolean isFirst) {
        OUT.println("self-check: " + selfCheck(seed));
        Throwable again = failure(seed);
        OUT.println("once more: " + (again == null ? "clean" : again.toString()));
        if (isFirst) {
            cause.printStackTrace(OUT);
            OUT.println(compiledMethods());
        }
    }

    /** Compares on random keys and challenges. @return what differed, or how much was equal */
    private static String selfCheck(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int ciphers = 0;
        int responses = 0;
        int keys = 0;
        String example = "";
        for (int i = 0; i < CHECKED_INPUTS; i++) {
            byte[] k = octets(random);
            byte[] opc = octets(random);
            byte[] rand = octets(random);
            boolean isCipherRight =
                    Arrays.equals(platformCipher(k, rand), bytes(PlainMilenage.encrypt(ints(k), ints(rand))));
            Milenage functions = new Milenage(OctetString.of(k), OctetString.of(opc));
            OctetString challenge = OctetString.of(rand);
            boolean isResponseRight = GsmVector.of(functions, challenge)
                    .sres()
                    .equals(OctetString.of(bytes(PlainMilenage.sres(ints(k), ints(opc), ints(rand)))));
            boolean areKeysRight = functions.f3(challenge).equals(plain(k, opc, rand, 4, 2))
                    && functions.f4(challenge).equals(plain(k, opc, rand, 8, 4));
            ciphers += isCipherRight ? 0 : 1;
            responses += isResponseRight ? 0 : 1;
            keys += areKeysRight ? 0 : 1;
            if (example.isEmpty() && !(isCipherRight && isResponseRight && areKeysRight)) {
                HexFormat hex = HexFormat.of();
                example =
                        ", first K " + hex.formatHex(k) + " OPc " + hex.formatHex(opc) + " RAND " + hex.formatHex(rand);
            }
        }
        return "of " + CHECKED_INPUTS + " inputs wrong: AES " + ciphers + ", SRES " + responses + ", CK or IK " + keys
                + example;
    }

    private static OctetString plain(byte[] k, byte[] opc, byte[] rand, int rotation, int constant) {
        return OctetString.of(bytes(PlainMilenage.output(ints(k), ints(opc), ints(rand), rotation, constant)));
    }

    private static byte[] platformCipher(byte[] key, byte[] block) {
        try {
            Cipher cipher = Cipher.getInstance("AES/ECB/NoPadding");
            cipher.init(Cipher.ENCRYPT_MODE, new SecretKeySpec(key, "AES"));
            return cipher.doFinal(block);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    private static byte[] octets(SplittableRandom random) {
        byte[] octets = new byte[Milenage.KEY_LENGTH];
        random.nextBytes(octets);
        return octets;
    }

    private static int[] ints(byte[] octets) {
        int[] result = new int[octets.length];
        for (int i = 0; i < octets.length; i++) {
            result[i] = octets[i] & 0xff;
        }
        return result;
    }

    private static byte[] bytes(int[] values) {
        byte[] result = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            result[i] = (byte) values[i];
        }
        return result;
    }

    private static String compiledMethods() {
        String program = Path.of(System.getProperty("java.home"), "bin", "jcmd").toString();
        String self = Long.toString(ProcessHandle.current().pid());
        try {
            Process list = new ProcessBuilder(program, self, "Compiler.codelist")
                    .redirectErrorStream(true)
                    .start();
            return new String(list.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            return "no list of compiled methods: " + e;
        }
    }
}

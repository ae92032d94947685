package simgsm.center.app;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.file.FileErrors;
import simgsm.file.PrivateFiles;
import simgsm.octets.OctetString;
import simgsm.sim.Milenage;
import simgsm.sim.SimCard;
import simgsm.sim.SimFile;

/** {@code --new-sim}: makes SIMs with new keys, and writes each to the list and to a separate file. */
public final class NewSims {
    /** Maximum in one run. */
    static final int MOST_AT_ONCE = 1_000;

    private static final String HEADING = "# SimGSM: the SIMs of a closed network; keep it secret, the keys are in it";

    private NewSims() {}

    public static int make(Arguments arguments) throws UsageException, IOException {
        Path list = arguments
                .path("hlr")
                .orElseThrow(() -> new UsageException("--new-sim needs --hlr FILE, the list to which SIMs are added"));
        Set<Msisdn> numbers = arguments.value("new-sim", NewSims::numbers).orElseThrow();
        make(list, numbers, Program.standardOutput());
        return ExitStatus.OK;
    }

    /**
     * Makes SIMs for these numbers.
     *
     * @param out receives the names of the written files
     * @throws UsageException if one of them exists
     */
    public static void make(Path list, Set<Msisdn> numbers, PrintStream out) throws UsageException, IOException {
        SimFile present = Files.exists(list) ? SimFile.read(list) : SimFile.EMPTY;
        List<SimCard> cards = new ArrayList<>();
        for (Msisdn number : numbers) {
            cards.add(newCard(number, present));
        }
        write(list, cards, out);
    }

    /** @throws IllegalArgumentException naming the expected text */
    static Set<Msisdn> numbers(String list) {
        Set<Msisdn> numbers = new LinkedHashSet<>();
        for (String range : list.split(",", -1)) {
            String[] ends = range.strip().split("-", 2);
            long first = number(ends[0]);
            long last = ends.length == 1 ? first : number(ends[1]);
            if (last < first) {
                throw new IllegalArgumentException("expected the smaller number first, found " + range);
            }
            for (long number = first; number <= last && numbers.size() <= MOST_AT_ONCE; number++) {
                numbers.add(new Msisdn(Long.toString(number)));
            }
        }
        if (numbers.size() > MOST_AT_ONCE) {
            throw new IllegalArgumentException("expected at most " + MOST_AT_ONCE + " numbers");
        }
        return numbers;
    }

    private static long number(String text) {
        if (!text.matches("[1-9][0-9]{0,9}")) {
            throw new IllegalArgumentException(
                    "expected numbers of 1 to 10 digits without a leading zero, as 5550100 or 5550100-5550119, found "
                            + (text.isEmpty() ? "none" : text));
        }
        return Long.parseLong(text);
    }

    private static SimCard newCard(Msisdn number, SimFile present) throws UsageException {
        Imsi imsi = Imsi.ofOpenNumber(number);
        for (var subscription : present.subscriptions()) {
            if (subscription.card().number().equals(number)
                    || subscription.card().imsi().equals(imsi)) {
                throw new UsageException("--new-sim: there is already the " + subscription.card());
            }
        }
        return new SimCard(imsi, number, newKey(), newKey());
    }

    private static OctetString newKey() {
        byte[] key = new byte[Milenage.KEY_LENGTH];
        new SecureRandom().nextBytes(key);
        return OctetString.of(key);
    }

    /** Cards first: after a failure a card without a list entry is harmless, a list entry without its card is not. */
    private static void write(Path list, List<SimCard> cards, PrintStream out) throws IOException {
        Path folder = list.toAbsolutePath().getParent();
        for (SimCard card : cards) {
            Path file = fileOf(card, folder);
            if (Files.exists(file)) {
                throw new IOException(file + ": there already; remove it if its SIM is not wanted any more");
            }
        }
        for (SimCard card : cards) {
            Path file = fileOf(card, folder);
            writeSecretly(file, line(card) + "\n");
            out.print(file + "\n");
        }
        StringBuilder lines = new StringBuilder(beginning(list));
        cards.forEach(card -> lines.append(line(card)).append('\n'));
        writeSecretly(list, lines.toString());
        out.print(list + "\n");
        out.flush();
    }

    private static Path fileOf(SimCard card, Path folder) {
        return folder.resolve(card.number() + ".sim");
    }

    private static String line(SimCard card) {
        return "sim number=" + card.number() + " imsi=" + card.imsi() + " k=" + card.k() + " opc="
                + card.opc().orElseThrow();
    }

    /** The heading of a new list, or a missing line break at the end of the list. */
    private static String beginning(Path list) throws IOException {
        try {
            String text = Files.readString(list);
            return text.isEmpty() || text.endsWith("\n") ? "" : "\n";
        } catch (NoSuchFileException e) {
            return HEADING + "\n";
        }
    }

    /** Appends to a file that only its owner may read; removes a new one if it cannot be written. */
    private static void writeSecretly(Path file, String text) throws IOException {
        boolean isNew = !Files.exists(file);
        try (FileChannel channel = PrivateFiles.open(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND)) {
            FileErrors.naming(
                    file, () -> Channels.newOutputStream(channel).write(text.getBytes(StandardCharsets.UTF_8)));
        } catch (IOException e) {
            if (isNew) {
                Files.deleteIfExists(file);
            }
            throw e;
        }
    }
}

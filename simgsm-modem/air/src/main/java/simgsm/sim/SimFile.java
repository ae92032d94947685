package simgsm.sim;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.file.FileReplacement;
import simgsm.file.Utf8Text;

/**
 * A file of SIMs: those of a network ({@code --hlr}) or, with some of its lines, those of the terminals of a program
 * ({@code --sim}). UTF-8 text; {@code #} begins a comment; each line is one of
 *
 * <pre>
 *   sim number=5550100 imsi=001010005550100 k=HEX opc=HEX [barred]
 *   sim number=5550100 imsi=001010005550100 k=HEX op=HEX  [barred]
 *   barred-imei 490154203237518
 * </pre>
 *
 * where HEX is 32 hexadecimal digits; further words of a {@code sim} line are {@code algorithm=comp128v1}, {@code
 * comp128v2} or {@code comp128v3} in place of {@code opc=}, {@code pin=}, {@code puk=} and {@code pin-enabled=false}, and
 * {@code pin-tries=} and {@code puk-tries=}, which {@link #keep} writes. Each number and each IMSI may occur once only.
 *
 * @param barredEquipment terminals that may not register
 */
public record SimFile(List<Subscription> subscriptions, Set<Imei> barredEquipment) {
    /** Most SIMs in a file. */
    public static final int MAX_SUBSCRIPTIONS = 100_000;

    /** A file without SIMs. */
    public static final SimFile EMPTY = new SimFile(List.of(), Set.of());

    private static final int SHOWN = 5;

    public SimFile {
        subscriptions = List.copyOf(subscriptions);
        barredEquipment = Set.copyOf(barredEquipment);
    }

    /**
     * Reads a file.
     *
     * @throws IOException naming the file and, for invalid content, the line and the expected form
     */
    public static SimFile read(Path file) throws IOException {
        return new SimFileReader(file.toString())
                .read(Utf8Text.read(file).lines().toList());
    }

    /** Writes the PIN's present state into the line of a card; the rest of the file stays. */
    public static void keep(Path file, Msisdn number, CardPin pin) throws IOException {
        String text = Utf8Text.read(file)
                .lines()
                .map(line -> isOf(line, number) ? withPin(line, pin) : line)
                .collect(Collectors.joining("\n", "", "\n"));
        FileReplacement.writePrivately(file, text.getBytes(StandardCharsets.UTF_8));
    }

    private static boolean isOf(String line, Msisdn number) {
        return line.strip().matches("sim\\b[^#]*\\snumber=" + number.digits() + "(\\s.*)?");
    }

    private static String withPin(String line, CardPin pin) {
        int comment = line.indexOf('#');
        String content = comment < 0 ? line : line.substring(0, comment);
        return content.replaceAll("\\s+(pin|puk|pin-enabled|pin-tries|puk-tries)=\\S*", "")
                        .stripTrailing()
                + " pin=" + pin.pin() + " puk=" + pin.puk() + " pin-enabled=" + pin.isEnabled() + " pin-tries="
                + pin.tries() + " puk-tries=" + pin.pukTries() + (comment < 0 ? "" : " " + line.substring(comment));
    }

    /** The card of a number. */
    public Optional<SimCard> cardOf(Msisdn number) {
        return subscriptions.stream()
                .map(Subscription::card)
                .filter(card -> card.number().equals(number))
                .findFirst();
    }

    /** The card if the file has exactly one. */
    public Optional<SimCard> onlyCard() {
        return subscriptions.size() == 1 ? Optional.of(subscriptions.get(0).card()) : Optional.empty();
    }

    /** The first 5 numbers, for the text of an error. */
    public String numbers() {
        String shown = subscriptions.stream()
                .limit(SHOWN)
                .map(subscription -> subscription.card().number().digits())
                .collect(Collectors.joining(", "));
        return subscriptions.size() > SHOWN ? shown + " ..." : shown;
    }
}

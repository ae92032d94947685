package simgsm.sms;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.octets.Octets;
import simgsm.octets.Septets;

/**
 * A broadcast message, and its division into pages.
 *
 * @param messageIdentifier the channel, 0 to 65535
 * @param language two letters of ISO 639, if the sender named one
 */
public record CellBroadcast(
        int messageIdentifier, BroadcastSerial serial, Optional<String> language, int pages, String text) {
    private static final int SEPTETS = 93;
    private static final int CHARACTERS = 41;
    private static final String LANGUAGE = "[a-z]{2}";
    private static final String FILLER = "\r";

    /**
     * The pages of a text, in the alphabet with the fewest octets that codes it without loss. Line ends become line
     * feeds, because carriage returns are the padding.
     *
     * @throws IllegalArgumentException for a text of more than 15 pages: 1395 septets or 615 characters of UCS-2
     */
    public static List<CellBroadcastPage> split(
            String text, int messageIdentifier, BroadcastSerial serial, Optional<String> language) {
        language.ifPresent(CellBroadcast::checkLanguage);
        String lines = text.replace("\r\n", "\n").replace('\r', '\n');
        Alphabet alphabet = Alphabet.of(lines);
        BroadcastCoding coding = BroadcastCoding.of(alphabet, language);
        boolean septets = alphabet == Alphabet.GSM_7BIT;
        String leader = coding.languageLeadsText() ? language.orElseThrow() : "";
        int room = septets ? SEPTETS - leaderSeptets(leader) : CHARACTERS - leader.length() / 2;
        List<String> pieces = MessageSplitter.pieces(lines, alphabet, room);
        if (pieces.size() > CellBroadcastPage.MAX_PAGES) {
            throw new IllegalArgumentException("the text needs " + pieces.size() + " pages, at most "
                    + CellBroadcastPage.MAX_PAGES + " can be broadcast");
        }
        List<CellBroadcastPage> pages = new ArrayList<>(pieces.size());
        for (String piece : pieces) {
            OctetString content = septets ? septets(leader, piece) : characters(leader, piece);
            pages.add(
                    new CellBroadcastPage(serial, messageIdentifier, coding, pages.size() + 1, pieces.size(), content));
        }
        return pages;
    }

    private static void checkLanguage(String language) {
        if (!language.matches(LANGUAGE)) {
            throw new IllegalArgumentException("\"" + language + "\" is no language of two letters");
        }
    }

    /** The message of these pages; all of them, in order. */
    public static CellBroadcast join(List<CellBroadcastPage> pages) {
        CellBroadcastPage first = pages.get(0);
        StringBuilder text = new StringBuilder();
        for (CellBroadcastPage page : pages) {
            text.append(text(page));
        }
        return new CellBroadcast(
                first.messageIdentifier(), first.serial(), language(first), pages.size(), text.toString());
    }

    /** Septets of the language and the carriage return after it. */
    private static int leaderSeptets(String leader) {
        return leader.isEmpty() ? 0 : leader.length() + 1;
    }

    private static OctetString septets(String leader, String text) {
        byte[] codes = GsmAlphabet.encode(leader.isEmpty() ? text : leader + FILLER + text);
        byte[] filled = Arrays.copyOf(codes, SEPTETS);
        Arrays.fill(filled, codes.length, SEPTETS, (byte) GsmAlphabet.CARRIAGE_RETURN);
        return OctetString.of(Arrays.copyOf(Septets.pack(filled, 0), CellBroadcastPage.CONTENT_LENGTH));
    }

    /** The language is packed into two octets, the size of one character. */
    private static OctetString characters(String leader, String text) {
        OctetWriter out = new OctetWriter();
        out.bytes(Septets.pack(GsmAlphabet.encode(leader), 0)).bytes(Ucs2.encode(text));
        while (out.length() < CellBroadcastPage.CONTENT_LENGTH) {
            out.bytes(Ucs2.encode(FILLER));
        }
        return out.toOctetString();
    }

    private static String text(CellBroadcastPage page) {
        boolean languageLeads = page.coding().languageLeadsText();
        byte[] octets = page.content().toArray();
        String text = switch (page.coding().alphabet()) {
            case GSM_7BIT ->
                GsmAlphabet.decode(Octets.range(Septets.unpack(octets, SEPTETS, 0), languageLeads ? 3 : 0, SEPTETS));
            case UCS2 -> Ucs2.decode(octets, languageLeads ? 2 : 0);
            case OCTETS -> page.content().toString();
        };
        int end = text.length();
        while (end > 0 && text.charAt(end - 1) == '\r') {
            end--;
        }
        return text.substring(0, end);
    }

    private static Optional<String> language(CellBroadcastPage page) {
        if (!page.coding().languageLeadsText()) {
            return page.coding().language();
        }
        String letters = GsmAlphabet.decode(Septets.unpack(page.content().toArray(), 2, 0));
        return letters.matches(LANGUAGE) ? Optional.of(letters) : Optional.empty();
    }
}

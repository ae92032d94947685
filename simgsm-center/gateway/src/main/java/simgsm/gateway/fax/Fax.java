package simgsm.gateway.fax;

import java.io.IOException;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A text for a fax machine.
 *
 * @param id letters, digits and dots
 * @param from the sender's digits
 * @param to the receiver's number
 */
public record Fax(String id, String from, String to, String text, ZonedDateTime date) {
    /** Limit of pages: form feeds alone make a page of each character. */
    public static final int MOST_PAGES = 50;

    private static final DateTimeFormatter DATE = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm");
    /** As the address in front of a message to e-mail (TS 23.040, 3.8.1); a shorter number may belong to the text. */
    private static final Pattern RECEIVER = Pattern.compile("(\\+?[0-9]{5,15})\\s+(\\S.*)", Pattern.DOTALL);

    /** @param number of the service: the receiver, if the text does not begin with a number of at least 5 digits */
    public static Fax of(String id, String from, String number, String text, ZonedDateTime date) {
        Matcher addressed = RECEIVER.matcher(text);
        return addressed.matches()
                ? new Fax(id, from, addressed.group(1), addressed.group(2), date)
                : new Fax(id, from, number, text, date);
    }

    /** The lines of each page, without its header. A form feed begins a page. */
    public List<List<String>> pages() {
        List<List<String>> pages = new ArrayList<>();
        for (String page : text.split("\f", -1)) {
            List<String> lines = new ArrayList<>();
            for (String line : page.split("\r\n?|\n", -1)) {
                wrap(line, lines);
            }
            for (int from = 0; from < lines.size(); from += FaxPage.LINES) {
                pages.add(lines.subList(from, Math.min(lines.size(), from + FaxPage.LINES)));
            }
        }
        return pages;
    }

    /** Breaks a line at spaces, or within a word that is longer than a line. */
    private static void wrap(String line, List<String> lines) {
        // one char a column
        String rest = line.replaceAll("[\\x{10000}-\\x{10ffff}]", "\ufffd");
        while (rest.length() > FaxPage.COLUMNS) {
            int space = rest.lastIndexOf(' ', FaxPage.COLUMNS);
            int end = space > 0 ? space : FaxPage.COLUMNS;
            lines.add(rest.substring(0, end));
            rest = rest.substring(end).stripLeading();
        }
        lines.add(rest);
    }

    /**
     * The file. Each page begins with a line.
     *
     * @param headers the line for date, sender, receiver, page and number of pages
     */
    public byte[] tiff(Function<Object[], String> headers) throws IOException {
        List<List<String>> pages = pages();
        FaxFile file = new FaxFile(pages.size());
        for (int page = 1; page <= pages.size(); page++) {
            String header = headers.apply(new Object[] {DATE.format(date), from, to, page, pages.size()});
            file.add(FaxPage.image(header, pages.get(page - 1)));
        }
        return file.octets();
    }
}

package simgsm.phone.store;

import java.text.Collator;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import simgsm.sim.SimPhoneBook;

/** The names in the SIM's phone book, also read and written by AT commands. */
public final class Contacts {
    /** @param place in the SIM's phone book, from 1 */
    public record NamedNumber(int place, String name, String number) {}

    private final SimPhoneBook book;
    private int knownVersion = -1;
    private List<NamedNumber> sorted = List.of();
    private Map<String, String> names = Map.of();

    public Contacts(SimPhoneBook book) {
        this.book = book;
    }

    private void refresh() {
        if (knownVersion == book.version()) {
            return;
        }
        knownVersion = book.version();
        if (book.entries().isEmpty()) {
            sorted = List.of();
            names = Map.of();
            return; // The collator's rules take milliseconds to read.
        }
        Collator order = Collator.getInstance(Locale.ROOT);
        sorted = book.entries().entrySet().stream()
                .map(entry -> new NamedNumber(
                        entry.getKey(),
                        entry.getValue().name(),
                        entry.getValue().number()))
                .sorted(Comparator.comparing(NamedNumber::name, order).thenComparing(NamedNumber::place))
                .toList();
        Map<String, String> next = new TreeMap<>();
        for (NamedNumber contact : sorted) {
            if (!contact.name().isEmpty()) {
                next.putIfAbsent(bare(contact.number()), contact.name());
            }
        }
        names = Map.copyOf(next);
    }

    /** By name. */
    public List<NamedNumber> all() {
        refresh();
        return sorted;
    }

    /** The name of each number, without the plus sign of international numbers. */
    public Map<String, String> names() {
        refresh();
        return names;
    }

    /** The name of a number, with or without a plus sign; the number itself if it has none. */
    public String nameOf(String number) {
        return names().getOrDefault(bare(number), number);
    }

    /** A number in the form of {@link #names}. */
    public static String bare(String number) {
        return number.startsWith("+") ? number.substring(1) : number;
    }

    public boolean isFull() {
        return book.free().isEmpty();
    }

    /** Writes a contact. @param place of the contact to replace; empty for a new one, which needs room */
    public void write(Optional<Integer> place, String name, String number) {
        place.or(book::free).ifPresent(free -> book.write(free, new SimPhoneBook.Entry(number, name)));
    }

    public void erase(NamedNumber contact) {
        book.erase(contact.place());
    }
}

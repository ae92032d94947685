package simgsm.modem.at.state;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import simgsm.air.Msisdn;
import simgsm.sim.SimPhoneBook;
import simgsm.sim.SimPhoneBook.Entry;

/** The phone books: the SIM's, written by clients, and those of the modem. Their places are counted from 1. */
public final class PhoneBooks {
    public static final String SIM = "SM";
    static final int LOG_CAPACITY = 10;

    private final SimPhoneBook written;
    private final Map<String, Deque<String>> logs = new LinkedHashMap<>();
    private final Entry own;

    /** @param written the SIM's */
    public PhoneBooks(Msisdn own, SimPhoneBook written) {
        this.written = written;
        this.own = new Entry(own.toString(), "");
        for (String log : List.of("LD", "RC", "MC")) {
            logs.put(log, new ArrayDeque<>());
        }
    }

    /** The names for +CPBS: SIM, own number, last dialled, received, missed. */
    public List<String> names() {
        List<String> names = new ArrayList<>(List.of(SIM, "ON"));
        names.addAll(logs.keySet());
        return names;
    }

    public int capacity(String book) {
        return book.equals(SIM) ? SimPhoneBook.CAPACITY : book.equals("ON") ? 1 : LOG_CAPACITY;
    }

    /** The entries by place. */
    public Map<Integer, Entry> entries(String book) {
        if (book.equals(SIM)) {
            return written.entries();
        }
        if (book.equals("ON")) {
            return Map.of(1, own);
        }
        Map<Integer, Entry> entries = new TreeMap<>();
        for (String number : logs.get(book)) {
            entries.put(entries.size() + 1, new Entry(number, ""));
        }
        return entries;
    }

    /** The SIM's book. */
    public SimPhoneBook sim() {
        return written;
    }

    public Optional<String> lastDialled() {
        return Optional.ofNullable(logs.get("LD").peekFirst());
    }

    public void dialled(String number) {
        log("LD", number);
    }

    public void answered(String number) {
        log("RC", number);
    }

    public void missed(String number) {
        log("MC", number);
    }

    private void log(String book, String number) {
        Deque<String> numbers = logs.get(book);
        if (!number.isEmpty()) {
            numbers.remove(number);
            numbers.addFirst(number);
        }
        if (numbers.size() > LOG_CAPACITY) {
            numbers.removeLast();
        }
    }
}

package simgsm.modem.at.command;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;

/** Commands that only keep their numbers: the read form answers what the client has set. */
final class KeptSettings {
    private static final String NO_EFFECT = "; accepted, without effect";

    private KeptSettings() {}

    /** Settings of lines, modes and displays that the terminal does not have. */
    static void addTo(AtCommandTable<AtClient> table) {
        add(table, "+IPR", "(0-4000000)", "0", "rate of the line" + NO_EFFECT);
        add(table, "+IFC", "(0-2),(0-2)", "0,0", "flow control" + NO_EFFECT);
        add(table, "+ICF", "(0-6),(0-3)", "3,3", "format of a character" + NO_EFFECT);
        add(table, "+CVHU", "(0-2)", "0", "what ends a voice call" + NO_EFFECT);
        add(table, "+CSTA", "(129,145)", "145", "type of dialled numbers" + NO_EFFECT);
        add(table, "+CMOD", "(0-3)", "0", "mode of calls" + NO_EFFECT);
        add(table, "+CBST", "(0-134),(0),(0-3)", "0,0,1", "bearer of data calls" + NO_EFFECT);
        add(table, "+CR", "(0,1)", "0", "reports of the bearer" + NO_EFFECT);
        add(table, "+CSSN", "(0,1),(0,1)", "0,0", "reports of supplementary services" + NO_EFFECT);
        add(table, "+CTZU", "(0,1)", "0", "clock by the network's time zone" + NO_EFFECT);
        add(table, "+CTZR", "(0-3)", "0", "reports of the time zone" + NO_EFFECT);
        add(table, "+CLTS", "(0,1)", "0", "reports of the network's time" + NO_EFFECT);
        add(table, "+CMMS", "(0-2)", "0", "link kept between messages" + NO_EFFECT);
        add(table, "+CSCLK", "(0-2)", "0", "sleep" + NO_EFFECT);
        add(table, "+CBATCHK", "(0,1)", "0", "watch over the battery" + NO_EFFECT);
        add(table, "+CFGRI", "(0-2)", "0", "ring indicator" + NO_EFFECT);
        add(table, "+CHFA", "(0-4)", "0", "audio channel" + NO_EFFECT);
        add(table, "+CLVL", "(0-100)", "50", "volume in percent" + NO_EFFECT);
        add(table, "+CMUT", "(0,1)", "0", "microphone off" + NO_EFFECT);
        add(table, "+CMIC", "(0-15),(0-15)", "0,0", "microphone: channel and gain" + NO_EFFECT);
    }

    /**
     * Adds a command.
     *
     * @param ranges the answer to its test form; a set command must lie in it, and what it leaves out stays
     * @param initial the values of a new connection
     */
    static AtCommandTable.Row<AtClient> add(
            AtCommandTable<AtClient> table, String name, String ranges, String initial, String meaning) {
        String parameters = ranges.replaceAll("(\\d),(?=\\d)", "$1|").replaceAll("[()]", "");
        return table.add(name, parameters, meaning + " (" + initial + ")")
                .read((client, request) -> request.answer(kept(client, name, initial)))
                .test(ranges)
                .set((client, request) -> keep(client, request, ranges, initial));
    }

    /** The values that a client has set, else the initial ones. */
    static String kept(AtClient client, String name, String initial) {
        return client.settings().kept.getOrDefault(name, initial);
    }

    /** Keeps what a set command gives, in these ranges. */
    static void keep(AtClient client, AtRequest request, String ranges, String initial) throws AtException {
        String[] limits = ranges.substring(1, ranges.length() - 1).split("\\),\\(");
        String[] values = kept(client, request.command().name(), initial).split(",");
        AtParameters parameters = request.parameters().atMost(limits.length);
        List<String> joined = new ArrayList<>();
        for (int i = 0; i < limits.length; i++) {
            int value = parameters.number(i, 0, Integer.MAX_VALUE, Integer.parseInt(values[i]));
            if (Stream.of(limits[i].split(",")).noneMatch(range -> isIn(range.split("-"), value))) {
                throw parameters.refused();
            }
            joined.add(String.valueOf(value));
        }
        client.settings().kept.put(request.command().name(), String.join(",", joined));
    }

    private static boolean isIn(String[] ends, int value) {
        return Integer.parseInt(ends[0]) <= value && value <= Integer.parseInt(ends[ends.length - 1]);
    }
}

package simgsm.modem.at.command;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import simgsm.modem.at.AtCommandTable;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtParameters;
import simgsm.modem.at.AtRequest;

/** Commands that only store their numbers: the read form answers the client's values. */
final class KeptSettings {
    private KeptSettings() {}

    /** Serves all rows with initial values; a set command must be in the ranges of the test form. */
    static void addTo(AtCommandTable<AtClient> table) {
        for (AtCommandTable.Row<AtClient> row : table.rows()) {
            if (row.initial().isPresent()) {
                row.read((client, request) -> request.answer(kept(client, row.name())))
                        .set(KeptSettings::keep);
            }
        }
    }

    /** The values set by a client, else the initial ones. */
    static String kept(AtClient client, String name) {
        return client.settings()
                .kept
                .getOrDefault(name, AtCommands.TABLE.row(name).initial().orElseThrow());
    }

    /** Stores the values of a set command; omitted ones do not change. */
    static void keep(AtClient client, AtRequest request) throws AtException {
        String name = request.command().name();
        String ranges = AtCommands.TABLE.row(name).ranges();
        String[] limits = ranges.substring(1, ranges.length() - 1).split("\\),\\(");
        String[] values = kept(client, name).split(",");
        AtParameters parameters = request.parameters().atMost(limits.length);
        List<String> joined = new ArrayList<>();
        for (int i = 0; i < limits.length; i++) {
            int value = parameters.number(i, 0, Integer.MAX_VALUE, Integer.parseInt(values[i]));
            if (Stream.of(limits[i].split(",")).noneMatch(range -> isIn(range.split("-"), value))) {
                throw parameters.refused();
            }
            joined.add(String.valueOf(value));
        }
        client.settings().kept.put(name, String.join(",", joined));
    }

    private static boolean isIn(String[] ends, int value) {
        return Integer.parseInt(ends[0]) <= value && value <= Integer.parseInt(ends[ends.length - 1]);
    }
}

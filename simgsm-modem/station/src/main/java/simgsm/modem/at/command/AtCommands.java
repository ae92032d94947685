package simgsm.modem.at.command;

import java.nio.charset.StandardCharsets;
import java.util.Scanner;
import simgsm.modem.at.AtCommandTable;

/** All commands of the modem, in the order of the manual. */
public final class AtCommands {
    static final AtCommandTable<AtClient> TABLE = rows();

    static {
        KeptSettings.addTo(TABLE);
        GeneralCommands.addTo(TABLE);
        CallCommands.addTo(TABLE);
        NetworkCommands.addTo(TABLE);
        MessageSettingCommands.addTo(TABLE);
        MessageCommands.addTo(TABLE);
        SimCommands.addTo(TABLE);
        PhoneBookCommands.addTo(TABLE);
    }

    private AtCommands() {}

    private static AtCommandTable<AtClient> rows() {
        try (Scanner text = new Scanner(AtCommands.class.getResourceAsStream("commands.txt"), StandardCharsets.UTF_8)) {
            return new AtCommandTable<>(text.useDelimiter("\n\n").tokens());
        }
    }

    /** The manual's list of commands, as a table in Markdown. */
    public static String toMarkdown() {
        return TABLE.toMarkdown();
    }
}

package simgsm.modem.at.command;

import simgsm.modem.at.AtCommandTable;

/** All commands of the modem, in the order of the manual. */
public final class AtCommands {
    static final AtCommandTable<AtClient> TABLE = new AtCommandTable<>();

    static {
        GeneralCommands.addTo(TABLE);
        CallCommands.addTo(TABLE);
        NetworkCommands.addTo(TABLE);
        MessageSettingCommands.addTo(TABLE);
        MessageCommands.addTo(TABLE);
        SimCommands.addTo(TABLE);
        PhoneBookCommands.addTo(TABLE);
    }

    private AtCommands() {}

    /** The manual's list of commands, as a table in Markdown. */
    public static String toMarkdown() {
        return TABLE.toMarkdown();
    }
}

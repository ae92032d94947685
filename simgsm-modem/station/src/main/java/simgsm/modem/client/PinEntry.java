package simgsm.modem.client;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;

/**
 * Gives a real modem the PIN of its SIM: once, and only if the modem has said that at least 2 tries are left, so that a
 * wrong file never blocks a SIM.
 */
final class PinEntry {
    /** No PIN is known. */
    static final PinEntry NONE = new PinEntry("");

    private static final Logger LOG = System.getLogger(PinEntry.class.getName());
    private static final int LEAST_TRIES = 2;
    /** The first answer's second field, and the second answer's first, are the tries left for the PIN. */
    private static final List<ModemCommand> QUESTIONS =
            List.of(ModemCommand.query("AT+CPINR", "+CPINR:"), ModemCommand.query("AT+SPIC", "+SPIC:"));

    private String pin;

    /** @param pin empty if none is known */
    PinEntry(String pin) {
        this.pin = pin;
    }

    /** The modem asks for the PIN. */
    void asked(CommandDialogue dialogue) {
        if (!pin.isEmpty()) {
            String code = pin;
            pin = "";
            ask(dialogue, code, 0);
        }
    }

    private void ask(CommandDialogue dialogue, String code, int question) {
        dialogue.send(QUESTIONS.get(question), answer -> {
            int tries = answer.isOk() ? tries(answer.lines()) : -1;
            if (tries < 0 && question + 1 < QUESTIONS.size()) {
                ask(dialogue, code, question + 1);
            } else if (tries < LEAST_TRIES) {
                LOG.log(
                        Level.WARNING,
                        "the PIN is not entered: {0}; at least 2 are needed",
                        tries < 0 ? "the modem does not tell its tries" : "tries left: " + tries);
            } else {
                enter(dialogue, code);
            }
        });
    }

    private static int tries(List<String> lines) {
        for (String line : lines) {
            AnswerFields fields = AnswerFields.of(line);
            if (line.startsWith("+SPIC:")) {
                return fields.number(0);
            }
            if (fields.text(0).strip().equals("SIM PIN")) {
                return fields.number(1);
            }
        }
        return -1;
    }

    private static void enter(CommandDialogue dialogue, String code) {
        dialogue.send(ModemCommand.of("AT+CPIN=\"" + code + "\"").within(20_000), answer -> {
            if (!answer.isOk()) {
                LOG.log(Level.WARNING, "the SIM refuses the PIN, {0}; it is not tried again", answer.text());
            }
        });
    }
}

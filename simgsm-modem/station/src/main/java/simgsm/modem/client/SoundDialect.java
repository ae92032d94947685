package simgsm.modem.client;

import java.util.Arrays;

/**
 * The commands of families of modems for the sound of a call on a second line, 8 kHz, 16 bit, little-endian (Huawei's
 * and the modules' manuals). One is chosen by its question, and repeated in each call.
 */
enum SoundDialect {
    /** 320 octets each 20 ms on a second tty; {@code ^CVOICE:1} is a stick for data only. */
    HUAWEI("AT^CVOICE?", "^CVOICE:", "AT^DDSETEX=2"),
    /** SIM7600 and alike: accepted only during a call. */
    SIMCOM("AT+CPCMREG=?", "+CPCMREG:", "AT+CPCMREG=1"),
    /** On the port of the GPS messages. */
    QUECTEL("AT+QPCMV=?", "+QPCMV:", "AT+QPCMV=1,0");

    private final ModemCommand question;
    private final ModemCommand switchOn;

    SoundDialect(String question, String prefix, String switchOn) {
        this.question = ModemCommand.query(question, prefix);
        this.switchOn = ModemCommand.of(switchOn);
    }

    static ModemCommand[] questions() {
        return Arrays.stream(values()).map(dialect -> dialect.question).toArray(ModemCommand[]::new);
    }

    /** The command that switches on the sound of a call, by the accepted question. */
    static ModemCommand switchOn(ModemCommand accepted) {
        return Arrays.stream(values())
                .filter(dialect -> dialect.question.equals(accepted))
                .findFirst()
                .orElseThrow()
                .switchOn;
    }
}

package simgsm.modem.client;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import simgsm.modem.ModemState;

/**
 * The steps of preparing a modem, in this order (TS 27.007, TS 27.005): the commands of each, tried until one is
 * accepted, and the expected answer.
 */
enum SetupStep {
    ECHO_OFF(Need.USEFUL, "", command("ATE0")),
    WORDS(Need.USEFUL, "", command("ATV1")),
    ERROR_NUMBERS(Need.USEFUL, "", command("AT+CMEE=1")),
    MANUFACTURER(Need.USEFUL, ".+", ModemCommand.free("AT+CGMI")),
    MODEL(Need.USEFUL, ".+", ModemCommand.free("AT+CGMM")),
    CARD(
            Need.AWAITED,
            "\\+CPIN: ?READY",
            ModemCommand.query("AT+CPIN?", "+CPIN:").within(2_000)),
    /** {@code ATH} also ends voice calls. */
    VOICE_HANG_UP(Need.USEFUL, "", command("AT+CVHU=0")),
    CALLER(Need.USEFUL, "", command("AT+CLIP=1")),
    KEYS(Need.FOR_KEYS, "", enablers()),
    /** The interval between equal keys; modems without it do not answer. */
    KEY_INTERVAL(Need.USEFUL, "(\\+DDET: ?1(, ?0(,.*)?)?)?", ModemCommand.query("AT+DDET?", "+DDET:")),
    TONES(Need.USEFUL, "", ModemCommand.query("AT+VTS=?", "+VTS:")),
    /** In units of 100 ms. */
    TONE_LENGTH(Need.USEFUL, "", command("AT+VTD=2")),
    /** Asked only if the sound of calls has a line. */
    SOUND(Need.USEFUL, "\\^CVOICE: ?0.*|\\+.*|", SoundDialect.questions()),
    CALL_LIST(Need.FOR_CALLS, "", ModemCommand.query("AT+CLCC", "+CLCC:")),
    HANG_UP(Need.FOR_CALLS, "", ModemCommand.ofCall("ATH"), ModemCommand.ofCall("AT+CHUP")),
    /** PDU mode; else text mode. */
    MESSAGE_FORMAT(Need.FOR_MESSAGES, "", command("AT+CMGF=0"), command("AT+CMGF=1")),
    MESSAGE_MEMORY(
            Need.USEFUL,
            "",
            ModemCommand.query("AT+CPMS=\"SM\",\"SM\",\"SM\"", "+CPMS:"),
            ModemCommand.query("AT+CPMS=\"ME\",\"ME\",\"ME\"", "+CPMS:")),
    MESSAGE_NOTICE(Need.USEFUL, "", command("AT+CNMI=2,1,0,0,0"), command("AT+CNMI=2,1"), command("AT+CNMI=1,1")),
    /** In text mode the second command. */
    MESSAGE_LIST(
            Need.FOR_MESSAGES,
            "",
            ModemCommand.listing("AT+CMGL=4", "+CMGL:"),
            ModemCommand.listing("AT+CMGL=\"ALL\"", "+CMGL:")),
    OPERATOR_FORMAT(Need.USEFUL, "", command("AT+COPS=3,0")),
    OPERATOR(Need.USEFUL, "\\+COPS: .*", ModemCommand.query("AT+COPS?", "+COPS:")),
    REGISTRATION_NOTICE(Need.USEFUL, "", command("AT+CREG=1")),
    /** At home or roaming. */
    REGISTRATION(Need.AWAITED, "\\+CREG: ?[0-9], ?[15](,.*)?", ModemCommand.query("AT+CREG?", "+CREG:"));

    /** The modem's ability that depends on the step. */
    enum Need {
        /** All abilities; the step is repeated until it succeeds. */
        AWAITED,
        FOR_CALLS,
        /** Reported keys; else keys heard in the sound. */
        FOR_KEYS,
        FOR_MESSAGES,
        /** None, or there is another way. */
        USEFUL
    }

    private final Need need;
    private final Pattern expected;
    private final List<ModemCommand> alternatives;

    /** @param expected pattern of the answer's joined lines; empty for any */
    SetupStep(Need need, String expected, ModemCommand... alternatives) {
        this.need = need;
        this.expected = Pattern.compile(expected.isEmpty() ? ".*" : expected);
        this.alternatives = List.of(alternatives);
    }

    private static ModemCommand command(String text) {
        return ModemCommand.of(text);
    }

    private static ModemCommand[] enablers() {
        return Arrays.stream(DtmfDialect.values())
                .flatMap(dialect -> dialect.enablers().stream())
                .map(ModemCommand::of)
                .toArray(ModemCommand[]::new);
    }

    Need need() {
        return need;
    }

    /** @param manufacturer as named by the modem; its dialect is tried first */
    List<ModemCommand> alternatives(String manufacturer) {
        if (this != KEYS) {
            return alternatives;
        }
        List<String> own = Arrays.stream(DtmfDialect.values())
                .filter(dialect -> dialect.isOf(manufacturer))
                .flatMap(dialect -> dialect.enablers().stream())
                .toList();
        Function<Boolean, Stream<ModemCommand>> ofOwn =
                wanted -> alternatives.stream().filter(command -> own.contains(command.text()) == wanted);
        return Stream.concat(ofOwn.apply(true), ofOwn.apply(false)).toList();
    }

    /** The state of a modem with this answer; empty if the answer names no obstacle. */
    Optional<ModemState> obstacle(ModemAnswer answer) {
        SetupVerdict verdict = verdict(answer);
        boolean isRefused = answer.ending() == ModemAnswer.Ending.REFUSED;
        if (need != Need.AWAITED || verdict == SetupVerdict.OK || verdict == SetupVerdict.MISSING && !isRefused) {
            return Optional.empty();
        }
        return this == REGISTRATION ? Optional.of(ModemState.NO_NETWORK) : cardState(answer);
    }

    /** {@code +CPIN} (TS 27.007, 8.3), or an error (9.2.1); a busy card (14) is asked again. */
    private static Optional<ModemState> cardState(ModemAnswer answer) {
        return switch (answer.errorNumber().orElse(-1)) {
            case 14 -> Optional.empty();
            case 11 -> Optional.of(ModemState.SIM_PIN);
            case 12 -> Optional.of(ModemState.SIM_PUK);
            default -> {
                String code = answer.content().replaceFirst("^\\+CPIN: *", "");
                yield Optional.of(
                        code.contains("PUK")
                                ? ModemState.SIM_PUK
                                : code.contains("PIN") ? ModemState.SIM_PIN : ModemState.NO_SIM);
            }
        };
    }

    /** A complete answer counts without its final result, too: Wavecom's to {@code +CPIN?} has none. */
    SetupVerdict verdict(ModemAnswer answer) {
        boolean fits = expected.matcher(String.join(" ", answer.lines())).matches();
        boolean isWhole = answer.isOk()
                || answer.ending() == ModemAnswer.Ending.TIMED_OUT
                        && !answer.lines().isEmpty();
        return !isWhole ? SetupVerdict.MISSING : fits ? SetupVerdict.OK : SetupVerdict.UNEXPECTED;
    }
}

package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.RadioResource;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.call.CallLeg;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallState;
import simgsm.center.msc.link.TerminalAccess;

/**
 * Every message that a mobile can send, in every state of the network's side of its call (TS 24.008, 5 and 8): what is
 * answered, and which state follows. The table is the standard's, written down here a second time.
 *
 * <p>A cell is the state that follows; {@code 98} stands for STATUS with that cause and the same state, {@code -} for no
 * answer and the same state. N0 is reached with or without an answer, as the row says.
 */
class CallStateWalkTest {
    private static final List<String> STATES = List.of("N3", "N4", "N6", "N9", "N7", "N10", "N12", "N19", "N28");

    private static final Map<String, List<String>> TABLE = new LinkedHashMap<>();

    private static void row(String message, String cells) {
        TABLE.put(message, Arrays.asList(cells.trim().split(" +")));
    }

    static {
        // state             N3    N4    N6    N9    N7    N10   N12   N19   N28
        row("CALL CONFIRMED", " 98    98    N9    98    98    98    -     -     98");
        row("ALERTING", "       98    98    98    N7    98    98    -     -     98");
        row("CONNECT", "        98    98    98    N10   N10   98    -     -     98");
        row("CONNECT ACK", "    98    98    98    98    98    98    -     -     N10");
        row("DISCONNECT", "     N19   N19   N19   N19   N19   N19   N19   -     N19");
        row("RELEASE", "        N0    N0    N0    N0    N0    N0    N0    N0    N0");
        row("RELEASE COMPLETE", "N0   N0    N0    N0    N0    N0    N0    N0    N0");
        row("STATUS 0", "       N0    N0    N0    N0    N0    N0    N0    N0    N0");
        row("STATUS", "         -     -     -     -     -     -     -     -     -");
        row("STATUS ENQUIRY", " 30    30    30    30    30    30    30    30    30");
        row("START DTMF", "     rej   rej   rej   rej   rej   ack   rej   rej   ack");
        row("UNKNOWN", "        97    97    97    97    97    97    97    97    97");
        // 8.5.3: clearing goes on all the same.
        row("DISCONNECT BARE", "N19   N19   N19   N19   N19   N19   N19   -     N19");
    }

    /** A mobile in the middle of a call, and the call's transaction as it writes it. */
    private record Party(TestMobile mobile, TransactionIdentifier transaction) {
        Optional<CallLeg> leg() {
            return mobile.network.exchange.callSwitch().leg(TerminalAccess.linkOf(mobile.link), transaction);
        }

        String state() {
            return leg().map(leg -> "N" + leg.state().code()).orElse("N0");
        }
    }

    private final TestNetwork network = new TestNetwork();

    static Stream<Arguments> cells() {
        return TABLE.entrySet().stream()
                .flatMap(row -> Stream.iterate(0, i -> i < STATES.size(), i -> i + 1)
                        .map(i -> Arguments.of(
                                STATES.get(i), row.getKey(), row.getValue().get(i))));
    }

    @ParameterizedTest(name = "{1} in {0}: {2}")
    @MethodSource("cells")
    void everyMessageHasItsReactionInEveryState(String state, String message, String cell) {
        Party party = in(state);
        assertEquals(state, party.state());
        party.mobile.received.clear();
        send(party, message);
        switch (cell) {
            case "98", "97", "30" -> assertStatus(party, state, Integer.parseInt(cell));
            case "rej" -> party.mobile.next(CallControl.StartDtmfReject.class);
            case "ack" -> party.mobile.next(CallControl.StartDtmfAcknowledge.class);
            default -> assertFollows(party, state, message, cell.equals("-") ? state : cell);
        }
    }

    private static void assertStatus(Party party, String state, int cause) {
        CallControl.Status status = party.mobile.next(CallControl.Status.class);
        assertEquals(cause, status.cause().code());
        assertEquals(state, "N" + status.callState());
        assertEquals(state, party.state());
    }

    private static void assertFollows(Party party, String before, String message, String after) {
        if (message.startsWith("DISCONNECT") && !before.equals("N19")) {
            party.mobile.next(CallControl.Release.class);
        } else if (message.equals("RELEASE") && !before.equals("N19")) {
            party.mobile.next(CallControl.ReleaseComplete.class);
        } else if (message.equals("CONNECT") && after.equals("N10")) {
            party.mobile.next(CallControl.ConnectAcknowledge.class);
        }
        assertEquals(after, party.state());
        if (after.equals("N0")) {
            party.mobile.next(RadioResource.ChannelRelease.class);
        }
        assertTrue(party.mobile.hasNothing(), party.mobile.received.toString());
    }

    private static void send(Party party, String message) {
        TransactionIdentifier transaction = party.transaction;
        TestMobile mobile = party.mobile;
        switch (message) {
            case "CALL CONFIRMED" -> mobile.tell(new CallControl.CallConfirmed(transaction));
            case "ALERTING" -> mobile.tell(new CallControl.Alerting(transaction));
            case "CONNECT" -> mobile.tell(new CallControl.Connect(transaction));
            case "CONNECT ACK" -> mobile.tell(new CallControl.ConnectAcknowledge(transaction));
            case "DISCONNECT" -> mobile.tell(new CallControl.Disconnect(transaction, Cause.NORMAL_CALL_CLEARING));
            case "RELEASE" -> mobile.tell(new CallControl.Release(transaction, Optional.empty()));
            case "RELEASE COMPLETE" -> mobile.tell(new CallControl.ReleaseComplete(transaction, Optional.empty()));
            case "STATUS 0" -> mobile.tell(new CallControl.Status(transaction, Cause.NORMAL_UNSPECIFIED, 0));
            case "STATUS" -> mobile.tell(new CallControl.Status(transaction, Cause.NORMAL_UNSPECIFIED, 10));
            case "STATUS ENQUIRY" -> mobile.tell(new CallControl.StatusEnquiry(transaction));
            case "START DTMF" -> mobile.tell(new CallControl.StartDtmf(transaction, '5'));
            // Message type 0x3f is none; a bare DISCONNECT lacks its cause.
            case "UNKNOWN" -> mobile.tellNext(head(transaction) + "3f", "");
            default -> mobile.tellNext(head(transaction) + "25", "");
        }
    }

    /** The transaction and the discriminator of call control, in hexadecimal. */
    private static String head(TransactionIdentifier transaction) {
        return String.format("%x3", transaction.value() | (transaction.fromOtherSide() ? 8 : 0));
    }

    private Party in(String state) {
        Map<String, Function<TestMobile[], Party>> ways = Map.of(
                "N3", pair -> caller(pair[0]),
                "N4",
                        pair -> {
                            pair[1].ring();
                            return caller(pair[0]);
                        },
                "N6",
                        pair -> {
                            pair[1].takeSetup();
                            return called(pair[1]);
                        },
                "N9",
                        pair -> {
                            pair[1].takeSetup();
                            pair[1].tell(new CallControl.CallConfirmed(ActiveCall.CALLED_TRANSACTION));
                            return called(pair[1]);
                        },
                "N7",
                        pair -> {
                            pair[1].ring();
                            return called(pair[1]);
                        },
                "N28",
                        pair -> {
                            answer(pair[1]);
                            return caller(pair[0]);
                        },
                "N10",
                        pair -> {
                            answer(pair[1]);
                            pair[0].tell(new CallControl.ConnectAcknowledge(TestMobile.OUR_CALL));
                            return caller(pair[0]);
                        },
                "N12",
                        pair -> {
                            answer(pair[1]);
                            pair[0].hangUpUnheard();
                            return called(pair[1]);
                        },
                "N19",
                        pair -> {
                            answer(pair[1]);
                            pair[0].hangUpUnheard();
                            return caller(pair[0]);
                        });
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        caller.dial("5550200");
        return ways.get(state).apply(new TestMobile[] {caller, called});
    }

    private static void answer(TestMobile called) {
        called.ring();
        called.tell(new CallControl.Connect(ActiveCall.CALLED_TRANSACTION));
    }

    private static Party caller(TestMobile mobile) {
        return new Party(mobile, TestMobile.OUR_CALL);
    }

    private static Party called(TestMobile mobile) {
        return new Party(mobile, ActiveCall.CALLED_TRANSACTION);
    }

    @Test
    void theTableHasACellForEveryState() {
        TABLE.forEach((message, cells) -> assertEquals(STATES.size(), cells.size(), message));
    }

    @Test
    void everyStateOfOursThatRestsIsInTheTable() {
        // N0 is no call; N0.1 has not heard of the mobile yet; N1 is left as soon as it is entered.
        List<String> resting = Arrays.stream(NetworkCallState.values())
                .filter(state -> state != NetworkCallState.NULL
                        && state != NetworkCallState.MM_CONNECTION_PENDING
                        && state != NetworkCallState.CALL_INITIATED)
                .map(state -> "N" + state.code())
                .sorted()
                .toList();
        assertEquals(STATES.stream().sorted().toList(), resting);
    }
}

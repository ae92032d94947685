package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.KeyMode;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.station.context.StationEvent;

/** Keys that go as messages: what the far end hears of it is not the phone's own speech. */
class SignalledKeysTest {
    private final Bench bench = Bench.connected(KeyMode.SIGNALLED);

    private List<String> asked() {
        List<String> asked = List.copyOf(bench.station.asked);
        bench.station.asked.clear();
        return asked.stream().filter(act -> !act.startsWith("dial")).toList();
    }

    private void networkSends(char symbol) {
        DtmfKey key = DtmfKey.of(symbol);
        bench.handset.accept(new StationEvent.KeyStarted(key));
        bench.speechMillis(100);
        bench.handset.accept(new StationEvent.KeyStopping(key));
        bench.handset.accept(new StationEvent.KeyCompleted(key));
    }

    @Test
    void aPressIsSignalledKeyByKeyAndSentWhenItsLastToneHasLeft() {
        bench.handset.press(DtmfKey.sequence("*1#"));
        assertEquals(List.of("signal * 100", "signal 1 100", "signal # 100"), asked());
        networkSends('*');
        networkSends('1');
        assertEquals(List.of(), bench.events);
        networkSends('#');
        assertEquals(List.of("sent *1#"), bench.events);
        assertEquals("*1#", bench.snapshot().call().keyed());
    }

    @Test
    void nothingOfItIsSaidInTheSpeech() {
        bench.handset.press(DtmfKey.sequence("5"));
        bench.handset.accept(new StationEvent.KeyStarted(DtmfKey.FIVE));
        short[] frame = new short[160];
        for (int i = 0; i < 10; i++) {
            bench.handset.fillFrame(frame);
            assertArrayEquals(new short[160], frame);
        }
    }

    @Test
    void theKeyIsSeenAndHeardHereWhileTheNetworkLetsItSound() {
        bench.down(PhoneKey.FIVE);
        bench.speechMillis(40);
        assertEquals(Optional.empty(), bench.snapshot().sounding(), "the network has not acknowledged it yet");
        bench.handset.accept(new StationEvent.KeyStarted(DtmfKey.FIVE));
        bench.speechMillis(40);
        assertEquals(Optional.of(DtmfKey.FIVE), bench.snapshot().sounding());
        assertTrue(bench.snapshot().trace().modem().levels().dbm0(1) > -15);
        bench.up(PhoneKey.FIVE);
        assertEquals(List.of("hold 5", "let go"), asked());
        bench.handset.accept(new StationEvent.KeyStopping(DtmfKey.FIVE));
        bench.speechMillis(100);
        bench.handset.accept(new StationEvent.KeyCompleted(DtmfKey.FIVE));
        assertEquals(Optional.empty(), bench.snapshot().sounding());
        assertEquals(List.of("sent 5"), bench.events);
    }

    @Test
    void aRefusalTellsWhichKeysHaveNotLeftAndTheDisplaySaysSo() {
        bench.handset.press(DtmfKey.sequence("123"));
        bench.handset.press(DtmfKey.sequence("45"));
        networkSends('1');
        bench.handset.accept(new StationEvent.KeysRefused(Cause.SERVICE_NOT_AVAILABLE));
        assertEquals(List.of("refused 2345 63"), bench.events);
        assertEquals(
                new Screen.Note(Screen.Note.Kind.KEYS_REFUSED, "63"),
                bench.snapshot().screen());
        bench.handset.press(DtmfKey.sequence("6"));
        networkSends('6');
        assertEquals(List.of("refused 2345 63", "sent 6"), bench.events);
    }

    @Test
    void withoutACallKeysSoundHereOnly() {
        Bench atRest = new Bench(KeyMode.SIGNALLED);
        atRest.down(PhoneKey.SEVEN);
        atRest.millis(60);
        assertEquals(Optional.of(DtmfKey.SEVEN), atRest.snapshot().sounding());
        atRest.up(PhoneKey.SEVEN);
        assertEquals(List.of("let go"), atRest.station.asked);
    }

    @Test
    void keysPressedBeforeTheCallIsTakenAreHandedOnAtOnceForTheStationToKeep() {
        Bench calling = new Bench(KeyMode.SIGNALLED);
        calling.handset.dial(new Msisdn("5550200"));
        calling.handset.press(DtmfKey.sequence("9"));
        assertEquals(List.of("dial 5550200", "signal 9 100"), calling.station.asked);
        calling.handset.accept(new StationEvent.Connected(Optional.empty()));
        calling.handset.accept(new StationEvent.KeyStarted(DtmfKey.NINE));
        calling.speechMillis(100);
        calling.handset.accept(new StationEvent.KeyStopping(DtmfKey.NINE));
        calling.handset.accept(new StationEvent.KeyCompleted(DtmfKey.NINE));
        assertTrue(calling.events.contains("sent 9"), calling.events.toString());
    }

    @Test
    void whatIsPendingIsSettledOnlyWhenItHasLeft() {
        boolean[] settled = new boolean[1];
        bench.handset.press(DtmfKey.sequence("8"));
        bench.handset.whenSettled(() -> settled[0] = true);
        bench.speechMillis(1000);
        assertEquals(false, settled[0]);
        networkSends('8');
        assertEquals(true, settled[0]);
    }
}

package simgsm.phone.handset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.PhoneKey;
import simgsm.station.context.StationEvent;

/** Keys on their way out: queued by the console, held in the window. */
class HandsetKeysTest {
    private static final List<DtmfKey> FORWARD_20 = DtmfKey.sequence("** #**20 **");

    @Test
    void queuedKeysLeaveAsTonesInTheirOrder() {
        Bench bench = Bench.connected();
        bench.handset.press(FORWARD_20);
        bench.speechMillis(9 * 200 + 100);
        assertEquals("**#**20**", bench.heardByFarEnd());
    }

    @Test
    void sentIsReportedOnceTheLastToneHasLeftAndNotBefore() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("12"));
        bench.speechMillis(280);
        assertEquals(List.of(), bench.events);
        bench.speechMillis(20);
        assertEquals(List.of("sent 12"), bench.events);
    }

    @Test
    void eachPressIsReportedByItself() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("12"));
        bench.handset.press(DtmfKey.sequence("3"));
        bench.speechMillis(600);
        assertEquals(List.of("sent 12", "sent 3"), bench.events);
    }

    @Test
    void aPlayedSoundIsHeardByTheFarEndAndDroppedAtHangUp() {
        short[] sound = new short[8 * 400];
        DtmfGenerator generator = new DtmfGenerator();
        DtmfKey.sequence("58").forEach(generator::enqueue);
        generator.read(sound);
        Bench bench = Bench.connected();
        assertEquals(Optional.empty(), bench.handset.play(sound));
        bench.speechMillis(500);
        assertEquals("58", bench.heardByFarEnd());
        bench.handset.play(sound);
        bench.handset.hangUp();
        assertEquals(Optional.of(Refusal.NO_CALL), bench.handset.play(sound));
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.speechMillis(500);
        assertEquals("58", bench.heardByFarEnd());
    }

    @Test
    void aPlayedSoundEndsWithTheHoldOfItsCall() {
        short[] sound = new short[8 * 400];
        DtmfGenerator generator = new DtmfGenerator();
        DtmfKey.sequence("58").forEach(generator::enqueue);
        generator.read(sound);
        Bench bench = Bench.connected();
        bench.handset.play(sound);
        bench.handset.accept(new StationEvent.CallHeld(Optional.of(new Msisdn("5550200"))));
        bench.handset.accept(new StationEvent.Connected(Optional.of(new Msisdn("5550102"))));
        bench.speechMillis(500);
        assertEquals("", bench.heardByFarEnd());
    }

    @Test
    void hangingUpDropsWhatHasNotLeft() {
        Bench bench = Bench.connected();
        bench.handset.press(FORWARD_20);
        bench.speechMillis(300);
        bench.handset.hangUp();
        assertEquals(List.of("released 16"), bench.events);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.speechMillis(2000);
        assertEquals("**", bench.heardByFarEnd());
    }

    @Test
    void aReleaseByTheFarEndDropsThemToo() {
        Bench bench = Bench.connected();
        bench.handset.press(FORWARD_20);
        bench.station.release(simgsm.air.Cause.USER_BUSY);
        bench.handset.dial(new Msisdn("5550200"));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.speechMillis(2000);
        assertEquals("", bench.heardByFarEnd());
    }

    @Test
    void pressingWithoutACallIsRefused() {
        assertEquals(Optional.of(Refusal.NO_CALL), new Bench().handset.press(FORWARD_20));
    }

    @Test
    void pressingBeforeTheCallIsAnsweredIsRefused() {
        Bench bench = new Bench();
        bench.station.ring("5550101");
        assertEquals(Optional.of(Refusal.NOT_ANSWERED), bench.handset.press(FORWARD_20));
    }

    @Test
    void keysPressedWhileItRingsThereWaitForTheConnection() {
        Bench bench = new Bench();
        bench.handset.dial(new Msisdn("5550200"));
        assertEquals(Optional.empty(), bench.handset.press(DtmfKey.sequence("7")));
        bench.handset.accept(new StationEvent.Connected(Optional.empty()));
        bench.speechMillis(200);
        assertEquals("7", bench.heardByFarEnd());
    }

    @Test
    void aHeldKeySoundsAsLongAsItIsHeld() {
        Bench bench = Bench.connected();
        bench.down(PhoneKey.FIVE);
        bench.speechMillis(700);
        bench.up(PhoneKey.FIVE);
        bench.speechMillis(200);
        assertEquals("5", bench.heardByFarEnd());
        assertEquals(700, bench.tonesMillis().get(0), 15);
    }

    @Test
    void aKeyTouchedForAnInstantSoundsSeventyMilliseconds() {
        Bench bench = Bench.connected();
        bench.down(PhoneKey.HASH);
        bench.up(PhoneKey.HASH);
        bench.speechMillis(300);
        assertEquals("#", bench.heardByFarEnd());
        assertEquals(70, bench.tonesMillis().get(0), 15);
    }

    @Test
    void everyKeyOfTheTwelveMakesItsOwnTone() {
        Bench bench = Bench.connected();
        for (PhoneKey key : PhoneKey.values()) {
            if (key.tone().isPresent()) {
                bench.down(key);
                bench.speechMillis(100);
                bench.up(key);
                bench.speechMillis(100);
            }
        }
        assertEquals("123456789*0#", bench.heardByFarEnd());
    }

    @Test
    void whatWasKeyedIsShown() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("**"));
        bench.tap(PhoneKey.HASH);
        assertEquals("**#", bench.snapshot().call().keyed());
    }

    @Test
    void theKeyThatSoundsIsShownWhileItSounds() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("8"));
        bench.speechMillis(40);
        assertEquals(Optional.of(DtmfKey.EIGHT), bench.snapshot().sounding());
        bench.speechMillis(200);
        assertEquals(Optional.empty(), bench.snapshot().sounding());
    }

    @Test
    void theScopeMeasuresTheToneThatIsSent() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("#"));
        bench.speechMillis(100);
        assertEquals(-10, bench.snapshot().trace().modem().levels().dbm0(3), 0.7);
        assertEquals(-10, bench.snapshot().trace().modem().levels().dbm0(4 + 2), 0.7);
        assertTrue(bench.snapshot().trace().modem().levels().dbm0(0) < -20);
    }

    @Test
    void beforeTheEndQueuedKeysMayLeave() {
        Bench bench = Bench.connected();
        bench.handset.press(DtmfKey.sequence("12"));
        bench.handset.whenSettled(() -> bench.events.add("settled"));
        bench.speechMillis(320);
        assertEquals(List.of("sent 12", "settled"), bench.events);
    }
}

package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.modem.at.AtProfile;

/** The forms of {@code --at-profile}: what TinyGSM and Adafruit_FONA send to a SIM800, and what they read in the answers. */
class AtProfileTest {
    private final VirtualSuite suite = new VirtualSuite(1500);
    private final VirtualModem modem = suite.modem("5550300", AtProfile.SIM800).connect();

    private void probe(String table) {
        for (String row : table.lines().toList()) {
            String[] commandAndAnswer = row.split(" +-> ");
            assertEquals(commandAndAnswer[1], modem.say(commandAndAnswer[0]), commandAndAnswer[0]);
        }
    }

    @Test
    void aModemThatStartsSaysItsBootCodesAndItsReadinessOnceItIsRegistered() {
        modem.heard();
        assertEquals(
                "OK|RDY|+CFUN: 1|+CPIN: READY|Call Ready|SMS Ready", modem.say("ATE0+CFUN=1,1"), "after a restart");
        modem.say("ATE0");
        modem.say("AT+CFUN=0");
        assertEquals("", modem.heard());
        assertEquals("OK|RDY|+CFUN: 1|+CPIN: READY|Call Ready|SMS Ready", modem.say("AT+CFUN=1,1"));
    }

    @Test
    void theSetUpOfTinyGsmAndFonaIsTaken() {
        probe("""
                AT                     -> OK
                AT+CMEE=0              -> OK
                AT+CGMI                -> SIMCOM_Ltd|OK
                AT+CGMM                -> SIMCOM_SIM800L|OK
                AT+CGMR                -> Revision:1308B08SIM800L16|OK
                ATI                    -> SIM800 R13.08|OK
                AT+CLTS=1              -> OK
                AT+CBATCHK=1           -> OK
                AT+CPIN?               -> +CPIN: READY|OK
                AT&FZE0&W              -> OK
                AT+IPR=0               -> OK
                AT+IFC=0,0             -> OK
                AT+ICF=3,3             -> OK
                AT+CSCLK=0             -> OK
                AT&W                   -> OK
                AT+CVHU=0              -> OK
                AT+CPMS="SM","SM","SM" -> +CPMS: 0,50,0,50,0,50|OK
                """.strip());
    }

    @Test
    void batteryCardProviderAndSoundAnswerInTheManualsForms() {
        probe("""
                AT+CCID            -> 8900101000555030007|OK
                AT+CBC             -> +CBC: 0,100,4200|OK
                AT+CNMI?           -> +CNMI: 2,1,0,0,0|OK
                AT+CSPN?           -> +CSPN: "SimGSM",0|OK
                AT+CREG?           -> +CREG: 0,1|OK
                AT+CGREG?          -> +CGREG: 0,1|OK
                AT+CLVL=70         -> OK
                AT+CLVL?           -> +CLVL: 70|OK
                AT+CMIC=0,9        -> OK
                AT+CMIC=9          -> OK
                AT+CHFA=1          -> OK
                AT+CSCLK=1         -> OK
                AT+CFGRI=1         -> OK
                AT+CFGRI?          -> +CFGRI: 1|OK
                AT+STTONE=1,16,100 -> OK
                AT+CLDTMF=3,"5"    -> OK
                AT+SPIC            -> +SPIC: 3,10,3,10|OK
                AT+CPINR           -> +CPINR: SIM PIN,3,3|+CPINR: SIM PUK,10,10|OK
                """.strip());
        modem.send("AT+CPOWD=1\r");
        assertEquals("NORMAL POWER DOWN", VirtualModem.lines(modem.heard()));
        assertEquals("+CFUN: 0|OK", modem.say("AT+CFUN?"));
    }

    @Test
    void textsAreHexadecimalInTheSetHex() {
        modem.say("AT+CMGF=1;+CSCS=\"HEX\"");
        assertEquals("OK|+CUSD: 0,\"35353530333030\",15", modem.say("AT+CUSD=1,\"*100#\""));
        assertEquals("OK|+CUSD: 0,\"35353530333030\",15", modem.say("AT+CUSD=1,\"2A31303023\""));
        VirtualModem other = suite.modem("5550301").connect();
        other.say("AT+CMGF=1;+CSCS=\"UCS2\"");
        modem.say("AT+CMGS=\"5550301\"", "48690D");
        modem.say("AT+CSMP=17,167,0,8");
        modem.say("AT+CMGS=\"5550301\"", "00480416");
        suite.seconds(0.5);
        assertTrue(other.say("AT+CMGR=1").endsWith("|00480069000D|OK"));
        assertTrue(other.say("AT+CMGR=2").endsWith("|00480416|OK"));
        assertTrue(other.say("AT+CSCS=\"HEX\";+CMGR=1").endsWith("|48690D|OK"));
    }

    @Test
    void furtherLinesOfATextArePromptedOnlyWithEcho() {
        modem.say("AT+CMGF=1");
        assertEquals("> ", modem.say("AT+CMGS=\"5550301\""));
        modem.send("first\r\nsecond\r\n");
        assertEquals("", modem.heard());
        modem.send("\u001b");
        modem.say("ATE1");
        modem.heard();
        modem.send("AT+CMGS=\"5550301\"\r");
        modem.heard();
        modem.send("first\r\n");
        assertEquals("first\r\n> ", modem.heard());
    }

    @Test
    void aCallerIsShownInTheManualsFormAndRejectedWhileTheModemIsBusy() {
        VirtualPhone caller = suite.phone("5550100");
        modem.say("AT+CLIP=1");
        caller.dial("5550300");
        suite.seconds(0.2);
        assertEquals("RING|+CLIP: \"5550100\",129,\"\",0,\"\",0", VirtualModem.lines(modem.heard()));
        assertEquals("OK", modem.say("ATH"));
        suite.seconds(0.2);
        modem.say("AT+GSMBUSY=1");
        caller.dial("5550300");
        suite.seconds(0.5);
        assertEquals(List.of(21, 21), caller.releaseCauses);
        assertEquals("NO CARRIER", VirtualModem.lines(modem.heard()));
    }
}

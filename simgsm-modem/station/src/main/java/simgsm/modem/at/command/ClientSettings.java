package simgsm.modem.at.command;

import simgsm.modem.at.state.CharacterSet;
import simgsm.sms.ChannelList;

/** What one client has set; each connection begins with these values, and ATZ and AT&F restore them. */
final class ClientSettings {
    CharacterSet characterSet = CharacterSet.IRA;

    // Calls.
    boolean showsCaller;
    boolean namesRingKind;
    boolean showsWaiting;
    boolean showsConnectedNumber;
    /** ATX: below 3 a busy line is reported as NO CARRIER. */
    int callProgress = 4;
    /** S0: rings after which a call is answered, 0 for never. */
    int ringsBeforeAnswer;
    /** VTD, in 0.1 s; 0 for the modem's own 100 ms. */
    int keyTenths;

    // Keys heard.
    boolean reportsKeys;
    int equalKeysMillis;
    boolean reportsKeyMillis;

    // Network.
    int registrationMode;
    int packetRegistrationMode;
    int operatorFormat;
    boolean reportsIndicators;
    int ussdMode;

    // Messages.
    boolean textMode;
    boolean showsHeader;
    boolean acknowledges;
    int indicationMode;
    int deliverMode;
    int broadcastMode;
    int reportMode;
    int bufferMode;
    ChannelList channels = ChannelList.ALL;
    int submitFirstOctet = 17;
    int submitValidity = 167;
    int submitProtocol;
    int submitCoding;

    String phoneBook = "SM";
}

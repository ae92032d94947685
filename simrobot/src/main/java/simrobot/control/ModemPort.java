package simrobot.control;

import vericommand.ReplyTone;

/** What a robot's control asks of its modem; any thread may ask. */
interface ModemPort {
    /** @param call the number of the call that is to hear it; when that one is over, nobody does */
    void sendTone(long call, ReplyTone tone);

    /** Clears this call, and no later one, once the tones asked for so far have left. */
    void clearCall(long call);

    /** @return false if that is no number that a message can go to */
    boolean sendMessage(String to, String text);

    /** While an order is under way the modem's count of idle time stands still. */
    void setOrderUnderWay(boolean underWay);
}

/** What the window shows of the selected robot's telephone side: modem, tone scope, VeriCommand and replies. */
package simrobot.ui.telephone;
